// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PointRows
 * @brief Coordinates of points in text, one point per line, before the cells.
 *
 * The points of a piece follow from its cells, so the rows are skipped first and read later.
 */
#ifndef camaron_PointRows_h
#define camaron_PointRows_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Rows/TextRows.h"

#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

namespace camaron
{
class PointRows
{
public:
  /**
   * @param scanner where the rows begin, see RowSequence
   * @param lines of a text large enough for parallel reading, else nullptr
   * @param what description of a number for errors, e.g. "a coordinate of a vertex"
   */
  PointRows(TextScanner& scanner, const TextLines* lines, vtkIdType count, const char* what)
    : Rows(scanner, lines, count, RowLayout::OneLine)
    , What(what)
  {
  }

  /// Moves the scanner behind the rows; false with the error in the scanner, or if stopped.
  bool Skip(const Progress& progress) const
  {
    return this->Rows.Skip(progress,
      [this](vtkIdType, vtkIdType, TextRow& row)
      {
        double x[3];
        return row.ReadPoint(x, this->What);
      });
  }

  /// Passes all points.
  bool ForEach(const PieceOfSpace::Visit& visit, const Progress& progress) const
  {
    return this->Rows.ForEach(progress,
      [&](vtkIdType i, vtkIdType, TextRow& row)
      {
        double x[3];
        const bool good = row.ReadPoint(x, this->What);
        if (good)
        {
          visit(i, x);
        }
        return good;
      });
  }

  /// Coordinates of the points of a piece, in its order; nullptr if rows that were skipped as lines
  /// are invalid, or if stopped.
  vtkSmartPointer<vtkDataArray> Read(const CellMeshPiece& piece, const Progress& progress) const
  {
    Buffer<double> coordinates(3 * piece.GetNumberOfPoints());
    const bool good = this->Rows.ForEach(progress,
      [&](vtkIdType i, vtkIdType, TextRow& row)
      {
        double unused[3];
        const vtkIdType point = piece.FindPoint(i);
        return row.ReadPoint(point < 0 ? unused : coordinates.data() + 3 * point, this->What);
      });
    return good ? coordinates.TakeArray<vtkDoubleArray>(3) : nullptr;
  }

private:
  RowSequence Rows;
  const char* What;
};
}

#endif
