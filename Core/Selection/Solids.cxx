// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/Solids.h"

#include "Geometry/HalfSpace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
double Square(double value)
{
  return value * value;
}
}

//------------------------------------------------------------------------------
BallSolid::BallSolid(const Vector& center, double radius, double tolerance)
  : Center(center)
  , SquaredRadius(radius >= 0 ? Square(radius + tolerance) : -1)
{
}

//------------------------------------------------------------------------------
bool BallSolid::MayMeet(const Bounds& box) const
{
  return box.GetSquaredDistance(this->Center) <= this->SquaredRadius;
}

//------------------------------------------------------------------------------
bool BallSolid::Meets(const CellBoundary& cell) const
{
  const std::vector<Simplex>& simplices = cell.GetSimplices();
  return std::any_of(simplices.begin(), simplices.end(), [this](const Simplex& simplex)
           { return GetSquaredDistance(this->Center, simplex) <= this->SquaredRadius; }) ||
    (this->SquaredRadius >= 0 && cell.Contains(this->Center));
}

//------------------------------------------------------------------------------
CylinderSolid::CylinderSolid(
  const Vector& center, const Vector& axis, double radius, double tolerance)
  : Center(center)
  , SquaredRadius(radius >= 0 ? Square(radius + tolerance) : -1)
{
  const Vector unit = Unit(axis);
  const Vector other = std::abs(unit.X) < 0.5 ? Vector{ 1, 0, 0 } : Vector{ 0, 1, 0 };
  this->Across[0] = Unit(Cross(unit, other));
  this->Across[1] = Cross(unit, this->Across[0]);
}

//------------------------------------------------------------------------------
bool CylinderSolid::MayMeet(const Bounds& box) const
{
  const double reach = std::sqrt(std::max(0.0, this->SquaredRadius)) + 0.5 * box.GetDiagonal();
  return Norm2(this->Project(box.GetCenter())) <= reach * reach;
}

//------------------------------------------------------------------------------
bool CylinderSolid::Meets(const CellBoundary& cell) const
{
  // An infinite cylinder does not fit into a cell.
  return std::any_of(cell.GetSimplices().begin(), cell.GetSimplices().end(),
    [this](const Simplex& simplex)
    {
      Simplex projected = simplex;
      for (int i = 0; i < simplex.Size; ++i)
      {
        projected.Points[i] = this->Project(simplex.Points[i]);
      }
      return GetSquaredDistance({ 0, 0, 0 }, projected) <= this->SquaredRadius;
    });
}

//------------------------------------------------------------------------------
HalfSpaceSolid::HalfSpaceSolid(
  const std::vector<HalfSpace>& halfSpaces, const Bounds& around, double tolerance)
  : HalfSpaces(halfSpaces)
  , Tolerance(tolerance)
{
  // If it is inside a cell, so is its largest ball.
  const Ball largest =
    FindLargestBall(this->HalfSpaces, 3, { around.GetCenter(), 0.5 * around.GetDiagonal() });
  this->Inside = largest.Center;
  this->HasInside = this->Contains(this->Inside);
}

//------------------------------------------------------------------------------
bool HalfSpaceSolid::MayMeet(const Bounds& box) const
{
  const Vector center = box.GetCenter(), half = 0.5 * (box.High - box.Low);
  return std::all_of(this->HalfSpaces.begin(), this->HalfSpaces.end(),
    [&](const HalfSpace& halfSpace)
    {
      const Vector& n = halfSpace.Normal;
      const double reach = std::abs(n.X) * half.X + std::abs(n.Y) * half.Y + std::abs(n.Z) * half.Z;
      return halfSpace.GetDistance(center) - reach <= this->Tolerance;
    });
}

//------------------------------------------------------------------------------
// Clips the simplex by one half-space after the other.
bool HalfSpaceSolid::Meets(const Simplex& simplex) const
{
  std::vector<Vector> polygon(simplex.Points, simplex.Points + simplex.Size), kept;
  for (const HalfSpace& halfSpace : this->HalfSpaces)
  {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Vector& point = polygon[i];
      const Vector& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const double distance = halfSpace.GetDistance(point);
      const double nextDistance = halfSpace.GetDistance(next);
      if (distance <= this->Tolerance)
      {
        kept.push_back(point);
      }
      if ((distance < -this->Tolerance && nextDistance > this->Tolerance) ||
        (distance > this->Tolerance && nextDistance < -this->Tolerance))
      {
        kept.push_back(point + (distance / (distance - nextDistance)) * (next - point));
      }
    }
    polygon.swap(kept);
  }
  return !polygon.empty();
}

