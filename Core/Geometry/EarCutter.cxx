// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/EarCutter.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace camaron
{
namespace
{
/// Priorities of ears without area; the quality of others is in between.
constexpr double First = 2, Last = 0;
/// Blocked ears are tried again this many times per vertex, then cut as they are.
constexpr int MaxTriedAgain = 4;

//------------------------------------------------------------------------------
/// A line through two points, and the region to the left of it beyond roundoff.
class Side
{
public:
  Side(const Vector& from, const Vector& to, double tolerance)
    : From(from)
    , To(to)
    , Rounding(tolerance * Norm(to - from))
  {
  }
  /// 1: to the left, 0: on the line, -1: to the right.
  int Find(const Vector& point) const
  {
    const double area = Orient(this->From, this->To, point);
    return area > this->Rounding ? 1 : area < -this->Rounding ? -1 : 0;
  }
  /// Whether a box may have a point that is not to the right.
  bool MayHave(const Bounds& box) const
  {
    const double x = this->To.X - this->From.X, y = this->To.Y - this->From.Y;
    const double area = x * ((x > 0 ? box.High.Y : box.Low.Y) - this->From.Y) -
      y * ((y > 0 ? box.Low.X : box.High.X) - this->From.X);
    constexpr double margin = 1e-14; // for the rounding of the product; coordinates are up to 1
    return area >= -2 * this->Rounding - margin;
  }

private:
  const Vector &From, &To;
  double Rounding;
};
}

//------------------------------------------------------------------------------
// Positive if the corner is convex.
double EarCutter::GetHeight(int corner) const
{
  const Vector &a = this->Flat[this->Corners[corner].Previous], &b = this->Flat[corner],
               &c = this->Flat[this->Corners[corner].Next];
  const double longest = std::max({ Norm2(b - a), Norm2(c - b), Norm2(a - c) });
  return longest > 0 ? Orient(a, b, c) / std::sqrt(longest) : 0;
}

//------------------------------------------------------------------------------
// 1 for an equilateral triangle.
double EarCutter::GetQuality(int corner) const
{
  const Vector &a = this->Places[this->Corners[corner].Previous], &b = this->Places[corner],
               &c = this->Places[this->Corners[corner].Next];
  constexpr double perfect = 3.4641016151377545871; // 2 * sqrt(3)
  const double squares = Norm2(b - a) + Norm2(c - b) + Norm2(a - c);
  return squares > 0 ? perfect * Norm(Cross(b - a, c - a)) / squares : 0;
}

//------------------------------------------------------------------------------
// For a vertex whose triangle has no area.
bool EarCutter::TurnsBack(int corner) const
{
  const Vector& b = this->Flat[corner];
  return Dot(this->Flat[this->Corners[corner].Previous] - b,
           this->Flat[this->Corners[corner].Next] - b) >= 0;
}

//------------------------------------------------------------------------------
void EarCutter::LinkCorners(int size)
{
  this->Corners.assign(size, Corner());
  for (int i = 0; i < size; ++i)
  {
    this->Corners[i].Previous = (i > 0 ? i : size) - 1;
    this->Corners[i].Next = i + 1 < size ? i + 1 : 0;
  }
  this->NumberLeft = size;
  this->AnyLeft = 0;
}

//------------------------------------------------------------------------------
void EarCutter::CutOff(int corner)
{
  Corner& cut = this->Corners[corner];
  this->Triangles->push_back({ { cut.Previous, corner, cut.Next } });
  this->Corners[cut.Previous].Next = cut.Next;
  this->Corners[cut.Next].Previous = cut.Previous;
  this->AnyLeft = cut.Next;
  cut.IsCut = true;
  if (cut.PlaceInTree >= 0)
  {
    this->Tree.LeaveOut(cut.PlaceInTree);
  }
  --this->NumberLeft;
}

//------------------------------------------------------------------------------
// Cuts off vertices at the same position as the next.
void EarCutter::CutRepeated()
{
  for (int corner = 0, tried = 0; tried < this->NumberLeft && this->NumberLeft > 3; ++tried)
  {
    const int next = this->Corners[corner].Next;
    if (this->Flat[corner].X == this->Flat[next].X && this->Flat[corner].Y == this->Flat[next].Y)
    {
      this->CutOff(corner);
      tried = -1;
    }
    corner = next;
  }
}

//------------------------------------------------------------------------------
void EarCutter::MarkSpikes()
{
  this->Ring.clear();
  int corner = this->AnyLeft;
  do
  {
    this->Ring.push_back(corner);
    corner = this->Corners[corner].Next;
  } while (corner != this->AnyLeft);
  for (const int place : this->Slits.Find(this->Flat, this->Ring, this->Tolerance))
  {
    this->Corners[this->Ring[place]].IsOutside = true;
  }
}

//------------------------------------------------------------------------------
void EarCutter::BuildTree()
{
  this->InTree.clear();
  this->Boxes.clear();
  for (const int corner : this->Ring)
  {
    if (!(this->GetHeight(corner) > this->Tolerance))
    {
      this->InTree.push_back(corner);
      this->Boxes.emplace_back();
      this->Boxes.back().Add(this->Flat[corner]);
    }
  }
  this->Tree.Build(this->Boxes);
  const std::vector<std::size_t>& order = this->Tree.GetOrder();
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    this->Corners[this->InTree[order[place]]].PlaceInTree = static_cast<int>(place);
  }
}

