// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and vertices of meshes small enough to count them by hand, and sums that hold in every mesh.
#include "Criteria/CompletedPieces.h"
#include "Criteria/Evaluation.h"
#include "MeshElementsTesting.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkDoubleArray.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Cubes in a row, as hexahedra.
Grid MakeRow(int cubes)
{
  Points points;
  Cells cells;
  for (int i = 0; i <= cubes; ++i)
  {
    const double x = i;
    points.insert(points.end(), { { x, 0, 0 }, { x, 1, 0 }, { x, 1, 1 }, { x, 0, 1 } });
  }
  for (vtkIdType a = 0; a < 4 * cubes; a += 4)
  {
    cells.push_back(
      { VTK_HEXAHEDRON, { a, a + 4, a + 5, a + 1, a + 3, a + 7, a + 6, a + 2 } });
  }
  return MakeGrid(points, cells);
}

// The same mesh with its inner points moved at random; of a block of unit cubes of that size.
Grid Warp(const Grid& grid, int size)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    if (std::all_of(x, x + 3, [=](double c) { return c > 0 && c < size; }))
    {
      points->SetPoint(i, x[0] + noise(random), x[1] + noise(random), x[2] + noise(random));
    }
  }
  return grid;
}

// The cubes of a block, each cut into the six tetrahedra around a diagonal.
Grid MakeTetrahedra(int size)
{
  const Grid block = MakeHexahedra(size, size, size, false);
  Cells cells;
  for (vtkIdType cube = 0; cube < block->GetNumberOfCells(); ++cube)
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(cube, ids);
    const int around[] = { 1, 2, 3, 7, 4, 5 };
    for (int i = 0; i < 6; ++i)
    {
      cells.push_back({ VTK_TETRA,
        { ids->GetId(0), ids->GetId(around[i]), ids->GetId(around[(i + 1) % 6]), ids->GetId(6) } });
    }
  }
  const Grid grid = MakeGrid({}, cells);
  grid->SetPoints(block->GetPoints());
  return grid;
}

}

//------------------------------------------------------------------------------
TEST(MeshElements, OfARowOfCubes)
{
  const Grid row = MakeRow(3);
  for (const Grid& grid : { row, ToPolyhedra(row) })
  {
    const Elements elements(grid);
    vtkPolyData* faces = elements.Faces;
    EXPECT_EQ(faces->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(faces, "IsBoundary"), 14);
    EXPECT_EQ(Sum(faces, "FaceCellCount"), 18);
    for (vtkIdType i = 0; i < 16; ++i)
    {
      EXPECT_EQ(faces->GetCellSize(i), 4);
      const bool isInner = Get(faces, "IsBoundary", i) == 0;
      EXPECT_EQ(Get(faces, "NeighborCell", i) >= 0, isInner);
      EXPECT_EQ(std::isnan(Get(faces, "NonOrthogonality", i)), !isInner);
      EXPECT_EQ(std::isnan(Get(faces, "BoundaryNonOrthogonality", i)), isInner);
      EXPECT_NEAR(Get(faces, "FaceSkewness", i), 0, 1e-12);
      EXPECT_NEAR(Get(faces, "FacePyramidVolume", i), 1.0 / 6, 1e-12);
      if (isInner)
      {
        EXPECT_EQ(Get(faces, "NeighborCell", i) - Get(faces, "OwnerCell", i), 1);
        EXPECT_NEAR(Get(faces, "FaceWeight", i), 0.5, 1e-12);
        EXPECT_NEAR(Get(faces, "VolumeRatio", i), 1, 1e-12);
      }
    }
    vtkPolyData* edges = elements.Edges;
    EXPECT_EQ(edges->GetNumberOfCells(), 28);
    EXPECT_EQ(Sum(edges, "EdgeLength"), 28);
    EXPECT_EQ(Sum(edges, "EdgeCellCount"), 36);
    EXPECT_EQ(Sum(edges, "EdgeFaceCount"), 4 * 16);
    EXPECT_EQ(Sum(edges, "IsBoundary"), 28);
    vtkPolyData* vertices = elements.Vertices;
    EXPECT_EQ(vertices->GetNumberOfCells(), 16);
    EXPECT_EQ(Sum(vertices, "VertexCellCount"), 24);
    EXPECT_EQ(Sum(vertices, "VertexEdgeCount"), 56);
    EXPECT_EQ(Sum(vertices, "VertexFaceCount"), 64);
    EXPECT_EQ(Sum(vertices, "UnusedPoint"), 0);
  }
}

