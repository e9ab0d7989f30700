// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of the criteria against tables that an independent program computed from closed forms, against
// themselves under what must not change them, and on degenerate cells.
#include "Criteria/CellStatusBits.h"

#include "CriteriaTesting.h"
#include "ReferenceShapes.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

// The published table of polyhedra, to all digits it prints; every shape as a polyhedron and, where
// there is one, as a cell of a standard type.
TEST(Criteria, ReferencePolyhedra)
{
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    for (vtkUnstructuredGrid* grid : { shape.Standard.Get(), shape.Polyhedron.Get() })
    {
      if (grid)
      {
        const Values values = EvaluateAll(grid);
        for (const auto& expected : shape.Expected)
        {
          ExpectNear(expected.second, values.at(expected.first)[0], 1e-9,
            std::string(shape.Name) + ' ' + expected.first);
        }
      }
    }
  }
}

// Closed forms to 1e-12: the angles that the original program got wrong.
TEST(Criteria, ClosedForms)
{
  const auto value = [](const Grid& grid, const char* name) { return EvaluateAll(grid)[name][0]; };
  const Grid tetrahedron = FindReferenceShape("regular tetrahedron").Polyhedron;
  EXPECT_NEAR(value(tetrahedron, "MinSolidAngle"), std::acos(23.0 / 27), 1e-12);
  EXPECT_NEAR(value(tetrahedron, "MaxSolidAngle"), 3 * std::acos(1.0 / 3) - Pi, 1e-12);
  const Grid octahedron = FindReferenceShape("truncated octahedron").Polyhedron;
  EXPECT_NEAR(value(octahedron, "MinSolidAngle"), Pi, 1e-12);
  EXPECT_NEAR(value(octahedron, "MaxSolidAngle"), Pi, 1e-12);
  EXPECT_NEAR(value(octahedron, "Volume"), 8 * std::sqrt(2.0), 1e-12);
  const Grid cube = FindReferenceShape("unit cube").Polyhedron;
  EXPECT_NEAR(value(cube, "MinSolidAngle"), Pi / 2, 1e-12);
  const Grid far = Transform(cube, [](const Point& p) { return Point{ p[0] + 1e6, p[1], p[2] }; });
  EXPECT_EQ(value(far, "Volume"), 1);
  EXPECT_NEAR(value(FindReferenceShape("L-prism").Polyhedron, "MaxSolidAngle"), 1.5 * Pi, 1e-12);
}

// The published table of polygons.
TEST(Criteria, ReferencePolygons)
{
  const double h = std::sqrt(3.0) / 2;
  struct Row
  {
    const char* Name;
    Points Polygon;
    double Area, Perimeter, Vertices, EdgeLengthRatio, MinAngle, MaxAngle, Skewness, Quotient;
  };
  const Row rows[] = {
    { "square", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, 1, 4, 4, 1, 90, 90, 0,
      0.7853981634 },
    { "rectangle", { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } }, 2, 6, 4, 0.5, 90, 90, 0,
      0.6981317008 },
    { "rhombus", { { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, h, 0 }, { .5, h, 0 } }, 0.8660254038, 4, 4, 1, 60,
      120, 0.3333333333, 0.6801747616 },
    { "pentagon", MakeRegularPolygon(5, 0), 1.720477401, 5, 5, 1, 108, 108, 0, 0.864806266 },
    { "hexagon", MakeRegularPolygon(6, 0), 2.598076211, 6, 6, 1, 120, 120, 0, 0.9068996821 },
    { "equilateral", { { 0, 0, 0 }, { 1, 0, 0 }, { .5, h, 0 } }, 0.4330127019, 3, 3, 1, 60, 60, 0,
      0.6045997881 },
    { "right isosceles", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.5, 3.414213562, 3,
      0.7071067812, 45, 90, 0.25, 0.5390120845 },
    { "3-4-5", { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 6, 12, 3, 0.6, 36.86989765, 90,
      0.3855017059, 0.5235987756 },
    { "L hexagon",
      { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } }, 3, 8, 6, 0.5,
      90, 270, 2.5, 0.5890486225 },
    { "warped quad", { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, .5 }, { 0, 1, 0 } }, 1.060660172,
      4.236067977, 4, 0.894427191, 78.46304097, 90, 0.1281884337, 0.7427801407 },
  };
  for (const Row& row : rows)
  {
    const Values values = EvaluateAll(MakePolygon(row.Polygon));
    const auto expect = [&](const char* name, double expected)
    { ExpectNear(expected, values.at(name)[0], 1e-9, std::string(row.Name) + ' ' + name); };
    expect("Area", row.Area);
    expect("Perimeter", row.Perimeter);
    expect("VertexCount", row.Vertices);
    expect("EdgeCount", row.Vertices);
    expect("EdgeLengthRatio", row.EdgeLengthRatio);
    expect("MinInteriorAngle", row.MinAngle);
    expect("MaxInteriorAngle", row.MaxAngle);
    expect("EquiangleSkewness", row.Skewness);
    expect("IsoperimetricQuotient", row.Quotient);
  }
}

// The published table of triangles and tetrahedra.
TEST(Criteria, ReferenceSimplices)
{
  const double h = std::sqrt(3.0) / 2;
  const struct
  {
    Points Triangle;
    double RadiusRatio, BhatiaLawrence;
  } triangles[] = { { { { 0, 0, 0 }, { 1, 0, 0 }, { .5, h, 0 } }, 1, 1 },
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.8284271247, 0.8660254038 },
    { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 0.8, 0.8313843876 } };
  for (const auto& row : triangles)
  {
    const Values values = EvaluateAll(MakePolygon(row.Triangle));
    ExpectNear(row.RadiusRatio, values.at("TriangleRadiusRatio")[0], 1e-9, "TriangleRadiusRatio");
    ExpectNear(row.BhatiaLawrence, values.at("BhatiaLawrence")[0], 1e-9, "BhatiaLawrence");
  }
  const struct
  {
    const char* Name;
    double RadiusRatio, RadiusEdgeRatio, MeanRatio;
  } tetrahedra[] = { { "regular tetrahedron", 1, 0.6123724357, 1 },
    { "right-corner tetrahedron", 0.7320508076, 0.8660254038, 0.8399473666 },
    { "flat sliver", 0.02999250221, 0.707071432, 0.08771176097 } };
  for (const auto& row : tetrahedra)
  {
    const ReferenceShape& shape = FindReferenceShape(row.Name);
    for (vtkUnstructuredGrid* grid : { shape.Standard.Get(), shape.Polyhedron.Get() })
    {
      const Values values = EvaluateAll(grid);
      ExpectNear(row.RadiusRatio, values.at("TetRadiusRatio")[0], 1e-9, row.Name);
      ExpectNear(row.RadiusEdgeRatio, values.at("TetRadiusEdgeRatio")[0], 1e-9, row.Name);
      ExpectNear(row.MeanRatio, values.at("TetMeanRatio")[0], 1e-9, row.Name);
    }
  }
}

