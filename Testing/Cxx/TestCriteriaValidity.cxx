// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with cells, and the criteria of cells that are degenerate, broken or without finite
// coordinates.
#include "Cell/CellDefects.h"
#include "Mesh/PointSetHulls.h"

#include "CriteriaTesting.h"
#include "ReferenceShapes.h"

#include <random>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// What is wrong with a cell, bit by bit.
TEST(CriteriaValidity, Validity)
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
    EXPECT_EQ(values.at("IsConvex")[0], !(expected & (Nonconvex | NonPlanarFaces))) << shape.Name;
    EXPECT_EQ(values.at("IsValid")[0], 1) << shape.Name;
    EXPECT_EQ(values.at("FaceOrientationStatus")[0], 0) << shape.Name;
  }

  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
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

  // A tetrahemihexahedron, of four triangles and the three squares between the points of an
  // octahedron: every edge has two faces, but they have one side only.
  const Grid oneSided = MakePolyhedron(
    { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } },
    { { 0, 1, 2 }, { 0, 4, 5 }, { 3, 1, 5 }, { 3, 4, 2 }, { 0, 1, 3, 4 }, { 0, 2, 3, 5 },
      { 1, 2, 4, 5 } });
  EvaluationOptions trust;
  trust.TrustFaceOrientation = true;
  for (const EvaluationOptions& options : { EvaluationOptions(), trust })
  {
    EXPECT_EQ(EvaluateAll(oneSided, options).at("FaceOrientationStatus")[0], 3);
    EXPECT_EQ(EvaluateAll(oneSided, options).at("IsConvex")[0], 0);
    EXPECT_NE(
      static_cast<unsigned>(EvaluateAll(oneSided, options).at("CellStatus")[0]) & IntersectingFaces,
      0u);
  }
  EXPECT_EQ(GetNullReason(EvaluateAll(oneSided).at("Volume")[0]), NullReason::InvalidTopology);
  EXPECT_EQ(status(oneSided) & (FacesAreOrientedIncorrectly | NotWatertight | NonManifoldEdge),
    FacesAreOrientedIncorrectly);

  // A tetrahedron with a point in the middle of an edge, where a face without an area closes it.
  const Grid sliver =
    MakePolyhedron({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0, 0 } },
      { { 0, 2, 1 }, { 0, 4, 1, 3 }, { 0, 1, 4 }, { 0, 3, 2 }, { 1, 2, 3 } });
  EXPECT_EQ(status(sliver) &
      (DegenerateFaces | ZeroLengthEdge | CoincidentPoints | NotWatertight | InvertedOrZeroVolume),
    DegenerateFaces);
  EXPECT_EQ(EvaluateAll(sliver).at("IsValid")[0], 0);

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
  // Open ones: with a corner pushed down through the middle of the bottom, unless that is the face
  // that is not there.
  points[6] = { 0.5, 0.5, -0.5 };
  for (const auto& missing : outward)
  {
    Faces open = outward;
    open.erase(std::find(open.begin(), open.end(), missing));
    const bool isBottom = *std::max_element(missing.begin(), missing.end()) < 4;
    EXPECT_EQ((status(MakePolyhedron(points, open)) & IntersectingFaces) != 0, !isBottom);
    EXPECT_EQ(status(MakePolyhedron(corners, open)) & IntersectingFaces, 0u);
  }
  // Faces that meet everywhere but share no points, as a cube of loose squares, or of one and two
  // rectangles at a side.
  Points loose;
  Faces looseFaces;
  for (const auto& face : outward)
  {
    looseFaces.emplace_back();
    for (const vtkIdType id : face)
    {
      looseFaces.back().push_back(static_cast<vtkIdType>(loose.size()));
      loose.push_back(corners[id]);
    }
  }
  EXPECT_EQ(
    status(MakePolyhedron(loose, looseFaces)) & (IntersectingFaces | NotWatertight), NotWatertight);
  // Squares with two opposite corners in common, which cross between them.
  EXPECT_NE(status(MakePolyhedron({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
                                    { 0.5, 0.5, 0.7 }, { 0.5, 0.5, -0.7 } },
              { { 0, 2, 1, 3 }, { 0, 4, 1, 5 } })) &
      IntersectingFaces,
    0u);
  // Walls that cross from their lower edges to their upper ones, without a floor and a ceiling.
  EXPECT_NE(status(MakePolyhedron({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                    { 1, 1, 1 }, { 1, 0, 1 }, { 0, 1, 1 } },
              { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } })) &
      IntersectingFaces,
    0u);
  points = corners;
  points.insert(points.end(), { { 0.5, 0, 0 }, { 0.5, 0, 1 } });
  EXPECT_EQ(status(MakePolyhedron(points,
              { { 0, 8, 9, 4 }, { 8, 1, 5, 9 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 4, 7, 3 },
                { 1, 2, 6, 5 }, { 2, 3, 7, 6 } })) &
      (IntersectingFaces | NotWatertight),
    NotWatertight);
  // The top in three strips, which the walls in front and behind do not know of, in any direction.
  points = corners;
  points.insert(
    points.end(), { { 1. / 3, 0, 1 }, { 2. / 3, 0, 1 }, { 1. / 3, 1, 1 }, { 2. / 3, 1, 1 } });
  const Grid strips = MakePolyhedron(points,
    { { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 2, 3, 7, 6 }, { 0, 4, 7, 3 }, { 1, 2, 6, 5 },
      { 4, 8, 10, 7 }, { 8, 9, 11, 10 }, { 9, 5, 6, 11 } });
  const Grid squares = MakePolyhedron(
    { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0.5, 0.7 }, { 0.5, 0.5, -0.7 } },
    { { 0, 2, 1, 3 }, { 0, 4, 1, 5 } });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 2 * Pi);
  for (int i = 0; i < 1000; ++i)
  {
    const double a = angle(random), b = angle(random);
    const auto turn = [&](const Point& p)
    {
      const double x = std::cos(a) * p[0] - std::sin(a) * p[1],
                   y = std::sin(a) * p[0] + std::cos(a) * p[1];
      return Point{ x, std::cos(b) * y - std::sin(b) * p[2], std::sin(b) * y + std::cos(b) * p[2] };
    };
    ASSERT_EQ(status(Transform(strips, turn)) & (IntersectingFaces | NotWatertight), NotWatertight)
      << a << ' ' << b;
    ASSERT_NE(status(Transform(squares, turn)) & IntersectingFaces, 0u) << a << ' ' << b;
  }

  // What is no face of less than three points has not, therefore, a point twice.
  EXPECT_EQ(status(MakePolyhedron(loose, { { 0, 1 } })), WrongNumberOfPoints | NotWatertight);
  EXPECT_EQ(polygon({ 0, 1 }), WrongNumberOfPoints);
  Faces withLine = outward;
  withLine.push_back({ 0, 1 });
  EXPECT_EQ(status(MakePolyhedron(corners, withLine)), 0u);
  EXPECT_NE(status(MakeGrid(corners, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 0, 7 } } })) &
      CoincidentPoints,
    0u);

  // Two tetrahedra that meet in one point, as one cell.
  const Points pair = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 },
    { 0, -1, 0 }, { 0, 0, -1 } };
  EXPECT_EQ(status(MakePolyhedron(pair,
              { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 4, 5 }, { 0, 5, 6 },
                { 0, 6, 4 }, { 4, 6, 5 } })) &
      (NonManifoldVertex | NotWatertight),
    NonManifoldVertex);

  // The same with one of them open, or both; and one with an edge of three faces and open ones.
  const Faces ofPair = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 0, 4, 5 }, { 0, 5, 6 },
    { 0, 6, 4 }, { 4, 6, 5 } };
  const unsigned ofTopology =
    NonManifoldVertex | NotWatertight | NonManifoldEdge | IntersectingFaces;
  EXPECT_EQ(status(MakePolyhedron(pair, ofPair)) & ofTopology, NonManifoldVertex | NotWatertight);
  EXPECT_EQ(status(MakePolyhedron(pair, Faces(ofPair.begin(), ofPair.end() - 1))) & ofTopology,
    NonManifoldVertex | NotWatertight);
  EXPECT_EQ(status(MakePolyhedron(pair, { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 0, 1, 4 } })) &
      ofTopology,
    NonManifoldVertex | NotWatertight | NonManifoldEdge);
  EXPECT_EQ(status(MakePolyhedron(pair, Faces(ofPair.begin(), ofPair.begin() + 3))) & ofTopology,
    NotWatertight);

  // Two that meet in an edge, which then has four faces.
  const Grid hinge = MakePolyhedron(pair,
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, { 0, 5, 4 }, { 0, 4, 3 }, { 0, 3, 5 },
      { 4, 5, 3 } });
  EXPECT_EQ(status(hinge) & (NonManifoldEdge | NotWatertight), NonManifoldEdge);
  EXPECT_EQ(EvaluateAll(hinge).at("IsConvex")[0], 0);
  EXPECT_EQ(EvaluateAll(hinge).at("IsValid")[0], 0);
}

