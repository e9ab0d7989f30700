// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces, edges and neighbors: everything that counts, borders or walks over cells stands on them.
#include "Geometry/FacetRing.h"
#include "Mesh/MeshTopology.h"

#include "TestMeshes.h"

#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
int CountBoundary(const FacetTable& table)
{
  int boundary = 0;
  for (Index f = 0; f < table.GetNumberOfFacets(); ++f)
  {
    boundary += table.IsBoundary(f);
  }
  return boundary;
}
}

// Counts of selection-and-statistics case G1: 36 faces, 24 on the boundary, 54 edges, 27 points.
TEST(MeshTopology, CountsOfEightHexahedra)
{
  for (const bool asPolyhedra : { false, true })
  {
    const auto grid = MakeHexahedra(2, 2, 2, asPolyhedra);
    const MeshTopology topology(grid);
    EXPECT_EQ(topology.GetFaces().GetNumberOfFacets(), 36);
    EXPECT_EQ(CountBoundary(topology.GetFaces()), 24);
    EXPECT_EQ(topology.GetEdges().size(), 54u);
    EXPECT_EQ(topology.GetPointCells().Offsets.size(), 28u);
    EXPECT_EQ(topology.GetPointCells().Cells.size(), 64u);
    EXPECT_EQ(topology.GetSurfaceEdges().GetNumberOfFacets(), 0);
  }
}

// Owner first, numbered by owner and local face; the second cell runs against the owner.
TEST(MeshTopology, NumberingAndDirection)
{
  const auto grid = MakeHexahedra(2, 1, 1, false);
  const FacetTable& faces = MeshTopology(grid).GetFaces();
  ASSERT_EQ(faces.GetNumberOfFacets(), 11);
  Index next = 0;
  for (int cell = 0; cell < 2; ++cell)
  {
    ASSERT_EQ(faces.GetCellFacets(cell).size(), 6);
    for (const CellFacet facet : faces.GetCellFacets(cell))
    {
      const auto cells = faces.GetCells(facet.Facet());
      EXPECT_EQ(facet.IsReversed(), cells.First != cell);
      if (cells.First == cell)
      {
        EXPECT_EQ(facet.Facet(), next++);
      }
    }
  }
}

// A face keeps the ring of points its owner gives it, outward.
TEST(MeshTopology, FacePoints)
{
  const auto grid = MakeStandardCell(VTK_TETRA);
  const MeshTopology topology(grid);
  std::vector<vtkIdType> points;
  topology.GetFacePoints(3, points);
  EXPECT_EQ(points, (std::vector<vtkIdType>{ 0, 2, 1 }));
}

// Every standard type has closed faces, and the same ones as when it is written as a polyhedron.
TEST(MeshTopology, StandardTypesEqualPolyhedra)
{
  for (const int type : StandardTypes3D)
  {
    const auto grid = MakeStandardCell(type);
    const auto polyhedron = ToPolyhedra(grid);
    const MeshTopology a(grid), b(polyhedron);
    EXPECT_EQ(a.GetFaces().GetNumberOfFacets(), b.GetFaces().GetNumberOfFacets()) << type;
    EXPECT_EQ(a.GetEdges(), b.GetEdges()) << type;
    // Euler: V - E + F = 2.
    EXPECT_EQ(grid->GetNumberOfPoints() - static_cast<vtkIdType>(a.GetEdges().size()) +
        a.GetFaces().GetNumberOfFacets(),
      2)
      << type;
  }
}

// Three tetrahedra on one triangle: the face is kept with all of its cells.
TEST(MeshTopology, NonManifoldFace)
{
  const auto grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 1, 1, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } },
        { VTK_TETRA, { 0, 1, 2, 5 } } });
  const FacetTable& faces = MeshTopology(grid).GetFaces();
  EXPECT_EQ(faces.GetNumberOfFacets(), 10);
  const Index shared = faces.GetCellFacets(0)[3].Facet();
  EXPECT_EQ(faces.GetNumberOfCells(shared), 3);
  std::vector<Index> cells;
  faces.GetCells(shared, cells);
  EXPECT_EQ(cells, (std::vector<Index>{ 0, 1, 2 }));
}

// A boundary triangle lying on a tetrahedron is an element of its own, not a second cell of the
// face.
TEST(MeshTopology, MixedDimensions)
{
  const auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 2, 1 } }, { VTK_LINE, { 0, 1 } },
      { VTK_VERTEX, { 3 } } });
  const MeshTopology topology(grid);
  EXPECT_EQ(topology.GetFaces().GetNumberOfFacets(), 4);
  EXPECT_EQ(CountBoundary(topology.GetFaces()), 4);
  EXPECT_EQ(topology.GetFaces().GetCellFacets(1).size(), 0);
  EXPECT_EQ(topology.GetSurfaceEdges().GetNumberOfFacets(), 3);
  EXPECT_EQ(topology.GetEdges().size(), 6u);
}