// A cell of every standard type has the same values as its faces written as a polyhedron, also when it
// is warped; its volume is positive in VTK's node order.
// Three measures of Verdict depend on the order of the nodes.
TEST(Criteria, StandardTypesEqualPolyhedra)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  for (const int type : StandardTypes3D)
  {
    const Grid healthy = MakeStandardCell(type);
    const Grid warped = Transform(healthy,
      [&](const Point& p)
      { return Point{ p[0] + noise(random), p[1] + noise(random), p[2] + noise(random) }; });
    for (const Grid& grid : { healthy, warped })
    {
      const Values standard = EvaluateAll(grid);
      EXPECT_GT(standard.at("Volume")[0], 0) << type;
      ExpectSame(standard, EvaluateAll(ToPolyhedra(grid)), 1e-12, "type " + std::to_string(type),
        { "CellTypeId", "VerdictEdgeRatio", "VerdictMinAngle", "VerdictCollapseRatio" });
    }
  }
}

// Of a tetrahedron the solid angles are twice the dihedral angles less a full sphere.
TEST(Criteria, SolidAnglesOfTetrahedron)
{
  const Values values = EvaluateAll(FindReferenceShape("right-corner tetrahedron").Standard);
  // Three corners alike and one right one: 3 x Min + Max = 2 (3 x 54.7 deg + 3 x 90 deg) - 4 pi.
  const double dihedral = 3 * std::acos(1 / std::sqrt(3.0)) + 3 * Pi / 2;
  EXPECT_NEAR(3 * values.at("MinSolidAngle")[0] + values.at("MaxSolidAngle")[0],
    2 * dihedral - 4 * Pi, 1e-12);
}

