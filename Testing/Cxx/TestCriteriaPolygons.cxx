// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of cells that polygons have, too, with edges for faces; and what lies in a plane or is folded onto itself.
#include "Criteria/CellStatusBits.h"

#include "CriteriaTesting.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
double Get(const Values& values, const char* name)
{
  return values.at(name)[0];
}
}

//------------------------------------------------------------------------------
// By hand: a square, and an L of three of them, whose centroid is at (5/6, 5/6).
TEST(CriteriaPolygons, CutAtTheCentroid)
{
  const Values square = EvaluateAll(MakePolygon({ { 0, 0, 7 }, { 1, 0, 7 }, { 1, 1, 7 }, { 0, 1, 7 } }));
  EXPECT_NEAR(Get(square, "MinFacePyramidVolume"), 0.25, 1e-15);
  EXPECT_NEAR(Get(square, "MinFacePyramidRatio"), 1, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetVolume"), 0.25, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetMeanRatio"), std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetQuality"), 0.25 / (0.75 * std::sqrt(3.0) * 0.25), 1e-15);
  EXPECT_NEAR(Get(square, "CellConcavity"), -0.5 / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(Get(square, "CellIsotropy"), 1, 1e-15);

  const Values corner =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } }));
  EXPECT_NEAR(Get(corner, "MinFacePyramidVolume"), 1.0 / 12, 1e-15);
  EXPECT_NEAR(Get(corner, "MinFacePyramidRatio"), 6.0 / 12 / 3, 1e-15);
  EXPECT_NEAR(Get(corner, "MinTetVolume"), 1.0 / 12, 1e-15);
  EXPECT_NEAR(Get(corner, "CellConcavity"), 0.5 / std::sqrt(8.0), 1e-15);
  EXPECT_NEAR(Get(corner, "CellIsotropy"), 1, 1e-15); // as much edge in either direction

  // A corner that has two points is one, too.
  const Values twice = EvaluateAll(MakePolygon(
    { { 1, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 1, 0 } }));
  EXPECT_NEAR(Get(twice, "CellConcavity"), 0.5 / std::sqrt(8.0), 1e-15);

  // A quarter of the rectangle's edges are short: T = diag(2, 18), 4 * 36 / 400.
  const Values rectangle = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 0, 1 }, { 0, 0, 1 } }));
  EXPECT_NEAR(Get(rectangle, "CellIsotropy"), 0.36, 1e-15);

  // Warped: the triangles have the area 1 in the mean plane, the circumradius 1.5 in space.
  const Values warped = EvaluateAll(MakePolygon({ { 1, 1, 1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, -1 } }));
  EXPECT_NEAR(Get(warped, "MinTetQuality"), 1 / (0.75 * std::sqrt(3.0) * 2.25), 1e-15);

  // The centroid of a dart lies outside.
  const Values dart = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 4, -4, 0 }, { 1, 0, 0 }, { 4, 4, 0 } }));
  EXPECT_LT(Get(dart, "MinTetVolume"), 0);
  EXPECT_LT(Get(dart, "MinTetMeanRatio"), 0);
  EXPECT_GT(Get(dart, "CellConcavity"), 0);
}

//------------------------------------------------------------------------------
// The regular polygons are the best ones, wherever they lie.
TEST(CriteriaPolygons, RegularOnes)
{
  for (const int size : { 3, 5, 6, 17 })
  {
    Points points;
    for (int i = 0; i < size; ++i)
    {
      const double angle = 2 * Pi * i / size;
      points.push_back({ 5 + std::cos(angle), std::sin(angle), 3 + std::cos(angle) });
      points.back()[0] = 5 + std::cos(angle) / std::sqrt(2.0);
      points.back()[2] = 3 + std::cos(angle) / std::sqrt(2.0);
    }
    const Values values = EvaluateAll(MakePolygon(points));
    EXPECT_NEAR(Get(values, "CellIsotropy"), 1, 1e-12) << size;
    EXPECT_NEAR(Get(values, "MinFacePyramidRatio"), 1, 1e-12) << size;
    const double side = 2 * std::sin(Pi / size), area = std::sin(2 * Pi / size) / 2;
    EXPECT_NEAR(Get(values, "MinTetVolume"), area, 1e-12) << size;
    EXPECT_NEAR(Get(values, "MinTetMeanRatio"), 4 * std::sqrt(3.0) * area / (2 + side * side), 1e-12) << size;
    const double radius = side / (4 * area);
    EXPECT_NEAR(Get(values, "MinTetQuality"), area / (0.75 * std::sqrt(3.0) * radius * radius), 1e-12) << size;
  }
}