//------------------------------------------------------------------------------
// An octahemioctahedron: the triangles of a cuboctahedron and the four hexagons through its center,
// which cross between points that they share, also when these are moved.
TEST(CriteriaValidity, FacesThatCrossBetweenTheirPoints)
{
  Points points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double a : { -1.0, 1.0 })
    {
      for (const double b : { -1.0, 1.0 })
      {
        Point point = { 0, 0, 0 };
        point[(axis + 1) % 3] = a;
        point[(axis + 2) % 3] = b;
        points.push_back(point);
      }
    }
  }
  // Those of a plane through signs * (1, 1, 1) at a distance, in the order in which they lie around
  // it.
  const auto getFace = [&](const Point& signs, double distance)
  {
    const Vector normal = { signs[0], signs[1], signs[2] };
    const Vector right = Unit(Cross(normal, { 0, 0, 1 })), up = Cross(Unit(normal), right);
    std::map<double, vtkIdType> byAngle;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Vector point = { points[i][0], points[i][1], points[i][2] };
      if (Dot(normal, point) == distance)
      {
        byAngle[std::atan2(Dot(point, up), Dot(point, right))] = static_cast<vtkIdType>(i);
      }
    }
    std::vector<vtkIdType> face;
    for (const auto& point : byAngle)
    {
      face.push_back(point.second);
    }
    return face;
  };
  Faces faces;
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      faces.push_back(getFace({ x, y, 1 }, 0));
      faces.push_back(getFace({ x, y, 1 }, 2));
      faces.push_back(getFace({ x, y, -1 }, 2));
    }
  }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  const Grid exact = MakePolyhedron(points, faces);
  const Grid moved = Transform(exact, [&](const Point& p)
    { return Point{ p[0] + noise(random), p[1] + noise(random), p[2] + noise(random) }; });
  for (const Grid& mesh : { exact, moved })
  {
    const Values values = EvaluateAll(mesh);
    EXPECT_EQ(values.at("FaceCount")[0], 12);
    EXPECT_EQ(values.at("IsWatertight")[0], 1);
    EXPECT_NE(static_cast<unsigned>(values.at("CellStatus")[0]) & IntersectingFaces, 0u);
    EXPECT_EQ(values.at("IsValid")[0], 0);
    EXPECT_EQ(values.at("IsConvex")[0], 0);
  }
}

