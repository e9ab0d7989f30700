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

#include "vtkSmartPointer.h"

class vtkDataArray;

namespace camaron
{
class PointRows
{
public:
  /**
   * @param scanner where the rows begin
   * @param lines of a text large enough for parallel reading, else nullptr
   * @param what description of a number for errors, e.g. "a coordinate of a vertex"
   */
  PointRows(const TextScanner& scanner, const TextLines* lines, vtkIdType count, const char* what)
    : Start(scanner)
    , Lines(lines)
    , Count(count)
    , What(what)
  {
  }

  /// Moves a scanner behind the rows; false with the error in the scanner, or if stopped.
  bool Skip(TextScanner& scanner, const Progress& progress);

  /// Passes all points; they must be in lines if there are lines.
  bool ForEach(const PieceOfSpace::Visit& visit, const Progress& progress) const;

  /**
   * Coordinates of the points of a piece, in its order; nullptr if stopped, or if rows that were
   * skipped as lines are invalid.
   */
  vtkSmartPointer<vtkDataArray> Read(const CellMeshPiece& piece, const Progress& progress) const;

private:
  TextScanner Start;
  const TextLines* Lines;
  vtkIdType Count;
  const char* What;
  const char* End = nullptr; ///< of the skipped rows
};
}

#endif