//------------------------------------------------------------------------------
TEST(CriteriaPolygons, WithoutAnArea)
{
  const Values line = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }));
  for (const char* name : { "MinFacePyramidVolume", "MinTetVolume", "MinTetMeanRatio", "MinTetQuality", "CellIsotropy" })
  {
    EXPECT_EQ(Get(line, name), 0) << name;
  }
  EXPECT_EQ(GetNullReason(Get(line, "MinFacePyramidRatio")), NullReason::Degenerate);
  EXPECT_EQ(GetNullReason(Get(line, "CellConcavity")), NullReason::Degenerate);
  const Values place = EvaluateAll(MakePolygon({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }));
  EXPECT_EQ(GetNullReason(Get(place, "CellIsotropy")), NullReason::Degenerate);
}

//------------------------------------------------------------------------------
// If this fails, points in one place are not found where all are.
TEST(CriteriaPolygons, PointsInOnePlace)
{
  const Points points(4, { 1, 2, 3 });
  const auto status = [](const Grid& grid) { return static_cast<unsigned>(EvaluateAll(grid)["CellStatus"][0]); };
  EXPECT_NE(status(MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } } })) & CoincidentPoints, 0u);
  EXPECT_NE(status(MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } } })) & CoincidentPoints, 0u);
}

//------------------------------------------------------------------------------
// If this fails, rounding decides about hexahedra and wedges without thickness, whose centroid is the centre of a face.
TEST(CriteriaPolygons, OrthogonalQualityOfFlatCells)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const auto point = [&] { return Point{ anywhere(random), anywhere(random), anywhere(random) }; };
  for (int trial = 0; trial < 200; ++trial)
  {
    const Point a = point(), b = point(), c = point();
    Point d;
    for (int i = 0; i < 3; ++i)
    {
      d[i] = a[i] + c[i] - b[i];
    }
    const Grid hexahedron = MakeGrid({ a, b, c, d, a, b, c, d }, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
    EXPECT_EQ(EvaluateAll(hexahedron)["OrthogonalQuality"][0], 0) << trial;
    const Grid wedge = MakeGrid({ a, b, c, a, b, c }, { { VTK_WEDGE, { 0, 1, 2, 3, 4, 5 } } });
    EXPECT_EQ(EvaluateAll(wedge)["OrthogonalQuality"][0], 0) << trial;
  }
}

//------------------------------------------------------------------------------
// If this fails, rounding turns an angle of 0 into one of 360 degrees.
TEST(CriteriaPolygons, SurfacesFoldedFlat)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  for (int trial = 0; trial < 200; ++trial)
  {
    Points points;
    for (int i = 0; i < 3; ++i)
    {
      points.push_back({ anywhere(random), anywhere(random), anywhere(random) });
    }
    for (const std::vector<vtkIdType>& back : { std::vector<vtkIdType>{ 2, 1, 0 }, { 1, 0, 2 }, { 0, 2, 1 } })
    {
      const Values values = EvaluateAll(MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, back } }));
      for (const int cell : { 0, 1 })
      {
        EXPECT_EQ(values.at("MaxSurfaceDihedralAngle")[cell], 0) << trial;
        EXPECT_EQ(values.at("MinSurfaceDihedralAngle")[cell], 0) << trial;
      }
    }
  }
}
