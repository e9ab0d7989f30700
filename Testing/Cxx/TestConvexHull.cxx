// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Number.h"
#include "Geometry/ConvexHull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>

using namespace camaron;

namespace
{
using HullPoints = std::vector<Vector>;

//------------------------------------------------------------------------------
// The sizes of the faces, in order. Every edge is used once in each direction, the surface is a
// sphere (Euler), and no point is outside of a face.
std::vector<std::size_t> CheckHull(const HullPoints& points, double tolerance)
{
  ConvexHull hull;
  hull.Compute(points);
  std::map<std::pair<int, int>, int> edges;
  std::set<int> corners;
  std::vector<std::size_t> sizes;
  for (const std::vector<int>& face : hull.GetFaces())
  {
    sizes.push_back(face.size());
    Vector normal;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const int a = face[i], b = face[(i + 1) % face.size()];
      EXPECT_EQ((++edges[{ a, b }]), 1);
      corners.insert(a);
      normal += Cross(points[a] - points[face[0]], points[b] - points[face[0]]);
    }
    normal = Unit(normal);
    for (const Vector& point : points)
    {
      EXPECT_LE(Dot(normal, point - points[face[0]]), tolerance);
    }
  }
  for (const auto& edge : edges)
  {
    EXPECT_EQ((edges.count({ edge.first.second, edge.first.first })), 1u);
  }
  if (!sizes.empty())
  {
    EXPECT_EQ(corners.size() + sizes.size(), edges.size() / 2 + 2);
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

//------------------------------------------------------------------------------
HullPoints MakeLattice(int n)
{
  HullPoints points;
  for (int i = 0; i < n * n * n; ++i)
  {
    points.push_back({ i % n / (n - 1.0), i / n % n / (n - 1.0), i / n / n / (n - 1.0) });
  }
  return points;
}

//------------------------------------------------------------------------------
HullPoints MakePrism(int n)
{
  HullPoints points;
  for (int i = 0; i < 2 * n; ++i)
  {
    points.push_back({ std::cos(2 * Pi * i / n), std::sin(2 * Pi * i / n), i < n ? -0.7 : 1.1 });
  }
  return points;
}

//------------------------------------------------------------------------------
HullPoints Map(HullPoints points, const std::function<Vector(const Vector&)>& map)
{
  std::transform(points.begin(), points.end(), points.begin(), map);
  return points;
}

//------------------------------------------------------------------------------
// A rotation about an axis that is none of the coordinates', and the same rounded to single
// precision.
Vector Turn(const Vector& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Vector q = { c * p.X - s * p.Y, s * p.X + c * p.Y, p.Z };
  return { q.X, c * q.Y - s * q.Z, s * q.Y + c * q.Z };
}

//------------------------------------------------------------------------------
Vector ToFloat(const Vector& p)
{
  return { static_cast<float>(p.X), static_cast<float>(p.Y), static_cast<float>(p.Z) };
}
}

//------------------------------------------------------------------------------
// Faces are whole, whatever the precision, the place, the size and the proportions of the cell.
TEST(ConvexHull, WholeFaces)
{
  const std::vector<std::size_t> cube(6, 4);
  for (const double scale : { 1e-3, 1.0, 1e4 })
  {
    for (const double offset : { 0.0, 3.0, 100.0 })
    {
      for (const double slender : { 1.0, 0.01, 20.0 })
      {
        const auto place = [=](const Vector& p)
        {
          const Vector q = scale * Turn({ p.X, p.Y, slender * p.Z });
          return Vector{ q.X + scale * offset, q.Y, q.Z };
        };
        SCOPED_TRACE(
          std::to_string(scale) + " " + std::to_string(offset) + " " + std::to_string(slender));
        const HullPoints points = Map(MakeLattice(2), place);
        EXPECT_EQ(CheckHull(points, 1e-12 * scale * (1 + offset)), cube);
        EXPECT_EQ(CheckHull(Map(points, ToFloat), 2e-6 * scale * (20 + offset)), cube);
      }
    }
  }
  for (int n = 3; n <= 12; ++n)
  {
    std::vector<std::size_t> prism(n, 4);
    prism.insert(prism.end(), 2, n);
    std::sort(prism.begin(), prism.end());
    EXPECT_EQ(CheckHull(Map(MakePrism(n), Turn), 1e-12), prism) << n;
    EXPECT_EQ(CheckHull(Map(Map(MakePrism(n), Turn), ToFloat), 1e-5), prism) << n;
  }
}

//------------------------------------------------------------------------------
// Regular polyhedra.
TEST(ConvexHull, RegularPolyhedra)
{
  HullPoints octahedron;
  for (const double x : { -1.0, 1.0 })
  {
    octahedron.insert(octahedron.end(), { { x, 0, 0 }, { 0, x, 0 }, { 0, 0, x } });
  }
  EXPECT_EQ(CheckHull(octahedron, 1e-12), std::vector<std::size_t>(8, 3));
  const double golden = (1 + std::sqrt(5.0)) / 2;
  HullPoints dodecahedron;
  for (const double a : { -1.0, 1.0 })
  {
    for (const double b : { -1.0, 1.0 })
    {
      dodecahedron.insert(dodecahedron.end(), { { a, b, 1 }, { a, b, -1 } });
      dodecahedron.insert(dodecahedron.end(),
        { { 0, a * golden, b / golden }, { a * golden, b / golden, 0 },
          { b / golden, 0, a * golden } });
    }
  }
  EXPECT_EQ(CheckHull(dodecahedron, 1e-12), std::vector<std::size_t>(12, 5));
  EXPECT_EQ(
    CheckHull(Map(Map(dodecahedron, Turn), ToFloat), 1e-5), std::vector<std::size_t>(12, 5));
}

//------------------------------------------------------------------------------
// Points inside of the hull, of faces and of edges, and points that are there twice, are no
// corners.
TEST(ConvexHull, PointsThatAreNoCorners)
{
  const std::vector<std::size_t> cube(6, 4);
  for (const int n : { 3, 4, 6 })
  {
    EXPECT_EQ(CheckHull(MakeLattice(n), 1e-12), cube) << n;
    EXPECT_EQ(CheckHull(Map(MakeLattice(n), Turn), 1e-12), cube) << n;
    EXPECT_EQ(CheckHull(Map(Map(MakeLattice(n), Turn), ToFloat), 1e-5), cube) << n;
  }
  HullPoints twice = MakeLattice(2);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 4);
  EXPECT_EQ(CheckHull(twice, 1e-12), cube);
}