// Higher-order cells are known by their corners and so meet linear ones.
TEST(MeshTopology, HigherOrderByCorners)
{
  const auto grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .5, 0, 0 }, { .5, .5, 0 }, { 0, .5, 0 },
      { 0, 0, .5 }, { .5, 0, .5 }, { 0, .5, .5 }, { 0, 0, -1 } },
    { { VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } }, { VTK_TETRA, { 0, 2, 1, 10 } } });
  EXPECT_EQ(MeshTopology(grid).GetFaces().GetNumberOfFacets(), 7);
}

// A strip is one cell bounded by its outline; a polygon beside it shares one edge.
TEST(MeshTopology, TriangleStrips)
{
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i / 2, i % 2, 0);
  }
  points->InsertNextPoint(0, -1, 0);
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polys, strips;
  polys->InsertNextCell({ 0, 6, 2 });
  strips->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  surface->SetPolys(polys);
  surface->SetStrips(strips);
  const FacetTable& edges = MeshTopology(surface).GetSurfaceEdges();
  EXPECT_EQ(edges.GetNumberOfFacets(), 3 + 6 - 1);
  EXPECT_EQ(edges.GetCellFacets(1).size(), 6);
}

// Large faces are matched by hash: any rotation and direction of a ring is the same face.
TEST(MeshTopology, LargeFaces)
{
  const auto grid = MakeHexagonalPrisms(4);
  const auto polyhedra = ToPolyhedra(grid);
  EXPECT_EQ(MeshTopology(polyhedra).GetFaces().GetNumberOfFacets(), 4 * 8 - 3);
  EXPECT_EQ(CountBoundary(MeshTopology(polyhedra).GetFaces()), 4 * 8 - 6);
}

// The same face is a set of points, whether listed along a ring, with a point twice or in another
// order.
TEST(MeshTopology, LargeFacesAreSets)
{
  Points points;
  for (int i = 0; i < 14; ++i)
  {
    points.push_back({ 1. * i, 1. * i * i, 1. * i * i * i });
  }
  const std::vector<std::vector<vtkIdType>> bases = { { 0, 1, 2, 3, 4 }, { 2, 1, 0, 4, 3 },
    { 3, 4, 0, 1, 2 }, { 0, 1, 1, 2, 3, 4 }, { 0, 2, 4, 1, 3 }, { 4, 0, 2, 1, 3 },
    { 0, 1, 2, 3, 13 } };
  std::vector<Faces> cells;
  for (std::size_t c = 0; c < bases.size(); ++c)
  {
    const auto apex = static_cast<vtkIdType>(5 + c);
    cells.push_back({ bases[c] });
    for (vtkIdType i = 0; i < 4; ++i)
    {
      cells.back().push_back({ i, i + 1, apex });
    }
  }
  const auto grid = MakePolyhedra(MakePoints(points), cells);
  const FacetTable& faces = MeshTopology(grid).GetFaces();
  EXPECT_EQ(faces.GetNumberOfFacets(), 4 * 7 + 2);
  std::vector<Index> sharing;
  faces.GetCells(faces.GetCellFacets(5)[0].Facet(), sharing);
  EXPECT_EQ(sharing, (std::vector<Index>{ 0, 1, 2, 3, 4, 5 }));
}