//------------------------------------------------------------------------------
// Updates the state of a vertex; convex ones stay convex.
void EarCutter::Queue(int corner)
{
  Corner& queued = this->Corners[corner];
  ++queued.Stamp;
  const double height = this->GetHeight(corner);
  if (height > this->Tolerance)
  {
    queued.IsFull = false;
    if (queued.PlaceInTree >= 0)
    {
      this->Tree.LeaveOut(queued.PlaceInTree);
      queued.PlaceInTree = -1;
    }
    this->Waiting.push_back({ this->GetQuality(corner), corner, queued.Stamp });
  }
  else if (height >= -this->Tolerance)
  {
    // Angles decrease: less than a full turn becomes zero when the polygon turns back.
    queued.IsFull = queued.IsFull && this->TurnsBack(corner);
    const bool isClosed = queued.IsOutside || (!queued.IsFull && this->TurnsBack(corner));
    this->Waiting.push_back({ isClosed ? First : Last, corner, queued.Stamp });
  }
  else
  {
    queued.IsFull = false;
    return;
  }
  std::push_heap(this->Waiting.begin(), this->Waiting.end());
}

//------------------------------------------------------------------------------
// Whether no part of the polygon is inside an ear. A part inside has a non-convex vertex where it
// is closest to the tip of the ear, away from the opposite side: inside, or on one of the other two
// sides with an edge that leads into the ear.
bool EarCutter::IsFree(int corner) const
{
  const Corner& tip = this->Corners[corner];
  if (tip.IsOutside)
  {
    return false;
  }
  const int before = tip.Previous, after = tip.Next;
  const Vector &a = this->Flat[before], &b = this->Flat[corner], &c = this->Flat[after];
  const Side left(a, b, this->Tolerance), right(b, c, this->Tolerance),
    bottom(c, a, this->Tolerance);
  Bounds box;
  box.Add(a);
  box.Add(b);
  box.Add(c);
  box.Grow(this->Tolerance);
  const auto isBlocking = [&](std::size_t place)
  {
    const int other = this->InTree[this->Tree.GetOrder()[place]];
    const Corner& found = this->Corners[other];
    if (found.PlaceInTree < 0 || found.IsCut || other == before || other == corner ||
      other == after)
    {
      return false;
    }
    const Vector& point = this->Flat[other];
    const int ofLeft = left.Find(point), ofRight = right.Find(point);
    if (ofLeft < 0 || ofRight < 0 || bottom.Find(point) <= 0)
    {
      return false;
    }
    const auto leadsIn = [&](int end)
    {
      return (ofLeft > 0 || left.Find(this->Flat[end]) > 0) &&
        (ofRight > 0 || right.Find(this->Flat[end]) > 0);
    };
    return leadsIn(found.Previous) || leadsIn(found.Next);
  };
  return !this->Tree.FindAny(
    [&](const Bounds& around)
    {
      return around.Meets(box) && left.MayHave(around) && right.MayHave(around) &&
        bottom.MayHave(around);
    },
    isBlocking);
}