//------------------------------------------------------------------------------
// The surface of a cube, with one face turned and one missing.
TEST(MeshElements, OfASurface)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 }, { 5, 5, 5 } };
  const Grid surface = MakeGrid(points,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 0, 3, 7, 4 } } }); // the last one runs the other way
  const Elements elements(surface);
  EXPECT_EQ(elements.Faces->GetNumberOfCells(), 5);
  vtkPolyData* edges = elements.Edges;
  EXPECT_EQ(edges->GetNumberOfCells(), 12);
  EXPECT_EQ(Sum(edges, "IsBoundary"), 4);
  EXPECT_EQ(Sum(edges, "InconsistentEdge"), 3);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double angle = Get(edges, "EdgeDihedralAngle", i);
    const bool isBoundary = Get(edges, "IsBoundary", i) != 0;
    EXPECT_EQ(std::isnan(angle), isBoundary);
    if (!isBoundary && Get(edges, "InconsistentEdge", i) == 0)
    {
      EXPECT_NEAR(angle, 90, 1e-9);
    }
  }
  EXPECT_EQ(Sum(elements.Vertices, "UnusedPoint"), 1);
  EXPECT_EQ(Get(elements.Vertices, "UnusedPoint", 8), 1);
  EXPECT_EQ(Sum(elements.Vertices, "IsBoundary"), 4);
}

//------------------------------------------------------------------------------
// If this fails, elements between processes count twice or not at all.
TEST(MeshElements, BelongToThePieceOfTheSmallestCell)
{
  const Grid pieces[] = { MakeRow(2), MakeRow(2) };
  double owned[3] = { 0, 0, 0 };
  for (int p = 0; p < 2; ++p)
  {
    // Cells 0 and 1 of three in the first piece, 1 and 2 in the second; cell 1 belongs to the first.
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("GlobalCellIds");
    ids->InsertNextValue(p);
    ids->InsertNextValue(p + 1);
    pieces[p]->GetCellData()->SetGlobalIds(ids);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->InsertNextValue(p == 1 ? vtkDataSetAttributes::DUPLICATECELL : 0);
    ghosts->InsertNextValue(0);
    pieces[p]->GetCellData()->AddArray(ghosts);
    const Elements elements(pieces[p]);
    vtkPolyData* sets[] = { elements.Faces, elements.Edges };
    for (int k = 0; k < 2; ++k)
    {
      for (vtkIdType i = 0; i < sets[k]->GetNumberOfCells(); ++i)
      {
        owned[k] += Get(sets[k], vtkDataSetAttributes::GhostArrayName(), i) == 0;
      }
    }
  }
  EXPECT_EQ(owned[0], 16);
  EXPECT_EQ(owned[1], 28);
}