// Values that follow from the shapes by hand.
TEST(Criteria, ValuesByHand)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double r3 = std::sqrt(3.0);
  const std::map<std::string, std::map<std::string, double>> expected = {
    { "unit cube",
      { { "EdgeRatio", 1 }, { "EdgeDiameterRatio", 1 / r3 }, { "MinPointDistanceRatio", 1 / r3 },
        { "PrincipalAspectRatio", 1 }, { "Sphericity", std::cbrt(Pi / 6) }, { "VolumeEdgeRatio", 1 },
        { "CornerScaledJacobian", 1 }, { "MaxWarpage", 0 }, { "MaxFaceConcavity", 0 },
        { "CellConcavity", -0.5 / r3 }, { "MinFacePyramidRatio", 1 }, { "MinTetVolume", 1.0 / 24 },
        { "MinTetMeanRatio", 0.8 }, { "EquivalentRadius", std::cbrt(0.75 / Pi) },
        { "MinFaceArea", 1 }, { "MaxFaceArea", 1 }, { "MinFaceVertexCount", 4 },
        { "MaxFaceVertexCount", 4 }, { "TetQualityFoam", none } } },
    { "regular tetrahedron",
      { { "CornerScaledJacobian", std::sqrt(0.5) }, { "TetQualityFoam", 1 },
        { "PrincipalAspectRatio", 1 }, { "MinFacePyramidRatio", 1 } } },
    { "right-corner tetrahedron", { { "TetQualityFoam", 0.5 } } },
    { "flat sliver", { { "TetQualityFoam", 0.02597686549 }, { "EdgeRatio", 1 / 0.7071774883 } } },
    { "square pyramid",
      { { "CornerScaledJacobian", none }, { "MinFaceVertexCount", 3 }, { "MaxFaceVertexCount", 4 },
        { "MinFaceArea", r3 / 4 }, { "MaxFaceArea", 1 } } },
    { "box",
      { { "PrincipalAspectRatio", 0.25 }, { "EdgeRatio", 4 }, { "VolumeEdgeRatio", 8 / std::pow(7, 1.5) },
        { "EdgeDiameterRatio", 1 / std::sqrt(21.0) } } },
    { "sheared hex", { { "CornerScaledJacobian", std::sqrt(0.5) } } },
    { "L-prism",
      { { "CornerScaledJacobian", -1 }, { "MaxFaceConcavity", 90 }, { "CellConcavity", 1.0 / 6 },
        { "MinFaceVertexCount", 4 }, { "MaxFaceVertexCount", 6 } } },
  };
  for (const auto& shape : expected)
  {
    const Values values = EvaluateAll(FindReferenceShape(shape.first).Polyhedron);
    for (const auto& criterion : shape.second)
    {
      ExpectNear(criterion.second, values.at(criterion.first)[0], 1e-9,
        shape.first + ' ' + criterion.first);
    }
  }

  // A saddle, whose vertices lie h above and below its plane.
  const double h = 0.2;
  const Values saddle = EvaluateAll(MakeGrid(
    { { 1, 0, h }, { 0, 1, -h }, { -1, 0, h }, { 0, -1, -h } }, { { VTK_QUAD, { 0, 1, 2, 3 } } }));
  ExpectNear(h / std::sqrt(1 + h * h), saddle.at("MaxWarpage")[0], 1e-12, "saddle");
  const Values rectangle = EvaluateAll(MakeGrid(
    { { 0, 0, 5 }, { 2, 0, 5 }, { 2, 1, 5 }, { 0, 1, 5 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } }));
  ExpectNear(0.5, rectangle.at("PrincipalAspectRatio")[0], 1e-12, "rectangle");
  ExpectNear(std::sqrt(2 / Pi), rectangle.at("EquivalentRadius")[0], 1e-12, "rectangle");
  const Values triangle =
    EvaluateAll(MakeGrid({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  ExpectNear(0.8333333333, triangle.at("TriangleRadiusEdgeRatio")[0], 1e-9, "triangle");

  // The faces of a cube but one: all of that axis is open.
  const Grid& cube = FindReferenceShape("unit cube").Polyhedron;
  Faces faces = GetFaces(cube, 0);
  Points points(8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    cube->GetPoint(i, points[i].data());
  }
  faces.pop_back();
  ExpectNear(1, EvaluateAll(MakePolyhedron(points, faces)).at("Openness")[0], 1e-12, "open cube");
}

// Two cells that share a face, from the table of pairs: what each sees of the other.
TEST(Criteria, Neighbors)
{
  const auto hexahedra = [](const Points& second)
  {
    Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
      { 1, 1, 1 }, { 0, 1, 1 } };
    points.insert(points.end(), second.begin(), second.end());
    return MakeGrid(points,
      { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_HEXAHEDRON, { 1, 8, 9, 2, 5, 10, 11, 6 } } });
  };
  const double d = std::sqrt(0.5);
  const struct
  {
    const char* Name;
    Grid Mesh;
    double NonOrthogonality, Quality, Skewness, Weight, Ratio;
  } pairs[] = {
    { "two unit cubes", hexahedra({ { 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 2, 1, 1 } }), 0, 1, 0, 0.5, 1 },
    { "cube and box", hexahedra({ { 3, 0, 0 }, { 3, 1, 0 }, { 3, 0, 1 }, { 3, 1, 1 } }), 0, 1, 0, 1.0 / 3,
      0.5 },
    { "cube and sheared cube", hexahedra({ { 2, 1, 0 }, { 2, 2, 0 }, { 2, 1, 1 }, { 2, 2, 1 } }),
      26.56505118, d, 1, 0.5, 1 },
  };
  for (const auto& pair : pairs)
  {
    for (const Grid& grid : { pair.Mesh, ToPolyhedra(pair.Mesh) })
    {
      const Values values = EvaluateAll(grid);
      for (const std::size_t cell : { 0, 1 })
      {
        ExpectNear(pair.NonOrthogonality, values.at("MaxNonOrthogonality")[cell], 1e-9, pair.Name);
        ExpectNear(pair.Weight, values.at("MinFaceWeight")[cell], 1e-9, pair.Name);
        ExpectNear(pair.Ratio, values.at("MinVolumeRatio")[cell], 1e-9, pair.Name);
        ExpectNear(1 / pair.Ratio, values.at("CellVolumeRatio")[cell], 1e-9, pair.Name);
      }
      ExpectNear(pair.Quality,
        std::min(values.at("OrthogonalQuality")[0], values.at("OrthogonalQuality")[1]), 1e-9, pair.Name);
      // The skewness of the inner face is 0.5 in the third pair; the sides of the sheared cell have 1.
      ExpectNear(pair.Skewness, values.at("MaxFaceSkewness")[1], 1e-9, pair.Name);
    }
  }
  EXPECT_NEAR(EvaluateAll(pairs[2].Mesh).at("MaxFaceSkewness")[0], 0.5, 1e-9);

  // A grid of 3 x 3 x 3 cubes: the one in the middle has six inner faces.
  Points points;
  Cells cells;
  for (int i = 0; i < 64; ++i)
  {
    points.push_back({ double(i % 4), double(i / 4 % 4), double(i / 16) });
  }
  for (int i = 0; i < 27; ++i)
  {
    const vtkIdType a = i % 3 + 4 * (i / 3 % 3) + 16 * (i / 9);
    cells.push_back(
      { VTK_HEXAHEDRON, { a, a + 1, a + 5, a + 4, a + 16, a + 17, a + 21, a + 20 } });
  }
  const Values cube = EvaluateAll(MakeGrid(points, cells));
  ExpectNear(1, cube.at("CellDeterminant")[13], 1e-12, "middle");
  EXPECT_EQ(GetNullReason(cube.at("MaxBoundaryNonOrthogonality")[13]), NullReason::NoNeighbor);
  ExpectNear(0, cube.at("MaxBoundaryNonOrthogonality")[0], 1e-12, "corner");

  // Alone: nothing to compare with.
  const Values alone = EvaluateAll(FindReferenceShape("unit cube").Polyhedron);
  for (const char* name : { "MaxNonOrthogonality", "MinFaceWeight", "MinVolumeRatio", "CellVolumeRatio" })
  {
    EXPECT_EQ(GetNullReason(alone.at(name)[0]), NullReason::NoNeighbor) << name;
  }
  ExpectNear(0, alone.at("CellDeterminant")[0], 1e-12, "alone");
  const std::map<std::string, std::array<double, 2>> boundary = {
    { "right-corner tetrahedron", { 0.25, 0.9045340337 } }, { "square pyramid", { 0.25, 0.9045340337 } },
    { "sheared hex", { 1, 0.7071067812 } }, { "flat sliver", { 0.49970012, 0.02999250221 } },
    { "L-prism", { 1.333333333, 0.242535625 } }, { "warped hex", { 0.2248677249, 0.9502584925 } },
  };
  for (const auto& shape : boundary)
  {
    const Values values = EvaluateAll(FindReferenceShape(shape.first).Polyhedron);
    ExpectNear(shape.second[0], values.at("MaxFaceSkewness")[0], 1e-9, shape.first);
    ExpectNear(shape.second[1], values.at("OrthogonalQuality")[0], 1e-9, shape.first);
  }

  // A cell next to a piece border: what is beyond is not known, unless there are ghosts.
  const Grid& two = pairs[0].Mesh;
  EvaluationOptions options;
  options.IsPieceWithoutGhosts = true;
  const Values piece = EvaluateAll(two, options);
  EXPECT_EQ(GetNullReason(piece.at("MaxNonOrthogonality")[0]), NullReason::MissingGhosts);
  const unsigned char ghosts[] = { 0, 1 };
  options = EvaluationOptions();
  options.Ghosts = ghosts;
  const Values withGhost = EvaluateAll(two, options);
  ExpectNear(0, withGhost.at("MaxNonOrthogonality")[0], 1e-12, "owned");
  EXPECT_EQ(GetNullReason(withGhost.at("MaxNonOrthogonality")[1]), NullReason::MissingGhosts);

  // Polygons in a plane, with edges for faces.
  const Values squares = EvaluateAll(MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 3, 1, 0 }, { 3, 2, 0 } },
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 2, 1, 4, 5 } } }));
  ExpectNear(2, squares.at("CellVolumeRatio")[0], 1e-12, "areas");
  ExpectNear(1.0 / 3, squares.at("MinFaceWeight")[1], 1e-12, "weights");
  ExpectNear(std::atan2(0.5, 1.5) * 180 / Pi, squares.at("MaxNonOrthogonality")[0], 1e-9, "angle");
}