//------------------------------------------------------------------------------
// What has as many points, edges and faces as a hexahedron is none if a face comes to a point
// twice, or if there are two pieces: quadrilaterals over all points of a tetrahedron.
TEST(CriteriaValidity, NoHexahedra)
{
  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  Faces twice = GetFaces(FindReferenceShape("unit cube").Polyhedron, 0);
  for (std::size_t face = 0; face < twice.size(); ++face)
  {
    Faces faces = twice;
    faces[face][3] = faces[face][1];
    std::swap(faces[0], faces[face]);
    EXPECT_EQ(EvaluateAll(MakePolyhedron(corners, faces)).at("CellFamilyId")[0], VTK_POLYHEDRON);
  }
  // Faces that are there twice, for others that are not.
  for (const Faces& faces :
    { Faces{ { 0, 2, 1 }, { 0, 1, 2 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } },
      Faces{ { 0, 3, 2, 1 }, { 0, 1, 4 }, { 0, 1, 4 }, { 2, 3, 4 }, { 2, 3, 4 } },
      Faces{ { 0, 1, 2 }, { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 3 } } })
  {
    EXPECT_EQ(EvaluateAll(MakePolyhedron(corners, faces)).at("CellFamilyId")[0], VTK_POLYHEDRON);
  }
  const Grid two = MakePolyhedron(corners,
    { { 0, 1, 2, 3 }, { 0, 2, 1, 3 }, { 0, 1, 3, 2 }, { 4, 5, 6, 7 }, { 4, 6, 5, 7 },
      { 4, 5, 7, 6 } });
  EXPECT_EQ(EvaluateAll(two).at("CellFamilyId")[0], VTK_POLYHEDRON);
}

