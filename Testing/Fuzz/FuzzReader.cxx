// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// A libFuzzer target: its inputs are packed files (Testing/Formats/MeshFiles.h) for the reader of a
// format. It ends at any fault of the reader.
//
// FuzzVisf [OPTION...] [CORPUS_FOLDER...], as for libFuzzer; FuzzVisf FILE... tries packed files
// again, with all checks if the environment has CAMARON_FUZZ_ALL_LAWS. The name under which the
// program runs says the format.
#include "ReaderTrial.h"

#include "vtkSMPTools.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Prints a finding so that it can be tried again if its file is lost: printf '...' creates it.
void Print(const std::string& bytes)
{
  std::fputs("printf '", stderr);
  for (const char byte : bytes)
  {
    const bool isPlain = byte >= ' ' && byte <= '~' && byte != '\'' && byte != '\\' && byte != '%';
    std::fprintf(stderr, isPlain ? "%c" : "\\%03o", static_cast<unsigned char>(byte));
  }
  std::fputs("'\n", stderr);
}
}

//------------------------------------------------------------------------------
// Default options; those on the command line come later and override them.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments)
{
  const std::string program = std::filesystem::path((*arguments)[0]).filename().string();
  if (program.compare(0, 4, "Fuzz") != 0 || !ChooseFormat(program.substr(4)))
  {
    std::fprintf(
      stderr, "%s: the name must be Fuzz and a format, such as FuzzVisf\n", program.c_str());
    std::exit(2);
  }
  static std::vector<std::string> all = {
    "-timeout=60",         // wall-clock seconds for one input; ReaderTrial limits the CPU time
    "-rss_limit_mb=2048",  // of the whole program, including sanitizer and corpus
    "-malloc_limit_mb=64", // for one request; inputs are far smaller
    "-max_len=16384",      // enough for some hundred rows of any format
  };
  if (std::filesystem::exists(GetFormat().Dictionary))
  {
    all.push_back("-dict=" + GetFormat().Dictionary);
  }
  all.insert(all.begin(), (*arguments)[0]);
  all.insert(all.end(), *arguments + 1, *arguments + *count);
  static std::vector<char*> pointers;
  for (std::string& argument : all)
  {
    pointers.push_back(&argument[0]);
  }
  *count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  *arguments = pointers.data();

  // The same input must always take the same path.
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static ReaderTrial trial;
  const std::string bytes(reinterpret_cast<const char*>(data), size);

  // The further check for an input depends on its bytes, so that a finding is reproduced when its
  // bytes are tried alone.
  std::uint32_t hash = 2166136261u; // Fowler, Noll and Vo's hash, FNV-1a
  for (const char byte : bytes)
  {
    hash = (hash ^ static_cast<std::uint8_t>(byte)) * 16777619u;
  }
  constexpr int Choices[] = { Parallel, Pieces, Writing, Stopping };
  const int laws = std::getenv("CAMARON_FUZZ_ALL_LAWS") ? int(AllLaws) : Choices[hash >> 16 & 3];

  const Reading reading = trial.Try(Unpack(bytes, GetFormat()), laws);
  if (!reading.Fault.empty())
  {
    std::fprintf(stderr, "%s: %s\n", GetFormat().Name.c_str(), reading.Fault.c_str());
    Print(bytes);
    std::abort();
  }
  return 0;
}
