// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellMesh.h"

#include "Base/Parallel.h"
#include "Intake/Ids/RepeatedIds.h"

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
void FindRepeatedPoints(const std::int32_t* points, const std::int32_t* offsets, std::int32_t size,
  vtkIdType first, vtkIdType count, Tally& repeating)
{
  for (vtkIdType i = 0; i < count && !offsets; ++i)
  {
    if (HasRepeatedIds(points + i * size, size))
    {
      repeating.Add(first + i);
    }
  }
  for (vtkIdType i = 0; i < count && offsets; ++i)
  {
    const std::int32_t* const p = points + (offsets[i] - offsets[0]);
    const std::int32_t length = offsets[i + 1] - offsets[i];
    bool repeats = false;
    if (length == 3 || length == 4)
    {
      // Avoids a branch on the size, because both sizes are often mixed: -1 if three.
      const std::int32_t fourth = p[length - 1] | (length - 4);
      repeats = p[0] == p[1] || p[0] == p[2] || p[1] == p[2] || fourth == p[0] || fourth == p[1] ||
        fourth == p[2];
    }
    else
    {
      repeats = HasRepeatedIds(p, length);
    }
    if (repeats)
    {
      repeating.Add(first + i);
    }
  }
}
}