//------------------------------------------------------------------------------
// Cubes of a block of 2 x 2 x 2, each a piece of its own that knows nothing of the others. If this fails, elements
// between pieces count twice, or lie at the boundary of the mesh.
TEST(MeshElements, OfPiecesWithoutGhosts)
{
  const double pi = std::acos(-1.0);
  const Grid block = MakeHexahedra(2, 2, 2, false);
  const auto take = [&](const std::vector<vtkIdType>& cubes, const std::vector<vtkIdType>& ids)
  {
    std::vector<Grid> grids;
    for (const vtkIdType cube : cubes)
    {
      Points points;
      vtkCell* cell = block->GetCell(cube);
      for (vtkIdType i = 0; i < 8; ++i)
      {
        double x[3];
        cell->GetPoints()->GetPoint(i, x);
        points.push_back({ x[0], x[1], x[2] });
      }
      grids.push_back(MakeGrid(points, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } }));
      grids.back() = cube % 2 ? ToPolyhedra(grids.back()) : grids.back();
    }
    std::vector<std::unique_ptr<MeshTopology>> topologies;
    std::vector<LinkedPiece> pieces(grids.size());
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      topologies.push_back(std::make_unique<MeshTopology>(grids[i]));
      pieces[i].Data = grids[i];
      pieces[i].Topology = topologies.back().get();
      pieces[i].CellIds = ids.empty() ? nullptr : &ids[i];
    }
    Reducer alone;
    const auto meshes = CompletePieces(pieces, {}, alone);
    std::vector<std::unique_ptr<Elements>> elements;
    for (std::size_t i = 0; i < grids.size(); ++i)
    {
      elements.push_back(
        std::make_unique<Elements>(meshes[i], 0, ElementSource{ grids[i], OfPolyhedra }));
      EXPECT_EQ(elements.back()->Faces->GetNumberOfPoints(), 8);
      EXPECT_EQ(elements.back()->Vertices->GetNumberOfCells(), 8);
    }
    return elements;
  };
  const auto sum = [&](const auto& elements, vtkNew<vtkPolyData> Elements::*set, const char* name)
  {
    double result = 0;
    for (const auto& piece : elements)
    {
      vtkPolyData* data = (*piece).*set;
      for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
      {
        const bool isOwn = Get(data, vtkDataSetAttributes::GhostArrayName(), i) == 0;
        result += isOwn ? name ? Get(data, name, i) : 1 : 0;
      }
    }
    return result;
  };
  for (const std::vector<vtkIdType>& ids :
    { std::vector<vtkIdType>(), std::vector<vtkIdType>{ 70, 10, 20, 60, 30, 50, 80, 40 } })
  {
    const auto all = take({ 0, 1, 2, 3, 4, 5, 6, 7 }, ids);
    EXPECT_EQ(sum(all, &Elements::Faces, nullptr), 36);
    EXPECT_EQ(sum(all, &Elements::Faces, "IsBoundary"), 24);
    EXPECT_EQ(sum(all, &Elements::Faces, "FaceCellCount"), 8 * 6);
    EXPECT_EQ(sum(all, &Elements::Edges, nullptr), 54);
    EXPECT_EQ(sum(all, &Elements::Edges, "IsBoundary"), 48);
    EXPECT_EQ(sum(all, &Elements::Edges, "EdgeCellCount"), 8 * 12);
    EXPECT_EQ(sum(all, &Elements::Edges, "EdgeFaceCount"), 36 * 4);
    EXPECT_NEAR(sum(all, &Elements::Edges, "EdgeAngleSum"), 8 * 12 * 90, 1e-9);
    EXPECT_EQ(sum(all, &Elements::Vertices, nullptr), 27);
    EXPECT_EQ(sum(all, &Elements::Vertices, "IsBoundary"), 26);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexCellCount"), 8 * 8);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexEdgeCount"), 54 * 2);
    EXPECT_EQ(sum(all, &Elements::Vertices, "VertexFaceCount"), 36 * 4);
    EXPECT_EQ(sum(all, &Elements::Vertices, "PointRegionCount"), 27);
    EXPECT_NEAR(sum(all, &Elements::Vertices, "VertexAngleSum"), 8 * 8 * pi / 2, 1e-9);
    // Inner faces of the first cube belong to it, or to those of smaller ids.
    std::multiset<double> neighbors, owners;
    for (vtkIdType face = 0; face < 6; ++face)
    {
      neighbors.insert(Get(all[0]->Faces, "NeighborCell", face));
      owners.insert(Get(all[0]->Faces, "OwnerCell", face));
      const bool isBoundary = Get(all[0]->Faces, "IsBoundary", face) != 0;
      const bool isGhost = Get(all[0]->Faces, vtkDataSetAttributes::GhostArrayName(), face) != 0;
      EXPECT_EQ(isGhost, !isBoundary && !ids.empty());
      EXPECT_EQ(std::isnan(Get(all[0]->Faces, "NonOrthogonality", face)), isBoundary);
    }
    const bool hasIds = !ids.empty();
    using Set = std::multiset<double>;
    EXPECT_EQ(neighbors, hasIds ? Set({ -1, -1, -1, 70, 70, 70 }) : Set({ -1, -1, -1, 1, 2, 4 }));
    EXPECT_EQ(owners, hasIds ? Set({ 10, 20, 30, 70, 70, 70 }) : Set({ 0, 0, 0, 0, 0, 0 }));
  }
  // Pieces that share no more than an edge, or a point.
  const auto edge = take({ 0, 3 }, {});
  EXPECT_EQ(sum(edge, &Elements::Edges, nullptr), 23);
  EXPECT_EQ(sum(edge, &Elements::Edges, "EdgeCellCount"), 24);
  EXPECT_EQ(sum(edge, &Elements::Vertices, "PointRegionCount"), 16);
  const auto point = take({ 0, 7 }, {});
  EXPECT_EQ(sum(point, &Elements::Vertices, nullptr), 15);
  EXPECT_EQ(sum(point, &Elements::Vertices, "PointRegionCount"), 16);
  EXPECT_EQ(sum(point, &Elements::Faces, "IsBoundary"), 12);
}