// More faces than are compared at once, numbered at random, many with more than two cells: as found
// one by one.
static void ExpectFacesOfTangle(bool onlyTetrahedra, bool repeatPoints)
{
  constexpr vtkIdType numberOfPoints = 3000, numberOfCells = 9000, window = 16;
  std::mt19937 random(1);
  const auto draw = [&random](vtkIdType end) { return static_cast<vtkIdType>(random() % end); };
  Cells cells;
  for (vtkIdType c = 0; c < numberOfCells; ++c)
  {
    const bool isHexahedron = !onlyTetrahedra && draw(2) != 0;
    const vtkIdType first = window * draw(numberOfPoints / window);
    std::set<vtkIdType> chosen;
    while (chosen.size() < (isHexahedron ? 8 : 4))
    {
      chosen.insert(first + draw(window));
    }
    std::vector<vtkIdType> nodes(chosen.begin(), chosen.end());
    for (std::size_t i = nodes.size() - 1; i > 0; --i)
    {
      std::swap(nodes[i], nodes[draw(static_cast<vtkIdType>(i + 1))]);
    }
    if (repeatPoints && draw(100) == 0)
    {
      nodes[0] = nodes[1];
    }
    cells.push_back({ isHexahedron ? VTK_HEXAHEDRON : VTK_TETRA, nodes });
  }
  const auto grid = MakeGrid(Points(numberOfPoints), cells);
  const FacetTable& table = MeshTopology(grid).GetFaces();

  struct Found
  {
    Index Number;
    std::vector<Index> Cells;
    std::vector<vtkIdType> Ring;
  };
  const auto runsAlong = [](const std::vector<vtkIdType>& ring, vtkIdType from, vtkIdType to)
  {
    const auto place = std::find(ring.begin(), ring.end(), from) - ring.begin();
    return ring[(place + 1) % ring.size()] == to;
  };
  std::map<std::set<vtkIdType>, Found> expected;
  Index numberOfCollapsed = 0;
  for (Index c = 0; c < numberOfCells; ++c)
  {
    const Faces faces = GetFaces(grid, c);
    const auto facets = table.GetCellFacets(c);
    ASSERT_EQ(facets.size(), static_cast<Index>(faces.size()));
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const CellFacet facet = facets[static_cast<Index>(f)];
      const std::set<vtkIdType> points(faces[f].begin(), faces[f].end());
      ASSERT_EQ(table.IsCollapsed(facet.Facet()), points.size() < 3);
      if (points.size() < 3)
      {
        ++numberOfCollapsed;
        ASSERT_EQ(table.GetNumberOfCells(facet.Facet()), 1);
        ASSERT_FALSE(table.IsBoundary(facet.Facet()));
        continue;
      }
      const Found next = { static_cast<Index>(expected.size()) + numberOfCollapsed, {}, faces[f] };
      Found& found = expected.insert({ points, next }).first->second;
      found.Cells.push_back(c);
      ASSERT_EQ(facet.Facet(), found.Number) << c << ' ' << f;
      if (points.size() == 3)
      {
        ASSERT_NE(facet.IsReversed(), runsAlong(faces[f], found.Ring[0], found.Ring[1]))
          << c << ' ' << f;
      }
    }
  }
  ASSERT_EQ(table.GetNumberOfFacets(), static_cast<Index>(expected.size()) + numberOfCollapsed);
  ASSERT_EQ(numberOfCollapsed > 0, repeatPoints);
  for (const auto& [points, found] : expected)
  {
    std::vector<Index> all;
    table.GetCells(found.Number, all);
    ASSERT_EQ(all, found.Cells);
  }
}

TEST(MeshTopology, TangleOfCells)
{
  ExpectFacesOfTangle(false, false);
}

// These have a way of their own, but not where a cell has a point twice.
TEST(MeshTopology, TangleOfTetrahedra)
{
  ExpectFacesOfTangle(true, false);
  ExpectFacesOfTangle(true, true);
}

// The same table for every number of threads, and when a reader hands its faces over.
TEST(MeshTopology, SameForAnyThreadsAndGivenFaces)
{
  const auto grid = MakeHexahedra(17, 13, 11, true);
  std::vector<CellFacet> reference;
  const auto all = [](const FacetTable& table)
  {
    return std::vector<CellFacet>(
      table.GetCellFacets(0).begin(), table.GetCellFacets(table.GetNumberOfCells() - 1).end());
  };
  const auto packed = [](const std::vector<CellFacet>& facets)
  {
    std::vector<Index> values;
    for (const CellFacet facet : facets)
    {
      values.push_back(facet.Packed);
    }
    return values;
  };
  for (const int threads : { 1, 2, 5 })
  {
    vtkNew<vtkUnstructuredGrid> copy;
    copy->DeepCopy(grid);
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        const auto facets = all(MeshTopology(copy).GetFaces());
        if (reference.empty())
        {
          reference = facets;
        }
        EXPECT_EQ(packed(facets), packed(reference)) << threads;
      });
  }
  // File numbers: shuffled, and one face under two numbers as in files that repeat inner faces.
  LargeVector<Index> given;
  const Index numberOfFaces = MeshTopology(grid).GetFaces().GetNumberOfFacets();
  std::set<Index> seen;
  for (const CellFacet facet : reference)
  {
    const bool second = !seen.insert(facet.Facet()).second;
    given.push_back(
      numberOfFaces - 1 - facet.Facet() + (second && facet.Facet() % 3 == 0 ? numberOfFaces : 0));
  }
  vtkNew<vtkUnstructuredGrid> copy;
  copy->DeepCopy(grid);
  MeshTopology::Provide(copy, std::move(given), 2 * numberOfFaces);
  EXPECT_EQ(packed(all(MeshTopology(copy).GetFaces())), packed(reference));
}

