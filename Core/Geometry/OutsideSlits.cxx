// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/OutsideSlits.h"

#include "Base/DisjointSets.h"
#include "Geometry/Orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool IsSamePlace(const Vector& a, const Vector& b)
{
  return a.X == b.X && a.Y == b.Y;
}

//------------------------------------------------------------------------------
// Order of directions from a point by angle, from 0 to less than a full turn.
bool IsEarlier(const Vector& middle, const Vector& a, const Vector& b)
{
  const auto isLower = [&](const Vector& end)
  { return end.Y < middle.Y || (end.Y == middle.Y && end.X < middle.X); };
  return isLower(a) != isLower(b) ? isLower(b) : Orient(middle, a, b) > 0;
}
}

//------------------------------------------------------------------------------
int OutsideSlits::GetPrevious(int place) const
{
  return (place > 0 ? place : static_cast<int>(this->Ring->size())) - 1;
}

//------------------------------------------------------------------------------
int OutsideSlits::GetNext(int place) const
{
  return place + 1 < static_cast<int>(this->Ring->size()) ? place + 1 : 0;
}

//------------------------------------------------------------------------------
bool OutsideSlits::IsSameDirection(const Vector& middle, const Vector& a, const Vector& b) const
{
  const double longest = std::max({ Norm2(a - middle), Norm2(b - middle), Norm2(b - a) });
  return Dot(a - middle, b - middle) > 0 &&
    std::abs(Orient(middle, a, b)) <= this->Tolerance * std::sqrt(longest);
}

//------------------------------------------------------------------------------
// Whether the polygon turns back.
bool OutsideSlits::IsTip(int place) const
{
  return this->IsSameDirection(this->GetPoint(place), this->GetPoint(this->GetPrevious(place)),
    this->GetPoint(this->GetNext(place)));
}

//------------------------------------------------------------------------------
// Counter-clockwise around a point, the polygon begins at outgoing edges and ends at incoming
// edges. Returns false if there are equally many in each direction, so that the sides of the edges
// remain unknown.
bool OutsideSlits::FindSides(const Vector& middle)
{
  const auto begin = this->Spokes.begin(), end = this->Spokes.end();
  std::sort(
    begin, end, [&](const Spoke& a, const Spoke& b) { return IsEarlier(middle, *a.End, *b.End); });
  const auto isOther = [&](const Spoke& a, const Spoke& b)
  { return !this->IsSameDirection(middle, *a.End, *b.End); };
  if (!isOther(this->Spokes.back(), this->Spokes.front()))
  {
    // The direction of the first one continues at the end of the list.
    const auto gap = std::adjacent_find(begin, end, isOther);
    if (gap == end)
    {
      return false;
    }
    std::rotate(begin, gap + 1, end);
  }
  const auto forEachDirection = [&](auto&& visit)
  {
    int covers = 0;
    for (auto first = begin; first != end;)
    {
      const auto gap = std::adjacent_find(first, end, isOther);
      const auto last = gap == end ? end : gap + 1;
      const int before = covers;
      std::for_each(first, last, [&](const Spoke& spoke) { covers += spoke.IsOutgoing ? 1 : -1; });
      visit(first, last, before, covers);
      first = last;
    }
  };
  int least = 0, most = 0;
  forEachDirection(
    [&](auto, auto, int, int after)
    {
      least = std::min(least, after);
      most = std::max(most, after);
    });
  if (least == most)
  {
    return false;
  }
  forEachDirection(
    [&](auto first, auto last, int before, int after)
    {
      std::for_each(first, last, [&](const Spoke& spoke)
        { this->Sides[spoke.Edge] = (spoke.IsOutgoing ? after : before) > least ? 1 : 0; });
    });
  return true;
}

//------------------------------------------------------------------------------
const std::vector<int>& OutsideSlits::Find(
  const Vector* points, const std::vector<int>& ring, double tolerance)
{
  this->Points = points;
  this->Tolerance = tolerance;
  this->Ring = &ring;
  this->Found.clear();
  this->Unclear.clear();
  const auto size = static_cast<int>(ring.size());
  this->Order.resize(size);
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::sort(this->Order.begin(), this->Order.end(),
    [&](int a, int b)
    {
      const Vector &p = this->GetPoint(a), &q = this->GetPoint(b);
      return std::tie(p.X, p.Y, a) < std::tie(q.X, q.Y, b);
    });
  this->Sides.assign(size, -1);
  for (auto begin = this->Order.begin(); begin != this->Order.end();)
  {
    const Vector& middle = this->GetPoint(*begin);
    const auto end = std::find_if(begin, this->Order.end(),
      [&](int place) { return !IsSamePlace(this->GetPoint(place), middle); });
    if (end - begin == 1 && !this->IsTip(*begin))
    {
      this->Sides[*begin] = this->Sides[this->GetPrevious(*begin)] = 1;
    }
    else
    {
      this->Spokes.clear();
      std::for_each(begin, end,
        [&](int place)
        {
          const int previous = this->GetPrevious(place), next = this->GetNext(place);
          this->Spokes.push_back({ &this->GetPoint(next), place, true });
          this->Spokes.push_back({ &this->GetPoint(previous), previous, false });
        });
      if (!this->FindSides(middle))
      {
        this->Unclear.insert(this->Unclear.end(), begin, end);
      }
    }
    begin = end;
  }
  if (!this->Unclear.empty())
  {
    this->FindOutside();
  }
  return this->Found;
}

//------------------------------------------------------------------------------
// Where nothing is known, all edges have the same region on both sides.
void OutsideSlits::FindOutside()
{
  DisjointSets alike(this->Ring->size());
  int before = this->Unclear.front();
  for (const int place : this->Unclear)
  {
    const int other = IsSamePlace(this->GetPoint(before), this->GetPoint(place)) ? before : place;
    for (const int edge : { other, place, this->GetPrevious(place) })
    {
      alike.Insert(edge);
      alike.Join(edge, other);
    }
    before = place;
  }
  for (std::size_t edge = 0; edge < this->Sides.size(); ++edge)
  {
    if (alike.Contains(edge))
    {
      signed char& side = this->Sides[alike.Find(edge)];
      side = std::max(side, this->Sides[edge]);
    }
  }
  for (const int place : this->Unclear)
  {
    if (this->Sides[alike.Find(place)] != 1)
    {
      this->Found.push_back(place);
    }
  }
}
}
