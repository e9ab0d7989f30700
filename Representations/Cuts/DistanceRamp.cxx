// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceRamp.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>

namespace camaron
{
namespace
{
// The height or depth as the distance from a plane: a x + b y + c z + d.
std::array<double, 4> GetPlane(const InspectionStyle& style, vtkMatrix4x4* toView)
{
  std::array<double, 4> plane = { { 0, 0, 0, 0 } };
  if (style.ColorBy == Coloring::Depth)
  {
    for (int i = 0; i < 4; ++i)
    {
      plane[i] = -toView->GetElement(2, i);
    }
    return plane;
  }
  std::copy(style.HeightDirection.begin(), style.HeightDirection.end(), plane.begin());
  if (vtkMath::Normalize(plane.data()) == 0.0)
  {
    plane[2] = 1;
  }
  return plane;
}

// The smallest and the largest distance of the corners of a box.
std::array<double, 2> GetRange(const std::array<double, 4>& plane, const double bounds[6])
{
  std::array<double, 2> range = { { plane[3], plane[3] } };
  for (int i = 0; i < 3; ++i)
  {
    const double low = plane[i] * bounds[2 * i];
    const double high = plane[i] * bounds[2 * i + 1];
    range[0] += std::min(low, high);
    range[1] += std::max(low, high);
  }
  return range;
}
}

//------------------------------------------------------------------------------
std::array<double, 4> GetDistanceRamp(const InspectionStyle& style, const double bounds[6],
  const std::array<double, 3>& middle, vtkMatrix4x4* toView)
{
  std::array<double, 4> plane = GetPlane(style, toView);
  std::array<double, 2> range = style.CustomColorRange ? style.ColorRange : GetRange(plane, bounds);
  if (!style.CustomColorRange && style.ColorBy == Coloring::Depth)
  {
    range[0] = std::max(range[0], 0.0); // nothing is visible behind the eye
  }
  for (int i = 0; i < 3; ++i)
  {
    plane[3] += plane[i] * middle[i];
  }
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  plane[3] -= range[0];
  for (double& coefficient : plane)
  {
    coefficient /= width;
  }
  return plane;
}
}
