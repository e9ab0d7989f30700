// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Vector.h"
#include "Drawing/CellTetrahedra.h"
#include "Drawing/DrawableFaces.h"
#include "Drawing/PolygonTriangles.h"
#include "Mesh/MeshTopology.h"
#include "TestMeshes.h"

#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExtractCells.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMassProperties.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
DrawableFaces Make(
  vtkUnstructuredGrid* grid, FacesToDraw which, const std::vector<unsigned char>& ghosts = {})
{
  const MeshTopology topology(grid);
  CellsToDraw cells;
  cells.Ghosts = ghosts.empty() ? nullptr : ghosts.data();
  return MakeDrawableFaces(topology, cells, which);
}

Vector GetPoint(vtkUnstructuredGrid* grid, vtkIdType id)
{
  double x[3];
  grid->GetPoint(id, x);
  return { x[0], x[1], x[2] };
}

// Six times the volume that triangles enclose, each oriented for the cell that is seen.
template <typename IsSeen>
double GetVolume(vtkUnstructuredGrid* grid, const DrawableFaces& faces, IsSeen&& isSeen)
{
  double volume = 0;
  for (const auto& triangle : faces.Triangles)
  {
    const auto& cells = faces.Faces[triangle[3] >> DrawableFaces::EdgeBits];
    const double part = Dot(
      GetPoint(grid, triangle[0]), Cross(GetPoint(grid, triangle[1]), GetPoint(grid, triangle[2])));
    volume += isSeen(cells[0]) ? part : 0;
    volume -= cells[1] != DrawableFaces::NoCell && isSeen(cells[1]) ? part : 0;
  }
  return volume / 6;
}
}

//------------------------------------------------------------------------------
// Outer faces first, all of them with one cell; what Outer makes is the beginning of what All
// makes.
TEST(DrawableFaces, OfHexahedra)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(3, 4, 5, asPolyhedra);
    const DrawableFaces all = Make(grid, FacesToDraw::All);
    const DrawableFaces outer = Make(grid, FacesToDraw::Outer);
    const std::size_t outside = 2 * (3 * 4 + 4 * 5 + 5 * 3);
    const std::size_t inside = 2 * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4;
    EXPECT_EQ(outer.Faces.size(), outside);
    EXPECT_EQ(all.Faces.size(), outside + inside);
    EXPECT_EQ(all.Triangles.size(), 2 * (outside + inside));
    EXPECT_EQ(outer.Triangles.size(), 2 * outside);
    EXPECT_EQ(all.NumberOfOuterTriangles, 2 * outside);
    EXPECT_TRUE(std::equal(outer.Triangles.begin(), outer.Triangles.end(), all.Triangles.begin()));
    EXPECT_TRUE(std::equal(outer.Faces.begin(), outer.Faces.end(), all.Faces.begin()));
    for (std::size_t face = 0; face < all.Faces.size(); ++face)
    {
      EXPECT_EQ(all.Faces[face][1] == DrawableFaces::NoCell, face < outside) << face;
    }
  }
}

//------------------------------------------------------------------------------
// Seen from either cell, faces run outward: the volumes of cells and of their sum come out right.
TEST(DrawableFaces, RunAroundTheirCells)
{
  const Grid grid = MakeHexahedra(2, 2, 2, true);
  const DrawableFaces faces = Make(grid, FacesToDraw::All);
  for (std::uint32_t cell = 0; cell < 8; ++cell)
  {
    // MakeHexahedra's cells need not have the same size, but none is inverted.
    EXPECT_GT(GetVolume(grid, faces, [&](std::uint32_t seen) { return seen == cell; }), 0) << cell;
  }
  double sum = 0;
  for (std::uint32_t cell = 0; cell < 8; ++cell)
  {
    sum += GetVolume(grid, faces, [&](std::uint32_t seen) { return seen == cell; });
  }
  EXPECT_NEAR(sum, GetVolume(grid, faces, [](std::uint32_t) { return true; }), 1e-12);
}

//------------------------------------------------------------------------------
// The edges that the bits name are those of the polygon, each once; diagonals are none.
TEST(DrawableFaces, EdgesArePolygonEdges)
{
  const Grid grid = MakeHexagonalPrisms(1);
  const DrawableFaces faces = Make(grid, FacesToDraw::All);
  std::vector<std::multiset<std::pair<vtkIdType, vtkIdType>>> edges(faces.Faces.size());
  for (const auto& triangle : faces.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (triangle[3] >> i & 1)
      {
        edges[triangle[3] >> DrawableFaces::EdgeBits].insert(
          std::minmax<vtkIdType>(triangle[i], triangle[(i + 1) % 3]));
      }
    }
  }
  std::multiset<std::size_t> sizes;
  for (const auto& ofFace : edges)
  {
    sizes.insert(ofFace.size());
    EXPECT_EQ(std::set(ofFace.begin(), ofFace.end()).size(), ofFace.size());
  }
  EXPECT_EQ(sizes.count(6), 2u);
  EXPECT_EQ(sizes.count(4), 6u);
}

