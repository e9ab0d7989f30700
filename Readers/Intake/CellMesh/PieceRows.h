// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PieceRows
 * @brief Reads the cells of a piece from rows of text, one cell of the same type per row.
 *
 * Only the cells of the piece are stored. If it is not the whole mesh, all rows are read to check
 * them and to find the piece, once more for every level of ghosts, and finally those of the piece
 * to store them.
 */
#ifndef camaron_PieceRows_h
#define camaron_PieceRows_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Rows/TextRows.h"

namespace camaron
{
class PieceRows
{
public:
  /// Numbers of points and cells of the file, and type and size of the cells.
  struct Table
  {
    vtkIdType NumberOfPoints;
    vtkIdType NumberOfCells;
    unsigned char Type;
    std::int32_t Size;
  };

  /**
   * @param scanner where the rows begin, see RowSequence
   * @param lines of a text large enough for parallel reading, else nullptr
   */
  PieceRows(TextScanner& scanner, const TextLines* lines, const Table& table)
    : Rows(scanner, lines, table.NumberOfCells, RowLayout::OneLine)
    , Cells(table)
  {
  }

  /**
   * Finds the piece by @a visit(row, TextRow&, points), which reads the points of a cell, returns
   * false on errors, and must be thread-safe. False with the error in the scanner, or if stopped.
   * Reads nothing if the piece is the whole mesh.
   */
  template <typename Visit>
  bool Find(const PieceRequest& request, CellMeshPiece& piece, const Progress& progress,
    Visit&& visit) const;

  /**
   * Reads the cells of the piece into @a mesh by @a visit(row, TextRow&, points, cell), as above;
   * @a cell is the index in the piece. Moves the scanner behind all rows.
   */
  template <typename Visit>
  bool Read(
    const CellMeshPiece& piece, CellMesh& mesh, const Progress& progress, Visit&& visit) const;

private:
  static constexpr int MostPoints = 20; ///< of cells of one type

  RowSequence Rows;
  Table Cells;
};

//------------------------------------------------------------------------------
template <typename Visit>
bool PieceRows::Find(
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress, Visit&& visit) const
{
  return piece.Find(this->Cells.NumberOfPoints, this->Cells.NumberOfCells, request,
    [&]
    {
      return this->Rows.ForEach(progress,
        [&](vtkIdType row, vtkIdType, TextRow& text)
        {
          std::int32_t points[MostPoints];
          const bool good = visit(row, text, points);
          if (good)
          {
            piece.Visit(row, points, this->Cells.Size);
          }
          return good;
        });
    });
}

//------------------------------------------------------------------------------
template <typename Visit>
bool PieceRows::Read(
  const CellMeshPiece& piece, CellMesh& mesh, const Progress& progress, Visit&& visit) const
{
  const std::int32_t size = this->Cells.Size;
  mesh = CellMesh(piece.GetNumberOfPoints(), piece.GetNumberOfCells(), this->Cells.Type, size);
  return this->Rows.ForEach(progress,
    [&, isWhole = piece.IsWhole()](vtkIdType row, vtkIdType, TextRow& text)
    {
      const vtkIdType cell = piece.FindCell(row);
      if (cell < 0)
      {
        text.Skip();
        return true;
      }
      std::int32_t* const points = mesh.Connectivity.data() + size * cell;
      const bool good = visit(row, text, points, cell);
      for (std::int32_t i = 0; good && !isWhole && i < size; ++i)
      {
        points[i] = static_cast<std::int32_t>(piece.FindPoint(points[i]));
      }
      return good;
    });
}
}

#endif
