// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PolygonTriangles.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
const std::vector<PolygonTriangulator::Triangle>& PolygonTriangles::Cut(
  const vtkIdType* points, vtkIdType size)
{
  this->Corners.resize(size);
  std::transform(points, points + size, this->Corners.begin(),
    [this](vtkIdType id) { return this->Mesh.GetPoint(id); });
  this->Triangulator.Cut(this->Corners.data(), static_cast<int>(size));
  return this->Triangulator.GetTriangles();
}
}
