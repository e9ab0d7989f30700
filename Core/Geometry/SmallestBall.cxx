// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/HalfSpace.h"

#include <cstdint>
#include <utility>

namespace camaron
{
namespace
{
constexpr int MaxSupport = 4;
constexpr double RadiusTolerance = 1e-12; // of squared radii

//------------------------------------------------------------------------------
bool Contains(const Ball& ball, const Vector& point)
{
  return Norm2(point - ball.Center) <= (1 + RadiusTolerance) * ball.Radius * ball.Radius;
}

//------------------------------------------------------------------------------
// Smallest ball through all of up to four points. Points that do not span a simplex have no such
// ball; the result is then arbitrary, and FindBall does not use it again.
Ball GetBallThrough(const Vector* points, int size)
{
  if (size == 0)
  {
    return { {}, -1 };
  }
  const Vector& p = points[0];
  Vector offset; // of the center from p
  if (size == 2)
  {
    offset = 0.5 * (points[1] - p);
  }
  else if (size > 2)
  {
    const Vector a = points[1] - p, b = points[2] - p, ab = Cross(a, b);
    const double area = Norm2(ab);
    if (size == 4)
    {
      const Vector c = points[3] - p;
      const double volume = Dot(ab, c);
      if (volume != 0)
      {
        offset = (0.5 / volume) * (Norm2(c) * ab + Norm2(a) * Cross(b, c) + Norm2(b) * Cross(c, a));
      }
    }
    else if (area > 0)
    {
      offset = (0.5 / area) * Cross(Norm2(a) * b - Norm2(b) * a, ab);
    }
  }
  return { p + offset, Norm(offset) };
}

//------------------------------------------------------------------------------
// Smallest ball around the first points that passes through those of the support.
Ball FindBall(const std::vector<Vector>& points, std::size_t size, Vector* support, int supportSize)
{
  Ball ball = GetBallThrough(support, supportSize);
  for (std::size_t i = 0; supportSize < MaxSupport && i < size; ++i)
  {
    if (ball.Radius < 0 || !Contains(ball, points[i]))
    {
      support[supportSize] = points[i];
      ball = FindBall(points, i, support, supportSize + 1);
    }
  }
  return ball;
}
}

//------------------------------------------------------------------------------
Ball FindSmallestBall(std::vector<Vector>& points)
{
  if (points.empty())
  {
    return {};
  }
  std::uint64_t random = 1;
  for (std::size_t i = points.size(); i-- > 1;)
  {
    random = random * 6364136223846793005u + 1442695040888963407u; // Knuth, MMIX
    std::swap(points[i], points[(random >> 33) % (i + 1)]);
  }
  Vector support[MaxSupport];
  return FindBall(points, points.size(), support, 0);
}
}