//------------------------------------------------------------------------------
bool HalfSpaceSolid::Meets(const CellBoundary& cell) const
{
  const std::vector<Simplex>& simplices = cell.GetSimplices();
  return std::any_of(simplices.begin(), simplices.end(),
           [this](const Simplex& simplex) { return this->Meets(simplex); }) ||
    (this->HasInside && cell.Contains(this->Inside));
}

//------------------------------------------------------------------------------
SurfaceSolid::SurfaceSolid(std::vector<Simplex>&& triangles, double tolerance)
  : Tolerance(tolerance)
{
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.size());
  for (const Simplex& triangle : triangles)
  {
    boxes.push_back(triangle.GetBounds());
  }
  this->Tree.Build(boxes);
  this->Triangles.reserve(triangles.size());
  for (const std::size_t triangle : this->Tree.GetOrder())
  {
    this->Triangles.push_back(triangles[triangle]);
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
bool SurfaceSolid::FindAny(const Bounds& box, Visit&& visit) const
{
  return this->Tree.FindAny([&](const Bounds& around) { return around.Meets(box); },
    [&](std::size_t place) { return visit(this->Triangles[place]); });
}

//------------------------------------------------------------------------------
std::size_t SurfaceSolid::CountOpenEdges(const std::vector<Simplex>& triangles)
{
  using Edge = std::array<double, 6>;
  std::vector<Edge> edges;
  for (const Simplex& triangle : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector& a = triangle.Points[i];
      const Vector& b = triangle.Points[(i + 1) % 3];
      const std::array<double, 3> first = { { a.X, a.Y, a.Z } }, second = { { b.X, b.Y, b.Z } };
      const auto& low = std::min(first, second);
      const auto& high = std::max(first, second);
      if (low != high)
      {
        edges.push_back({ { low[0], low[1], low[2], high[0], high[1], high[2] } });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  for (std::size_t i = 0; i < edges.size();)
  {
    const std::size_t first = i;
    while (i < edges.size() && edges[i] == edges[first])
    {
      ++i;
    }
    open += (i - first) % 2;
  }
  return open;
}

//------------------------------------------------------------------------------
bool SurfaceSolid::Contains(const Vector& point) const
{
  Bounds around;
  around.Add(point);
  around.Grow(this->Tolerance);
  if (!this->MayMeet(around))
  {
    return false;
  }
  if (this->FindAny(around, [&](const Simplex& triangle)
        { return GetSquaredDistance(point, triangle) <= this->Tolerance * this->Tolerance; }))
  {
    return true;
  }
  Bounds way;
  way.Add(point);
  way.High.Z = Bounds::Infinity;
  bool isInside = false;
  this->FindAny(way,
    [&](const Simplex& triangle)
    {
      isInside = isInside != IsAbove(triangle, point);
      return false;
    });
  return isInside;
}

//------------------------------------------------------------------------------
bool SurfaceSolid::MayMeet(const Bounds& box) const
{
  Bounds larger = box;
  larger.Grow(this->Tolerance);
  return !this->Tree.IsEmpty() && this->Tree.GetBounds().Meets(larger);
}

//------------------------------------------------------------------------------
bool SurfaceSolid::Meets(const CellBoundary& cell) const
{
  // The surface intersects that of the cell, or is inside it; otherwise a vertex would be inside
  // the solid.
  Bounds box = cell.GetBounds();
  box.Grow(this->Tolerance);
  return this->FindAny(box,
    [&](const Simplex& triangle)
    {
      return std::any_of(cell.GetSimplices().begin(), cell.GetSimplices().end(),
               [&](const Simplex& simplex) { return Touch(simplex, triangle, this->Tolerance); }) ||
        cell.Contains(triangle.Points[0]);
    });
}

//------------------------------------------------------------------------------
bool SurfaceSolid::Crosses(const CellBoundary& cell) const
{
  return this->FindAny(cell.GetBounds(),
    [&](const Simplex& triangle)
    {
      const auto isOn = [&](const Simplex& simplex)
      {
        return GetSquaredDistance(triangle.Points[0], simplex) <= this->Tolerance * this->Tolerance;
      };
      const std::vector<Simplex>& simplices = cell.GetSimplices();
      return std::any_of(simplices.begin(), simplices.end(),
               [&](const Simplex& simplex) { return Pierce(simplex, triangle); }) ||
        (cell.Contains(triangle.Points[0]) &&
          std::none_of(simplices.begin(), simplices.end(), isOn));
    });
}
}
