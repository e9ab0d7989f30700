// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What cells have to do with each other: parts of a mesh, pinched points, cells that are there
// twice.
#include "CriteriaTesting.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/MeshFacts.h"
#include "Selection/Growth.h"

#include "vtkIdTypeArray.h"

#include <memory>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Those cubes of a block of unit cubes whose places are listed, with the points of the whole block.
Grid MakeCubes(int size, const std::vector<std::array<int, 3>>& places, bool asPolyhedra)
{
  const Grid block = MakeHexahedra(size, size, size, false);
  Cells cells;
  for (const auto& place : places)
  {
    vtkNew<vtkIdList> ids;
    block->GetCellPoints(place[0] + size * (place[1] + vtkIdType(size) * place[2]), ids);
    cells.push_back({ VTK_HEXAHEDRON, { ids->begin(), ids->end() } });
  }
  auto grid = MakeGrid({}, cells);
  grid->SetPoints(block->GetPoints());
  return asPolyhedra ? ToPolyhedra(grid) : grid;
}

// Those squares of a plane whose places are listed.
Grid MakeSquares(int size, const std::vector<std::array<int, 2>>& places)
{
  Points points;
  for (int i = 0; i <= size; ++i)
  {
    for (int j = 0; j <= size; ++j)
    {
      points.push_back({ double(j), double(i), 0 });
    }
  }
  Cells cells;
  for (const auto& place : places)
  {
    const vtkIdType a = place[0] + (size + 1) * place[1], b = a + size + 1;
    cells.push_back({ VTK_QUAD, { a, a + 1, b + 1, b } });
  }
  return MakeGrid(points, cells);
}
}

//------------------------------------------------------------------------------
// Cells of two pieces that share a face find each other by global ids where a point of it is
// nowhere.
TEST(CriteriaConnectivity, PiecesWithAPointNowhere)
{
  const Grid block = MakeHexahedra(2, 1, 1, false);
  std::vector<Grid> grids;
  std::vector<std::vector<vtkIdType>> ids;
  std::vector<std::unique_ptr<MeshTopology>> topologies;
  std::vector<LinkedPiece> pieces(2);
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkIdList* const corners = block->GetCell(cell)->GetPointIds();
    ids.emplace_back(corners->begin(), corners->end());
    Points points;
    for (const vtkIdType id : ids.back())
    {
      double x[3];
      block->GetPoint(id, x);
      const bool isNowhere = x[0] == 1 && x[1] == 0 && x[2] == 0;
      points.push_back({ x[0], isNowhere ? std::numeric_limits<double>::quiet_NaN() : x[1], x[2] });
    }
    grids.push_back(MakeGrid(points, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } }));
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    topologies.push_back(std::make_unique<MeshTopology>(grids[i]));
    pieces[i].Data = grids[i];
    pieces[i].Topology = topologies[i].get();
    pieces[i].PointIds = ids[i].data();
  }
  Reducer alone;
  const std::vector<PieceLinks> links = LinkPieces(pieces, alone);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EvaluationOptions options;
    options.Links = &links[i];
    double count = 0;
    EXPECT_TRUE(Evaluate(*topologies[i], options, { { FindCriterion("MaxFaceCellCount"), &count } },
      [](double) { return true; }));
    EXPECT_EQ(count, 2);
  }
}

