// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/LargestCircle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr double RelativePrecision = 1e-10;
constexpr int MaxSquares = 20000;
constexpr double RootOfTwo = 1.4142135623730951;
}

//------------------------------------------------------------------------------
Ball LargestCircle::Find(const std::vector<Vector>& polygon)
{
  this->Polygon = &polygon;
  this->Best = {};
  this->Squares.clear();
  if (polygon.size() < 3)
  {
    return this->Best;
  }
  Vector low = polygon[0], high = low;
  for (const Vector& point : polygon)
  {
    low = { std::min(low.X, point.X), std::min(low.Y, point.Y), 0 };
    high = { std::max(high.X, point.X), std::max(high.Y, point.Y), 0 };
  }
  this->Around = { 0.5 * (low + high), 0.5 * Norm(high - low) };
  this->Precision = RelativePrecision * this->Around.Radius;
  this->AddSquare(this->Around.Center, 0.5 * std::max(high.X - low.X, high.Y - low.Y));
  for (int i = 0; i < MaxSquares && !this->Squares.empty(); ++i)
  {
    std::pop_heap(this->Squares.begin(), this->Squares.end());
    const Square square = this->Squares.back();
    this->Squares.pop_back();
    if (square.Bound <= this->Best.Radius + this->Precision)
    {
      break;
    }
    const double half = 0.5 * square.Half;
    for (const double x : { -half, half })
    {
      for (const double y : { -half, half })
      {
        this->AddSquare(square.Center + Vector{ x, y, 0 }, half);
      }
    }
  }
  return this->Best;
}

//------------------------------------------------------------------------------
// Distance from the nearest edge, negative outside.
double LargestCircle::GetSignedDistance(const Vector& point) const
{
  const std::vector<Vector>& polygon = *this->Polygon;
  double nearest = std::numeric_limits<double>::infinity();
  bool isInside = false;
  Vector a = polygon.back() - point;
  for (const Vector& corner : polygon)
  {
    const Vector b = corner - point, edge = b - a;
    const double square = Norm2(edge);
    const double t = square > 0 ? std::clamp(-Dot(a, edge) / square, 0.0, 1.0) : 0;
    nearest = std::min(nearest, Norm2(a + t * edge));
    if ((a.Y > 0) != (b.Y > 0) && (a.X * edge.Y - a.Y * edge.X > 0) == (edge.Y > 0))
    {
      isInside = !isInside;
    }
    a = b;
  }
  return isInside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

//------------------------------------------------------------------------------
void LargestCircle::Try(const Vector& center)
{
  const double distance = this->GetSignedDistance(center);
  if (distance > this->Best.Radius)
  {
    this->Best = { center, distance };
  }
}

//------------------------------------------------------------------------------
void LargestCircle::AddSquare(const Vector& center, double half)
{
  const double distance = this->GetSignedDistance(center);
  if (distance > this->Best.Radius)
  {
    this->Best = { center, distance };
  }
  double bound = distance + RootOfTwo * half;
  if (bound <= this->Best.Radius + this->Precision)
  {
    return;
  }
  this->FindFeatures(center, half);
  const Ball between = FindLargestBall(this->Features, 2, this->Around);
  bound = std::min(bound, between.Radius);
  if (Norm2(between.Center - this->Around.Center) < this->Around.Radius * this->Around.Radius)
  {
    this->Try(between.Center);
  }
  if (bound > this->Best.Radius + this->Precision)
  {
    this->Squares.push_back({ center, half, bound });
    std::push_heap(this->Squares.begin(), this->Squares.end());
  }
}

//------------------------------------------------------------------------------
// Linear functions that the distance from the boundary does not exceed anywhere in the square:
// those of edges over all of which the square lies to one side, and tangents of the distance from
// corners, raised by what that distance may bend.
void LargestCircle::FindFeatures(const Vector& center, double half)
{
  this->Features.clear();
  const std::vector<Vector>& polygon = *this->Polygon;
  const std::size_t size = polygon.size();
  const double reach = RootOfTwo * half;
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector &a = polygon[i], edge = polygon[i + 1 < size ? i + 1 : 0] - a;
    const double length = Norm(edge);
    const Vector fromCorner = center - a;
    const double distance = Norm(fromCorner);
    if (distance > reach)
    {
      const Vector normal = (-1 / distance) * fromCorner;
      this->Features.push_back(
        { normal, Dot(normal, center) + distance + 0.5 * reach * reach / distance });
    }
    if (length > 0)
    {
      const Vector along = (1 / length) * edge;
      const double extent = half * (std::abs(along.X) + std::abs(along.Y));
      const double position = Dot(fromCorner, along);
      const double height = along.X * fromCorner.Y - along.Y * fromCorner.X;
      if (position >= extent && position + extent <= length && std::abs(height) >= extent)
      {
        const Vector inward =
          height > 0 ? Vector{ -along.Y, along.X, 0 } : Vector{ along.Y, -along.X, 0 };
        this->Features.push_back({ -inward, -Dot(inward, a) });
      }
    }
  }
}
}
