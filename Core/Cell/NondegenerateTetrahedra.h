// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::NondegenerateTetrahedra
 * @brief A block of consecutive cells, of which those VTK_TETRA are evaluated that are sound:
 * nothing in them is collapsed, flat, huge or not a number, and solid angles need no second way
 * where they are asked for.
 *
 * So formulas need not look for what is undefined, and take two cells at a time. Makes no topology.
 * Values do not depend on how a mesh is cut into blocks.
 */
#ifndef camaron_NondegenerateTetrahedra_h
#define camaron_NondegenerateTetrahedra_h

#include "Cell/CellGeometry.h"
#include "Cell/TetrahedronPair.h"

namespace camaron
{
class NondegenerateTetrahedra
{
public:
  static constexpr int Size = TetrahedronBlock::Size;

  /// Takes up to Size cells from @a first on, with the angles that a combination of Needs names;
  /// returns how many of them are sound.
  int Load(const MeshView& mesh, vtkIdType first, int numberOfCells,
    const EvaluationOptions& options, unsigned needs);

  /// False if the cell is something else than a tetrahedron, or so close to it that CellGeometry
  /// has to tell.
  bool IsSound(int cell) const { return this->AreSound[cell] != 0; }

  /// Fills Size values with formula(const TetrahedronPair&); those of cells that are not sound mean
  /// nothing.
  template <typename Formula>
  void Evaluate(Formula&& formula, double* values) const
  {
    for (int cell = 0; cell < Size; cell += 2)
    {
      StorePair(formula(TetrahedronPair(this->Block, cell)), values + cell);
    }
  }

private:
  /// Returns the number of tetrahedra.
  template <typename Coordinate>
  int LoadPoints(
    const MeshView& mesh, const Coordinate* points, vtkIdType first, int numberOfCells);
  /// Loads all cells from the ids of their corners, four of each cell.
  template <typename Coordinate, typename Id>
  void LoadCells(const Coordinate* points, const Id* corners);
  void FindSound(const EvaluationOptions& options);
  void ComputeAngles(unsigned needs);

  TetrahedronBlock Block = {}; // what was not loaded has to be numbers, too
  double Places[Size]; // sums of the absolute coordinates of first points; NaN where there is none
  double AreSound[Size]; // 1 or 0
};
}

#endif
