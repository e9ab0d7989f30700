// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria that look at the neighbors of a cell, or at all cells of the mesh.
#include "CriteriaTesting.h"
#include "MeshElementsTesting.h"
#include "ReferenceShapes.h"

#include <algorithm>
#include <random>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Two cells that share a face, from the table of pairs: what each sees of the other.
TEST(CriteriaNeighbors, Neighbors)
{
  const auto hexahedra = [](const Points& second)
  {
    Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
      { 1, 1, 1 }, { 0, 1, 1 } };
    points.insert(points.end(), second.begin(), second.end());
    return MakeGrid(points,
      { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
        { VTK_HEXAHEDRON, { 1, 8, 9, 2, 5, 10, 11, 6 } } });
  };
  const auto shear = [](const Point& p) { return Point{ p[0], p[1] + p[0], p[2] }; };
  const double d = std::sqrt(0.5);
  // What the inner face has, but the quality of the worse cell and the skewness of the second,
  // whose other faces count.
  const struct
  {
    const char* Name;
    Grid Mesh;
    double NonOrthogonality, Quality, InnerSkewness, Skewness, Weight, Ratio;
  } pairs[] = {
    { "two unit cubes", hexahedra({ { 2, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 2, 1, 1 } }), 0, 1, 0,
      0, 0.5, 1 },
    { "cube and box", hexahedra({ { 3, 0, 0 }, { 3, 1, 0 }, { 3, 0, 1 }, { 3, 1, 1 } }), 0, 1, 0, 0,
      1.0 / 3, 0.5 },
    { "cube and sheared cube", hexahedra({ { 2, 1, 0 }, { 2, 2, 0 }, { 2, 1, 1 }, { 2, 2, 1 } }),
      std::atan(0.5) * 180 / Pi, d, 0.5, 1, 0.5, 1 },
    { "two sheared cubes, x-face", Transform(MakeHexahedra(2, 1, 1, false), shear), 45, d, 0, 1,
      0.5, 1 },
    { "two sheared cubes, y-face", Transform(MakeHexahedra(1, 2, 1, false), shear), 45, d, 0, 1,
      0.5, 1 },
    // The slanted sides of the wedge have lines to the center (1/6, -1/4) and normals (1/2, -1),
    // and count.
    { "cube and wedge",
      MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
                 { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0.5, 0 }, { 2, 0.5, 1 } },
        { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } } }),
      0, 8 / std::sqrt(65.0), 0, 1.0 / 15, 0.4, 0.5 },
  };
  for (const auto& pair : pairs)
  {
    for (const Grid& grid : { pair.Mesh, ToPolyhedra(pair.Mesh) })
    {
      const Values values = EvaluateAll(grid);
      for (const std::size_t cell : { 0, 1 })
      {
        ExpectNear(pair.NonOrthogonality, values.at("MaxNonOrthogonality")[cell], 1e-10, pair.Name);
        ExpectNear(pair.Weight, values.at("MinFaceWeight")[cell], 1e-10, pair.Name);
        ExpectNear(pair.Ratio, values.at("MinVolumeRatio")[cell], 1e-10, pair.Name);
        ExpectNear(1 / pair.Ratio, values.at("CellVolumeRatio")[cell], 1e-10, pair.Name);
      }
      ExpectNear(pair.Quality,
        std::min(values.at("OrthogonalQuality")[0], values.at("OrthogonalQuality")[1]), 1e-10,
        pair.Name);
      ExpectNear(pair.Skewness, values.at("MaxFaceSkewness")[1], 1e-10, pair.Name);
      const Elements elements(grid);
      for (vtkIdType face = 0; face < elements.Faces->GetNumberOfCells(); ++face)
      {
        if (Get(elements.Faces, "IsBoundary", face) == 0)
        {
          ExpectNear(
            pair.InnerSkewness, Get(elements.Faces, "FaceSkewness", face), 1e-10, pair.Name);
        }
      }
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
    cells.push_back({ VTK_HEXAHEDRON, { a, a + 1, a + 5, a + 4, a + 16, a + 17, a + 21, a + 20 } });
  }
  const Values cube = EvaluateAll(MakeGrid(points, cells));
  ExpectNear(1, cube.at("CellDeterminant")[13], 1e-12, "middle");
  EXPECT_EQ(GetNullReason(cube.at("MaxBoundaryNonOrthogonality")[13]), NullReason::NoNeighbor);
  ExpectNear(0, cube.at("MaxBoundaryNonOrthogonality")[0], 1e-12, "corner");

  // Alone: nothing to compare with.
  const Values alone = EvaluateAll(FindReferenceShape("unit cube").Polyhedron);
  for (const char* name :
    { "MaxNonOrthogonality", "MinFaceWeight", "MinVolumeRatio", "CellVolumeRatio" })
  {
    EXPECT_EQ(GetNullReason(alone.at(name)[0]), NullReason::NoNeighbor) << name;
  }
  ExpectNear(0, alone.at("CellDeterminant")[0], 1e-12, "alone");
  const std::map<std::string, std::array<double, 2>> boundary = {
    { "unit cube", { 0, 1 } },
    { "regular tetrahedron", { 0, 1 } },
    { "right triangular prism", { 0, 1 } },
    { "regular octahedron", { 0, 1 } },
    { "regular dodecahedron", { 0, 1 } },
    { "truncated octahedron", { 0, 1 } },
    { "box", { 0, 1 } },
    { "hexagonal prism", { 0, 1 } },
    { "right-corner tetrahedron", { 0.25, 0.9045340337333 } },
    { "square pyramid", { 0.25, 0.9045340337333 } },
    { "sheared hex", { 1, 0.7071067811865 } },
    { "flat sliver", { 0.499700119952, 0.02999250221178 } },
    { "L-prism", { 1.333333333333, 0.2425356250363 } },
    { "warped hex", { 0.2248677248677, 0.9502584924607 } },
  };
  for (const auto& shape : boundary)
  {
    const Values values = EvaluateAll(FindReferenceShape(shape.first).Polyhedron);
    ExpectNear(shape.second[0], values.at("MaxFaceSkewness")[0], 1e-10, shape.first);
    ExpectNear(shape.second[1], values.at("OrthogonalQuality")[0], 1e-10, shape.first);
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
  const Values squares = EvaluateAll(
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 3, 1, 0 }, { 3, 2, 0 } },
      { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 2, 1, 4, 5 } } }));
  ExpectNear(2, squares.at("CellVolumeRatio")[0], 1e-12, "areas");
  ExpectNear(1.0 / 3, squares.at("MinFaceWeight")[1], 1e-12, "weights");
  ExpectNear(std::atan2(0.5, 1.5) * 180 / Pi, squares.at("MaxNonOrthogonality")[0], 1e-10, "angle");
}