//------------------------------------------------------------------------------
// Edges and faces with too few different points connect nothing, in one piece and in two, and a
// face with a repeated point is that without.
TEST(CriteriaConnectivity, CollapsedFacetsBetweenPieces)
{
  const Points points = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 },
    { 2, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } };
  const Grid flat = MakeGrid(points,
    { { VTK_QUAD, { 0, 2, 3, 1 } }, { VTK_QUAD, { 2, 4, 5, 3 } }, { VTK_QUAD, { 2, 3, 2, 3 } },
      { VTK_TRIANGLE, { 3, 5, 5 } }, { VTK_QUAD, { 0, 2, 2, 6 } }, { VTK_TRIANGLE, { 0, 2, 6 } } });
  // A wedge as a collapsed hexahedron, twice, and a tetrahedron at one of its triangles.
  const Grid solid = MakeGrid(points,
    { { VTK_HEXAHEDRON, { 0, 2, 4, 4, 6, 8, 5, 5 } },
      { VTK_HEXAHEDRON, { 0, 2, 4, 4, 6, 8, 5, 5 } },
      { VTK_HEXAHEDRON, { 0, 2, 2, 0, 1, 3, 3, 1 } }, { VTK_TETRA, { 0, 2, 4, 3 } } });
  const char* const names[] = { "MaxFaceCellCount", "RegionId", "DuplicateCell", "IsBoundary" };
  for (const Grid& whole : { flat, solid })
  {
    const Values expected = EvaluateAll(whole);
    const vtkIdType size = whole->GetNumberOfCells();
    for (int split = 1; split < 1 << size; ++split)
    {
      std::vector<Cells> cells(2);
      std::vector<vtkNew<vtkIdTypeArray>> ids(2);
      for (vtkIdType cell = 0; cell < size; ++cell)
      {
        vtkIdList* const corners = whole->GetCell(cell)->GetPointIds();
        cells[split >> cell & 1].push_back(
          { whole->GetCellType(cell), { corners->begin(), corners->end() } });
        ids[split >> cell & 1]->InsertNextValue(cell);
      }
      std::vector<Grid> grids;
      std::vector<std::unique_ptr<MeshTopology>> topologies;
      std::vector<LinkedPiece> pieces(2);
      CellMarks all, marks;
      for (std::size_t i = 0; i < 2; ++i)
      {
        grids.push_back(MakeGrid(points, cells[i]));
        topologies.push_back(std::make_unique<MeshTopology>(grids[i]));
        pieces[i].Topology = topologies[i].get();
        pieces[i].CellIds = ids[i]->GetPointer(0);
        pieces[i].Options.GlobalIds = ids[i];
        all.emplace_back(cells[i].size(), 1);
        marks.emplace_back(cells[i].size(), 0);
      }
      Reducer alone;
      const std::vector<PieceLinks> links = LinkPieces(pieces, alone);
      for (std::size_t i = 0; i < 2; ++i)
      {
        pieces[i].Options.Links = &links[i];
      }
      const std::vector<MeshRegions> regions = FindMeshRegions(pieces, alone);
      marks[split & 1][0] = 1;
      Grow(pieces, {}, static_cast<int>(size), all, alone, marks);
      for (std::size_t i = 0; i < 2; ++i)
      {
        pieces[i].Options.Regions = &regions[i];
        std::vector<double> values(cells[i].size());
        for (const char* name : names)
        {
          Evaluate(*topologies[i], pieces[i].Options, { { FindCriterion(name), values.data() } },
            [](double) { return true; });
          for (std::size_t cell = 0; cell < values.size(); ++cell)
          {
            const vtkIdType id = ids[i]->GetValue(static_cast<vtkIdType>(cell));
            EXPECT_EQ(values[cell], expected.at(name)[id]) << name << " of " << id << ", " << split;
            EXPECT_EQ(marks[i][cell] != 0, expected.at("RegionId")[id] == 0) << id << ", " << split;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// Polygons at the boundary of a solid do not pinch it, nor it them.
TEST(CriteriaConnectivity, SolidWithItsBoundary)
{
  const Grid cubes = MakeCubes(2, { { 0, 0, 0 }, { 1, 0, 0 } }, false);
  Cells cells;
  for (vtkIdType cell = 0; cell < 2; ++cell)
  {
    vtkNew<vtkIdList> ids;
    cubes->GetCellPoints(cell, ids);
    cells.push_back({ VTK_HEXAHEDRON, { ids->begin(), ids->end() } });
    cells.push_back({ VTK_QUAD, { ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) } });
  }
  const Grid both = MakeGrid({}, cells);
  both->SetPoints(cubes->GetPoints());
  EXPECT_EQ(EvaluateAll(both).at("PointRegionCount"), std::vector<double>(4, 1));
}

//------------------------------------------------------------------------------
// A cell that lies upon another one is seen in both, and in the neighbor of both.
TEST(CriteriaConnectivity, CellsAtAFace)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid cubes = MakeCubes(
      4, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 0, 0 }, { 3, 3, 3 } }, asPolyhedra);
    EXPECT_EQ(EvaluateAll(cubes).at("MaxFaceCellCount"), std::vector<double>({ 3, 3, 2, 3, 1 }));
  }
  // Three squares with an edge in common, and a line.
  const Grid fan = MakeGrid({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 1, 0 },
                              { 0, 1, 1 }, { -1, 0, 0 }, { -1, 0, 1 } },
    { { VTK_QUAD, { 0, 1, 3, 2 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 0, 1, 7, 6 } },
      { VTK_TRIANGLE, { 2, 3, 5 } }, { VTK_LINE, { 0, 1 } } });
  const auto counts = EvaluateAll(fan).at("MaxFaceCellCount");
  EXPECT_EQ(
    std::vector<double>(counts.begin(), counts.end() - 1), std::vector<double>({ 3, 3, 3, 2 }));
  EXPECT_EQ(GetNullReason(counts[4]), NullReason::NotApplicable);
}

