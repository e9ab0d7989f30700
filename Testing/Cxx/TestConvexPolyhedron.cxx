// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex polyhedra that half-spaces cut: all at once against one after the other and closed forms.
#include "Base/Number.h"
#include "Geometry/ConvexPolyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace camaron;

namespace
{
constexpr double Tolerance = 1e-12;

//------------------------------------------------------------------------------
void Clip(ConvexPolyhedron& polyhedron, const std::vector<HalfSpace>& halfSpaces)
{
  EXPECT_TRUE(polyhedron.Clip(halfSpaces, Tolerance, [](double) { return true; }));
}

//------------------------------------------------------------------------------
ConvexPolyhedron MakeBox(double size)
{
  ConvexPolyhedron box;
  box.SetBox({ -size, -size, -size }, { size, size, size });
  return box;
}

//------------------------------------------------------------------------------
// Every edge is used in both directions, and the surface is a sphere (Euler).
void ExpectClosed(const ConvexPolyhedron& polyhedron)
{
  std::map<std::pair<int, int>, int> edges;
  for (int f = 0; f < polyhedron.GetNumberOfFaces(); ++f)
  {
    const int size = polyhedron.GetFaceSize(f);
    EXPECT_GE(size, 3);
    for (int i = 0; i < size; ++i)
    {
      const int a = polyhedron.GetFace(f)[i], b = polyhedron.GetFace(f)[(i + 1) % size];
      ++edges[{ a, b }];
      --edges[{ b, a }];
    }
  }
  for (const auto& edge : edges)
  {
    EXPECT_EQ(edge.second, 0);
  }
  if (!polyhedron.IsEmpty())
  {
    EXPECT_EQ(static_cast<int>(polyhedron.GetPoints().size()) - static_cast<int>(edges.size()) / 2 +
        polyhedron.GetNumberOfFaces(),
      2);
  }
}

//------------------------------------------------------------------------------
std::vector<Vector> GetSortedPoints(const ConvexPolyhedron& polyhedron)
{
  std::vector<Vector> points = polyhedron.GetPoints();
  // By numbers that rounding does not change the order of.
  const auto key = [](const Vector& p) -> std::array<double, 3>
  { return { std::round(1e7 * p.X), std::round(1e7 * p.Y), std::round(1e7 * p.Z) }; };
  std::sort(points.begin(), points.end(),
    [&](const Vector& p, const Vector& q) { return key(p) < key(q); });
  return points;
}

//------------------------------------------------------------------------------
// All at once gives what one after the other gives, in the order in which they come.
void ExpectSameAsOneByOne(const std::vector<HalfSpace>& halfSpaces)
{
  ConvexPolyhedron together = MakeBox(2), single = MakeBox(2);
  Clip(together, halfSpaces);
  for (const HalfSpace& halfSpace : halfSpaces)
  {
    Clip(single, { halfSpace });
  }
  ExpectClosed(together);
  EXPECT_EQ(together.GetNumberOfFaces(), single.GetNumberOfFaces());
  EXPECT_NEAR(together.GetVolume(), single.GetVolume(), 1e-12);
  const std::vector<Vector> points = GetSortedPoints(together), others = GetSortedPoints(single);
  ASSERT_EQ(points.size(), others.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_LT(Norm(points[i] - others[i]), 1e-9) << i;
  }
}

//------------------------------------------------------------------------------
// Planes through points spread evenly over a sphere, which they touch.
std::vector<HalfSpace> MakeTangents(int size)
{
  std::vector<HalfSpace> halfSpaces;
  for (int i = 0; i < size; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / size, angle = Pi * (3 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1 - z * z);
    halfSpaces.push_back({ { r * std::cos(angle), r * std::sin(angle), z }, 1 });
  }
  return halfSpaces;
}
}

// Half-spaces cut a polyhedron in two that together have its volume, through corners and along
// edges and faces, too; the surface stays closed.
TEST(ConvexPolyhedron, ClippedParts)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> small(-2, 2);
  for (int trial = 0; trial < 300; ++trial)
  {
    ConvexPolyhedron polyhedron;
    polyhedron.SetBox({ -2, -2, -2 }, { 2, 2, 2 });
    EXPECT_EQ(polyhedron.GetVolume(), 64);
    for (int cut = 0; cut < 12; ++cut)
    {
      const Vector direction = { double(small(random)), double(small(random)),
        double(small(random)) };
      if (Norm2(direction) == 0)
      {
        continue;
      }
      HalfSpace halfSpace = { Unit(direction), small(random) / Norm(direction) };
      ConvexPolyhedron other = polyhedron;
      const double volume = polyhedron.GetVolume();
      Clip(other, { { -halfSpace.Normal, -halfSpace.Offset } });
      Clip(polyhedron, { halfSpace });
      EXPECT_NEAR(polyhedron.GetVolume() + other.GetVolume(), volume, 1e-11) << trial;
      ExpectClosed(polyhedron);
    }
  }
}

