// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/LargestCircle.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double RelativePrecision = 1e-10;
constexpr int MaxSquares = 20000;
constexpr double RootOfTwo = 1.4142135623730951;
constexpr double Rounding = 1 + 1e-6; // of distances that others are derived from
/// For up to this many, all edges of a polygon are tested.
constexpr std::size_t FewEdges = 64;
}

//------------------------------------------------------------------------------
Ball LargestCircle::Find(const std::vector<Vector>& polygon)
{
  this->Outline.Build(polygon);
  this->Best = {};
  this->Squares.clear();
  if (polygon.size() < 3)
  {
    return this->Best;
  }
  Bounds box;
  for (const Vector& point : polygon)
  {
    box.Add(point);
  }
  this->Around = { box.GetCenter(), 0.5 * box.GetDiagonal() };
  this->Precision = RelativePrecision * this->Around.Radius;
  const Vector size = box.High - box.Low;
  this->AddSquare(this->Around.Center, 0.5 * std::max(size.X, size.Y), 2 * this->Around.Radius);
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
        this->AddSquare(
          square.Center + Vector{ x, y, 0 }, half, square.Distance + RootOfTwo * half);
      }
    }
  }
  return this->Best;
}

//------------------------------------------------------------------------------
double LargestCircle::Try(const Vector& center, double limit)
{
  const double distance = this->Outline.GetSignedDistance(center, limit * Rounding);
  if (distance > this->Best.Radius)
  {
    this->Best = { center, distance };
  }
  return distance;
}

//------------------------------------------------------------------------------
// @param limit an upper limit of the distance of the center from the outline
void LargestCircle::AddSquare(const Vector& center, double half, double limit)
{
  const double distance = this->Try(center, limit);
  double bound = distance + RootOfTwo * half;
  if (bound <= this->Best.Radius + this->Precision)
  {
    return;
  }
  this->FindFeatures(center, half, std::abs(distance));
  const Ball between = FindLargestBall(this->Features, 2, this->Around);
  bound = std::min(bound, between.Radius);
  if (Norm2(between.Center - this->Around.Center) < this->Around.Radius * this->Around.Radius)
  {
    this->Try(between.Center, std::abs(distance) + Norm(between.Center - center));
  }
  if (bound > this->Best.Radius + this->Precision)
  {
    this->Squares.push_back({ center, half, std::abs(distance), bound });
    std::push_heap(this->Squares.begin(), this->Squares.end());
  }
}

//------------------------------------------------------------------------------
// Linear functions that bound the distance from the outline everywhere in the square: those of
// edges whose normal strip contains the square on one side, and tangents of the distance from
// vertices, raised by the maximum curvature of that distance. Of many edges, those nearest to some
// position of the square count.
void LargestCircle::FindFeatures(const Vector& center, double half, double nearest)
{
  this->Features.clear();
  const double reach = RootOfTwo * half;
  const double farthest =
    this->Outline.GetSize() > FewEdges ? Rounding * (nearest + 2 * reach) : 4 * this->Around.Radius;
  this->Outline.ForEachNear(center, farthest, [&](std::size_t i)
    { this->AddFeatures(center, half, this->Outline.GetBegin(i), this->Outline.GetEnd(i)); });
}

//------------------------------------------------------------------------------
void LargestCircle::AddFeatures(const Vector& center, double half, const Vector& a, const Vector& b)
{
  const double reach = RootOfTwo * half;
  const Vector edge = b - a, fromCorner = center - a;
  const double length = Norm(edge), distance = Norm(fromCorner);
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
