// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FirstPoint.h
 * @brief Order of points by coordinates, then by id, which is the same on all ranks.
 */
#ifndef camaron_FirstPoint_h
#define camaron_FirstPoint_h

#include "Mesh/MeshView.h"

namespace camaron
{
inline bool IsBefore(const MeshView& mesh, vtkIdType a, vtkIdType b)
{
  double p[3], q[3];
  mesh.GetPoint(a, p);
  mesh.GetPoint(b, q);
  for (int i = 0; i < 3; ++i)
  {
    if (p[i] != q[i])
    {
      return p[i] < q[i];
    }
  }
  return a < b;
}

/// The position of the first point in a list of points.
inline vtkIdType FindFirstPoint(const MeshView& mesh, const vtkIdType* points, vtkIdType size)
{
  vtkIdType first = 0;
  for (vtkIdType i = 1; i < size; ++i)
  {
    first = IsBefore(mesh, points[i], points[first]) ? i : first;
  }
  return first;
}
}

#endif