//------------------------------------------------------------------------------
// Around an inner edge the cells fill 360 degrees, around an inner vertex 4 pi; neither at the boundary.
TEST(MeshElements, AnglesAroundInnerElements)
{
  const double pi = std::acos(-1.0);
  const Grid tetrahedra = Warp(MakeTetrahedra(4), 4);
  for (const Grid& grid : { tetrahedra, ToPolyhedra(tetrahedra) })
  {
    const Elements elements(grid);
    int inner = 0;
    for (vtkIdType i = 0; i < elements.Edges->GetNumberOfCells(); ++i)
    {
      const bool isBoundary = Get(elements.Edges, "IsBoundary", i) != 0;
      const double sum = Get(elements.Edges, "EdgeAngleSum", i);
      inner += !isBoundary;
      EXPECT_NEAR(sum, isBoundary ? std::min(sum, 300.0) : 360, 1e-9);
      EXPECT_LE(Get(elements.Edges, "EdgeMinDihedralAngle", i), sum);
      EXPECT_LE(Get(elements.Edges, "EdgeMaxDihedralAngle", i), sum);
      EXPECT_GE(Get(elements.Edges, "EdgeMaxDihedralAngle", i) * Get(elements.Edges, "EdgeCellCount", i),
        sum - 1e-9);
    }
    EXPECT_GT(inner, 100);
    // Euler: a block has V - E + F - C = 1.
    EXPECT_EQ(elements.Vertices->GetNumberOfCells() - elements.Edges->GetNumberOfCells() +
        elements.Faces->GetNumberOfCells() - grid->GetNumberOfCells(),
      1);
  }
  const Grid hexahedra = Warp(MakeHexahedra(4, 4, 4, false), 4);
  for (const Grid& grid : { tetrahedra, hexahedra, ToPolyhedra(hexahedra) })
  {
    const Elements elements(grid);
    for (vtkIdType i = 0; i < 125; ++i)
    {
      const double sum = Get(elements.Vertices, "VertexAngleSum", i);
      double x[3];
      grid->GetPoint(i, x);
      const auto sides = std::count_if(x, x + 3, [](double c) { return c == 0 || c == 4; });
      EXPECT_NEAR(sum, 4 * pi / (1 << sides), 1e-9);
    }
  }
}

