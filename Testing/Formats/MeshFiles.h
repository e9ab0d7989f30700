// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshFiles.h
 * @brief The files that make up one mesh, in memory, in a folder, or packed into one string.
 *
 * A fuzzer changes the packed form. A mesh in one file with the default extension of its format is
 * packed as it is; otherwise every file follows a line with its extension, the file to open first:
 *
 *     //// ele
 *     1 4 0
 *     1 1 2 3 4
 *
 *     //// node
 *     4 3 0 0
 *     ...
 *
 * The line feed before such a line is not part of a file.
 */
#ifndef camaron_MeshFiles_h
#define camaron_MeshFiles_h

#include "FormatUnderTest.h"
#include "TemporaryFolder.h"

#include <cstddef>    // for std::size_t
#include <filesystem> // for paths

namespace camaron
{
namespace testing
{
struct MeshFile
{
  std::string Extension; ///< without the dot
  std::string Bytes;
};

/// The first file is opened; all have the same name except for the extension.
using MeshFiles = std::vector<MeshFile>;

std::size_t GetTotalSize(const MeshFiles& files);
/// The largest size of files after decompression, for readers of gzip: 100 times the compressed
/// size.
std::size_t GetInflatedSize(const MeshFiles& files);

std::string Pack(const MeshFiles& files, const FormatUnderTest& format);
/// Only extensions of the format begin a new file; of several files with the same one the first is
/// used.
MeshFiles Unpack(const std::string& bytes, const FormatUnderTest& format);

/// The file, and those next to it with the same name and another extension of the format.
MeshFiles LoadMeshFiles(const std::filesystem::path& opened, const FormatUnderTest& format);

/// All files in a folder, subfolders included, with an extension of the format, by name.
std::vector<std::filesystem::path> FindMeshFiles(
  const std::filesystem::path& folder, const FormatUnderTest& format);

/// A folder for files to be read, in memory if the system supports it, removed by the destructor.
class Folder
{
public:
  /// Writes the files, each named @a name and its extension; returns the path of the first.
  std::string Write(const MeshFiles& files, const std::string& name = "mesh") const;
  /// Removes all files in the folder.
  void Clear() const;

  const std::filesystem::path& GetPath() const { return this->Files.Path; }

private:
  static std::filesystem::path GetParent();

  TemporaryFolder Files{ GetParent() };
};
}
}

#endif
