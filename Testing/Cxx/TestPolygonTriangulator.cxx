// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Number.h"
#include "Geometry/PolygonTriangulator.h"

#include "TouchingPolygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Corners = std::vector<Vector>;

//------------------------------------------------------------------------------
Vector SumTriangles(
  const Corners& corners, const std::vector<PolygonTriangulator::Triangle>& triangles)
{
  Vector sum;
  for (const auto& t : triangles)
  {
    sum += 0.5 * Cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
  }
  return sum;
}

//------------------------------------------------------------------------------
double SumAreas(const Corners& corners, const std::vector<PolygonTriangulator::Triangle>& triangles)
{
  double sum = 0;
  for (const auto& t : triangles)
  {
    sum += 0.5 * Norm(Cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]));
  }
  return sum;
}

//------------------------------------------------------------------------------
/// Triangles that have the area of the polygon and run as it does cover it once.
void ExpectArea(const Corners& corners, double area, double tolerance, const std::string& name)
{
  PolygonTriangulator triangulator;
  triangulator.Cut(corners.data(), static_cast<int>(corners.size()));
  ASSERT_EQ(triangulator.GetTriangles().size(), corners.size() - 2) << name;
  EXPECT_NEAR(SumAreas(corners, triangulator.GetTriangles()), area, tolerance * area) << name;
  EXPECT_NEAR(Norm(SumTriangles(corners, triangulator.GetTriangles())), area, tolerance * area)
    << name;
  EXPECT_LE(triangulator.GetOverlap(), tolerance * area) << name;
  EXPECT_NEAR(triangulator.GetArea(), area, tolerance * area) << name;
}

//------------------------------------------------------------------------------
/// The triangles by the places of their corners, each from the same one on.
std::multiset<std::vector<double>> GetPlaces(
  const Corners& corners, const std::vector<PolygonTriangulator::Triangle>& triangles)
{
  std::multiset<std::vector<double>> places;
  for (const auto& t : triangles)
  {
    std::vector<std::vector<double>> triangle;
    for (const int corner : t)
    {
      triangle.push_back({ corners[corner].X, corners[corner].Y, corners[corner].Z });
    }
    std::sort(triangle.begin(), triangle.end());
    std::vector<double> flat;
    for (const auto& corner : triangle)
    {
      flat.insert(flat.end(), corner.begin(), corner.end());
    }
    places.insert(flat);
  }
  return places;
}

//------------------------------------------------------------------------------
struct Frame
{
  Vector Origin, X, Y;
};
Frame DrawFrame(TouchingPolygons& random)
{
  const auto draw = [&]
  { return Vector{ random.DrawReal(), random.DrawReal(), random.DrawReal() }; };
  const Vector x = Unit(draw()), y = Unit(Cross(x, draw()));
  return { 10.0 * draw(), x, y };
}
}

//------------------------------------------------------------------------------
// If this fails, a polygon that touches itself loses a part, or a hole is filled. The area is known
// from how it was made.
TEST(PolygonTriangulator, CoversPolygonsThatTouchThemselves)
{
  constexpr int count = 1500;
  for (int seed = 0; seed < count; ++seed)
  {
    TouchingPolygons random(seed);
    const bool hasSpikes = seed % 2 == 0;
    const double jitter = seed % 3 == 0 ? 0 : hasSpikes ? 0.15 : 0.29;
    const int size = seed % 10 == 0 ? 200 : seed % 10 < 4 ? 8 : 40;
    const auto polygon = random.Make(1 + random.Draw(size), jitter, hasSpikes);
    const std::string name = "seed " + std::to_string(seed);
    if (polygon.Corners.size() < 3)
    {
      continue;
    }
    ExpectArea(polygon.Corners, polygon.Area, 1e-12, name + ", in a plane");

    const Frame frame = DrawFrame(random);
    Corners turned, single, warped;
    for (const Vector& corner : polygon.Corners)
    {
      turned.push_back(frame.Origin + corner.X * frame.X + corner.Y * frame.Y);
      const Vector& last = turned.back();
      single.push_back(
        { static_cast<float>(last.X), static_cast<float>(last.Y), static_cast<float>(last.Z) });
      const double height = 0.02 * std::sin(3 * corner.X) * std::sin(2 * corner.Y);
      warped.push_back(last + height * Cross(frame.X, frame.Y));
    }
    ExpectArea(turned, polygon.Area, 1e-11, name + ", turned");
    ExpectArea(single, polygon.Area, 2e-5, name + ", in single precision");

    // Warped, it has more area than its projection, which the triangles cover once.
    PolygonTriangulator triangulator;
    triangulator.Cut(warped.data(), static_cast<int>(warped.size()));
    EXPECT_LE(triangulator.GetOverlap(), 1e-3 * polygon.Area) << name;
  }
}