//------------------------------------------------------------------------------
// A set of points one of which is nowhere is not the hull of the others.
TEST(CriteriaValidity, PointSetsThatAreNotFinite)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), Infinity })
  {
    const Grid grid =
      MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, bad } },
        { { VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4 } } });
    const Values values = EvaluateAll(WithHulls(grid, VTK_CONVEX_POINT_SET));
    EXPECT_EQ(values.at("CellStatus")[0], NonFinitePoint);
    EXPECT_TRUE(std::isnan(values.at("Volume")[0]));
    EXPECT_EQ(values.at("VertexCount")[0], 5);
  }
}

//------------------------------------------------------------------------------
// A cube whose top is rotated about its axis. Its mean planes enclose a box, but the triangles of
// its sides bend inward as soon as they are not planar: it is convex within the tolerance for that
// only. Of a polygon the mean plane counts.
TEST(CriteriaValidity, ConvexityOfTwistedCells)
{
  const auto evaluate = [](double degrees, double tolerance)
  {
    const Grid cube = MakeStandardCell(VTK_HEXAHEDRON);
    const double sine = std::sin(degrees * Pi / 180), cosine = std::cos(degrees * Pi / 180);
    const Grid twisted = Transform(cube,
      [&](const Point& p)
      {
        const double x = p[0] - 0.5, y = p[1] - 0.5;
        return p[2] > 0.5
          ? Point{ { 0.5 + cosine * x - sine * y, 0.5 + sine * x + cosine * y, p[2] } }
          : p;
      });
    EvaluationOptions options;
    options.PlanarityTolerance = tolerance;
    const Values values = EvaluateAll(twisted, options);
    EXPECT_EQ(values.at("IsConvex"), EvaluateAll(ToPolyhedra(twisted), options).at("IsConvex"));
    EXPECT_EQ(static_cast<unsigned>(values.at("CellStatus")[0]) & Nonconvex, 0u);
    EXPECT_EQ(values.at("KernelRatio")[0] > 1 - 1e-9, degrees == 0) << degrees;
    return values.at("IsConvex")[0];
  };
  EXPECT_EQ(evaluate(0, 0.1), 1);
  EXPECT_EQ(evaluate(2, 0.1), 1);
  EXPECT_EQ(evaluate(90, 0.1), 0);
  EXPECT_EQ(evaluate(-90, 0.1), 0);
  EXPECT_EQ(evaluate(90, 10), 1);
  const Values saddle =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0.5 }, { 1, 1, 0 }, { 0, 1, 0.5 } }));
  EXPECT_EQ(saddle.at("IsConvex")[0], 1);
}

