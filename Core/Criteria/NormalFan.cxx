// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/NormalFan.h"

#include "Base/Number.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace camaron
{
//------------------------------------------------------------------------------
void NormalFan::Add(const Vector& normal, Index cell)
{
  if (Norm2(normal) > 0)
  {
    this->Entries.push_back({ normal, cell });
  }
}

//------------------------------------------------------------------------------
void NormalFan::Sort()
{
  const auto key = [](const Entry& e)
  { return std::make_tuple(e.Normal.X, e.Normal.Y, e.Normal.Z, e.Cell); };
  std::sort(this->Entries.begin(), this->Entries.end(),
    [&key](const Entry& a, const Entry& b) { return key(a) < key(b); });
  std::vector<Vector> directions;
  for (const Entry& entry : this->Entries)
  {
    directions.push_back(Unit(entry.Normal));
  }
  this->Directions.Build(directions.data(), directions.size());
}

//------------------------------------------------------------------------------
double NormalFan::Search(const Vector& normal, Index cell, bool isLargest) const
{
  constexpr double Tolerance = 1e-12; // above the rounding of directions
  const Vector target =
    Unit(isLargest ? -normal : normal); // the wanted normal is the nearest to it
  double chord = 3;                     // its distance; at most 2
  double chosen = -1;
  const auto visit = [&](std::size_t place)
  {
    const Entry& entry = this->Entries[this->Directions.GetOrder()[place]];
    if (entry.Cell != cell)
    {
      const double angle = std::atan2(Norm(Cross(normal, entry.Normal)), Dot(normal, entry.Normal));
      if (chosen < 0 || (isLargest ? angle > chosen : angle < chosen))
      {
        chosen = angle;
        chord = 2 * std::sin((isLargest ? Pi - angle : angle) / 2);
      }
    }
    return false;
  };
  // Down to the leaf that is probably the nearest, then wherever there may be a nearer one.
  const std::vector<BoxTree::Node>& nodes = this->Directions.GetNodes();
  std::size_t n = 0;
  while (n < nodes.size() && nodes[n].Next > n + 1)
  {
    const std::size_t first = n + 1, second = nodes[first].Next;
    const bool isFirst = second >= nodes[n].Next ||
      nodes[first].Box.GetSquaredDistance(target) <= nodes[second].Box.GetSquaredDistance(target);
    n = isFirst ? first : second;
  }
  for (std::size_t place = n < nodes.size() ? nodes[n].First : 0;
    n < nodes.size() && place < nodes[n].Last; ++place)
  {
    visit(place);
  }
  this->Directions.FindAny([&](const Bounds& box)
    { return std::sqrt(box.GetSquaredDistance(target)) + Tolerance < chord; }, visit);
  return chosen;
}
}
