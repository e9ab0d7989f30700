// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::testing::ReaderTrial
 * @brief Has the format's reader read files that may be damaged, and finds fault with what it does.
 *
 * Whatever the bytes are, a reader either gives a mesh that filters can work with, or one error
 * that names the file, with its kind and an empty output; and it takes neither long nor memory out
 * of all proportion to the file.
 */
#ifndef camaron_ReaderTrial_h
#define camaron_ReaderTrial_h

#include "MeshFiles.h"

class vtkUnstructuredGrid;

namespace camaron
{
namespace testing
{
/// What reading a file gave.
struct Reading
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< output of port 0
  unsigned long ErrorCode = 0;
  std::vector<std::string> Errors; ///< as worded by the reader, without VTK's preamble
  std::vector<std::string> Warnings;
  std::string Fault; ///< what is wrong with this, or nothing
};

/// Which further laws a trial looks at, for the time that these take.
enum Laws
{
  NoFurtherLaws = 0,
  Parallel = 1, ///< read in many pieces of text as in one: the same mesh, the same error
  Pieces = 2,   ///< the pieces of ranks are good, and have all cells together
  Writing = 4,  ///< what the writer makes of the mesh is read as the same mesh
  Stopping = 8, ///< progress goes one way, and a reader that is stopped gives nothing and is silent
  AllLaws = 15
};

class ReaderTrial
{
public:
  /// Processor seconds that reading may take; sanitizers make it slower.
#if defined(__SANITIZE_ADDRESS__)
  static constexpr double MaxSeconds = 50;
#else
  static constexpr double MaxSeconds = 5;
#endif
  ///@{
  /// Bytes that reading may have in use: so many times the files', and what small files need
  /// anyway.
  static constexpr std::size_t MaxAllocation = 10;
  static constexpr std::size_t BaseAllocation = std::size_t(1) << 20;
  ///@}

  /// Begins with a reading that is not measured, for what is set up once.
  ReaderTrial();

  /// Reads files; the result has the first fault that was found.
  Reading Try(const MeshFiles& files, int laws = NoFurtherLaws);
  /// Reads what is no file at all.
  Reading TryWithoutFile(const std::string& path) const { return this->Read(path, 0); }

  /// The files of the last trial lie here, for as long as the object lives.
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
