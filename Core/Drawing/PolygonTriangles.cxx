// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PolygonTriangles.h"

namespace camaron
{
//------------------------------------------------------------------------------
const std::vector<PolygonTriangulator::Triangle>& PolygonTriangles::Cut(
  const vtkIdType* points, vtkIdType size)
{
  this->Corners.resize(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    double x[3];
    this->Mesh.GetPoint(points[i], x);
    this->Corners[i] = { x[0], x[1], x[2] };
  }
  this->Triangulator.Cut(this->Corners.data(), static_cast<int>(size));
  return this->Triangulator.GetTriangles();
}
}
