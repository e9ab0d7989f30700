// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CollapsedCells
 * @brief Finds the cells of higher order that are drawn as what remains of them: those that list
 * corners more than once, such as a quadratic tetrahedron written as a hexahedron.
 *
 * Holds scratch memory: use one object per thread.
 */
#ifndef camaron_CollapsedCells_h
#define camaron_CollapsedCells_h

#include "Cell/CellGeometry.h"
#include "Curved/CollapsedShape.h"
#include "Mesh/MeshView.h"

namespace camaron
{
class CollapsedCells
{
public:
  explicit CollapsedCells(const MeshView& mesh)
    : Mesh(mesh)
  {
  }

  /// nullptr for other cells.
  const CollapsedShape* Find(vtkIdType cell)
  {
    if (!this->RepeatsCorners(cell))
    {
      return nullptr;
    }
    this->Geometry.Load(this->Mesh, cell, this->Options);
    return this->Geometry.GetCollapsedShape();
  }

private:
  bool RepeatsCorners(vtkIdType cell) const
  {
    const CellShape& shape = GetCellShape(this->Mesh.GetCellType(cell));
    const IndexRange nodes = this->Mesh.GetCellPoints(cell);
    for (int i = 1; shape.IsHigherOrder && i < shape.NumberOfCorners; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        if (nodes[i] == nodes[j])
        {
          return true;
        }
      }
    }
    return false;
  }

  const MeshView& Mesh;
  const EvaluationOptions Options;
  CellGeometry Geometry;
};
}

#endif
