// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/SurfaceSolid.h"

#include <algorithm>
#include <array>
#include <utility>

namespace camaron
{
namespace
{
constexpr std::size_t TrianglesPerLeaf = 4;
}

//------------------------------------------------------------------------------
SurfaceSolid::SurfaceSolid(std::vector<Simplex>&& triangles, double tolerance)
  : Triangles(std::move(triangles))
  , Tolerance(tolerance)
{
  if (!this->Triangles.empty())
  {
    this->AddNodes(0, this->Triangles.size());
  }
}

//------------------------------------------------------------------------------
// Halves the triangles along the longest side of their box.
void SurfaceSolid::AddNodes(std::size_t first, std::size_t last)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ Bounds(), 0, first, first });
  Bounds box;
  for (std::size_t i = first; i < last; ++i)
  {
    box.Add(this->Triangles[i].GetBounds());
  }
  if (last - first <= TrianglesPerLeaf)
  {
    this->Nodes[node].Last = last;
  }
  else
  {
    const Vector size = box.High - box.Low;
    const auto side = size.X >= size.Y && size.X >= size.Z ? &Vector::X
      : size.Y >= size.Z                                   ? &Vector::Y
                                                           : &Vector::Z;
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = this->Triangles.begin();
    std::nth_element(begin + first, begin + middle, begin + last,
      [side](const Simplex& a, const Simplex& b)
      {
        return a.Points[0].*side + a.Points[1].*side + a.Points[2].*side <
          b.Points[0].*side + b.Points[1].*side + b.Points[2].*side;
      });
    this->AddNodes(first, middle);
    this->AddNodes(middle, last);
  }
  this->Nodes[node].Box = box;
  this->Nodes[node].Next = this->Nodes.size();
}

//------------------------------------------------------------------------------
template <typename Visit>
bool SurfaceSolid::FindAny(const Bounds& box, Visit&& visit) const
{
  for (std::size_t n = 0; n < this->Nodes.size();)
  {
    const Node& node = this->Nodes[n];
    if (!node.Box.Meets(box))
    {
      n = node.Next;
      continue;
    }
    for (std::size_t i = node.First; i < node.Last; ++i)
    {
      if (visit(this->Triangles[i]))
      {
        return true;
      }
    }
    ++n;
  }
  return false;
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
  if (this->FindAny(around,
        [&](const Simplex& triangle)
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
  return !this->Nodes.empty() && this->Nodes.front().Box.Meets(larger);
}

//------------------------------------------------------------------------------
bool SurfaceSolid::Meets(const CellBoundary& cell) const
{
  // The surface goes through the cell's, or lies within; else a corner would be inside.
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
