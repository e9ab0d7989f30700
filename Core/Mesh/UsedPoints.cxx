// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/UsedPoints.h"

namespace camaron
{
//------------------------------------------------------------------------------
std::vector<bool> FindUsedPoints(const MeshView& mesh)
{
  const vtkIdType numberOfPoints = mesh.GetNumberOfPoints();
  std::vector<bool> areUsed(static_cast<std::size_t>(numberOfPoints));
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    const vtkIdType size = mesh.GetCellType(cell) == VTK_EMPTY_CELL ? 0 : points.Size;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType point = points[i];
      if (point >= 0 && point < numberOfPoints)
      {
        areUsed[static_cast<std::size_t>(point)] = true;
      }
    }
  }
  return areUsed;
}
}
