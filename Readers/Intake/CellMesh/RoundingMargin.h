// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RoundingMargin
 * @brief Finds cells that keep their shape however their coordinates are rounded.
 *
 * Rounding moves a point by at most a distance that follows from its coordinates. A cell is safe if
 * its edges and its volume are large compared with this distance. Nearly all cells of most meshes
 * are, and this takes a tenth of the time of rounding their points and comparing; cells that are
 * not safe may keep their shape, too. Holds scratch memory: use one object per thread.
 */
#ifndef camaron_RoundingMargin_h
#define camaron_RoundingMargin_h

#include "Base/VectorPair.h"
#include "Mesh/CellFacets.h"

namespace camaron
{
/// Rounding changes a number by at most Relative times its magnitude plus Absolute, if its
/// magnitude is less than Greatest.
struct Rounding
{
  double Relative, Absolute, Greatest;
};

class RoundingMargin
{
public:
  /// @param maxChange relative change of the length of an edge with which a cell keeps its shape
  RoundingMargin(const MeshView& mesh, const Rounding& rounding, double maxChange);

  /// Whether the lengths of all edges of a cell change by less than the maximum, and the sign of
  /// the volume of a 3D cell does not change.
  bool IsSafe(vtkIdType cell) { return this->AreSafe(cell, cell + 1); }
  /// The same for the cells [begin, end).
  bool AreSafe(vtkIdType begin, vtkIdType end);

private:
  struct Limits
  {
    Rounding Shift;       ///< of a point, by its distance from zero
    double ShiftsPerEdge; ///< so much longer than a shift is an edge
  };
  class Extent;
  static constexpr int MaxCorners = 12; ///< of a standard cell

  bool ArePairSafe(const CellShape& shape, const IndexRange& first, const IndexRange& second);
  bool IsOtherSafe(vtkIdType cell);

  const MeshView& Mesh;
  CellFacets Facets;
  const CellShape* Shapes;
  Limits Least;
  VectorPair Corners[MaxCorners]; ///< of two cells
};
}

#endif
