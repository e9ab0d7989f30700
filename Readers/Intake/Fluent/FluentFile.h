// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentFile
 * @brief The sections of a Fluent mesh or case file: where their data are, and their headers.
 *
 * Subclasses find the sections: of text and binary files, and of containers.
 */
#ifndef camaron_FluentFile_h
#define camaron_FluentFile_h

#include "Base/Buffer.h"
#include "Base/Number.h"
#include "Base/Progress.h"
#include "Intake/Pieces/PieceExchange.h"
#include "Intake/Pieces/PieceRequest.h"
#include "Scan/ScanError.h"

#include <algorithm>        // for sizes of batches
#include <charconv>         // for hexadecimal numbers
#include <cstdint>          // for integers of known size
#include <initializer_list> // for headers
#include <set>              // for zones
#include <string>           // for names
#include <vector>           // for sections

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

namespace camaron
{
/// The first character that is not white space, or the end.
inline const char* SkipSpaceFrom(const char* text, const char* end)
{
  while (text < end && IsSpace(*text))
  {
    ++text;
  }
  return text;
}

/**
 * Reads a number after white space; returns its end, or nullptr if there is none, if it is directly
 * followed by another character, or if it is too large.
 */
template <typename Integer>
const char* ParseHex(const char* text, const char* end, Integer& value)
{
  constexpr int Base = 16;
  text = SkipSpaceFrom(text, end);
  const auto [next, error] = std::from_chars(text, end, value, Base);
  return error == std::errc() && *text != '-' && (next == end || IsSpace(*next)) ? next : nullptr;
}

/// A section with data of the mesh.
struct FluentSection
{
  /// Indices without the encoding, e.g. 13 for 3013.
  enum : int
  {
    NodesIndex = 10,
    CellsIndex = 12,
    FacesIndex = 13,
    FaceTreeIndex = 59, ///< faces that were split, and their parts
    InterfaceIndex = 61 ///< faces at nonconformal interfaces
  };
  static constexpr int Polygons = 5; ///< type of faces that state their numbers of nodes, as type 0
  static constexpr int MaxHeader = 8;
  const char* Place = nullptr; ///< of its opening parenthesis
  int Index = 0;               ///< -1 for a list without index
  int RealSize = 0;            ///< of binary reals, 4 or 8; 0 for text
  bool IsStored = false; ///< whether FluentFile::LoadStored reads the body, in the form of binary
  std::int64_t Header[MaxHeader] = {};
  int HeaderSize = 0;
  const char* Begin = nullptr; ///< of the body; nullptr if there is none
  const char* End = nullptr;

  /// A section that FluentFile::LoadStored reads.
  static FluentSection MakeStored(int index, std::initializer_list<std::int64_t> header)
  {
    FluentSection section;
    section.Index = index;
    section.RealSize = sizeof(double);
    section.IsStored = true;
    std::copy(header.begin(), header.end(), section.Header);
    section.HeaderSize = static_cast<int>(header.size());
    return section;
  }

  bool IsText() const { return this->RealSize == 0; }
  bool HasBody() const { return this->Begin || this->IsStored; }
  /// Number of records, for headers (zone first last ...).
  std::int64_t GetCount() const { return this->Header[2] - this->Header[1] + 1; }
  /// Dimension of nodes, type of cells, number of nodes of faces; 0 if they differ or if missing.
  std::int64_t GetElement() const { return this->Header[4]; }
};

/// Declared total number of nodes, cells or faces.
struct FluentTotal
{
  std::int64_t Count = -1;     ///< -1 if not declared
  const char* Place = nullptr; ///< of the section that declares it
};

struct FluentZone
{
  int Id = 0;
  std::string Type, Name;
  int BoundaryType = 0; ///< Fluent's number; 0 for cell zones
};

class FluentFile
{
public:
  static constexpr std::int64_t BlockSize = 1024; ///< faces per block, whose begin is known
  /// Records that are loaded at once: enough for many threads, but only a small part of all.
  static std::int64_t GetStoredBatch(std::int64_t all)
  {
    constexpr std::int64_t Part = 32, Least = 4, Most = 128; // blocks
    return BlockSize * std::max(Least, std::min(Most, all / BlockSize / Part));
  }