// Random planes, most of which cut nothing; many planes through one corner, along one direction,
// and equal but for rounding. If this fails, a kernel depends on the order of the faces.
TEST(ConvexPolyhedron, TogetherAndOneByOne)
{
  std::mt19937 random(19);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> offset(0.5, 1.5);
  for (int trial = 0; trial < 20; ++trial)
  {
    std::vector<HalfSpace> halfSpaces;
    for (int i = 0; i < 100 * (trial + 1); ++i)
    {
      const Vector direction = Unit({ normal(random), normal(random), normal(random) });
      halfSpaces.push_back({ direction, offset(random) });
    }
    ExpectSameAsOneByOne(halfSpaces);
  }
  ExpectSameAsOneByOne(MakeTangents(1500)); // enough to be shuffled

  // The sides of a cone, all through its apex, and of a prism, all along one direction.
  for (const double slope : { 1.0, 0.0 })
  {
    std::vector<HalfSpace> sides;
    for (int i = 0; i < 101; ++i)
    {
      const double angle = 2 * Pi * i / 101;
      const Vector direction = Unit({ std::cos(angle), std::sin(angle), slope });
      sides.push_back({ direction, Dot(direction, slope > 0 ? Vector{ 0, 0, 1 } : direction) });
    }
    ExpectSameAsOneByOne(sides);
  }

  // The sides of a cube a thousand times each, nearly: no more than six faces.
  std::uniform_real_distribution<double> rounding(-1e-14, 1e-14);
  std::vector<HalfSpace> nearly;
  for (int i = 0; i < 6000; ++i)
  {
    const double sign = i % 2 ? 1 : -1;
    Vector direction = { rounding(random), rounding(random), rounding(random) };
    (i % 6 < 2 ? direction.X : i % 6 < 4 ? direction.Y : direction.Z) += sign;
    nearly.push_back({ direction, 1 });
  }
  ConvexPolyhedron cube = MakeBox(2);
  Clip(cube, nearly);
  ExpectClosed(cube);
  EXPECT_EQ(cube.GetNumberOfFaces(), 6);
  EXPECT_NEAR(cube.GetVolume(), 8, 1e-11);
}

// Twenty thousand planes around a ball: every one has its face, and simple corners make Euler's
// 2 F - 4 of them; the volume is a third of the surface, as every plane is 1 away from the middle.
TEST(ConvexPolyhedron, Many)
{
  const int size = 20000;
  ConvexPolyhedron ball = MakeBox(2);
  Clip(ball, MakeTangents(size));
  ExpectClosed(ball);
  EXPECT_EQ(ball.GetNumberOfFaces(), size);
  EXPECT_NEAR(static_cast<double>(ball.GetPoints().size()), 2 * size - 4, 10);
  double surface = 0;
  for (int f = 0; f < ball.GetNumberOfFaces(); ++f)
  {
    Vector sum;
    const int* face = ball.GetFace(f);
    for (int i = 2; i < ball.GetFaceSize(f); ++i)
    {
      sum += Cross(ball.GetPoints()[face[i - 1]] - ball.GetPoints()[face[0]],
        ball.GetPoints()[face[i]] - ball.GetPoints()[face[0]]);
    }
    surface += Norm(sum) / 2;
  }
  EXPECT_NEAR(ball.GetVolume(), surface / 3, 1e-9);
  EXPECT_GT(ball.GetVolume(), 4 * Pi / 3);
  EXPECT_LT(ball.GetVolume(), 4 * Pi / 3 * (1 + 10.0 / size));
}

// No point is inside: nothing is left, and nothing more happens to it.
TEST(ConvexPolyhedron, Empty)
{
  std::vector<HalfSpace> halfSpaces = MakeTangents(50);
  halfSpaces.push_back({ { 0, 0, 1 }, -1.5 });
  ConvexPolyhedron ball = MakeBox(2);
  Clip(ball, halfSpaces);
  EXPECT_TRUE(ball.IsEmpty());
  EXPECT_EQ(ball.GetNumberOfFaces(), 0);
  Clip(ball, halfSpaces);
  EXPECT_TRUE(ball.IsEmpty());
}

// Stopping leaves at once; progress runs from 0 upwards, a hundred times at most.
TEST(ConvexPolyhedron, ProgressAndAbort)
{
  std::vector<double> reports;
  ConvexPolyhedron ball = MakeBox(2);
  EXPECT_TRUE(ball.Clip(MakeTangents(5000), Tolerance,
    [&](double done)
    {
      reports.push_back(done);
      return true;
    }));
  EXPECT_GT(reports.size(), 50u);
  EXPECT_LE(reports.size(), 100u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.front(), 0);
  EXPECT_LT(reports.back(), 1);
  int calls = 0;
  ball = MakeBox(2);
  EXPECT_FALSE(ball.Clip(MakeTangents(5000), Tolerance, [&](double) { return ++calls < 3; }));
  EXPECT_EQ(calls, 3);
  // What was stopped can be used for another one.
  ball.SetBox({ -1, -1, -1 }, { 1, 1, 1 });
  Clip(ball, { { { 0, 0, 1 }, 0 } });
  EXPECT_NEAR(ball.GetVolume(), 4, 1e-12);
}