//------------------------------------------------------------------------------
// Faces between two ghosts are of no use here; those of hidden cells are gone, and open their
// neighbors.
TEST(DrawableFaces, GhostAndHiddenCells)
{
  const Grid grid = MakeHexahedra(3, 1, 1, false);
  constexpr unsigned char ghost = vtkDataSetAttributes::DUPLICATECELL;
  constexpr unsigned char hidden = vtkDataSetAttributes::HIDDENCELL;
  EXPECT_EQ(Make(grid, FacesToDraw::All, { 0, ghost, ghost }).Faces.size(), 5u + 1u);
  EXPECT_EQ(Make(grid, FacesToDraw::Outer, { 0, ghost, ghost }).Faces.size(), 5u);
  EXPECT_EQ(Make(grid, FacesToDraw::All, { 0, hidden, 0 }).Faces.size(), 12u);
  EXPECT_EQ(Make(grid, FacesToDraw::Outer, { hidden, 0, 0 }).Faces.size(), 10u);
  EXPECT_EQ(Make(grid, FacesToDraw::All, { hidden, hidden, hidden }).Faces.size(), 0u);
}

//------------------------------------------------------------------------------
// Half of a mesh still knows which faces were inside: they are no part of the outside.
TEST(DrawableFaces, HalfOfAMesh)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid whole = MakeHexahedra(2, 3, 1, asPolyhedra);
    const MeshTopology topology(whole);
    const std::vector<std::uint64_t> outer = FindOuterFacets(topology, nullptr);
    int count = 0;
    for (const std::uint64_t bits : outer)
    {
      count += static_cast<int>(std::bitset<64>(bits).count());
    }
    EXPECT_EQ(count, 2 * (2 * 3 + 3 * 1 + 2 * 1));
    const double middle = 0.5 * (whole->GetBounds()[0] + whole->GetBounds()[1]) + 0.1;
    std::map<std::set<vtkIdType>, std::vector<std::uint32_t>>
      shared; // by its points in the whole mesh
    for (const bool isLeft : { false, true })
    {
      vtkNew<vtkIdList> half;
      std::vector<std::uint64_t> outerOfHalf;
      for (vtkIdType cell = 0; cell < 6; ++cell)
      {
        if ((whole->GetCell(cell)->GetBounds()[1] < middle) == isLeft)
        {
          half->InsertNextId(cell);
          outerOfHalf.push_back(outer[cell]);
        }
      }
      ASSERT_EQ(half->GetNumberOfIds(), 3);
      vtkNew<vtkExtractCells> extract;
      extract->SetInputData(whole);
      extract->SetCellList(half);
      extract->Update();
      const MeshTopology part(extract->GetOutput());
      CellsToDraw cells;
      cells.OuterFacets = outerOfHalf.data();
      const DrawableFaces faces = MakeDrawableFaces(part, cells, FacesToDraw::All);
      EXPECT_EQ(faces.NumberOfOuterTriangles, 2u * (2 * 3 * 1 + 2 * 1 + 3 * 1));
      std::map<std::size_t, std::set<vtkIdType>> points;
      for (const auto& triangle : faces.Triangles)
      {
        for (int i = 0; i < 3; ++i)
        {
          points[triangle[3] >> DrawableFaces::EdgeBits].insert(
            whole->FindPoint(extract->GetOutput()->GetPoint(triangle[i])));
        }
      }
      for (std::size_t face = 0; face < faces.Faces.size(); ++face)
      {
        if (faces.Faces[face][1] == DrawableFaces::CellElsewhere ||
          faces.Faces[face][1] == DrawableFaces::FirstCellElsewhere)
        {
          shared[points[face]].push_back(faces.Faces[face][1]);
        }
      }
    }
    // Each of the two halves has them, and for one of them its own cell comes first.
    EXPECT_EQ(shared.size(), 3u);
    for (const auto& [points, others] : shared)
    {
      ASSERT_EQ(others.size(), 2u);
      EXPECT_NE(others[0], others[1]);
    }
  }
}

//------------------------------------------------------------------------------
// A face of three cells is there for each of them.
TEST(DrawableFaces, NonManifold)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 2 },
    { 0, 0, -1 } };
  const Grid grid = MakeGrid(points,
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } },
      { VTK_TETRA, { 0, 2, 1, 5 } } });
  const DrawableFaces faces = Make(grid, FacesToDraw::All);
  EXPECT_EQ(faces.Faces.size(), 9u + 2u);
  EXPECT_EQ(faces.NumberOfOuterTriangles, 9u);
  std::multiset<std::uint32_t> cells;
  for (const std::size_t face : { 9, 10 })
  {
    cells.insert(faces.Faces[face].begin(), faces.Faces[face].end());
  }
  EXPECT_EQ(cells, (std::multiset<std::uint32_t>{ 0, 0, 1, 2 }));
}