  /// @param begin,end of the bytes to which the places of sections point
  FluentFile(std::string name, const char* begin, const char* end);
  virtual ~FluentFile() = default;
  FluentFile(const FluentFile&) = delete;
  FluentFile& operator=(const FluentFile&) = delete;

  const std::string& GetName() const { return this->Name; }
  /// 2 or 3.
  int GetDimension() const { return this->Dimension; }
  /// Whether the bytes of binary sections must be swapped.
  bool IsSwapped() const { return this->Swap; }

  ///@{
  /// Sections with a body or a range, in the order of the file, and the declared totals.
  std::vector<FluentSection> Nodes, Cells, Faces;
  FluentTotal DeclaredNodes, DeclaredCells, DeclaredFaces;
  ///@}
  std::vector<FluentSection> FaceTrees, InterfaceFaces;
  std::vector<FluentZone> Zones;
  /// Ids of zones that are left out, with their cells and boundary faces.
  std::set<int> ZonesLeftOut;
  bool LeavesOutCells() const
  {
    return std::any_of(this->Cells.begin(), this->Cells.end(), [this](const FluentSection& section)
      { return this->ZonesLeftOut.count(static_cast<int>(section.Header[0])) > 0; });
  }

  /// Sections in the order of their ids.
  static std::vector<const FluentSection*> SortById(const std::vector<FluentSection>& sections);
  /// Checks that the ids of a section of faces or cells follow the last one of those before, and do
  /// not exceed the declared total; false with the error.
  bool CheckIds(const FluentSection& section, std::int64_t lastId, const FluentTotal& declared,
    const std::string& what);
  ///@{
  /// Replaces @a values by consecutive records of a stored section of faces or types of cells, or
  /// by the coordinates of nodes; @a first counts from 0. Throws a ScanError.
  virtual void LoadStored(const FluentSection& /*section*/, std::int64_t /*first*/,
    std::int64_t /*count*/, Buffer<std::int32_t>& /*values*/)
  {
  }
  virtual void LoadStored(const FluentSection& /*section*/, std::int64_t /*first*/,
    std::int64_t /*count*/, Buffer<double>& /*values*/)
  {
  }
  ///@}
  /// By which processes share the work of loading; nullptr if they do not.
  PieceExchange* Exchange = nullptr;

  /// Sets the error, unless there is one: "place: expected ..., found ...".
  void FailAt(
    const char* place, ErrorKind kind, const std::string& expected, const std::string& found);
  /// The same, with the word at the position as found.
  void FailAt(const char* place, ErrorKind kind, const std::string& expected);
  ///@{
  /// An error of the file as a whole; with another message behind its name.
  void Fail(ErrorKind kind, const std::string& expected, const std::string& found);
  void Fail(const ScanError& error);
  ///@}
  const ScanError& GetError() const { return this->Error; }
  /// Where the cell on a side of a face is, " (meshes/1/faces/c1/1[4])"; empty for other files.
  virtual std::string LocateCell(std::int64_t /*face*/, int /*side*/) const { return ""; }
  bool HasFailed() const { return static_cast<bool>(this->Error); }

protected:
  /// The name of the file and where in it a position is, for messages.
  virtual std::string Locate(const char* place) const = 0;

  std::string Name;
  const char* Begin;
  const char* End;
  int Dimension = 0;
  bool Swap = false;
  ScanError Error;
};

/**
 * Reads a piece of a file whose sections have been found.
 * @param boundaries if given, gets one block per face zone, except interior ones
 * @return false with the error in @a error, or without one if aborted; the outputs are then
 * incomplete
 */
bool ReadFluent(FluentFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress);
}

#endif
