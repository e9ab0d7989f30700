// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeUniforms.h"

#include <algorithm>

namespace camaron
{
ShapeUniforms::ShapeUniforms(const ConvexShape& shape, const std::array<double, 3>& middle)
  : NumberOfPlanes(std::min(static_cast<int>(shape.Planes.size()), ConvexShape::MaxPlanes))
{
  const auto atMiddle = [&](const double* row)
  {
    return static_cast<float>(
      row[3] + row[0] * middle[0] + row[1] * middle[1] + row[2] * middle[2]);
  };
  for (int i = 0; i < this->NumberOfPlanes; ++i)
  {
    const double* plane = shape.Planes[i].data();
    std::copy_n(plane, 3, this->Planes[i]);
    this->Planes[i][3] = atMiddle(plane);
  }
  for (int row = 0; row < 4; ++row)
  {
    const double* from = &shape.ToUnitSphere[4 * row];
    for (int k = 0; k < 3; ++k)
    {
      this->ToUnitSphere[4 * k + row] = static_cast<float>(from[k]);
    }
    this->ToUnitSphere[12 + row] = atMiddle(from);
  }
}
}