// What is wrong with a cell, bit by bit.
TEST(Criteria, Validity)
{
  const auto status = [](const Grid& grid)
  { return static_cast<unsigned>(EvaluateAll(grid).at("CellStatus")[0]); };
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    const unsigned expected = shape.Name == std::string("L-prism") ? Nonconvex
      : shape.Name == std::string("warped hex")                    ? NonPlanarFaces
                                                                    : 0u;
    EXPECT_EQ(status(shape.Polyhedron), expected) << shape.Name;
    const Values values = EvaluateAll(shape.Polyhedron);
    EXPECT_EQ(values.at("IsConvex")[0], !(expected & Nonconvex)) << shape.Name;
    EXPECT_EQ(values.at("IsValid")[0], 1) << shape.Name;
    EXPECT_EQ(values.at("FaceOrientationStatus")[0], 0) << shape.Name;
  }

  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
  const Faces outward = GetFaces(FindReferenceShape("unit cube").Polyhedron, 0);
  Faces faces = outward;
  faces.pop_back();
  EXPECT_EQ(status(MakePolyhedron(corners, faces)), NotWatertight | OpenCell);
  EXPECT_EQ(EvaluateAll(MakePolyhedron(corners, faces)).at("IsWatertight")[0], 0);
  faces = outward;
  for (auto& face : faces)
  {
    std::reverse(face.begin(), face.end());
  }
  EXPECT_EQ(status(MakePolyhedron(corners, faces)), FacesAreOrientedIncorrectly);
  EXPECT_EQ(EvaluateAll(MakePolyhedron(corners, faces)).at("FaceOrientationStatus")[0], 1);
  faces = outward;
  std::reverse(faces[2].begin(), faces[2].end());
  EXPECT_EQ(EvaluateAll(MakePolyhedron(corners, faces)).at("FaceOrientationStatus")[0], 2);

  Points points = corners;
  points[6] = points[5]; // an edge of no length
  EXPECT_EQ(status(MakePolyhedron(points, outward)) & (ZeroLengthEdge | CoincidentPoints),
    ZeroLengthEdge | CoincidentPoints);
  points = corners;
  points[3][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(status(MakePolyhedron(points, outward)), NonFinitePoint);
  EXPECT_EQ(
    GetNullReason(EvaluateAll(MakePolyhedron(points, outward)).at("FaceOrientationStatus")[0]),
    NullReason::Degenerate);
  const Values empty = EvaluateAll(MakePolyhedron(corners, {}));
  EXPECT_EQ(empty.at("IsWatertight")[0], 0);
  EXPECT_EQ(empty.at("IsConvex")[0], 0);

  const Points unit = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 } };
  const auto tetrahedron = [&](std::vector<vtkIdType> ids)
  { return status(MakeGrid(unit, { { VTK_TETRA, ids } })); };
  EXPECT_EQ(tetrahedron({ 0, 1, 2, 3 }), 0u);
  EXPECT_EQ(tetrahedron({ 1, 0, 2, 3 }), InvertedOrZeroVolume | FacesAreOrientedIncorrectly);
  EXPECT_EQ(tetrahedron({ 0, 1, 2, 4 }) & InvertedOrZeroVolume, InvertedOrZeroVolume);
  EXPECT_NE(tetrahedron({ 0, 1, 2, 2 }) & WrongNumberOfPoints, 0u);

  const auto polygon = [&](std::vector<vtkIdType> ids)
  { return status(MakeGrid(unit, { { VTK_POLYGON, ids } })); };
  EXPECT_EQ(polygon({ 0, 1, 4, 2 }), 0u);
  EXPECT_NE(polygon({ 0, 1, 2, 4 }) & IntersectingEdges, 0u); // a bow tie
  EXPECT_NE(polygon({ 0, 1, 4, 0, 2 }) & NoncontiguousEdges, 0u);
  EXPECT_NE(polygon({ 0, 1, 1, 4, 2 }) & CoincidentPoints, 0u);
  EXPECT_NE(polygon({ 0, 1, 0 }) & WrongNumberOfPoints, 0u);

  // A cube whose top is pushed down through its bottom.
  points = corners;
  points[6][2] = -0.5;
  EXPECT_NE(status(MakePolyhedron(points, outward)) & IntersectingFaces, 0u);

  // Two tetrahedra that meet in one point, as one cell.
  const Points pair = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 },
    { 0, 0, -1 } };
  EXPECT_EQ(status(MakePolyhedron(pair,
              { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 4, 5 }, { 0, 5, 6 }, { 0, 6, 4 },
                { 4, 6, 5 } })) &
      (NonManifoldVertex | NotWatertight),
    NonManifoldVertex);
}

