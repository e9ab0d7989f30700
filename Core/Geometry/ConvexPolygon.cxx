// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ConvexPolygon.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
void ConvexPolygon::SetBox(const Vector& low, const Vector& high)
{
  this->Points = { { low.X, low.Y, 0 }, { high.X, low.Y, 0 }, { high.X, high.Y, 0 },
    { low.X, high.Y, 0 } };
}

//------------------------------------------------------------------------------
void ConvexPolygon::Clip(const HalfSpace& halfPlane, double tolerance)
{
  this->Distances.clear();
  for (const Vector& point : this->Points)
  {
    this->Distances.push_back(halfPlane.GetDistance(point));
  }
  const auto [low, high] = std::minmax_element(this->Distances.begin(), this->Distances.end());
  if (this->Points.empty() || *high <= tolerance)
  {
    return;
  }
  if (*low >= -tolerance)
  {
    this->Points.clear();
    return;
  }
  this->Kept.clear();
  const std::size_t size = this->Points.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t next = i + 1 < size ? i + 1 : 0;
    const double here = this->Distances[i], there = this->Distances[next];
    if (here <= tolerance)
    {
      this->Kept.push_back(this->Points[i]);
    }
    if ((here < -tolerance && there > tolerance) || (here > tolerance && there < -tolerance))
    {
      this->Kept.push_back(
        this->Points[i] + (here / (here - there)) * (this->Points[next] - this->Points[i]));
    }
  }
  std::swap(this->Points, this->Kept);
}

//------------------------------------------------------------------------------
double ConvexPolygon::GetArea() const
{
  double sum = 0;
  for (std::size_t i = 2; i < this->Points.size(); ++i)
  {
    sum += Cross(this->Points[i - 1] - this->Points[0], this->Points[i] - this->Points[0]).Z;
  }
  return 0.5 * sum;
}
}
