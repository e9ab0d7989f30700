// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/EarCutter.h"

#include "Geometry/Orientation.h"

#include <algorithm>
#include <cmath>

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
}
