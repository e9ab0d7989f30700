// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Values of the criteria against tables that an independent program computed from closed forms, and
// against themselves under what must not change them.
#include "Cell/CellDefects.h"
#include "Cell/CellGeometry.h"

#include "CriteriaTesting.h"
#include "ReferenceShapes.h"
#include "Sanitized.h"

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
          ExpectNear(expected.second, values.at(expected.first)[0], 1e-10,
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

// The published table of triangles and tetrahedra.
TEST(Criteria, ReferenceSimplices)
{
  const double h = std::sqrt(3.0) / 2;
  const struct
  {
    Points Triangle;
    double RadiusRatio, BhatiaLawrence, RadiusEdgeRatio;
  } triangles[] = { { { { 0, 0, 0 }, { 1, 0, 0 }, { .5, h, 0 } }, 1, 1, std::sqrt(1.0 / 3) },
    { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, 0.8284271247462, 0.8660254037844, std::sqrt(0.5) },
    { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } }, 0.8, 0.8313843876331, 5.0 / 6 } };
  for (const auto& row : triangles)
  {
    const Values values = EvaluateAll(MakePolygon(row.Triangle));
    ExpectNear(row.RadiusRatio, values.at("TriangleRadiusRatio")[0], 1e-10, "TriangleRadiusRatio");
    ExpectNear(row.BhatiaLawrence, values.at("BhatiaLawrence")[0], 1e-10, "BhatiaLawrence");
    ExpectNear(row.RadiusEdgeRatio, values.at("TriangleRadiusEdgeRatio")[0], 1e-10,
      "TriangleRadiusEdgeRatio");
  }
  const struct
  {
    const char* Name;
    double RadiusRatio, RadiusEdgeRatio, MeanRatio, AspectGamma, AspectRatio;
  } tetrahedra[] = { { "regular tetrahedron", 1, 0.6123724356958, 1, 1, 1 },
    { "right-corner tetrahedron", 0.7320508075689, 0.8660254037844, 0.8399473665966, 1.299038105677,
      1.366025403784 },
    { "flat sliver", 0.02999250221178, 0.7070714320336, 0.08771176097029, 38.495791593,
      40.83299319586 } };
  for (const auto& row : tetrahedra)
  {
    const ReferenceShape& shape = FindReferenceShape(row.Name);
    for (vtkUnstructuredGrid* grid : { shape.Standard.Get(), shape.Polyhedron.Get() })
    {
      const Values values = EvaluateAll(grid);
      ExpectNear(row.RadiusRatio, values.at("TetRadiusRatio")[0], 1e-10, row.Name);
      ExpectNear(row.RadiusEdgeRatio, values.at("TetRadiusEdgeRatio")[0], 1e-10, row.Name);
      ExpectNear(row.MeanRatio, values.at("TetMeanRatio")[0], 1e-10, row.Name);
      ExpectNear(row.AspectGamma, values.at("VerdictAspectGamma")[0], 1e-10, row.Name);
      ExpectNear(row.AspectRatio, values.at("VerdictAspectRatio")[0], 1e-10, row.Name);
    }
  }
}