//------------------------------------------------------------------------------
// The mesh is connected over faces, but not over an edge or a point only.
TEST(CriteriaConnectivity, Regions)
{
  for (const bool asPolyhedra : { false, true })
  {
    // Two cubes side by side, one over an edge, one over a point of that one, one beside the first.
    const Values values = EvaluateAll(MakeCubes(3,
      { { { 0, 0, 0 } }, { { 1, 1, 0 } }, { { 2, 2, 1 } }, { { 0, 0, 1 } }, { { 2, 1, 0 } } },
      asPolyhedra));
    EXPECT_EQ(values.at("RegionId"), (std::vector<double>{ 0, 1, 2, 0, 1 }));
    EXPECT_EQ(values.at("PointRegionCount"), std::vector<double>(5, 2));
  }
}

//------------------------------------------------------------------------------
// The same for pieces of a cube or two each, which know of each other by the places of their points
// only.
TEST(CriteriaConnectivity, PinchedBetweenPieces)
{
  using Places = std::vector<std::array<int, 3>>;
  const auto count = [](const std::vector<Places>& parts)
  {
    std::vector<Grid> grids;
    std::vector<std::unique_ptr<MeshTopology>> topologies;
    std::vector<LinkedPiece> pieces;
    for (const Places& places : parts)
    {
      grids.push_back(MakeCubes(2, places, pieces.size() % 2 == 1));
      topologies.push_back(std::make_unique<MeshTopology>(grids.back()));
      pieces.emplace_back();
      pieces.back().Data = grids.back();
      pieces.back().Topology = topologies.back().get();
    }
    Reducer alone;
    std::vector<std::vector<int>> points; // of every piece how many points have 1, 2, 3, 4 groups
    for (const PointRegions& regions : FindPointRegions(pieces, alone))
    {
      points.push_back({ 0, 0, 0, 0 });
      for (const Index groups : regions.Counts)
      {
        EXPECT_LE(groups, 4);
        if (groups > 0)
        {
          ++points.back()[groups - 1];
        }
      }
    }
    return points;
  };
  using Counts = std::vector<std::vector<int>>;
  const auto expect = [&](const std::vector<Places>& parts, const Counts& expected)
  { EXPECT_EQ(count(parts), expected); };
  expect({ { { { 0, 0, 0 } } }, { { { 1, 0, 0 } } } }, { { 8, 0, 0, 0 }, { 8, 0, 0, 0 } });
  expect({ { { { 0, 0, 0 } } }, { { { 1, 1, 0 } } } }, { { 6, 2, 0, 0 }, { 6, 2, 0, 0 } });
  expect({ { { { 0, 0, 0 } } }, { { { 1, 1, 1 } } } }, { { 7, 1, 0, 0 }, { 7, 1, 0, 0 } });
  // The second and the third piece share a face, so that there are two groups at the first one.
  expect({ { { { 0, 0, 0 } } }, { { { 1, 1, 0 } } }, { { { 1, 1, 1 } } } },
    { { 6, 2, 0, 0 }, { 6, 2, 0, 0 }, { 7, 1, 0, 0 } });
  // Alternate cubes meet in edges, and all four in the middle.
  expect({ { { { 0, 0, 0 } } }, { { { 1, 1, 0 } }, { { 1, 0, 1 } } }, { { { 0, 1, 1 } } } },
    { { 4, 3, 0, 1 }, { 8, 5, 0, 1 }, { 4, 3, 0, 1 } });
}

