// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The smallest ball around points and the largest circle in a polygon, against trying everything.
#include "Base/Number.h"
#include "Geometry/HalfSpace.h"
#include "Geometry/LargestCircle.h"

#include "HalfSpaceTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Distance from the boundary of a polygon, negative outside: winding angle and all edges.
double GetClearance(const std::vector<Vector>& polygon, const Vector& p)
{
  double angle = 0, nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p, e = b - a;
    angle += std::atan2(Cross(a, b).Z, Dot(a, b));
    const double t = std::min(1.0, std::max(0.0, -Dot(a, e) / Norm2(e)));
    nearest = std::min(nearest, Norm(a + t * e));
  }
  return std::abs(angle) > Pi ? nearest : -nearest;
}
}

//------------------------------------------------------------------------------
// The smallest ball is that through two, three or four points that holds the rest.
TEST(Balls, SmallestBall)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const int n = 2 + trial % 8;
    const bool isFlat = trial % 3 == 0;
    std::vector<Vector> points;
    for (int i = 0; i < n; ++i)
    {
      points.push_back({ coordinate(random), coordinate(random), isFlat ? 0 : coordinate(random) });
    }
    points.push_back(points[0]); // twice
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Vector& center, double radius)
    {
      if (radius < best &&
        std::all_of(
          points.begin(), points.end(),
          [&](const Vector& p) { return Norm(p - center) <= radius + 1e-9; }))
      {
        best = radius;
      }
    };
    // Centers as far from p as from q lie in a plane; so do those level with three points.
    const auto level = [](const Vector& p, const Vector& q) -> HalfSpace
    { return { q - p, 0.5 * (Norm2(q) - Norm2(p)) }; };
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        const Vector& p = points[i];
        const HalfSpace pq = level(p, points[j]);
        consider(0.5 * (p + points[j]), 0.5 * Norm(p - points[j]));
        for (int k = 0; k < j; ++k)
        {
          const HalfSpace pr = level(p, points[k]);
          const Vector normal = Cross(pq.Normal, pr.Normal);
          Vector center;
          if (Intersect(pq, pr, { normal, Dot(normal, p) }, center))
          {
            consider(center, Norm(center - p));
          }
          for (int l = 0; l < k; ++l)
          {
            if (Intersect(pq, pr, level(p, points[l]), center))
            {
              consider(center, Norm(center - p));
            }
          }
        }
      }
    }
    EXPECT_NEAR(FindSmallestBall(points).Radius, best, 1e-8) << trial;
  }
  std::vector<Vector> none;
  EXPECT_EQ(FindSmallestBall(none).Radius, 0);
}

// The largest circle lies inside and no place that a fine search finds has a larger one; also where
// many circles are equally large, or nearly.
TEST(Balls, LargestCircle)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1);
  std::vector<std::vector<Vector>> polygons;
  for (int trial = 0; trial < 25; ++trial)
  {
    polygons.emplace_back();
    const int n = 5 + trial;
    for (int i = 0; i < n; ++i)
    {
      const double r = radius(random), angle = 2 * Pi * i / n;
      polygons.back().push_back({ 3 * r * std::cos(angle), r * std::sin(angle), 0 });
    }
  }
  polygons.push_back({ { 0, 0, 0 }, { 9, 0, 0 }, { 9, 5, 0 }, { 8, 5, 0 }, { 8, 1, 0 }, { 1, 1, 0 },
    { 1, 5, 0 }, { 0, 5, 0 } }); // a corridor with two corners
  for (const double taper : { 1e-3, 1e-6, 1e-9 })
  {
    polygons.push_back({ { 0, 0, 0 }, { 9, 0, 0 }, { 9, 1 - taper, 0 }, { 4, 1, 0 }, { 4, .9, 0 },
      { 3.9, .9, 0 }, { 3.9, 1 + taper, 0 }, { 0, 1 + taper, 0 } });
  }
  std::vector<Vector> comb = { { 0, -1, 0 }, { 40, -1, 0 } };
  for (int i = 20; i-- > 0;)
  {
    comb.insert(comb.end(),
      { { 2.0 * i + 2, 5, 0 }, { 2.0 * i + 1, 5, 0 }, { 2.0 * i + 1, 0, 0 }, { 2.0 * i, 0, 0 } });
  }
  polygons.push_back(comb);

  LargestCircle search;
  for (std::size_t trial = 0; trial < polygons.size(); ++trial)
  {
    const std::vector<Vector>& polygon = polygons[trial];
    Vector low = polygon[0], high = low;
    for (const Vector& p : polygon)
    {
      low = { std::min(low.X, p.X), std::min(low.Y, p.Y), 0 };
      high = { std::max(high.X, p.X), std::max(high.Y, p.Y), 0 };
    }
    const double size = Norm(high - low);
    const Ball found = search.Find(polygon);
    EXPECT_NEAR(GetClearance(polygon, found.Center), found.Radius, 1e-12 * size) << trial;
    Vector best = found.Center;
    double largest = 0;
    for (int i = 1; i < 150; ++i)
    {
      for (int j = 1; j < 150; ++j)
      {
        const Vector p = { low.X + i * (high.X - low.X) / 150, low.Y + j * (high.Y - low.Y) / 150,
          0 };
        const double clearance = GetClearance(polygon, p);
        if (clearance > largest)
        {
          largest = clearance;
          best = p;
        }
      }
    }
    for (double step = size / 150; step > 1e-8 * size;)
    {
      const Vector center = best;
      for (int direction = 0; direction < 16; ++direction)
      {
        const double angle = Pi / 8 * direction;
        const Vector p = center + Vector{ step * std::cos(angle), step * std::sin(angle), 0 };
        const double clearance = GetClearance(polygon, p);
        if (clearance > largest)
        {
          largest = clearance;
          best = p;
        }
      }
      step = best.X == center.X && best.Y == center.Y ? step / 2 : step;
    }
    EXPECT_GE(found.Radius, largest - 1e-6 * size) << trial;
  }
  // The corridor's corners are wider: a circle about (r, r) that touches (1, 1).
  EXPECT_NEAR(search.Find(polygons[25]).Radius, 2 - std::sqrt(2.0), 1e-6);
  EXPECT_EQ(search.Find({}).Radius, 0);
}