//------------------------------------------------------------------------------
// A face that is bent by more than rounding is not whole.
TEST(ConvexHull, BentFaces)
{
  for (const double bend : { 1e-4, 1e-2 })
  {
    HullPoints points = Map(MakeLattice(2), Turn);
    points[7] = points[7] + bend * Unit(points[7] - points[0]);
    EXPECT_EQ(CheckHull(points, 1e-12).size(), 9u) << bend;
    EXPECT_EQ(CheckHull(Map(points, ToFloat), 1e-6).size(), 9u) << bend;
  }
}

//------------------------------------------------------------------------------
// Points of a sphere are all corners of triangles, also where it is flattened.
TEST(ConvexHull, ManyPoints)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const int n : { 4, 5, 20, 60, 300, 1200 })
  {
    for (const double flat : { 1.0, 1e-4 })
    {
      HullPoints points;
      for (int i = 0; i < n; ++i)
      {
        const double x = normal(random), y = normal(random), z = normal(random);
        const Vector p = Unit({ x, y, z });
        points.push_back({ p.X, p.Y, flat * p.Z });
      }
      EXPECT_EQ(CheckHull(points, 1e-9), std::vector<std::size_t>(2 * n - 4, 3))
        << n << " " << flat;
    }
  }
}

//------------------------------------------------------------------------------
// Sets without a volume have no faces.
TEST(ConvexHull, FlatSets)
{
  for (const auto& map : { std::function<Vector(const Vector&)>(Turn),
         std::function<Vector(const Vector&)>([](const Vector& p) { return p; }) })
  {
    HullPoints plane = MakeLattice(3);
    plane.resize(9);
    EXPECT_TRUE(CheckHull(Map(plane, map), 0).empty());
    EXPECT_TRUE(CheckHull(Map(HullPoints(plane.begin(), plane.begin() + 3), map), 0).empty());
    EXPECT_TRUE(CheckHull(Map(HullPoints(plane.begin(), plane.begin() + 1), map), 0).empty());
    EXPECT_TRUE(CheckHull(Map(HullPoints(5, plane[1]), map), 0).empty());
  }
  EXPECT_TRUE(CheckHull({}, 0).empty());
}
