// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/CellMesh.h"

#include <algorithm>
#include <vector>

namespace camaron
{
//------------------------------------------------------------------------------
CellMesh MakeCloud(vtkIdType numberOfPoints)
{
  CellMesh mesh(numberOfPoints, numberOfPoints, VTK_VERTEX, 1);
  constexpr vtkIdType Grain = 65536;
  ParallelFor(numberOfPoints, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        mesh.Connectivity[i] = static_cast<std::int32_t>(i);
      }
    });
  return mesh;
}

//------------------------------------------------------------------------------
bool HasRepeatedPointsAnywhere(const std::int32_t* points, vtkIdType size)
{
  constexpr vtkIdType Few = 8; // for which comparing all pairs is fastest
  if (size <= Few)
  {
    for (vtkIdType i = 1; i < size; ++i)
    {
      for (vtkIdType j = 0; j < i; ++j)
      {
        if (points[i] == points[j])
        {
          return true;
        }
      }
    }
    return false;
  }
  thread_local std::vector<std::int32_t> scratch;
  scratch.assign(points, points + size);
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}
}