//------------------------------------------------------------------------------
// The published table of degenerate polygons.
TEST(CriteriaValidity, DegeneratePolygons)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    const char* Name;
    Points Polygon;
    double EdgeLengthRatio, MinAngle, MaxAngle, RadiusRatio, RadiusEdgeRatio, BhatiaLawrence, Area;
  } rows[] = {
    { "collinear", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, 0.5, 0, 180, 0, Infinity, 0, 0 },
    { "two equal points", { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 } }, 0, nan, nan, 0, Infinity, 0,
      0 },
    { "one point", { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, nan, nan, nan, nan, nan, nan, 0 },
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
    expect("TriangleRadiusEdgeRatio", row.RadiusEdgeRatio);
    expect("BhatiaLawrence", row.BhatiaLawrence);
    expect("Area", row.Area);
  }
  const Values quad =
    EvaluateAll(MakePolygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }));
  for (const char* name : { "TriangleRadiusRatio", "TriangleRadiusEdgeRatio", "BhatiaLawrence",
         "TetRadiusRatio", "Volume" })
  {
    EXPECT_EQ(GetNullReason(quad.at(name)[0]), NullReason::NotApplicable) << name;
  }
}

//------------------------------------------------------------------------------
// If this fails, flat tetrahedra, in many of which three or four points lie in a line, have solid
// angles that no convex cell has, or others when they are polyhedra.
TEST(CriteriaValidity, SolidAnglesOfFlatTetrahedra)
{
  std::mt19937 random(6);
  Points points;
  Cells cells;
  for (int i = 0; i < 3000; ++i)
  {
    Points corners(4);
    for (Point& corner : corners)
    {
      corner = { { double(random() % 3), double(random() % 3), double(random() % 3) } };
    }
    const auto edge = [&](int end, int c) { return corners[end][c] - corners[0][c]; };
    const double volume = edge(1, 0) * (edge(2, 1) * edge(3, 2) - edge(2, 2) * edge(3, 1)) +
      edge(1, 1) * (edge(2, 2) * edge(3, 0) - edge(2, 0) * edge(3, 2)) +
      edge(1, 2) * (edge(2, 0) * edge(3, 1) - edge(2, 1) * edge(3, 0));
    if (volume == 0)
    {
      const auto first = static_cast<vtkIdType>(points.size());
      points.insert(points.end(), corners.begin(), corners.end());
      cells.push_back({ VTK_TETRA, { first, first + 1, first + 2, first + 3 } });
    }
  }
  ASSERT_GT(cells.size(), 500u);
  const Grid grid = MakeGrid(points, cells);
  const Values values = EvaluateAll(grid), ofPolyhedra = EvaluateAll(ToPolyhedra(grid));
  for (const char* name : { "MinSolidAngle", "MaxSolidAngle" })
  {
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const double value = values.at(name)[i], other = ofPolyhedra.at(name)[i];
      ASSERT_EQ(std::isnan(value), std::isnan(other)) << name << " of cell " << i;
      if (!std::isnan(value))
      {
        EXPECT_NEAR(value, other, 1e-9) << name << " of cell " << i;
        EXPECT_TRUE(std::abs(value) < 1e-9 || std::abs(value - 2 * Pi) < 1e-9)
          << name << " of cell " << i << ": " << value;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The published table of degenerate polyhedra.
TEST(CriteriaValidity, DegeneratePolyhedra)
{
  // Flat: the corners of the unit square.
  const Grid flat = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  Values values = EvaluateAll(flat);
  EXPECT_EQ(values["Volume"][0], 0);
  EXPECT_EQ(values["TetRadiusEdgeRatio"][0], Infinity);
  EXPECT_EQ(values["TetRadiusRatio"][0], 0);
  EXPECT_EQ(values["TetMeanRatio"][0], 0);
  EXPECT_NEAR(values["MinDihedralAngle"][0], 0, 1e-12);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 180, 1e-12);
  EXPECT_NEAR(values["MinSolidAngle"][0], 0, 1e-12);
  EXPECT_FALSE(std::signbit(values["MinSolidAngle"][0]));
  EXPECT_EQ(values["CellAspectRatio"][0], Infinity);

  // Inverted: only the volume shows it.
  const Grid inverted = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 2, 1, 3 } } });
  values = EvaluateAll(inverted);
  EXPECT_NEAR(values["Volume"][0], -1.0 / 6, 1e-15);
  const double root3 = std::sqrt(3.0);
  EXPECT_NEAR(values["TetMeanRatio"][0], -std::cbrt(16.0) / 3, 1e-12);
  EXPECT_NEAR(values["TetRadiusEdgeRatio"][0], root3 / 2, 1e-12);
  EXPECT_NEAR(values["TetRadiusRatio"][0], root3 - 1, 1e-12);
  EXPECT_NEAR(values["MinDihedralAngle"][0], std::acos(1 / root3) * 180 / Pi, 1e-10);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 90, 1e-10);
  EXPECT_NEAR(values["MinSolidAngle"][0], 2 * std::acos(1 / root3) - Pi / 2, 1e-12);

  // All faces of a polyhedron inward: found out, unless the user trusts them.
  const Grid inward = ToPolyhedra(inverted);
  EXPECT_NEAR(EvaluateAll(inward)["Volume"][0], 1.0 / 6, 1e-15);
  EvaluationOptions trust;
  trust.TrustFaceOrientation = true;
  values = EvaluateAll(inward, trust);
  EXPECT_NEAR(values["Volume"][0], -1.0 / 6, 1e-15);
  EXPECT_NEAR(values["MaxDihedralAngle"][0], 90, 1e-10);

  // One face inward: corrected, unless the user trusts orientations; then the cell has no inside.
  const ReferenceShape& cube = FindReferenceShape("unit cube");
  Faces faces = GetFaces(cube.Polyhedron, 0);
  std::reverse(faces[2].begin(), faces[2].end());
  const Grid mixed = MakePolyhedra(cube.Polyhedron->GetPoints(), { faces });
  values = EvaluateAll(mixed);
  EXPECT_NEAR(values["Volume"][0], 1, 1e-12);
  EXPECT_EQ(values["FaceOrientationStatus"][0], 2);
  values = EvaluateAll(mixed, trust);
  EXPECT_EQ(GetNullReason(values["Volume"][0]), NullReason::InvalidTopology);
  EXPECT_EQ(values["FaceOrientationStatus"][0], 2);

  // Open: a cube without its last face.
  faces = GetFaces(cube.Polyhedron, 0);
  faces.pop_back();
  values = EvaluateAll(MakePolyhedra(cube.Polyhedron->GetPoints(), { faces }));
  for (const char* name :
    { "Volume", "MinDihedralAngle", "MinSolidAngle", "IsoperimetricQuotient" })
  {
    EXPECT_EQ(GetNullReason(values[name][0]), NullReason::InvalidTopology) << name;
  }
  EXPECT_NEAR(values["SurfaceArea"][0], 5, 1e-12);
  EXPECT_EQ(values["FaceCount"][0], 5);

  // A collapsed edge, as a repeated id and as two ids in one place: the cell that remains. Its side
  // at x = 0 is warped, with vector area (-1, 1/2, 1/2) and center (5/18, 19/36, 19/36); at its
  // edges the angles are those of mean planes.
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 1, 1, 1 } };
  for (const vtkIdType last : { 6, 7 })
  {
    const Grid grid = MakeGrid(points, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, last } } });
    values = EvaluateAll(grid);
    EXPECT_EQ(values["VertexCount"][0], last == 6 ? 7 : 8);
    EXPECT_EQ(values["MinEdgeLength"][0], 0);
    EXPECT_EQ(values["EdgeLengthRatio"][0], 0);
    EXPECT_NEAR(values["Volume"][0], 0.75, 1e-10) << last;
    EXPECT_NEAR(values["MinDihedralAngle"][0], std::atan(2.0) * 180 / Pi, 1e-10) << last;
    EXPECT_NEAR(
      values["MaxDihedralAngle"][0], 180 - std::atan(3 / std::sqrt(2.0)) * 180 / Pi, 1e-10)
      << last;
    EXPECT_NEAR(values["MinSolidAngle"][0], Pi / 4, 1e-10) << last;
    EXPECT_NEAR(values["MaxSolidAngle"][0], Pi / 2, 1e-10) << last;
    EXPECT_EQ(static_cast<unsigned>(values["CellStatus"][0]) & (ZeroLengthEdge | CoincidentPoints),
      ZeroLengthEdge | CoincidentPoints);
    EXPECT_EQ(GetNullReason(values["TetRadiusRatio"][0]), NullReason::NotApplicable);
  }

  // For points, lines and empty cells everything is undefined but their type.
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

