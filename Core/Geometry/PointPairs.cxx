// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PointPairs.h"

#include "Geometry/BoxTree.h"

#include <algorithm>

namespace camaron
{
namespace
{
/// Up to this number of points, all pairs are tested.
constexpr std::size_t FewPoints = 64;

//------------------------------------------------------------------------------
// Reduces a first value and the squared distances of all pairs by choose(a, b), in any order;
// several independent pairs at a time.
template <typename Choose>
double ChooseOfPairs(const Vector* points, std::size_t size, double first, Choose&& choose)
{
  constexpr std::size_t numberOfLanes = 4;
  double chosen[numberOfLanes];
  std::fill_n(chosen, numberOfLanes, first);
  for (std::size_t i = 0; i < size; ++i)
  {
    const Vector point = points[i];
    std::size_t j = 0;
    for (; j + numberOfLanes <= i; j += numberOfLanes)
    {
      for (std::size_t lane = 0; lane < numberOfLanes; ++lane)
      {
        chosen[lane] = choose(chosen[lane], Norm2(point - points[j + lane]));
      }
    }
    for (; j < i; ++j)
    {
      chosen[0] = choose(chosen[0], Norm2(point - points[j]));
    }
  }
  return choose(choose(chosen[0], chosen[1]), choose(chosen[2], chosen[3]));
}

//------------------------------------------------------------------------------
double GetSquaredReach(const Bounds& box, const Vector& point)
{
  const auto reach = [](double low, double high, double x) { return std::max(x - low, high - x); };
  return Norm2({ reach(box.Low.X, box.High.X, point.X), reach(box.Low.Y, box.High.Y, point.Y),
    reach(box.Low.Z, box.High.Z, point.Z) });
}

//------------------------------------------------------------------------------
// The same for any number of points; of many, only with those in boxes where
// mayChange(box, point, chosen) is true.
template <typename Choose, typename MayChange>
double ChooseOfAllPairs(
  const Vector* points, std::size_t size, double chosen, Choose&& choose, MayChange&& mayChange)
{
  if (size <= FewPoints)
  {
    return ChooseOfPairs(points, size, chosen, choose);
  }
  BoxTree tree;
  tree.Build(points, size);
  for (std::size_t i = 0; i < size; ++i)
  {
    tree.FindAny([&](const Bounds& box) { return mayChange(box, points[i], chosen); },
      [&](std::size_t place)
      {
        const std::size_t other = tree.GetOrder()[place];
        chosen = other == i ? chosen : choose(chosen, Norm2(points[other] - points[i]));
        return false;
      });
  }
  return chosen;
}
}

//------------------------------------------------------------------------------
double FindLargestSquaredDistance(const Vector* points, std::size_t size)
{
  return ChooseOfAllPairs(
    points, size, 0, [](double a, double b) { return std::max(a, b); },
    [](const Bounds& box, const Vector& point, double largest)
    { return GetSquaredReach(box, point) > largest; });
}

//------------------------------------------------------------------------------
double FindSmallestSquaredDistance(const Vector* points, std::size_t size)
{
  return ChooseOfAllPairs(
    points, size, Bounds::Infinity, [](double a, double b) { return std::min(a, b); },
    [](const Bounds& box, const Vector& point, double smallest)
    { return box.GetSquaredDistance(point) < smallest; });
}
}
