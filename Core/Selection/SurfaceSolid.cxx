// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/SurfaceSolid.h"

#include <algorithm>
#include <array>

namespace camaron
{
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