//------------------------------------------------------------------------------
// If this fails, a criterion reads a part of the geometry that its row does not name.
TEST(Criteria, AloneAsTogether)
{
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    const Values together = EvaluateAll(shape.Polyhedron);
    for (const Criterion& criterion : GetCriteria())
    {
      double alone = 0;
      EXPECT_TRUE(Evaluate(MeshTopology(shape.Polyhedron), {}, { { &criterion, &alone } },
        [](double) { return true; }));
      // What CellStatus says of stars depends on the company.
      const double expected = together.at(criterion.Name)[0];
      const bool isSame = alone == expected || (std::isnan(alone) && std::isnan(expected)) ||
        (criterion.Name == std::string("CellStatus") && alone + NotStarShaped == expected);
      EXPECT_TRUE(isSame) << criterion.Name << " of " << shape.Name << ": " << alone << ' ' << expected;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, a cell of two pieces, none of which bends inward, is called convex.
TEST(Criteria, SeveralSurfacesAreNotConvex)
{
  Points points;
  Faces faces;
  for (const double x : { 0.0, 5.0 })
  {
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    points.insert(points.end(), { { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } });
    for (const auto& face : Faces{ { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } })
    {
      faces.push_back({ face[0] + first, face[1] + first, face[2] + first });
    }
  }
  const Values apart = EvaluateAll(MakePolyhedron(points, faces));
  EXPECT_EQ(apart.at("IsConvex")[0], 0);
  EXPECT_EQ(apart.at("KernelRatio")[0], 0);
  EXPECT_NEAR(apart.at("Volume")[0], 2.0 / 6, 1e-12);

  // The second one mirrored, so that both share the point 0.
  for (std::size_t i = 4; i < 8; ++i)
  {
    const Point& p = points[i - 4];
    points[i] = { -p[0], -p[1], -p[2] };
  }
  for (std::size_t f = 4; f < 8; ++f)
  {
    std::replace(faces[f].begin(), faces[f].end(), vtkIdType(4), vtkIdType(0));
    std::reverse(faces[f].begin(), faces[f].end());
  }
  const Values touching = EvaluateAll(MakePolyhedron(points, faces));
  EXPECT_EQ(touching.at("IsConvex")[0], 0);
  EXPECT_NEAR(touching.at("Volume")[0], 2.0 / 6, 1e-12);
}

// Translation, rotation, renumbering and scaling change what they should and nothing else.
TEST(Criteria, Invariance)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turn = [=](const Point& p)
  {
    const Point q = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
    return Point{ q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
  };
  std::vector<std::string> ofLength;
  for (const Criterion& criterion : GetCriteria())
  {
    if (criterion.Unit == Unit::Length || criterion.Unit == Unit::Area ||
      criterion.Unit == Unit::Volume)
    {
      ofLength.push_back(criterion.Name);
    }
  }
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    const Grid& grid = shape.Polyhedron;
    const Values values = EvaluateAll(grid);
    ExpectSame(values,
      EvaluateAll(Transform(
        grid, [](const Point& p) { return Point{ p[0] + 100, p[1] - 30, p[2] + 7 }; })),
      1e-10, std::string(shape.Name) + " moved");
    ExpectSame(values, EvaluateAll(Transform(grid, turn)), 1e-10, std::string(shape.Name) + " turned",
      { "CellAspectRatio" });
    ExpectSame(values,
      EvaluateAll(
        Transform(grid, [](const Point& p) { return Point{ 1e-3 * p[0], 1e-3 * p[1], 1e-3 * p[2] }; })),
      1e-10, std::string(shape.Name) + " scaled", ofLength);

    // Points in another order, faces started elsewhere, every second one backwards.
    const vtkIdType n = grid->GetNumberOfPoints();
    Points points(n);
    for (vtkIdType i = 0; i < n; ++i)
    {
      grid->GetPoint(i, points[n - 1 - i].data());
    }
    Faces faces = GetFaces(grid, 0);
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (vtkIdType& id : faces[f])
      {
        id = n - 1 - id;
      }
      std::rotate(faces[f].begin(), faces[f].begin() + 1, faces[f].end());
      if (f % 2)
      {
        std::reverse(faces[f].begin(), faces[f].end());
      }
    }
    std::reverse(faces.begin(), faces.end());
    ExpectSame(values, EvaluateAll(MakePolyhedron(points, faces)), 1e-10,
      std::string(shape.Name) + " renumbered",
      { "CellStatus", "FaceOrientationStatus", "VerdictEdgeRatio", "VerdictMinAngle",
        "VerdictCollapseRatio" });
  }
}

// The published table of degenerate polygons.
TEST(Criteria, DegeneratePolygons)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    const char* Name;
    Points Polygon;
    double EdgeLengthRatio, MinAngle, MaxAngle, RadiusRatio, BhatiaLawrence, Area;
  } rows[] = {
    { "collinear", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, 0.5, 0, 180, 0, 0, 0 },
    { "two equal points", { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 } }, 0, nan, nan, 0, 0, 0 },
    { "one point", { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, nan, nan, nan, nan, nan, 0 },
  };
  for (const auto& row : rows)
  {
    const Values values = EvaluateAll(MakePolygon(row.Polygon));
    const auto expect = [&](const char* name, double expected)
    { ExpectNear(expected, values.at(name)[0], 1e-12, std::string(row.Name) + ' ' + name); };
    expect("EdgeLengthRatio", row.EdgeLengthRatio);
    expect("MinInteriorAngle", row.MinAngle);
    expect("MaxInteriorAngle", row.MaxAngle);
    expect("TriangleRadiusRatio", row.RadiusRatio);
    expect("BhatiaLawrence", row.BhatiaLawrence);
    expect("Area", row.Area);
  }
  const Values quad = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }));
  for (const char* name : { "TriangleRadiusRatio", "BhatiaLawrence", "TetRadiusRatio", "Volume" })
  {
    EXPECT_EQ(GetNullReason(quad.at(name)[0]), NullReason::NotApplicable) << name;
  }
}

