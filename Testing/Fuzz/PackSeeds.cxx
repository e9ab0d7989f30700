// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// PackSeeds FORMAT FOLDER: writes the seeds of the format there, packed for its fuzzer.
// PackSeeds FORMAT FOLDER FILE...: the same for the meshes in these files.
// PackSeeds FORMAT --unpack FOLDER PACKED...: the reverse: writes findings of a fuzzer as files to
// open.
#include "MeshFiles.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

using namespace camaron::testing;

int main(int count, char* arguments[])
{
  const bool unpacks = count > 2 && std::strcmp(arguments[2], "--unpack") == 0;
  const int first = unpacks ? 3 : 2;
  if (count <= first || !ChooseFormat(arguments[1]))
  {
    std::fprintf(stderr, "usage: %s FORMAT [--unpack] FOLDER [FILE...]\n", arguments[0]);
    return 2;
  }
  const FormatUnderTest& format = GetFormat();
  const std::filesystem::path folder = arguments[first];
  std::vector<std::filesystem::path> paths(arguments + first + 1, arguments + count);
  if (paths.empty())
  {
    paths = FindMeshFiles(format.SeedFolder, format);
  }
  std::filesystem::create_directories(folder);
  for (const std::filesystem::path& path : paths)
  {
    if (!unpacks)
    {
      std::ofstream(folder / path.filename(), std::ios::binary)
        << Pack(LoadMeshFiles(path, format), format);
      continue;
    }
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes(
      (std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    for (const MeshFile& file : Unpack(bytes, format))
    {
      const std::filesystem::path unpacked =
        folder / (path.filename().string() + "." + file.Extension);
      std::ofstream(unpacked, std::ios::binary) << file.Bytes;
      std::printf("%s\n", unpacked.c_str());
    }
  }
  return 0;
}