//------------------------------------------------------------------------------
// If this fails, two cells cut the face between them differently, and so do two processes.
TEST(PolygonTriangulator, DependsOnPlacesOnly)
{
  for (int seed = 0; seed < 200; ++seed)
  {
    TouchingPolygons random(seed);
    const auto polygon = random.Make(1 + random.Draw(30), 0.15, true);
    const Frame frame = DrawFrame(random);
    Corners corners;
    for (const Vector& corner : polygon.Corners)
    {
      corners.push_back(frame.Origin + corner.X * frame.X + corner.Y * frame.Y);
    }
    PolygonTriangulator triangulator;
    const auto size = static_cast<int>(corners.size());
    triangulator.Cut(corners.data(), size);
    const auto expected = GetPlaces(corners, triangulator.GetTriangles());
    const Vector area = SumTriangles(corners, triangulator.GetTriangles());
    std::rotate(corners.begin(), corners.begin() + random.Draw(size), corners.end());
    triangulator.Cut(corners.data(), size);
    EXPECT_EQ(GetPlaces(corners, triangulator.GetTriangles()), expected) << seed;
    EXPECT_GT(Dot(SumTriangles(corners, triangulator.GetTriangles()), area), 0) << seed;
    std::reverse(corners.begin(), corners.end());
    triangulator.Cut(corners.data(), size);
    EXPECT_EQ(GetPlaces(corners, triangulator.GetTriangles()), expected) << seed;
    EXPECT_LT(Dot(SumTriangles(corners, triangulator.GetTriangles()), area), 0) << seed;
  }
}

//------------------------------------------------------------------------------
// Polygons that people report: the area is that of the formula.
TEST(PolygonTriangulator, CutsNotedPolygons)
{
  ExpectArea({ { 0, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 0, 2, 0 }, { 0.5, 0.5, 0 }, { 0, 0, 0 } },
    1.5, 1e-15, "the first corner again at the end");
  // A square of 3 with a hole of 1, and a bridge.
  ExpectArea({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 }, { 0, 0, 0 }, { 1, 1, 0 },
               { 1, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 }, { 1, 1, 0 } },
    8, 1e-15, "a keyhole");
  // Two triangles, joined by a bent line.
  ExpectArea({ { 0, 0, 0 }, { 1, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 4, 3, 0 }, { 4, 4, 0 },
               { 3, 3, 0 }, { 3, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } },
    1, 1e-15, "a bridge outside");
  // An L in large coordinates and with large numbers.
  for (const double scale : { 1e-150, 1.0, 1e120 })
  {
    Corners corners = { { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 },
      { 0, 2, 1 } };
    for (Vector& corner : corners)
    {
      corner = scale * corner;
    }
    PolygonTriangulator triangulator;
    triangulator.Cut(corners.data(), 6);
    for (Vector& corner : corners)
    {
      corner = (1 / scale) * corner;
    }
    EXPECT_NEAR(SumAreas(corners, triangulator.GetTriangles()), 3, 1e-12) << scale;
  }
}

