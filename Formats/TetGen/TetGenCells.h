// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenCells
 * @brief A table of cells of one kind: a .ele, .face or .edge file, or the segments of a .poly
 * file.
 *
 * The points of all cells are read at once; for a piece, which of them it has is known then, and
 * the values of its cells are read in a second pass.
 */
#ifndef camaron_TetGenCells_h
#define camaron_TetGenCells_h

#include "TetGenFiles.h"
#include "TetGenNodes.h"

namespace camaron
{
class TetGenCells
{
public:
  /// The first line, and what follows from the first row.
  struct Header
  {
    std::int64_t Count = 0;
    int NumberOfNodes = 4;
    int Corners = 4;
    TetGenColumns::Layout Columns;
  };
  /// @a kind is that of the table: Ele, Face, or Edge for segments too.
  static bool ReadHeader(TextScanner& scanner, TetGenKind kind, Header& header,
    ErrorKind notThis = ErrorKind::NotThisFormat);
  /// Whether the scanner is at a row that fits the header. Reports nothing.
  static bool IsRow(TextScanner scanner, const Header& header);

  explicit TetGenCells(TetGenKind kind)
    : Kind(kind)
  {
  }

  /// Reads the table from its header to its end; with all values if @a whole.
  bool Read(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes, bool whole,
    const Progress& progress, ErrorKind notThis = ErrorKind::NotThisFormat);
  /// Whether there is something to read for a piece.
  bool HasValues() const { return !this->Table.Columns.IsEmpty(); }
  /// Reads the values of the cells of a piece, the scanner being where it was for Read.
  bool ReadValues(
    TextScanner& scanner, const TextLines* lines, const CellPiece& piece, const Progress& progress);

  int GetNumberOfCorners() const { return this->Table.Corners; }
  /// Whether cells have nodes on their edges, which are in the order of the file.
  bool IsQuadratic() const { return this->Table.NumberOfNodes > this->Table.Corners; }
  CellMesh& GetMesh() { return this->Mesh; }
  const Buffer<std::int32_t>& GetIds() const { return this->Ids; }

  /// Adds "Region", "attr_i", "BoundaryMarker", "Tetrahedra", and "OriginalCellId" unless ids count
  /// from 0.
  void AddArrays(vtkUnstructuredGrid* grid, const CellPiece& piece);
  void Warn(Warnings& warnings) const;

private:
  bool HasMidpoints(TextScanner scanner, const TetGenNodes& nodes) const;
  bool ReadRow(TextRow& row, vtkIdType number, const TetGenNodes& nodes);

  TetGenKind Kind;
  Header Table;
  CellMesh Mesh;
  Buffer<std::int32_t> Ids;
  TetGenColumns Columns;
};
}

#endif
