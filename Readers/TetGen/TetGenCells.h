// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetGenCells
 * @brief A table of cells of one type: a .ele, .face or .edge file, or the segments of a .poly
 * file.
 *
 * To read a piece, all rows are checked, but only its own are kept.
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
  /// The first line, and properties of the first row.
  struct Header
  {
    std::int64_t Count = 0;
    int NumberOfNodes = 4;
    int Corners = 4;
    TetGenColumns::Layout Columns;
  };
  /// @param kind of the table: Ele, Face, or Edge, also for segments
  static bool ReadHeader(TextScanner& scanner, TetGenKind kind, Header& header,
    ErrorKind notThis = ErrorKind::NotThisFormat);

  explicit TetGenCells(TetGenKind kind)
    : Kind(kind)
  {
  }

  /// Keeps the ids of all cells, not only of the piece.
  void KeepAllIds() { this->KeepsIds = true; }
  /// Reads the table from its header to its end, and determines @a piece.
  bool Read(TextScanner& scanner, const TextLines* lines, const TetGenNodes& nodes,
    const PieceRequest& request, CellMeshPiece& piece, const Progress& progress,
    ErrorKind notThis = ErrorKind::NotThisFormat);

  int GetNumberOfCorners() const { return this->Table.Corners; }
  /// Whether cells have midside nodes; they are still in the order of the file.
  bool IsQuadratic() const { return this->Table.NumberOfNodes > this->Table.Corners; }
  /// Number of cells in the file.
  vtkIdType GetCount() const { return this->Table.Count; }
  /// The cells of the piece.
  CellMesh& GetMesh() { return this->Mesh; }
  /// Nodes of the first cell of the file.
  const std::vector<std::int32_t>& GetFirstCell() const { return this->FirstCell; }
  /// Of all cells; only if they are kept.
  const Buffer<std::int32_t>& GetAllIds() const { return this->IsWhole ? this->Ids : this->AllIds; }

  /// Adds "Region", "attr_i", "BoundaryMarker", "Tetrahedra", and "OriginalCellId" unless ids count
  /// from 0.
  void AddArrays(vtkUnstructuredGrid* grid);
  void Warn(Warnings& warnings) const;

private:
  bool HasMidpoints(TextScanner scanner, const TetGenNodes& nodes) const;
  bool ReadHeaderAndColumns(TextScanner& scanner, const TetGenNodes& nodes, ErrorKind notThis);
  bool ReadRow(
    TextRow& row, vtkIdType number, const TetGenNodes& nodes, std::int32_t* points, vtkIdType cell);

  TetGenKind Kind;
  Header Table;
  CellMesh Mesh;
  Buffer<std::int32_t> Ids; ///< of the cells of the piece
  std::atomic<bool> CountsFromZero{ true };
  std::vector<std::int32_t> FirstCell;
  TetGenColumns Columns;

  bool IsWhole = true;
  bool KeepsIds = false;
  Buffer<std::int32_t> AllIds;
};
}

#endif