//------------------------------------------------------------------------------
// If this fails, polygons get the determinant of the three directions of space, which is 0, or
// another one in planes that are not those of the axes.
TEST(CriteriaNeighbors, DeterminantOfPolygons)
{
  Points points;
  Cells cells;
  for (int i = 0; i < 16; ++i)
  {
    points.push_back({ 1e-3 * (i % 4), 0.6e-3 * (i / 4), 0.8e-3 * (i / 4) });
  }
  for (int i = 0; i < 9; ++i)
  {
    const vtkIdType a = i % 3 + 4 * (i / 3);
    cells.push_back({ VTK_QUAD, { a, a + 1, a + 5, a + 4 } });
  }
  const auto squares = EvaluateAll(MakeGrid(points, cells)).at("CellDeterminant");
  ExpectNear(1, squares[4], 1e-12, "middle");
  ExpectNear(0.5, squares[1], 1e-12, "side");
  ExpectNear(0.25, squares[0], 1e-12, "corner");
  const auto alone = EvaluateAll(MakeGrid(points, { cells[0] })).at("CellDeterminant");
  ExpectNear(0, alone[0], 1e-12, "alone");
}

//------------------------------------------------------------------------------
// The published table takes all faces for inner ones, which those of a cell are that is there
// twice, and is of the determinant that is 8 for a cube. If this fails, ours is not OpenFOAM's.
TEST(CriteriaNeighbors, DeterminantOfReferenceShapes)
{
  const std::map<std::string, double> expected = {
    { "unit cube", 8 },
    { "regular tetrahedron", 2.37037037037 },
    { "right-corner tetrahedron", 1.459229314226 },
    { "square pyramid", 2.935468516058 },
    { "right triangular prism", 3.948622274316 },
    { "regular octahedron", 18.96296296296 },
    { "regular dodecahedron", 64 },
    { "truncated octahedron", 163.134669766 },
    { "sheared hex", 3.68191210096 },
    { "box", 3.172555652832 },
    { "flat sliver", 2.556930455963e-06 },
    { "hexagonal prism", 16.16975301667 },
    { "L-prism", 22.56039575347 },
    { "warped hex", 7.871281112028 },
  };
  for (const ReferenceShape& shape : GetReferenceShapes())
  {
    const Faces faces = GetFaces(shape.Polyhedron, 0);
    const Values values =
      EvaluateAll(MakePolyhedra(shape.Polyhedron->GetPoints(), { faces, faces }));
    for (const std::size_t cell : { 0, 1 })
    {
      ExpectNear(
        expected.at(shape.Name) / 8, values.at("CellDeterminant")[cell], 1e-10, shape.Name);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, the centroid of a cell with coordinates that are not finite is taken to lie
// somewhere, and its neighbors get numbers that depend on where the mesh lies.
TEST(CriteriaNeighbors, NonFiniteNeighbor)
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

//------------------------------------------------------------------------------
// Every cell of a split surface sees its neighbors; folds and inconsistent neighbors count right.
TEST(CriteriaNeighbors, NeighborNormals)
{
  // A flat square of two triangles and a wall standing on its edge; the second wall runs backwards.
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 } };
  for (const bool backwards : { false, true })
  {
    const std::vector<vtkIdType> wall =
      backwards ? std::vector<vtkIdType>{ 0, 1, 5, 4 } : std::vector<vtkIdType>{ 1, 0, 4, 5 };
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

//------------------------------------------------------------------------------
// Many polygons at one edge. If this fails, an extreme neighbor is missed.
TEST(CriteriaNeighbors, NormalsAroundAnEdge)
{
  // Triangles and warped quadrilaterals in random and in frequent directions, either way round.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double warp : { 0.0, 0.3 })
  {
    Points points = { { 1, 2, 3 }, { 2, 2.5, 3.5 } };
    Cells cells;
    std::vector<Vector> normals; // as if all traversed the edge in the same direction
    for (vtkIdType i = 0; i < 300; ++i)
    {
      const auto first = static_cast<vtkIdType>(points.size());
      const Point tip = i % 3 ? Point{ any(random), any(random), any(random) } : Point{ 0, 0, 1 };
      points.push_back(tip);
      points.push_back({ tip[0] + 1 + warp * any(random), tip[1] + 0.5, tip[2] + 0.5 });
      std::vector<vtkIdType> polygon = { 0, 1, first + 1, first };
      if (i % 4 == 0)
      {
        polygon.erase(polygon.begin() + 2);
      }
      const auto between = [&](std::size_t from, std::size_t to)
      {
        const Point &a = points[polygon[from]], &b = points[polygon[to]];
        return Vector{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
      };
      normals.push_back(Cross(between(0, 2), between(1, polygon.size() - 1)));
      if (i % 2)
      {
        std::reverse(polygon.begin(), polygon.end());
      }
      cells.push_back({ polygon.size() == 3 ? VTK_TRIANGLE : VTK_QUAD, polygon });
    }
    const Values values = EvaluateAll(MakeGrid(points, cells));
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      double least = 180, largest = 0;
      for (std::size_t j = 0; j < cells.size(); ++j)
      {
        const double angle =
          std::atan2(Norm(Cross(normals[i], normals[j])), -Dot(normals[i], normals[j])) * 180 / Pi;
        least = i == j ? least : std::min(least, angle);
        largest = i == j ? largest : std::max(largest, angle);
      }
      EXPECT_NEAR(values.at("MinNeighborNormalAngle")[i], least, 1e-9) << i;
      EXPECT_NEAR(values.at("MaxNeighborNormalAngle")[i], largest, 1e-9) << i;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells are compared with another mean than that of all cells of their dimension.
TEST(CriteriaNeighbors, RelativeSize)
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
// The boundary of a solid has the dihedral angles of the solid. If this fails, the outer side of a
// surface is mistaken, or what is open counts as closed.
TEST(CriteriaNeighbors, SurfaceDihedralAngles)
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

//------------------------------------------------------------------------------
// Polygons of fewer than three points have no facets; if this fails, a mesh that begins with one
// crashes.
TEST(CriteriaNeighbors, PolygonsWithoutFacets)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const Values values = EvaluateAll(MakeGrid(points,
    { { VTK_POLYGON, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 1 } }, { VTK_QUAD, { 0, 1, 2, 3 } } }));
  for (const int cell : { 0, 1 })
  {
    EXPECT_EQ(GetNullReason(values.at("OrthogonalQuality")[cell]), NullReason::Degenerate);
    EXPECT_EQ(GetNullReason(values.at("MaxFaceSkewness")[cell]), NullReason::Degenerate);
  }
  EXPECT_NEAR(values.at("OrthogonalQuality")[2], 1, 1e-15);
}