//------------------------------------------------------------------------------
// Polygons are connected over edges; a point can be pinched although there is a way around.
TEST(CriteriaConnectivity, PinchedWithinARegion)
{
  Values values = EvaluateAll(MakeSquares(4,
    { { { 1, 1 } }, { { 1, 0 } }, { { 2, 0 } }, { { 3, 0 } }, { { 3, 1 } }, { { 3, 2 } },
      { { 2, 2 } } }));
  EXPECT_EQ(values["RegionId"], std::vector<double>(7, 0));
  EXPECT_EQ(values["PointRegionCount"], (std::vector<double>{ 2, 1, 1, 1, 1, 1, 2 }));
  values = EvaluateAll(MakeSquares(2, { { { 0, 0 } }, { { 1, 1 } }, { { 1, 0 } } }));
  EXPECT_EQ(values["RegionId"], std::vector<double>(3, 0));
  EXPECT_EQ(values["PointRegionCount"], std::vector<double>(3, 1));
}

//------------------------------------------------------------------------------
// A shell on a solid is a region of its own; points and lines are none.
TEST(CriteriaConnectivity, MixedDimensions)
{
  const Values values = EvaluateAll(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_LINE, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TETRA, { 0, 1, 2, 3 } } }));
  for (const char* name : { "RegionId", "PointRegionCount", "DuplicateCell", "IsBoundary" })
  {
    EXPECT_EQ(GetNullReason(values.at(name)[0]), NullReason::NotApplicable) << name;
  }
  EXPECT_EQ(values.at("RegionId")[1], 0);
  EXPECT_EQ(values.at("RegionId")[2], 1);
}

//------------------------------------------------------------------------------
// The same points in another order or as another type are the same cell; a flat cell of the same
// points and cells that share all points but one are not.
TEST(CriteriaConnectivity, Duplicates)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 1 }, { 0, 0, 2 } };
  const Grid grid = MakeGrid(points,
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } },
      { VTK_TETRA, { 3, 1, 0, 2 } }, { VTK_POLYGON, { 3, 2, 1, 0 } },
      { VTK_TETRA, { 2, 1, 0, 3 } } });
  EXPECT_EQ(EvaluateAll(grid).at("DuplicateCell"), (std::vector<double>{ 0, 1, -1, 1, 0, 1 }));

  vtkNew<vtkIdTypeArray> ids;
  for (const vtkIdType id : { 70, 60, 50, 40, 30, 80 })
  {
    ids->InsertNextValue(id);
  }
  EvaluationOptions options;
  options.GlobalIds = ids;
  EXPECT_EQ(EvaluateAll(grid, options).at("DuplicateCell"),
    (std::vector<double>{ 30, 40, -1, 40, 30, 40 }));

  // As many copies as there are cells must not take all day.
  const std::size_t many = 300000;
  const Grid copies = MakeGrid(points, Cells(many, { VTK_TETRA, { 0, 1, 2, 3 } }));
  std::vector<double> values(many);
  Evaluate(MeshTopology(copies), {}, { { FindCriterion("DuplicateCell"), values.data() } },
    [](double) { return true; });
  EXPECT_EQ(values, std::vector<double>(many, 0));
}

//------------------------------------------------------------------------------
// Every cell of a block of cubes but the innermost; what lies beyond a ghost or a piece is not
// known.
TEST(CriteriaConnectivity, Boundary)
{
  const Grid block = MakeHexahedra(3, 3, 3, false);
  std::vector<double> expected(27, 1);
  expected[13] = 0;
  EXPECT_EQ(EvaluateAll(block).at("IsBoundary"), expected);
  std::vector<unsigned char> ghosts(27, 0);
  ghosts[0] = 1;
  EvaluationOptions options;
  options.Ghosts = ghosts.data();
  EXPECT_EQ(
    GetNullReason(EvaluateAll(block, options).at("IsBoundary")[0]), NullReason::MissingGhosts);
  EXPECT_EQ(EvaluateAll(block, options).at("IsBoundary")[1], 1);
  options = EvaluationOptions();
  options.IsPieceWithoutGhosts = true;
  const Values values = EvaluateAll(block, options);
  EXPECT_EQ(GetNullReason(values.at("IsBoundary")[1]), NullReason::MissingGhosts);
  EXPECT_EQ(values.at("IsBoundary")[13], 0);
}