//------------------------------------------------------------------------------
// The vertex of the best entry, or -1.
int EarCutter::TakeUpToDate(std::vector<Entry>& heap, double& quality)
{
  while (!heap.empty())
  {
    std::pop_heap(heap.begin(), heap.end());
    const Entry entry = heap.back();
    heap.pop_back();
    if (!this->Corners[entry.Corner].IsCut && this->Corners[entry.Corner].Stamp == entry.Stamp)
    {
      quality = entry.Quality;
      return entry.Corner;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
void EarCutter::CutBest()
{
  double quality = 0;
  int corner = this->TakeUpToDate(this->Waiting, quality);
  while (corner >= 0 && quality > Last && quality < First && !this->IsFree(corner))
  {
    this->Blocked.push_back({ quality, corner, this->Corners[corner].Stamp });
    std::push_heap(this->Blocked.begin(), this->Blocked.end());
    corner = this->TakeUpToDate(this->Waiting, quality);
  }
  if (corner < 0 && this->HasCutSince && !this->Blocked.empty() && this->TriedAgain > 0)
  {
    this->TriedAgain -= static_cast<int>(this->Blocked.size());
    this->HasCutSince = false;
    this->Waiting.swap(this->Blocked);
    return;
  }
  if (corner < 0)
  {
    corner = this->TakeUpToDate(this->Blocked, quality);
  }
  if (corner < 0)
  {
    corner = this->AnyLeft;
  }
  const int before = this->Corners[corner].Previous, after = this->Corners[corner].Next;
  this->CutOff(corner);
  this->Queue(before);
  this->Queue(after);
  this->HasCutSince = true;
}

//------------------------------------------------------------------------------
void EarCutter::Cut(const Vector* flat, const Vector* places, int size, double tolerance,
  std::vector<Triangle>& triangles)
{
  this->Flat = flat;
  this->Places = places;
  this->Tolerance = tolerance;
  this->Triangles = &triangles;
  triangles.clear();
  this->Waiting.clear();
  this->Blocked.clear();
  this->LinkCorners(size);
  this->CutRepeated();
  this->MarkSpikes();
  this->BuildTree();
  for (const int corner : this->Ring)
  {
    this->Corners[corner].IsFull = this->TurnsBack(corner);
    this->Queue(corner);
  }
  this->TriedAgain = MaxTriedAgain * size;
  this->HasCutSince = false;
  while (this->NumberLeft > 3)
  {
    this->CutBest();
  }
  this->CutOff(this->AnyLeft);
}

namespace
{
//------------------------------------------------------------------------------
/// A sum without rounding: non-overlapping numbers, the largest last.
class ExpandedSum
{
public:
  void AddProduct(double a, double b)
  {
    const double product = a * b;
    this->Add(std::fma(a, b, -product));
    this->Add(product);
  }
  double GetLargest() const { return this->Size > 0 ? this->Parts[this->Size - 1] : 0; }

private:
  void Add(double sum)
  {
    int kept = 0;
    for (int i = 0; i < this->Size; ++i)
    {
      const double part = this->Parts[i], total = sum + part, virtualPart = total - sum;
      const double rest = (sum - (total - virtualPart)) + (part - virtualPart);
      if (rest != 0)
      {
        this->Parts[kept++] = rest;
      }
      sum = total;
    }
    if (sum != 0)
    {
      this->Parts[kept++] = sum;
    }
    this->Size = kept;
  }

  static constexpr int MaxParts = 12; // of six products
  double Parts[MaxParts];
  int Size = 0;
};
}

//------------------------------------------------------------------------------
double OrientExactly(const Vector& a, const Vector& b, const Vector& c)
{
  ExpandedSum sum;
  sum.AddProduct(a.X, b.Y);
  sum.AddProduct(-a.Y, b.X);
  sum.AddProduct(b.X, c.Y);
  sum.AddProduct(-b.Y, c.X);
  sum.AddProduct(c.X, a.Y);
  sum.AddProduct(-c.Y, a.X);
  return sum.GetLargest();
}

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
