// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// A libFuzzer target: what it is given are packed files (Testing/Formats/MeshFiles.h) for the
// reader of a format. One program per format. Whatever is wrong with what the reader does ends it.
//
// FuzzVisf [OPTION...] [CORPUS_FOLDER...], as libFuzzer has it; FuzzVisf FILE... tries packed files
// again, under all laws if the environment has CAMARON_FUZZ_ALL_LAWS.
#include "ReaderTrial.h"

#include "vtkSMPTools.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// So that a finding whose file is lost can be tried again: printf '...' makes the file.
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
// Options that need not be named at every call; what is named there comes later and counts.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments)
{
  static std::vector<std::string> all = {
    "-timeout=60", // seconds for one input, of which it may wait any; ReaderTrial counts those of
                   // the processor
    "-rss_limit_mb=2048",  // of the whole program, sanitizer and corpus included
    "-malloc_limit_mb=64", // for one request; inputs are far smaller
    "-max_len=16384",      // enough for some hundred rows of anything
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

  // The same input shall always take the same way.
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  vtkSMPTools::SetBackend("Sequential");
  return 0;
}

//------------------------------------------------------------------------------
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static ReaderTrial trial;
  const std::string bytes(reinterpret_cast<const char*>(data), size);

  // Under which further law an input is tried depends on its bytes, so that a finding is one again
  // when its bytes are tried alone.
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
