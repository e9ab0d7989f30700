// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::NondegenerateTetrahedra
 * @brief Evaluates the regular case of VTK_TETRA in a block of consecutive cells, two at a time.
 *
 * Only takes sound tetrahedra: no edge is collapsed, the cell is neither flat nor extremely large,
 * all coordinates are finite, and solid angles, if requested, need no special treatment. Formulas
 * for them need no topology and no tests for undefined values; all other cells are left to
 * CellGeometry. Values do not depend on how a mesh is divided into blocks.
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

  /// Loads up to Size cells from @a first on, with the angles named by a combination of Needs;
  /// returns the number of sound tetrahedra.
  int Load(const MeshView& mesh, vtkIdType first, int numberOfCells,
    const EvaluationOptions& options, unsigned needs);

  /// False unless the cell is a sound tetrahedron; CellGeometry must evaluate it then.
  bool IsSound(int cell) const { return this->AreSound[cell] != 0; }

  /// Fills Size values with formula(const TetrahedronPair&). The values of cells that are not sound
  /// are meaningless.
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
  /// Loads all cells from the point ids of their vertices, four per cell.
  template <typename Coordinate, typename Id>
  void LoadCells(const Coordinate* points, const Id* corners);
  void FindSound(const EvaluationOptions& options);
  void ComputeAngles(unsigned needs);

  TetrahedronBlock Block = {}; // initialized, because unloaded lanes are computed, too
  double Places[Size];   // sums of the absolute coordinates of first points; NaN for other cells
  double AreSound[Size]; // 1 or 0
};
}

#endif