// The published table of degenerate polyhedra.
TEST(Criteria, DegeneratePolyhedra)
{
  // Flat: the corners of the unit square.
  const Grid flat = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  Values values = EvaluateAll(flat);
  EXPECT_EQ(values["Volume"][0], 0);
  EXPECT_EQ(values["TetRadiusEdgeRatio"][0], Infinity);
  EXPECT_EQ(values["TetRadiusRatio"][0], 0);
  EXPECT_EQ(values["TetMeanRatio"][0], 0);
  EXPECT_NEAR(values["MinDihedralAngle"][0], 0, 1e-12);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 180, 1e-12);
  EXPECT_NEAR(values["MinSolidAngle"][0], 0, 1e-12);
  EXPECT_EQ(values["CellAspectRatio"][0], Infinity);

  // Inverted: the volume says so, nothing else does.
  const Grid inverted = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 2, 1, 3 } } });
  values = EvaluateAll(inverted);
  EXPECT_NEAR(values["Volume"][0], -1.0 / 6, 1e-15);
  EXPECT_NEAR(values["TetMeanRatio"][0], -0.8399473666, 1e-9);
  EXPECT_NEAR(values["TetRadiusEdgeRatio"][0], 0.8660254038, 1e-9);
  EXPECT_NEAR(values["TetRadiusRatio"][0], 0.7320508076, 1e-9);
  EXPECT_NEAR(values["MinDihedralAngle"][0], 54.73561032, 1e-8);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 90, 1e-10);
  EXPECT_NEAR(values["MinSolidAngle"][0], 0.3398369095, 1e-9);

  // All faces of a polyhedron inward: found out, unless the user trusts them.
  const Grid inward = ToPolyhedra(inverted);
  EXPECT_NEAR(EvaluateAll(inward)["Volume"][0], 1.0 / 6, 1e-15);
  EvaluationOptions trust;
  trust.TrustFaceOrientation = true;
  values = EvaluateAll(inward, trust);
  EXPECT_NEAR(values["Volume"][0], -1.0 / 6, 1e-15);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 90, 1e-10);

  // Open: a cube without its last face.
  const ReferenceShape& cube = FindReferenceShape("unit cube");
  Faces faces = GetFaces(cube.Polyhedron, 0);
  faces.pop_back();
  values = EvaluateAll(MakePolyhedra(cube.Polyhedron->GetPoints(), { faces }));
  for (const char* name : { "Volume", "MinDihedralAngle", "MinSolidAngle", "IsoperimetricQuotient" })
  {
    EXPECT_EQ(GetNullReason(values[name][0]), NullReason::InvalidTopology) << name;
  }
  EXPECT_NEAR(values["SurfaceArea"][0], 5, 1e-12);
  EXPECT_EQ(values["FaceCount"][0], 5);

  // A collapsed edge, as a repeated id and as two ids in one place: the cell that remains.
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 1, 1, 1 } };
  for (const vtkIdType last : { 6, 7 })
  {
    const Grid grid = MakeGrid(points, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, last } } });
    values = EvaluateAll(grid);
    EXPECT_EQ(values["VertexCount"][0], last == 6 ? 7 : 8);
    EXPECT_EQ(values["MinEdgeLength"][0], 0);
    EXPECT_EQ(values["EdgeLengthRatio"][0], 0);
    EXPECT_NEAR(values["Volume"][0], 5.0 / 6, 0.1);
    EXPECT_FALSE(std::isnan(values["MinDihedralAngle"][0])) << last;
    EXPECT_FALSE(std::isnan(values["MinSolidAngle"][0])) << last;
    EXPECT_EQ(GetNullReason(values["TetRadiusRatio"][0]), NullReason::NotApplicable);
  }

  // Points, lines and empty cells are null for everything but their type.
  const Grid others =
    MakeGrid(points, { { VTK_VERTEX, { 0 } }, { VTK_LINE, { 0, 1 } }, { VTK_EMPTY_CELL, {} } });
  for (const auto& row : EvaluateAll(others))
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(std::isnan(row.second[i]), row.first != "CellTypeId") << row.first;
    }
  }
}

// A coordinate that is no number leaves nothing but the counts, and never looks healthy.
TEST(Criteria, NonFinitePoints)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), Infinity })
  {
    for (const int corner : { 0, 1, 6 })
    {
      const Grid cube = FindReferenceShape("unit cube").Standard;
      const Grid grid = Grid::New();
      grid->DeepCopy(cube);
      double x[3];
      grid->GetPoint(corner, x);
      grid->GetPoints()->SetPoint(corner, x[0], bad, x[2]);
      for (const Grid& mesh : { grid, ToPolyhedra(grid) })
      {
        for (const auto& row : EvaluateAll(mesh))
        {
          const Criterion* criterion = FindCriterion(row.first);
          if (criterion->AppliesTo & Polyhedra)
          {
            const bool hasValue =
              criterion->IsInteger && row.first != "FaceOrientationStatus"; // which needs a volume
            EXPECT_EQ(GetNullReason(row.second[0]),
              hasValue ? NullReason::Value : NullReason::Degenerate)
              << row.first;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, the centroid of a cell with coordinates that are not finite is taken to lie somewhere, and its
// neighbours get numbers that depend on where the mesh lies.
TEST(Criteria, NonFiniteNeighbor)
{
  const Grid row = MakeHexahedra(3, 1, 1, false); // cubes along x
  double x[3];
  for (vtkIdType i = 0; i < row->GetNumberOfPoints(); ++i)
  {
    row->GetPoint(i, x);
    if (x[0] == row->GetBounds()[1])
    {
      row->GetPoints()->SetPoint(i, x[0], std::numeric_limits<double>::quiet_NaN(), x[2]);
      break;
    }
  }
  const Values values = EvaluateAll(row);
  const auto expectCubes = [&](const char* name, double inGrid)
  {
    EXPECT_NEAR(values.at(name)[0], inGrid, 1e-12) << name;
    EXPECT_NEAR(values.at(name)[1], inGrid, 1e-12) << name;
    EXPECT_TRUE(std::isnan(values.at(name)[2])) << name;
  };
  expectCubes("MaxNonOrthogonality", 0);
  expectCubes("MaxFaceSkewness", 0);
  expectCubes("MinFaceWeight", 0.5);
  expectCubes("MinVolumeRatio", 1);
  expectCubes("OrthogonalQuality", 1);
}

// A triangle with a repeated id has a collapsed edge.
TEST(Criteria, RepeatedIdInTriangle)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_TRIANGLE, { 0, 0, 1 } } });
  const Values values = EvaluateAll(grid);
  EXPECT_EQ(values.at("EdgeLengthRatio")[0], 0);
  EXPECT_EQ(values.at("Area")[0], 0);
  EXPECT_EQ(values.at("VertexCount")[0], 2);
}

// Polyhedra without points, with one face, with a point as a face: no answer, and no crash.
TEST(Criteria, BrokenPolyhedra)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (const Faces& faces : { Faces{}, Faces{ { 0, 1, 2 } }, Faces{ { 0 }, { 1, 2 }, {} },
         Faces{ { 0, 1, 2 }, { 0, 1, 2 } }, Faces{ { 0, 0, 0 }, { 1, 1, 2 }, { 3, 3, 3 }, { 2, 2, 2 } },
         Faces{ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 2 }, { 2, 3, 0 }, { 1, 3, 2 } } })
  {
    Values values = EvaluateAll(MakePolyhedron(points, faces));
    EXPECT_EQ(GetNullReason(values["Volume"][0]), NullReason::InvalidTopology) << faces.size();
  }
}

