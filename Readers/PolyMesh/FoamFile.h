// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FoamFile
 * @brief Writes one file of an OpenFOAM mesh: a header and lists, in text or binary.
 */
#ifndef camaron_FoamFile_h
#define camaron_FoamFile_h

#include "Intake/Write/WriteRows.h"

#include "vtk_zlib.h" // for the file

#include <filesystem> // for folders
#include <string>     // for bytes
#include <vector>     // for labels

namespace camaron
{
/// How the files of a mesh are written.
struct FoamEncoding
{
  bool IsBinary = false;
  bool Has64BitLabels = false;
  bool IsCompressed = false; ///< by gzip
  FoamEncoding AsText() const { return { false, this->Has64BitLabels, this->IsCompressed }; }
};

class FoamFile
{
public:
  /**
   * @param folder of the file, which exists
   * @param kind OpenFOAM's class of the contents, e.g. labelList
   * @param note of the header; empty for none
   */
  FoamFile(const std::filesystem::path& folder, const std::string& name, const std::string& kind,
    const FoamEncoding& encoding, const std::string& note = "");
  ~FoamFile();
  FoamFile(const FoamFile&) = delete;
  FoamFile& operator=(const FoamFile&) = delete;

  void Write(const std::string& bytes);
  bool HasFailed() const { return static_cast<bool>(this->Error); }
  /// Completes the file; false with the error, or without one if @a isWritten is false.
  bool Finish(bool isWritten, ScanError& error);

  /// Appends a label; in text without anything behind it.
  void AppendLabel(std::string& bytes, vtkIdType label) const;

  /// Writes a list of @a count items, "n(...)": append(i, bytes) for each of some rows with all of
  /// them; in text one row per line.
  template <typename Append>
  bool WriteList(vtkIdType count, vtkIdType rows, const Progress& progress, Append&& append)
  {
    const bool isBinary = this->Encoding.IsBinary;
    const bool isOpen = count > 0 || !isBinary; // binary lists of no items have no parentheses
    this->Write("\n" + std::to_string(count) + (isOpen ? isBinary ? "\n(" : "\n(\n" : "\n"));
    const bool good = WriteRows(*this, rows, progress,
      [&](vtkIdType i, std::string& bytes)
      {
        append(i, bytes);
        bytes.append(isBinary ? 0 : 1, '\n');
      });
    this->Write(isOpen ? ")\n" : "\n");
    return good;
  }
  ///@{
  /// Writes a list of labels; get(i) for each.
  template <typename Get>
  bool WriteLabels(vtkIdType count, const Progress& progress, Get&& get)
  {
    return this->WriteList(count, count, progress,
      [&](vtkIdType i, std::string& bytes) { this->AppendLabel(bytes, get(i)); });
  }
  bool WriteLabels(const std::vector<vtkIdType>& labels, const Progress& progress)
  {
    return this->WriteLabels(
      static_cast<vtkIdType>(labels.size()), progress, [&](vtkIdType i) { return labels[i]; });
  }
  ///@}

private:
  void Fail();

  std::string Name;
  FoamEncoding Encoding;
  gzFile File; ///< also for files that are not compressed
  ScanError Error;
};
}

#endif
