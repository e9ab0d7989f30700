// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PolygonOutline.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
void PolygonOutline::Build(const std::vector<Vector>& corners)
{
  this->Corners = &corners;
  this->Boxes.assign(corners.size(), Bounds());
  for (std::size_t edge = 0; edge < corners.size(); ++edge)
  {
    this->Boxes[edge].Add(this->GetBegin(edge));
    this->Boxes[edge].Add(this->GetEnd(edge));
  }
  this->Tree.Build(this->Boxes, false);
}

//------------------------------------------------------------------------------
double PolygonOutline::GetSignedDistance(const Vector& point, double limit) const
{
  const double distance = std::sqrt(this->FindSquaredDistance(point, limit));
  return this->IsInside(point) ? distance : -distance;
}

//------------------------------------------------------------------------------
double PolygonOutline::FindSquaredDistance(const Vector& point, double limit) const
{
  double nearest = limit * limit;
  const auto visit = [&](std::size_t i)
  {
    const Vector a = this->GetBegin(i) - point, edge = this->GetEnd(i) - this->GetBegin(i);
    const double square = Norm2(edge);
    const double t = square > 0 ? std::clamp(-Dot(a, edge) / square, 0.0, 1.0) : 0;
    nearest = std::min(nearest, Norm2(a + t * edge));
  };
  // Start where the nearest edge is likely to be, so that most others can be skipped.
  const std::vector<BoxTree::Node>& nodes = this->Tree.GetNodes();
  std::size_t n = 0;
  while (nodes[n].Next != n + 1)
  {
    const std::size_t left = n + 1, right = nodes[left].Next;
    const bool isLeft =
      nodes[left].Box.GetSquaredDistance(point) <= nodes[right].Box.GetSquaredDistance(point);
    n = isLeft ? left : right;
  }
  for (std::size_t i = nodes[n].First; i < nodes[n].Last; ++i)
  {
    visit(i);
  }
  this->ForEach([&](const BoxTree::Node& node)
    { return node.Box.GetSquaredDistance(point) <= nearest; }, visit);
  return nearest;
}

//------------------------------------------------------------------------------
// Whether the edges cross the ray to the right an odd number of times.
bool PolygonOutline::IsInside(const Vector& point) const
{
  bool isInside = false;
  const auto isAbove = [&](const Vector& corner) { return corner.Y > point.Y; };
  this->ForEach(
    [&](const BoxTree::Node& node)
    {
      const Bounds& box = node.Box;
      if (isAbove(box.Low) || !isAbove(box.High) || box.High.X < point.X)
      {
        return false;
      }
      if (box.Low.X > point.X)
      {
        isInside =
          isInside != (isAbove(this->GetBegin(node.First)) != isAbove(this->GetEnd(node.Last - 1)));
        return false;
      }
      return true;
    },
    [&](std::size_t i)
    {
      const Vector a = this->GetBegin(i) - point, edge = this->GetEnd(i) - this->GetBegin(i);
      if (isAbove(this->GetBegin(i)) != isAbove(this->GetEnd(i)) &&
        (a.X * edge.Y - a.Y * edge.X > 0) == (edge.Y > 0))
      {
        isInside = !isInside;
      }
    });
  return isInside;
}
}