//------------------------------------------------------------------------------
// A coordinate that is no number leaves nothing but the counts, and never looks healthy.
TEST(CriteriaValidity, NonFinitePoints)
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
            const bool hasValue = criterion->IsInteger() &&
              row.first != "FaceOrientationStatus"; // which needs a volume
            EXPECT_EQ(
              GetNullReason(row.second[0]), hasValue ? NullReason::Value : NullReason::Degenerate)
              << row.first;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// A triangle with a repeated id has a collapsed edge.
TEST(CriteriaValidity, RepeatedIdInTriangle)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_TRIANGLE, { 0, 0, 1 } } });
  const Values values = EvaluateAll(grid);
  EXPECT_EQ(values.at("EdgeLengthRatio")[0], 0);
  EXPECT_EQ(values.at("Area")[0], 0);
  EXPECT_EQ(values.at("VertexCount")[0], 2);
}

//------------------------------------------------------------------------------
// Polyhedra without points, with one face, with a point as a face: no answer, and no crash.
TEST(CriteriaValidity, BrokenPolyhedra)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (const Faces& faces : { Faces{}, Faces{ { 0, 1, 2 } }, Faces{ { 0 }, { 1, 2 }, {} },
         Faces{ { 0, 1, 2 }, { 0, 1, 2 } },
         Faces{ { 0, 0, 0 }, { 1, 1, 2 }, { 3, 3, 3 }, { 2, 2, 2 } },
         Faces{ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 2 }, { 2, 3, 0 }, { 1, 3, 2 } } })
  {
    Values values = EvaluateAll(MakePolyhedron(points, faces));
    EXPECT_EQ(GetNullReason(values["Volume"][0]), NullReason::InvalidTopology) << faces.size();
  }
}