//------------------------------------------------------------------------------
// A curved cell whose nodes are those of VTK's own cell, bent.
Grid MakeCurvedCell(int cellType)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(cellType);
  const double* nodes = cell->GetParametricCoords();
  Points points;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    const double x = nodes[3 * i], y = nodes[3 * i + 1], z = nodes[3 * i + 2];
    points.push_back({ x + 0.15 * y * y, y - 0.1 * z * z, z + 0.2 * x * x });
    ids.push_back(i);
  }
  return MakeGrid(points, { { cellType, ids } });
}

//------------------------------------------------------------------------------
// Triangles go through the nodes on edges and close around the cell, and its tetrahedra fill just
// what they enclose.
TEST(DrawableFaces, OfCurvedCells)
{
  for (const int cellType : { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
         VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON,
         VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_TRIQUADRATIC_PYRAMID })
  {
    SCOPED_TRACE(cellType);
    const Grid grid = MakeCurvedCell(cellType);
    vtkCell* cell = grid->GetCell(0);
    const int numberOfEdges = cell->GetNumberOfEdges();
    const DrawableFaces faces = Make(grid, FacesToDraw::All);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& triangle : faces.Triangles)
    {
      for (int i = 0; i < 3; ++i)
      {
        if (triangle[3] >> i & 1)
        {
          edges.insert(std::minmax(triangle[i], triangle[(i + 1) % 3]));
        }
      }
    }
    EXPECT_EQ(edges.size(), 2u * numberOfEdges);
    const double volume = GetVolume(grid, faces, [](std::uint32_t) { return true; });
    double filled = 0;
    const CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(grid));
    for (const auto& points : tetrahedra.Points)
    {
      const Vector apex = GetPoint(grid, points[0]);
      filled += Dot(GetPoint(grid, points[1]) - apex,
                  Cross(GetPoint(grid, points[2]) - apex, GetPoint(grid, points[3]) - apex)) /
        6;
    }
    EXPECT_GT(volume, 0.05);
    EXPECT_NEAR(filled, volume,
      cellType == VTK_QUADRATIC_TETRA ? 1e-12 : 0.02); // quads may be cut either way
  }
}

//------------------------------------------------------------------------------
// VTK cuts a quadratic triangle in the same four.
TEST(DrawableFaces, OfQuadraticTetrahedronAsVTK)
{
  const Grid grid = MakeCurvedCell(VTK_QUADRATIC_TETRA);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->SetNonlinearSubdivisionLevel(1);
  vtkNew<vtkMassProperties> properties;
  properties->SetInputConnection(surface->GetOutputPort());
  const double volume =
    GetVolume(grid, Make(grid, FacesToDraw::All), [](std::uint32_t) { return true; });
  EXPECT_NEAR(volume, properties->GetVolumeProjected(), 1e-7); // of single precision
}

//------------------------------------------------------------------------------
// If this fails, strips are drawn as the polygon around them, which is another shape where they
// bend.
TEST(DrawableFaces, OfStrips)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 5 }, { 2, 0, 0 }, { 2, 1, 0 } },
      { { VTK_TRIANGLE_STRIP, { 0, 1, 2, 3, 4, 5 } } });
  const DrawableFaces faces = Make(grid, FacesToDraw::Outer);
  ASSERT_EQ(faces.Triangles.size(), 4u);
  const std::uint32_t expected[4][3] = { { 0, 1, 2 }, { 2, 1, 3 }, { 2, 3, 4 }, { 4, 3, 5 } };
  for (int t = 0; t < 4; ++t)
  {
    EXPECT_TRUE(std::equal(expected[t], expected[t] + 3, faces.Triangles[t].begin())) << t;
    EXPECT_EQ(faces.Triangles[t][3], 7u) << "all edges are drawn, and the face is the first";
  }
}

//------------------------------------------------------------------------------
// An L: a fan from its first corner would leave it. The triangles cover its area, once.
TEST(PolygonTriangles, OfConcavePolygon)
{
  const Points corners = { { 0, 0, 1 }, { 2, 0, 1 }, { 2, 1, 1 }, { 1, 1, 1 }, { 1, 2, 1 },
    { 0, 2, 1 } };
  for (int start = 0; start < 6; ++start)
  {
    std::vector<vtkIdType> polygon(6);
    for (int i = 0; i < 6; ++i)
    {
      polygon[i] = (start + i) % 6;
    }
    const Grid grid = MakeGrid(corners, { { VTK_POLYGON, polygon } });
    const MeshView mesh(grid);
    PolygonTriangles triangles(mesh);
    double area = 0;
    int count = 0, edges = 0;
    triangles.ForEach({ polygon.data(), 6, PolygonTriangles::Form::Straight },
      [&](const PolygonTriangles::Triangle& triangle)
      {
        const auto point = [&](int i) { return GetPoint(grid, polygon[triangle.Corners[i]]); };
        const Vector twice = Cross(point(1) - point(0), point(2) - point(0));
        EXPECT_GE(twice.Z, 0);
        area += 0.5 * twice.Z;
        ++count;
        for (int i = 0; i < 3; ++i)
        {
          edges += triangle.Edges >> i & 1;
        }
      });
    EXPECT_EQ(count, 4);
    EXPECT_EQ(edges, 6);
    EXPECT_DOUBLE_EQ(area, 3);
  }
}