// A face listed twice, once in each direction, is a fin inside the cell and leaves its volume alone.
TEST(Criteria, Fin)
{
  const ReferenceShape& cube = FindReferenceShape("unit cube");
  Faces faces = GetFaces(cube.Polyhedron, 0);
  faces.push_back({ 0, 2, 6 });
  faces.push_back({ 6, 2, 0 });
  Values values = EvaluateAll(MakePolyhedra(cube.Polyhedron->GetPoints(), { faces }));
  EXPECT_NEAR(values["Volume"][0], 1, 1e-12);
  EXPECT_EQ(GetNullReason(values["MinDihedralAngle"][0]), NullReason::InvalidTopology);
}

// Every cell of a split surface sees its neighbours; folds and inconsistent neighbours count right.
TEST(Criteria, NeighborNormals)
{
  // A flat square of two triangles and a wall standing on its edge; the second wall runs backwards.
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 } };
  for (const bool backwards : { false, true })
  {
    const std::vector<vtkIdType> wall = backwards ? std::vector<vtkIdType>{ 0, 1, 5, 4 }
                                                  : std::vector<vtkIdType>{ 1, 0, 4, 5 };
    Values values = EvaluateAll(MakeGrid(points,
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_QUAD, wall } }));
    EXPECT_NEAR(values["MinNeighborNormalAngle"][0], 0, 1e-12);
    EXPECT_NEAR(values["MaxNeighborNormalAngle"][0], 90, 1e-12);
    EXPECT_NEAR(values["MaxNeighborNormalAngle"][1], 0, 1e-12);
    EXPECT_NEAR(values["MinNeighborNormalAngle"][2], 90, 1e-12);
  }
  const Values alone = EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  EXPECT_EQ(GetNullReason(alone.at("MinNeighborNormalAngle")[0]), NullReason::NoNeighbor);
}

// Radians change plane angles and nothing else.
TEST(Criteria, AngleUnits)
{
  const Grid grid = FindReferenceShape("L-prism").Polyhedron;
  EvaluationOptions radians;
  radians.Angles = AngleUnit::Radians;
  const Values degrees = EvaluateAll(grid), values = EvaluateAll(grid, radians);
  for (const Criterion& criterion : GetCriteria())
  {
    const double factor = criterion.Unit == Unit::Angle ? Pi / 180 : 1;
    ExpectNear(factor * degrees.at(criterion.Name)[0], values.at(criterion.Name)[0], 1e-12,
      criterion.Name);
  }
}

// Higher-order cells are evaluated by their corners.
TEST(Criteria, HigherOrder)
{
  const Grid linear = MakeStandardCell(VTK_TETRA);
  const Grid quadratic = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, .3, 0 },
                                    { .5, .5, 0 }, { 0, .5, 0 }, { 0, 0, .5 }, { .5, 0, .5 },
                                    { 0, .5, .5 } },
    { { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } } });
  ExpectSame(EvaluateAll(linear), EvaluateAll(quadratic), 0, "quadratic", { "CellTypeId" });
}

// Volumes of a warped mesh add up to that of the domain, because neighbours see the same face centres.
TEST(Criteria, VolumesFillTheDomain)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> noise(-0.3, 0.3);
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = Transform(MakeHexahedra(4, 5, 6, asPolyhedra),
      [&](const Point& p)
      {
        const auto inside = [](double x, double size) { return x > 0 && x < size; };
        const bool free = inside(p[0], 4) && inside(p[1], 5) && inside(p[2], 6);
        return free ? Point{ p[0] + noise(random), p[1] + noise(random), p[2] + noise(random) } : p;
      });
    double sum = 0;
    const Values values = EvaluateAll(grid);
    for (const double volume : values.at("Volume"))
    {
      sum += volume;
    }
    EXPECT_NEAR(sum, 4 * 5 * 6, 1e-10);
  }
}

// Bit for bit the same on one thread and on many, alone and together with other criteria.
TEST(Criteria, IndependentOfThreadsAndCompany)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  const Grid grid = Transform(MakeHexahedra(20, 20, 20, true), [&](const Point& p)
    { return Point{ p[0] + noise(random), p[1] + noise(random), p[2] + noise(random) }; });
  Values reference;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        const Values values = EvaluateAll(grid);
        reference = reference.empty() ? values : reference;
        ExpectSame(reference, values, 0, std::to_string(threads) + " threads");
      });
  }
  for (const Criterion& criterion : GetCriteria())
  {
    std::vector<double> alone(grid->GetNumberOfCells());
    Evaluate(MeshTopology(grid), {}, { { &criterion, alone.data() } }, [](double) { return true; });
    for (std::size_t i = 0; i < alone.size(); i += 97)
    {
      ExpectNear(reference.at(criterion.Name)[i], alone[i], 0, criterion.Name);
    }
  }
}