// A cell of every standard type has the same values as its faces written as a polyhedron, also when
// it is warped; its volume is positive in VTK's node order. Three measures of Verdict depend on the
// order of the nodes.
TEST(Criteria, StandardTypesEqualPolyhedra)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  for (const int type : StandardTypes3D)
  {
    const Grid healthy = MakeStandardCell(type);
    const Grid warped = Transform(healthy, [&](const Point& p)
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

// The node order is the orientation: of a cell inside out the volume is below zero, of whatever
// type.
TEST(Criteria, StandardTypesInsideOut)
{
  for (const int type : StandardTypes3D)
  {
    const Grid cell = MakeStandardCell(type);
    const Grid turned =
      Transform(cell, [](const Point& p) { return Point{ -p[0] - 0.3 * p[2], p[1], p[2] }; });
    const double volume = EvaluateAll(cell).at("Volume")[0];
    EXPECT_NEAR(EvaluateAll(turned).at("Volume")[0], -volume, 1e-12) << type;
    EXPECT_NEAR(EvaluateAll(ToPolyhedra(turned)).at("Volume")[0], volume, 1e-12) << type;
  }
}

// Girard: of a corner of planar faces the solid angle is the sum of the dihedral angles of its n
// edges less (n - 2) pi.
TEST(Criteria, SolidAnglesOfCornersByGirard)
{
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    if (shape.Name == std::string("warped hex"))
    {
      continue;
    }
    CellGeometry cell;
    const EvaluationOptions options;
    const MeshView mesh(shape.Polyhedron);
    cell.Load(mesh, 0, options);
    cell.Compute(NeedsEdges | NeedsFaces | NeedsVolume | NeedsAngles);
    std::vector<double> expected(cell.GetNumberOfPoints(), 2 * Pi);
    for (int edge = 0; edge < cell.GetNumberOfEdges(); ++edge)
    {
      for (const int point : cell.GetTopology().Edges[edge].Points)
      {
        expected[point] += cell.GetDihedralAngle(edge) - Pi;
      }
    }
    for (int point = 0; point < cell.GetNumberOfPoints(); ++point)
    {
      EXPECT_NEAR(cell.GetSolidAngle(point), expected[point], 1e-10) << shape.Name << ' ' << point;
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
        { "PrincipalAspectRatio", 1 }, { "Sphericity", std::cbrt(Pi / 6) },
        { "VolumeEdgeRatio", 1 }, { "CornerScaledJacobian", 1 }, { "MaxWarpage", 0 },
        { "MaxFaceConcavity", 0 }, { "CellConcavity", -0.5 / r3 }, { "MinFacePyramidRatio", 1 },
        { "MinTetVolume", 1.0 / 24 }, { "MinTetMeanRatio", 0.8 },
        { "MinTetQuality", 1.8 / std::sqrt(15.0) }, // circumradius sqrt(5 / 16)
        { "EquivalentRadius", std::cbrt(0.75 / Pi) }, { "MinFaceArea", 1 }, { "MaxFaceArea", 1 },
        { "MinFaceVertexCount", 4 }, { "MaxFaceVertexCount", 4 }, { "TetQualityFoam", none } } },
    { "regular tetrahedron",
      { { "CornerScaledJacobian", std::sqrt(0.5) }, { "TetQualityFoam", 1 },
        { "PrincipalAspectRatio", 1 },
        { "MinFacePyramidRatio", 1 }, // circumradius sqrt(11 / 32) of a twelfth
        { "MinTetQuality", std::sqrt(2.0) / 144 / (8 * r3 / 27 * std::pow(11.0 / 32, 1.5)) } } },
    { "regular octahedron", { { "MinTetQuality", 1.0 / 6 }, { "MeanEdgeLength", 1 } } },
    { "right-corner tetrahedron",
      { { "TetQualityFoam", 0.5 }, { "MeanEdgeLength", (1 + std::sqrt(2.0)) / 2 } } },
    { "flat sliver",
      { { "TetQualityFoam", 0.0259768654863 }, { "EdgeRatio", 1 / 0.7071774883295 } } },
    { "square pyramid",
      { { "CornerScaledJacobian", none }, { "MinFaceVertexCount", 3 }, { "MaxFaceVertexCount", 4 },
        { "MinFaceArea", r3 / 4 }, { "MaxFaceArea", 1 } } },
    { "box",
      { { "PrincipalAspectRatio", 0.25 }, { "EdgeRatio", 4 },
        { "VolumeEdgeRatio", 8 / std::pow(7, 1.5) }, { "EdgeDiameterRatio", 1 / std::sqrt(21.0) },
        { "MeanEdgeLength", 7.0 / 3 } } },
    { "sheared hex", { { "CornerScaledJacobian", std::sqrt(0.5) } } },
    { "L-prism",
      { { "CornerScaledJacobian", -1 }, { "MinFaceConcavity", 0 }, { "MaxFaceConcavity", 90 },
        { "CellConcavity", 1.0 / 6 }, { "MinFaceVertexCount", 4 }, { "MaxFaceVertexCount", 6 } } },
  };
  for (const auto& shape : expected)
  {
    const Values values = EvaluateAll(FindReferenceShape(shape.first).Polyhedron);
    for (const auto& criterion : shape.second)
    {
      ExpectNear(criterion.second, values.at(criterion.first)[0], 1e-10,
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
  const Values triangle = EvaluateAll(
    MakeGrid({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  ExpectNear(4, triangle.at("MeanEdgeLength")[0], 1e-12, "triangle");

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
      EXPECT_TRUE(isSame) << criterion.Name << " of " << shape.Name << ": " << alone << ' '
                          << expected;
    }
  }
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
      EvaluateAll(
        Transform(grid, [](const Point& p) { return Point{ p[0] + 100, p[1] - 30, p[2] + 7 }; })),
      1e-10, std::string(shape.Name) + " moved");
    ExpectSame(values, EvaluateAll(Transform(grid, turn)), 1e-10,
      std::string(shape.Name) + " turned", { "CellAspectRatio" });
    ExpectSame(values,
      EvaluateAll(Transform(
        grid, [](const Point& p) { return Point{ 1e-3 * p[0], 1e-3 * p[1], 1e-3 * p[2] }; })),
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
    ExpectNear(
      factor * degrees.at(criterion.Name)[0], values.at(criterion.Name)[0], 1e-12, criterion.Name);
  }
}

// Volumes of a warped mesh add up to that of the domain, because neighbors see the same face
// centers.
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
  constexpr int size = IsSanitized ? 8 : 14;
  const Grid grid = Transform(MakeHexahedra(size, size, size, true), [&](const Point& p)
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
    for (std::size_t i = 0; i < alone.size(); i += 31)
    {
      ExpectNear(reference.at(criterion.Name)[i], alone[i], 0, criterion.Name);
    }
  }
}

// Sound tetrahedra go without topology: if this fails, a value depends on whether they do, and so
// on what else is asked for. Among them are flat and inverted ones, one with a point used twice,
// huge and tiny ones, one that is not a number, regular ones, whose angles differ by rounding, one
// with a point in the middle of an edge, and other cells.
TEST(Criteria, TetrahedraWithoutTopology)
{
  std::mt19937 random(5);
  Points points;
  Cells cells;
  const double huge = std::numeric_limits<double>::max(),
               nan = std::numeric_limits<double>::quiet_NaN();
  for (const double size : { 1.0, 1e-3, 1e6, 1e-40, 1e40, huge, nan })
  {
    for (const double height : { 1.0, -1.0, 1e-5, 1e-7, 3e-12, 1e-13, 0.0 })
    {
      for (const double place : { 0.0, 1.0, 1e4 })
      {
        const auto first = static_cast<vtkIdType>(points.size());
        for (int i = 0; i < 4; ++i)
        {
          const auto next = [&] { return size * (place + random() / 4294967296.0); };
          const double x = next(), y = next(), z = next();
          points.push_back({ { x, y, height * z } });
        }
        cells.push_back({ VTK_TETRA, { first, first + 1, first + 2, first + 3 } });
        if (cells.size() % 10 == 0)
        {
          cells.push_back({ VTK_TETRA, { first, first + 1, first + 1, first + 3 } });
          cells.push_back({ VTK_TRIANGLE, { first, first + 1, first + 2 } });
          cells.push_back({ VTK_PYRAMID, { 0, first + 1, first + 2, first + 3, 1 } });
        }
      }
    }
  }
  for (int i = 0; i < 200; ++i)
  {
    const double turn = random(), c = i == 0 ? 1 : std::cos(turn), s = i == 0 ? 0 : std::sin(turn);
    for (const Points& shape : { Points{ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
           Points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
           Points{ { -1, 0, 0 }, { 1, 0, 0 }, { 1e-9, 1, 0 }, { 0, 1e-5, 1e-5 } } })
    {
      const auto first = static_cast<vtkIdType>(points.size());
      for (const Point& p : shape)
      {
        const double x = c * p[0] - s * p[1], y = s * p[0] + c * p[1];
        points.push_back({ { x, c * y - s * p[2], s * y + c * p[2] } });
      }
      cells.push_back({ VTK_TETRA, { first, first + 1, first + 2, first + 3 } });
    }
  }
  const Grid grid = MakeGrid(points, cells);
  int tried = 0;
  for (const double tolerance : { 0.0, 1e-3 })
  {
    EvaluationOptions options;
    options.DegeneracyTolerance = tolerance;
    const Values together = EvaluateAll(grid, options);
    for (const Criterion& criterion : GetCriteria())
    {
      if (!criterion.TetrahedronFunction)
      {
        continue;
      }
      ++tried;
      std::vector<double> alone(grid->GetNumberOfCells());
      Evaluate(
        MeshTopology(grid), options, { { &criterion, alone.data() } }, [](double) { return true; });
      const std::vector<double>& expected = together.at(criterion.Name);
      for (std::size_t i = 0; i < alone.size(); ++i)
      {
        EXPECT_TRUE(alone[i] == expected[i] || (std::isnan(alone[i]) && std::isnan(expected[i])))
          << criterion.Name << " of cell " << i << ": " << alone[i] << ' ' << expected[i];
        EXPECT_EQ(GetNullReason(alone[i]), GetNullReason(expected[i])) << criterion.Name;
      }
    }
  }
  EXPECT_GT(tried, 0);
}

// Stopping leaves at once; progress runs from 0 upwards.
TEST(Criteria, ProgressAndAbort)
{
  for (const Criterion& criterion : GetCriteria())
  {
    EXPECT_TRUE(Evaluate(MeshTopology(MakeGrid({}, {})), {}, { { &criterion, nullptr } },
      [](double done)
      {
        EXPECT_EQ(done, 0);
        return true;
      }));
  }
  const Grid grid = MakeHexahedra(60, 60, 60, false);
  std::vector<double> values(grid->GetNumberOfCells());
  for (const char* name : { "Volume", "MaxNonOrthogonality", "RegionId" })
  {
    const std::vector<CriterionValues> rows = { { FindCriterion(name), values.data() } };
    std::vector<double> reports;
    EXPECT_TRUE(Evaluate(MeshTopology(grid), {}, rows,
      [&](double done)
      {
        reports.push_back(done);
        return true;
      }));
    EXPECT_GT(reports.size(), 2u) << name;
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end())) << name;
    EXPECT_LT(reports.back(), 1) << name;
    const int number = static_cast<int>(reports.size());
    for (int last = 1; last <= number; last += IsSanitized ? (number + 2) / 3 : 1)
    {
      int calls = 0;
      EXPECT_FALSE(Evaluate(MeshTopology(grid), {}, rows, [&](double) { return ++calls < last; }))
        << name;
      EXPECT_EQ(calls, last) << name;
    }
  }
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
    // A range is for some cells to which the criterion applies, and reports say what those outside
    // of it are.
    unsigned appliesTo = criterion.AppliesTo;
    appliesTo |= appliesTo & Polygons ? SimplePolygons : NoShapes;
    appliesTo |= appliesTo & Polyhedra ? SimplePolyhedra : NoShapes;
    EXPECT_EQ(criterion.HasAcceptableRange(), (criterion.AcceptableFor & appliesTo) != 0)
      << criterion.Name;
    EXPECT_EQ(criterion.HasAcceptableRange() && std::string(criterion.Family) != "Verdict",
      criterion.Notes.Consequence[0] != '\0')
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