//------------------------------------------------------------------------------
// A face listed twice, once in each direction, is a fin inside the cell and leaves its volume
// alone.
TEST(CriteriaValidity, Fin)
{
  const ReferenceShape& cube = FindReferenceShape("unit cube");
  Faces faces = GetFaces(cube.Polyhedron, 0);
  faces.push_back({ 0, 2, 6 });
  faces.push_back({ 6, 2, 0 });
  Values values = EvaluateAll(MakePolyhedra(cube.Polyhedron->GetPoints(), { faces }));
  EXPECT_NEAR(values["Volume"][0], 1, 1e-12);
  EXPECT_EQ(GetNullReason(values["MinDihedralAngle"][0]), NullReason::InvalidTopology);
}

//------------------------------------------------------------------------------
// Whatever way polygons run through space.
TEST(CriteriaValidity, FlatnessOfTangledPolygons)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Points points;
  Cells cells;
  for (vtkIdType cell = 0; cell < 500; ++cell)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < 4 + cell % 5; ++i)
    {
      ids.push_back(static_cast<vtkIdType>(points.size()));
      points.push_back({ { coordinate(random), coordinate(random), coordinate(random) } });
    }
    cells.push_back({ VTK_POLYGON, ids });
  }
  const auto values = EvaluateAll(MakeGrid(points, cells));
  for (const double flatness : values.at("MinFaceFlatness"))
  {
    EXPECT_GE(flatness, 0);
    EXPECT_LE(flatness, 1);
  }
}