// Stopping leaves at once; progress runs from 0 upwards.
TEST(Criteria, ProgressAndAbort)
{
  const Grid grid = MakeHexahedra(60, 60, 60, false);
  std::vector<double> values(grid->GetNumberOfCells());
  const std::vector<CriterionValues> rows = { { FindCriterion("Volume"), values.data() } };
  std::vector<double> reports;
  EXPECT_TRUE(Evaluate(MeshTopology(grid), {}, rows,
    [&](double done)
    {
      reports.push_back(done);
      return true;
    }));
  EXPECT_GT(reports.size(), 2u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_LT(reports.back(), 1);
  int calls = 0;
  EXPECT_FALSE(Evaluate(MeshTopology(grid), {}, rows, [&](double) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
}

// The registry is complete and consistent in itself.
TEST(Criteria, Registry)
{
  for (const Criterion& criterion : GetCriteria())
  {
    EXPECT_EQ(FindCriterion(criterion.Name), &criterion) << "name used twice: " << criterion.Name;
    EXPECT_GT(std::string(criterion.Description).size(), 20u) << criterion.Name;
    EXPECT_EQ((criterion.CellFunction != nullptr) + (criterion.MeshFunction != nullptr) +
        (criterion.NeighborFunction != nullptr),
      1);
    EXPECT_LE(criterion.Range[0], criterion.Range[1]);
    EXPECT_LE(criterion.Acceptable[0], criterion.Acceptable[1]);
    EXPECT_EQ(criterion.HasAcceptableRange(),
      std::isfinite(criterion.Acceptable[0]) || std::isfinite(criterion.Acceptable[1]))
      << criterion.Name;
  }
  EXPECT_EQ(FindCriterion("NoSuchCriterion"), nullptr);
  for (const Preset& preset : GetPresets())
  {
    EXPECT_EQ(FindPreset(preset.Name), &preset);
    for (const auto& rule : preset.Rules)
    {
      EXPECT_NE(FindCriterion(rule.Criterion), nullptr) << preset.Name << ' ' << rule.Criterion;
    }
  }
}

// The values of the reference shapes, also inside out, lie in the range that the registry promises.
TEST(Criteria, ValuesInRange)
{
  const auto expectInRange = [](const Values& values, const std::string& shape)
  {
    for (const Criterion& criterion : GetCriteria())
    {
      const double value = values.at(criterion.Name)[0];
      if (!std::isnan(value))
      {
        EXPECT_GE(value, criterion.Range[0] - 1e-12) << shape << ' ' << criterion.Name;
        EXPECT_LE(value, criterion.Range[1] + 1e-12) << shape << ' ' << criterion.Name;
      }
    }
  };
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    expectInRange(EvaluateAll(shape.Polyhedron), shape.Name);
    if (shape.Standard)
    {
      expectInRange(EvaluateAll(Transform(shape.Standard,
                      [](const Point& p) { return Point{ -p[0], p[1], p[2] }; })),
        std::string(shape.Name) + " inside out");
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, powers of the size leave the range of numbers: a product of twelve lengths.
TEST(Criteria, IsotropyOfAnySize)
{
  for (const double size : { 1e-40, 1e40 })
  {
    const Grid hexahedron = Transform(FindReferenceShape("sheared hex").Standard,
      [size](const Point& p) { return Point{ size * p[0], size * p[1], size * p[2] }; });
    EXPECT_NEAR(EvaluateAll(hexahedron).at("CellIsotropy")[0], 0.421875, 1e-12) << size;
  }
}

//------------------------------------------------------------------------------
// If this fails, cells are compared with another mean than that of all cells of their dimension.
TEST(Criteria, RelativeSize)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, 0, 3 } };
  // Volumes 1/6, 1/2 and -1/6: their mean is 1/6; areas 1 and 1/2.
  const Grid mesh = MakeGrid(points,
    { { VTK_TETRA, { 0, 1, 3, 4 } }, { VTK_TETRA, { 0, 1, 3, 5 } }, { VTK_TETRA, { 0, 3, 1, 4 } },
      { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 0, 1 } } });
  const std::vector<double> values = EvaluateAll(mesh).at("RelativeSize");
  const double expected[] = { 1, 1.0 / 3, 0, 0.75, 2.0 / 3 };
  for (int cell = 0; cell < 5; ++cell)
  {
    ExpectNear(expected[cell], values[cell], 1e-12, "cell " + std::to_string(cell));
  }
  EXPECT_EQ(GetNullReason(values[5]), NullReason::NotApplicable);
  // A ghost does not count, but is compared.
  const unsigned char ghosts[] = { 0, 1, 0, 0, 1, 0 };
  EvaluationOptions options;
  options.Ghosts = ghosts;
  const std::vector<double> withGhosts = EvaluateAll(mesh, options).at("RelativeSize");
  EXPECT_EQ(GetNullReason(withGhosts[0]), NullReason::Degenerate); // the mean is 0
  ExpectNear(1, withGhosts[3], 1e-12, "square");
  ExpectNear(0.5, withGhosts[4], 1e-12, "ghost");
}

//------------------------------------------------------------------------------
// The boundary of a solid has the dihedral angles of the solid. If this fails, the outer side of a surface is
// mistaken, or what is open counts as closed.
TEST(Criteria, SurfaceDihedralAngles)
{
  for (const auto& shape : GetReferenceShapes())
  {
    const Grid& solid = shape.Polyhedron;
    const Values expected = EvaluateAll(solid);
    vtkNew<vtkCellArray> faces;
    solid->GetPolyhedronFaces(0, faces);
    const auto makeSurface = [&](bool turned, vtkIdType first, vtkIdType flipped)
    {
      Cells cells;
      vtkNew<vtkIdList> ids;
      for (vtkIdType f = first; f < faces->GetNumberOfCells(); ++f)
      {
        faces->GetCellAtId(f, ids);
        cells.push_back({ VTK_POLYGON, { ids->begin(), ids->end() } });
        if (turned != (f == flipped))
        {
          std::reverse(cells.back().second.begin(), cells.back().second.end());
        }
      }
      Grid surface = MakeGrid({}, cells);
      surface->SetPoints(solid->GetPoints());
      return EvaluateAll(surface);
    };
    for (const bool turned : { false, true })
    {
      const Values surface = makeSurface(turned, 0, -1);
      const auto& smallest = surface.at("MinSurfaceDihedralAngle");
      const auto& largest = surface.at("MaxSurfaceDihedralAngle");
      ExpectNear(expected.at("MinDihedralAngle")[0],
        *std::min_element(smallest.begin(), smallest.end()), 1e-10, shape.Name);
      ExpectNear(expected.at("MaxDihedralAngle")[0],
        *std::max_element(largest.begin(), largest.end()), 1e-10, shape.Name);
    }
    for (const Values& broken : { makeSurface(false, 1, -1), makeSurface(false, 0, 1) })
    {
      for (const double value : broken.at("MaxSurfaceDihedralAngle"))
      {
        EXPECT_EQ(GetNullReason(value), NullReason::InvalidTopology) << shape.Name;
      }
    }
  }
}