//------------------------------------------------------------------------------
// Edges between polygons are to 2D meshes what faces are to 3D ones. By hand for a square and a sheared one
// of twice the area; for any sheet the worst edge of all is the worst one of a polygon.
TEST(MeshElements, FiniteVolumesOfPolygons)
{
  const double pi = std::acos(-1.0);
  const Grid pair =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 3, 1, 0 }, { 3, 2, 0 } },
      { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 2, 1, 4, 5 } } });
  const Elements two(pair);
  int inner = 0;
  for (vtkIdType i = 0; i < two.Edges->GetNumberOfCells(); ++i)
  {
    const bool isInner = Get(two.Edges, "EdgeCellCount", i) == 2;
    inner += isInner;
    for (const char* name : { "NonOrthogonality", "FaceWeight", "VolumeRatio" })
    {
      EXPECT_EQ(GetNullReason(Get(two.Edges, name, i)), isInner ? NullReason::Value : NullReason::NoNeighbor);
    }
    EXPECT_EQ(std::isnan(Get(two.Edges, "BoundaryNonOrthogonality", i)), isInner);
    if (isInner)
    {
      // Centroids (0.5, 0.5) and (2, 1); the line between them meets the edge at height 2/3.
      EXPECT_NEAR(Get(two.Edges, "NonOrthogonality", i), std::atan2(0.5, 1.5) * 180 / pi, 1e-12);
      EXPECT_NEAR(Get(two.Edges, "FaceWeight", i), 1.0 / 3, 1e-15);
      EXPECT_NEAR(Get(two.Edges, "VolumeRatio", i), 0.5, 1e-15);
      EXPECT_NEAR(Get(two.Edges, "FaceSkewness", i), (2.0 / 3 - 0.5) / 0.5, 1e-12);
    }
  }
  EXPECT_EQ(inner, 1);

  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-0.25, 0.25);
  Points points;
  Cells cells;
  const int size = 20;
  for (vtkIdType i = 0; i < (size + 1) * (size + 1); ++i)
  {
    const double x = i % (size + 1), y = i / (size + 1);
    points.push_back({ x + noise(random), y + noise(random), noise(random) });
    if (x < size && y < size)
    {
      cells.push_back({ VTK_QUAD, { i, i + 1, i + size + 2, i + size + 1 } });
    }
  }
  const Grid sheet = MakeGrid(points, cells);
  const Elements elements(sheet);
  const struct
  {
    const char *OfEdges, *OfCells;
    bool IsLargest;
  } rows[] = { { "NonOrthogonality", "MaxNonOrthogonality", true },
    { "BoundaryNonOrthogonality", "MaxBoundaryNonOrthogonality", true },
    { "FaceSkewness", "MaxFaceSkewness", true },
    { "FaceWeight", "MinFaceWeight", false }, { "VolumeRatio", "MinVolumeRatio", false } };
  for (const auto& row : rows)
  {
    std::vector<double> values(sheet->GetNumberOfCells());
    ASSERT_TRUE(Evaluate(MeshTopology(sheet), {}, { { FindCriterion(row.OfCells), values.data() } },
      [](double) { return true; }));
    const double sign = row.IsLargest ? 1 : -1;
    double ofCells = -1e9, ofEdges = -1e9;
    for (const double value : values)
    {
      ofCells = std::isnan(value) ? ofCells : std::max(ofCells, sign * value);
    }
    for (vtkIdType i = 0; i < elements.Edges->GetNumberOfCells(); ++i)
    {
      const double value = Get(elements.Edges, row.OfEdges, i);
      ofEdges = std::isnan(value) ? ofEdges : std::max(ofEdges, sign * value);
    }
    EXPECT_NEAR(ofEdges, ofCells, 1e-9) << row.OfEdges;
  }
}

//------------------------------------------------------------------------------
// Of a closed surface the angles that are missing to 360 degrees are two full circles together.
TEST(MeshElements, AngleDefects)
{
  const Points cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 } };
  const Elements closed(MakeGrid(cube,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_PIXEL, { 3, 0, 7, 4 } }, { VTK_TRIANGLE, { 4, 5, 6 } },
      { VTK_TRIANGLE, { 4, 6, 7 } } }));
  EXPECT_NEAR(8 * 360 - Sum(closed.Vertices, "VertexAngleSum"), 720, 1e-9);
  EXPECT_EQ(Sum(closed.Edges, "BoundaryEdge") + Sum(closed.Edges, "NonManifoldEdge"), 0);

  // A reflex corner, and three polygons at one edge.
  const Elements open(MakeGrid(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 1, 0, 1 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4, 5 } }, { VTK_TRIANGLE, { 0, 6, 1 } }, { VTK_TRIANGLE, { 0, 1, 6 } } }));
  EXPECT_NEAR(Get(open.Vertices, "VertexAngleSum", 3), 270, 1e-9);
  EXPECT_NEAR(Get(open.Vertices, "VertexAngleSum", 0), 90 + 45 + 45, 1e-9);
  EXPECT_EQ(Sum(open.Edges, "NonManifoldEdge"), 1);
  EXPECT_EQ(Sum(open.Edges, "BoundaryEdge"), 5);
  EXPECT_NEAR(Get(open.Faces, "FaceConcavity", 0), 90, 1e-9);
  EXPECT_EQ(Sum(open.Faces, "Warpage"), 0);
}

