// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of polygons, also those that have edges for faces; and what lies in a plane or is folded
// onto itself.
#include "Cell/CellDefects.h"

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
// The published table of polygons.
TEST(CriteriaPolygons, ReferenceValues)
{
  const double h = std::sqrt(3.0) / 2;
  struct Row
  {
    const char* Name;
    Points Polygon;
    double Area, Perimeter, Vertices, EdgeLengthRatio, MinAngle, MaxAngle, Skewness, Quotient;
    double Flatness = 1;
  };
  const Row rows[] = {
    { "square", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, 1, 4, 4, 1, 90, 90, 0,
      0.7853981633974 },
    { "rectangle", { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } }, 2, 6, 4, 0.5, 90, 90, 0,
      0.6981317007977 },
    { "rhombus", { { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, h, 0 }, { .5, h, 0 } }, 0.8660254037844, 4, 4,
      1, 60, 120, 0.3333333333333, 0.6801747615878 },
    { "pentagon", MakeRegularPolygon(5, 0), 1.720477400589, 5, 5, 1, 108, 108, 0, 0.8648062659772 },
    { "hexagon", MakeRegularPolygon(6, 0), 2.598076211353, 6, 6, 1, 120, 120, 0, 0.9068996821171 },
    { "equilateral", { { 0, 0, 0 }, { 1, 0, 0 }, { .5, h, 0 } }, 0.4330127018922, 3, 3, 1, 60, 60,
      0, 0.6045997880781 },
    { "right isosceles", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.5, 3.414213562373, 3,
      0.7071067811865, 45, 90, 0.25, 0.5390120844526 },
    { "3-4-5", { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 6, 12, 3, 0.6, 36.86989764584, 90,
      0.3855017059026, 0.5235987755983 },
    { "L hexagon", { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } },
      3, 8, 6, 0.5, 90, 270, 2.5, 0.5890486225481 },
    { "warped quad", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, .5 }, { 0, 1, 0 } }, 1.06066017178,
      4.2360679775, 4, 0.8944271909999, 78.46304096718, 90, 0.1281884336979, 0.7427801407227,
      0.9746721852373 },
  };
  for (const Row& row : rows)
  {
    const Values values = EvaluateAll(MakePolygon(row.Polygon));
    const auto expect = [&](const char* name, double expected)
    { ExpectNear(expected, values.at(name)[0], 1e-10, std::string(row.Name) + ' ' + name); };
    expect("Area", row.Area);
    expect("Perimeter", row.Perimeter);
    expect("VertexCount", row.Vertices);
    expect("EdgeCount", row.Vertices);
    expect("EdgeLengthRatio", row.EdgeLengthRatio);
    expect("MinInteriorAngle", row.MinAngle);
    expect("MaxInteriorAngle", row.MaxAngle);
    expect("EquiangleSkewness", row.Skewness);
    expect("IsoperimetricQuotient", row.Quotient);
    expect("MinFaceFlatness", row.Flatness);
  }
}

//------------------------------------------------------------------------------
// By hand: a square, and an L of three of them, whose centroid is at (5/6, 5/6).
TEST(CriteriaPolygons, CutAtTheCentroid)
{
  const Values square =
    EvaluateAll(MakePolygon({ { 0, 0, 7 }, { 1, 0, 7 }, { 1, 1, 7 }, { 0, 1, 7 } }));
  EXPECT_NEAR(Get(square, "MinFacePyramidVolume"), 0.25, 1e-15);
  EXPECT_NEAR(Get(square, "MinFacePyramidRatio"), 1, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetVolume"), 0.25, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetMeanRatio"), std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(Get(square, "MinTetQuality"), 0.25 / (0.75 * std::sqrt(3.0) * 0.25), 1e-15);
  EXPECT_NEAR(Get(square, "CellConcavity"), -0.5 / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(Get(square, "CellIsotropy"), 1, 1e-15);

  const Values corner = EvaluateAll(
    MakePolygon({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } }));
  EXPECT_NEAR(Get(corner, "MinFaceConcavity"), 90, 1e-12);
  EXPECT_NEAR(Get(corner, "MinFacePyramidVolume"), 1.0 / 12, 1e-15);
  EXPECT_NEAR(Get(corner, "MaxFacePyramidVolume"), 5.0 / 6, 1e-15);
  EXPECT_NEAR(Get(corner, "MinFacePyramidRatio"), 6.0 / 12 / 3, 1e-15);
  EXPECT_NEAR(Get(corner, "MinTetVolume"), 1.0 / 12, 1e-15);
  EXPECT_NEAR(Get(corner, "CellConcavity"), 0.5 / std::sqrt(8.0), 1e-15);
  EXPECT_NEAR(Get(corner, "CellIsotropy"), 1, 1e-15); // as much edge in either direction

  // A corner that has two points is one, too.
  const Values twice = EvaluateAll(MakePolygon({ { 1, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 },
    { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 2, 1, 0 } }));
  EXPECT_NEAR(Get(twice, "CellConcavity"), 0.5 / std::sqrt(8.0), 1e-15);

  // A quarter of the rectangle's edges are short: T = diag(2, 18), 4 * 36 / 400.
  const Values rectangle =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 0, 1 }, { 0, 0, 1 } }));
  EXPECT_NEAR(Get(rectangle, "CellIsotropy"), 0.36, 1e-15);

  // Warped: the triangles have the area 1 in the mean plane, the circumradius 1.5 in space.
  const Values warped =
    EvaluateAll(MakePolygon({ { 1, 1, 1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, -1 } }));
  EXPECT_NEAR(Get(warped, "MinTetQuality"), 1 / (0.75 * std::sqrt(3.0) * 2.25), 1e-15);

  // The centroid of a dart lies outside.
  const Values dart =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 4, -4, 0 }, { 1, 0, 0 }, { 4, 4, 0 } }));
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
    EXPECT_NEAR(
      Get(values, "MinTetMeanRatio"), 4 * std::sqrt(3.0) * area / (2 + side * side), 1e-12)
      << size;
    const double radius = side / (4 * area);
    EXPECT_NEAR(
      Get(values, "MinTetQuality"), area / (0.75 * std::sqrt(3.0) * radius * radius), 1e-12)
      << size;
  }
}

//------------------------------------------------------------------------------
TEST(CriteriaPolygons, WithoutAnArea)
{
  const Values line = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }));
  for (const char* name :
    { "MinFacePyramidVolume", "MinTetVolume", "MinTetMeanRatio", "MinTetQuality", "CellIsotropy" })
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
  const auto status = [](const Grid& grid)
  { return static_cast<unsigned>(EvaluateAll(grid)["CellStatus"][0]); };
  EXPECT_NE(status(MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } } })) & CoincidentPoints, 0u);
  EXPECT_NE(status(MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } } })) & CoincidentPoints, 0u);
}

//------------------------------------------------------------------------------
// If this fails, rounding decides about hexahedra and wedges without thickness, whose centroid is
// the center of a face.
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
    const Grid hexahedron =
      MakeGrid({ a, b, c, d, a, b, c, d }, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
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
    for (const std::vector<vtkIdType>& back :
      { std::vector<vtkIdType>{ 2, 1, 0 }, { 1, 0, 2 }, { 0, 2, 1 } })
    {
      const Values values =
        EvaluateAll(MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, back } }));
      for (const int cell : { 0, 1 })
      {
        EXPECT_EQ(values.at("MaxSurfaceDihedralAngle")[cell], 0) << trial;
        EXPECT_EQ(values.at("MinSurfaceDihedralAngle")[cell], 0) << trial;
      }
    }
  }
}
