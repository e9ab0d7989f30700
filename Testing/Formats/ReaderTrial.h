// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::ReaderTrial
 * @brief Reads possibly damaged files with the reader of a format and reports faults of the reader.
 *
 * Whatever the bytes are, a reader must return either a mesh that filters can process, or one error
 * with the name of the file, an error code and an empty output; time and memory must be reasonable
 * for the size of the file.
 */
#ifndef camaron_ReaderTrial_h
#define camaron_ReaderTrial_h

#include "MeshFiles.h"

class vtkUnstructuredGrid;

namespace camaron
{
namespace testing
{
/// Result of reading a file.
struct Reading
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< output of port 0
  unsigned long ErrorCode = 0;
  std::vector<std::string> Errors; ///< messages of the reader, without VTK's preamble
  std::vector<std::string> Warnings;
  std::string Fault; ///< description of a fault, or empty
};

/// Further, more expensive checks of a trial.
enum Laws
{
  NoFurtherLaws = 0,
  Parallel = 1, ///< reading in many chunks of text gives the same mesh or error as in one
  Pieces = 2,   ///< the pieces of ranks are valid, and together have all cells
  Writing = 4,  ///< writing and reading the mesh again gives the same mesh
  Stopping = 8, ///< progress ascends, and an aborted reader has no output and no message
  AllLaws = 15
};

class ReaderTrial
{
public:
  /// CPU seconds that reading may take; sanitizers make it slower.
#if defined(__SANITIZE_ADDRESS__)
  static constexpr double MaxSeconds = 50;
#else
  static constexpr double MaxSeconds = 5;
#endif
  ///@{
  /// Bytes that reading may use: a multiple of the size of the files, and a minimum for small
  /// files.
  static constexpr std::size_t MaxAllocation = 10;
  static constexpr std::size_t BaseAllocation = std::size_t(1) << 20;
  ///@}

  /// Begins with a reading that is not measured, for one-time initialization.
  ReaderTrial();

  /// Reads files; the result has the first fault found.
  Reading Try(const MeshFiles& files, int laws = NoFurtherLaws);
  /// Reads a path that is not a file.
  Reading TryWithoutFile(const std::string& path) const { return this->Read(path, 0); }

  /// Folder with the files of the last trial, while the object lives.
  const Folder& GetFolder() const { return this->Input; }

private:
  /// @param size of all files, in bytes
  Reading Read(const std::string& path, std::size_t size, int piece = 0, int pieces = 1,
    int ghostLevels = 0) const;
  std::string FindFaultInParallel(
    const std::string& path, std::size_t size, const Reading& expected) const;
  std::string FindFaultInPieces(
    const std::string& path, std::size_t size, const Reading& whole) const;
  std::string FindFaultInWriting(const Reading& reading) const;
  std::string FindFaultInStopping(const std::string& path) const;

  Folder Input;
  Folder Output;
};
}
}

#endif