//------------------------------------------------------------------------------
// Which end is the worst follows from the criterion; null values count for nothing.
TEST(MeshElements, WorstOfTheCellsAround)
{
  const Grid row = MakeRow(3);
  const auto add = [&](const char* name, const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : values)
    {
      array->InsertNextValue(value);
    }
    row->GetCellData()->AddArray(array);
  };
  const double none = Null(NullReason::Degenerate);
  add("EdgeRatio", { 1, 5, 3 });
  add("EdgeLengthRatio", { none, 0.2, 0.5 });
  add("Diameter", { 1, 2, 3 });
  add("Pressure", { 1, 2, 3 });
  const Elements elements(row);
  const double ratios[] = { 1, 5, 5, 3 }, lengths[] = { none, 0.2, 0.2, 0.5 };
  for (vtkIdType i = 0; i < 16; ++i)
  {
    EXPECT_EQ(Get(elements.Vertices, "VertexWorstEdgeRatio", i), ratios[i / 4]);
    const double worst = Get(elements.Vertices, "VertexWorstEdgeLengthRatio", i);
    EXPECT_TRUE(i < 4 ? std::isnan(worst) : worst == lengths[i / 4]) << worst;
  }
  EXPECT_FALSE(elements.Vertices->GetCellData()->HasArray("VertexWorstDiameter"));
  EXPECT_FALSE(elements.Vertices->GetCellData()->HasArray("VertexWorstPressure"));
}

//------------------------------------------------------------------------------
// Where two cubes meet in a point only, and where a cell has none of its volume.
TEST(MeshElements, PinchedPointsAndFlatCells)
{
  const Grid block = MakeHexahedra(2, 2, 2, false);
  const Grid two = MakeGrid({}, {});
  two->SetPoints(block->GetPoints());
  for (const vtkIdType cube : { 0, 7 })
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(cube, ids);
    two->InsertNextCell(VTK_HEXAHEDRON, ids);
  }
  const Elements pinched(two);
  EXPECT_EQ(Get(pinched.Vertices, "PointRegionCount", 13), 2);
  EXPECT_EQ(Sum(pinched.Vertices, "PointRegionCount"), 16);
  EXPECT_EQ(Sum(pinched.Vertices, "UnusedPoint"), 12);

  // A wedge with a collapsed edge: no angle there, and none at the ends of it.
  const Elements collapsed(MakeGrid(
    { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 1 }, { 1, 0, 1 } },
    { { VTK_WEDGE, { 0, 1, 2, 3, 4, 5 } } }));
  EXPECT_TRUE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 0)));
  EXPECT_TRUE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 3)));
  EXPECT_FALSE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 5)));
}

//------------------------------------------------------------------------------
// The arrays of faces are what the criteria of cells choose from.
TEST(MeshElements, WorstFacesAreThoseOfCells)
{
  const Grid grid = Warp(MakeHexahedra(4, 4, 4, false), 4);
  const Elements elements(grid);
  const auto worst = [&](const char* name, auto&& better)
  {
    double chosen = Get(elements.Faces, name, 0);
    for (vtkIdType i = 1; i < elements.Faces->GetNumberOfCells(); ++i)
    {
      const double value = Get(elements.Faces, name, i);
      chosen = !(better(chosen, value) || std::isnan(value)) ? value : chosen;
    }
    return chosen;
  };
  const auto ofCells = [&](const char* name, bool largest)
  {
    std::vector<double> values(grid->GetNumberOfCells());
    Evaluate(MeshTopology(grid), {}, { { FindCriterion(name), values.data() } },
      [](double) { return true; });
    return largest ? *std::max_element(values.begin(), values.end())
                   : *std::min_element(values.begin(), values.end());
  };
  const auto less = std::less<double>();
  const auto greater = std::greater<double>();
  EXPECT_NEAR(worst("Warpage", greater), ofCells("MaxWarpage", true), 1e-12);
  EXPECT_NEAR(worst("FaceFlatness", less), ofCells("MinFaceFlatness", false), 1e-12);
  EXPECT_NEAR(worst("FaceConcavity", greater), ofCells("MaxFaceConcavity", true), 1e-9);
  EXPECT_NEAR(worst("FaceSkewness", greater), ofCells("MaxFaceSkewness", true), 1e-12);
  EXPECT_NEAR(worst("FacePyramidVolume", less), ofCells("MinFacePyramidVolume", false), 1e-12);

  const Elements straight(MakeRow(3));
  EXPECT_NEAR(Sum(straight.Faces, "FaceTwist"), 16, 1e-12);
  EXPECT_NEAR(Sum(straight.Faces, "FaceFlatness"), 16, 1e-12);
}

