// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/CellRing.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
bool CellRing::Make(const IdList* edges, const FaceDirection* directions, std::int32_t count)
{
  this->Edges.clear();
  this->Loops.clear();
  for (std::int32_t i = 0; i < count; ++i)
  {
    if (edges[i].Size != 2)
    {
      return false;
    }
    const std::int32_t a = edges[i][0], b = edges[i][1];
    if (a == b)
    {
      this->Loops.push_back(a);
      continue;
    }
    const bool isLeft = directions[i] == FaceDirection::Inward;
    this->Edges.push_back(isLeft ? Edge{ a, b } : Edge{ b, a });
  }
  return this->Edges.size() > 1 && this->FollowEdges() &&
    (this->Loops.empty() || this->InsertLoops());
}

//------------------------------------------------------------------------------
// Of several edges from a point, takes that which comes first.
bool CellRing::FollowEdges()
{
  const std::int32_t first = this->Edges.front().From;
  std::stable_sort(this->Edges.begin(), this->Edges.end(),
    [](const Edge& a, const Edge& b) { return a.From < b.From; });
  this->Used.assign(this->Edges.size(), 0);
  this->Points.clear();
  std::int32_t point = first;
  do
  {
    const auto begin = std::lower_bound(this->Edges.begin(), this->Edges.end(), point,
      [](const Edge& edge, std::int32_t from) { return edge.From < from; });
    const auto next =
      begin == this->Edges.end() ? begin : begin + this->Used[begin - this->Edges.begin()]++;
    if (next >= this->Edges.end() || next->From != point)
    {
      return false;
    }
    this->Points.push_back(point);
    point = next->To;
  } while (this->Points.size() < this->Edges.size());
  return point == first;
}

//------------------------------------------------------------------------------
// Where their point is first passed.
bool CellRing::InsertLoops()
{
  std::sort(this->Loops.begin(), this->Loops.end());
  this->Used.assign(this->Loops.size(), 0);
  this->Scratch.clear();
  for (const std::int32_t point : this->Points)
  {
    const auto loops = std::equal_range(this->Loops.begin(), this->Loops.end(), point);
    if (loops.first != loops.second && this->Used[loops.first - this->Loops.begin()]++ == 0)
    {
      this->Scratch.insert(this->Scratch.end(), loops.first, loops.second);
    }
    this->Scratch.push_back(point);
  }
  std::swap(this->Points, this->Scratch);
  return this->Points.size() == this->Edges.size() + this->Loops.size();
}
}