//------------------------------------------------------------------------------
// Any triangles will do, but as many as ever, and soon.
TEST(PolygonTriangulator, EndsWhateverTheCorners)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   infinity = std::numeric_limits<double>::infinity();
  const auto count = [](const Corners& corners)
  {
    PolygonTriangulator triangulator;
    triangulator.Cut(corners.data(), static_cast<int>(corners.size()));
    for (const auto& t : triangulator.GetTriangles())
    {
      for (const int corner : t)
      {
        EXPECT_TRUE(corner >= 0 && corner < static_cast<int>(corners.size()));
      }
    }
    return triangulator.GetTriangles().size();
  };
  for (const int size : { 0, 1, 2, 3, 4, 5, 50 })
  {
    const auto expected = static_cast<std::size_t>(std::max(size - 2, 0));
    Corners corners(size, Vector{ 1, 2, 3 });
    EXPECT_EQ(count(corners), expected) << "in one place";
    for (int i = 0; i < size; ++i)
    {
      corners[i] = { 0.1 * (i * 7 % 11), 0.3 * (i * 7 % 11), 0.7 * (i * 7 % 11) };
    }
    EXPECT_EQ(count(corners), expected) << "on a line";
    for (const double bad : { nan, infinity, -infinity, std::numeric_limits<double>::max() })
    {
      for (int i = 0; i < size; i += 2)
      {
        corners[i] = { bad, 1.0 * i, -bad };
      }
      EXPECT_EQ(count(corners), expected) << bad;
    }
    TouchingPolygons random(size);
    for (Vector& corner : corners)
    {
      corner = { random.DrawReal(), random.DrawReal(), random.DrawReal() };
    }
    EXPECT_EQ(count(corners), expected) << "crossing itself";
  }
}

//------------------------------------------------------------------------------
// If this fails, polygons whose triangles are arbitrary are not reported.
TEST(PolygonTriangulator, TellsOfCrossings)
{
  PolygonTriangulator triangulator;
  const Corners tie = { { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 0 }, { 0, 1, 0 } };
  triangulator.Cut(tie.data(), 4);
  EXPECT_GT(triangulator.GetOverlap(), 0.1);
  const Corners even = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  triangulator.Cut(even.data(), 4);
  EXPECT_GT(triangulator.GetOverlap(), 0.1) << "whose parts cancel";
  Corners star;
  for (int i = 0; i < 5; ++i)
  {
    star.push_back({ std::cos(4 * Pi * i / 5), std::sin(4 * Pi * i / 5), 0 });
  }
  triangulator.Cut(star.data(), 5);
  EXPECT_GT(triangulator.GetOverlap(), 0.1) << "a pentagram";
}

//------------------------------------------------------------------------------
// O(n^2) would take minutes.
TEST(PolygonTriangulator, CutsLargePolygons)
{
  constexpr int size = 100000;
  Corners star, comb, spiral;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2 * Pi * i / size, radius = i % 2 ? 0.1 : 1;
    star.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
    const bool isUp = i % 4 == 1 || i % 4 == 2;
    comb.push_back({ 1.0 * i, isUp ? 100.0 : 0.0, 0 });
  }
  comb.push_back({ size, -1, 0 });
  comb.push_back({ 0, -1, 0 });
  for (int i = 0; i < size; ++i)
  {
    const int step = i < size / 2 ? i : size - 1 - i;
    const double angle = 100 * Pi * step / size, radius = (i < size / 2 ? 1 : 1.5) + angle;
    spiral.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
  }
  for (const Corners* corners : { &star, &comb, &spiral })
  {
    Vector shoelace;
    for (std::size_t i = 0; i < corners->size(); ++i)
    {
      shoelace += 0.5 * Cross((*corners)[i], (*corners)[(i + 1) % corners->size()]);
    }
    ExpectArea(*corners, Norm(shoelace), 1e-10, "of many corners");
  }
}
