// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/CellMesh.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasRepeated(const std::int32_t* points, vtkIdType size, std::vector<std::int32_t>& scratch)
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
  scratch.assign(points, points + size);
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}
}

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
void WarnOfRepeatedPoints(const CellMesh& mesh, Warnings& warnings, const Progress& progress,
  const char* one, const char* many)
{
  Tally repeated;
  std::mutex mutex;
  constexpr vtkIdType Block = 4096;
  progress.For((mesh.NumberOfCells + Block - 1) / Block,
    [&](vtkIdType first, vtkIdType last)
    {
      Tally local;
      std::vector<std::int32_t> scratch;
      const vtkIdType end = std::min(last * Block, mesh.NumberOfCells);
      for (vtkIdType cell = first * Block; cell < end; ++cell)
      {
        if (HasRepeated(mesh.GetPoints(cell), mesh.GetSize(cell), scratch))
        {
          local.Add(cell);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      repeated.Merge(local);
    });
  warnings.Add(repeated, one, many, "with the same point more than once");
}
}