// Shallow copies share one build; a change of the connectivity makes a new one.
TEST(MeshTopology, SharedByConnectivity)
{
  const auto grid = MakeHexahedra(2, 2, 2, false);
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(grid);
  EXPECT_EQ(&MeshTopology(grid).GetFaces(), &MeshTopology(copy).GetFaces());
  const MeshTopology before(grid);
  grid->GetCells()->GetConnectivityArray()->Modified();
  EXPECT_NE(&before.GetFaces(), &MeshTopology(grid).GetFaces());
}

// Also of a ring that comes to its smallest point twice, wherever it begins.
TEST(MeshTopology, DirectionOfRings)
{
  for (const std::vector<vtkIdType>& ring : std::vector<std::vector<vtkIdType>>{ { 0, 1, 3, 0, 1 },
         { 5, 2, 7, 2, 9 }, { 1, 1, 2, 3 }, { 4, 8, 6, 7 }, { 0, 1, 5, 4, 4, 1 } })
  {
    const auto size = static_cast<vtkIdType>(ring.size());
    const bool down = RunsDown(ring.data(), size);
    for (vtkIdType start = 0; start < size; ++start)
    {
      std::vector<vtkIdType> turned(ring);
      std::rotate(turned.begin(), turned.begin() + start, turned.end());
      EXPECT_EQ(RunsDown(turned.data(), size), down) << start;
      std::reverse(turned.begin(), turned.end());
      EXPECT_NE(RunsDown(turned.data(), size), down) << start;
    }
  }
}

// Whatever its cells begin with, and where there are two ways to lay one ring over the other.
TEST(MeshTopology, DirectionOfFacesThatRepeatPoints)
{
  const Points points(16, Point{ 0, 0, 0 });
  for (const std::vector<vtkIdType>& ring :
    std::vector<std::vector<vtkIdType>>{ { 0, 1, 3, 0, 1 }, { 5, 2, 7, 2, 9 }, { 1, 1, 2, 3 },
      { 4, 8, 6, 7 }, { 0, 1, 5, 4, 4, 1 }, { 4, 0, 4, 5 }, { 0, 4, 5, 4 } })
  {
    std::vector<Faces> cells;
    for (std::size_t start = 0; start < ring.size(); ++start)
    {
      std::vector<vtkIdType> turned(ring);
      std::rotate(
        turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
      cells.push_back({ turned, { 10, 11, 12 } });
      std::reverse(turned.begin(), turned.end());
      cells.push_back({ turned, { 10, 11, 13 } });
    }
    const auto grid = MakePolyhedra(MakePoints(points), cells);
    const FacetTable& faces = MeshTopology(grid).GetFaces();
    const bool down = RunsDown(ring.data(), static_cast<vtkIdType>(ring.size()));
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
      const std::vector<vtkIdType>& own = cells[cell][0];
      const CellFacet facet = faces.GetCellFacets(static_cast<vtkIdType>(cell))[0];
      EXPECT_EQ(facet.Facet(), faces.GetCellFacets(0)[0].Facet());
      EXPECT_EQ(
        facet.IsReversed(), RunsDown(own.data(), static_cast<vtkIdType>(own.size())) != down);
    }
  }
}

// Cells that are added or changed in place leave the times of arrays as they were.
TEST(MeshTopology, ChangedInPlace)
{
  const auto grid = MakeHexahedra(2, 1, 1, false);
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(grid);
  EXPECT_EQ(MeshTopology(grid).GetFaces().GetNumberOfFacets(), 11);
  EXPECT_EQ(&MeshTopology(grid).GetFaces(), &MeshTopology(copy).GetFaces());
  const vtkIdType points[4] = { 0, 1, 3, 6 };
  grid->InsertNextCell(VTK_TETRA, 4, points);
  grid->Modified();
  EXPECT_EQ(MeshTopology(grid).GetFaces().GetNumberOfFacets(), 15);
  const vtkIdType others[8] = { 0, 1, 4, 3, 6, 7, 10, 9 };
  grid->GetCells()->ReplaceCellAtId(1, 8, others); // now the same as the first one
  grid->Modified();
  EXPECT_EQ(MeshTopology(grid).GetFaces().GetNumberOfFacets(), 6 + 4);
}

// Empty meshes and meshes of points only have empty tables.
TEST(MeshTopology, Empty)
{
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_EQ(MeshTopology(grid).GetFaces().GetNumberOfFacets(), 0);
  EXPECT_EQ(MeshTopology(grid).GetEdges().size(), 0u);
  const auto cloud = MakeGrid({ { 0, 0, 0 } }, { { VTK_VERTEX, { 0 } } });
  EXPECT_EQ(MeshTopology(cloud).GetFaces().GetNumberOfFacets(), 0);
  EXPECT_EQ(MeshTopology(cloud).GetPointCells().Cells.size(), 1u);
}