//------------------------------------------------------------------------------
// Bit for bit the same on one thread and on many.
TEST(MeshElements, IndependentOfThreads)
{
  const Grid grid = Warp(MakeTetrahedra(9), 9);
  std::vector<std::vector<double>> reference;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        const Elements elements(grid);
        std::vector<std::vector<double>> values;
        for (vtkPolyData* data : { elements.Faces.Get(), elements.Edges.Get(), elements.Vertices.Get() })
        {
          for (int a = 0; a < data->GetCellData()->GetNumberOfArrays(); ++a)
          {
            values.emplace_back();
            vtkDataArray* array = data->GetCellData()->GetArray(a);
            for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
            {
              const double value = array->GetComponent(i, 0);
              values.back().push_back(std::isnan(value) ? -1e300 : value);
            }
          }
        }
        reference = reference.empty() ? values : reference;
        EXPECT_EQ(reference, values) << threads;
      });
  }
}

//------------------------------------------------------------------------------
// Only what is asked for is there, and only where it means something.
TEST(MeshElements, Tables)
{
  const Grid row = MakeRow(1);
  const MeshTopology topology(row);
  const ElementContext context(row, topology, EvaluationOptions());
  vtkNew<vtkPolyData> edges;
  MakeEdges(context, { "EdgeLength", "BoundaryEdge" }, edges);
  EXPECT_EQ(edges->GetCellData()->GetNumberOfArrays(), 1);
  for (const auto* rows : { &GetFaceArrays(), &GetEdgeArrays(), &GetVertexArrays() })
  {
    std::set<std::pair<std::string, unsigned>> names;
    for (const ElementArray& array : *rows)
    {
      EXPECT_TRUE(names.emplace(array.Name, array.Dimensions).second) << array.Name;
      EXPECT_EQ((array.IdFunction != nullptr) + (array.FlagFunction != nullptr) +
          (array.RealFunction != nullptr) + (array.FacetFunction != nullptr) +
          (array.ShapeFunction != nullptr),
        1)
        << array.Name;
      EXPECT_GT(std::string(array.Description).size(), 10u);
    }
  }
}

//------------------------------------------------------------------------------
// Points in the middle of an edge or a face of a cell, where finer cells meet it.
TEST(MeshElements, AnglesAtHangingPoints)
{
  // A cube below four smaller ones, whose faces are its top.
  Points points;
  for (const double z : { 0.0, 2.0, 3.0 })
  {
    for (int i = 0; i < 9; ++i)
    {
      points.push_back({ double(i % 3), double(i / 3), z });
    }
  }
  std::vector<Faces> cells = { { { 0, 6, 8, 2 }, { 0, 2, 11, 10, 9 }, { 2, 8, 17, 14, 11 },
    { 8, 6, 15, 16, 17 }, { 6, 0, 9, 12, 15 } } };
  for (const vtkIdType a : { 9, 10, 12, 13 })
  {
    const vtkIdType b = a + 1, c = a + 4, d = a + 3;
    cells[0].push_back({ a, b, c, d });
    cells.push_back({ { a, d, c, b }, { a, b, b + 9, a + 9 }, { b, c, c + 9, b + 9 },
      { c, d, d + 9, c + 9 }, { d, a, a + 9, d + 9 }, { a + 9, b + 9, c + 9, d + 9 } });
  }
  const Grid grid = MakePolyhedra(MakePoints(points), cells);
  const double pi = std::acos(-1.0);
  std::vector<double> largest(cells.size());
  Evaluate(MeshTopology(grid), {}, { { FindCriterion("MaxSolidAngle"), largest.data() } },
    [](double) { return true; });
  EXPECT_NEAR(largest[0], 2 * pi, 1e-12);
  EXPECT_NEAR(largest[1], pi / 2, 1e-12);
  const Elements elements(grid);
  EXPECT_NEAR(Get(elements.Vertices, "VertexAngleSum", 13), 4 * pi, 1e-12);
  for (const vtkIdType point : { 10, 12, 14, 16 })
  {
    EXPECT_NEAR(Get(elements.Vertices, "VertexAngleSum", point), 2 * pi, 1e-12);
  }
  for (const vtkIdType point : { 9, 11, 15, 17 })
  {
    EXPECT_NEAR(Get(elements.Vertices, "VertexAngleSum", point), pi, 1e-12);
  }
}
