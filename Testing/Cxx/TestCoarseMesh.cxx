// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Vector.h"
#include "Drawing/CoarseMesh.h"
#include "Drawing/DrawableFaces.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"
#include "TestMeshes.h"

#include "vtkDataSetAttributes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace camaron;
using namespace camaron::testing;

namespace
{
CoarseMesh MakeCoarse(
  vtkUnstructuredGrid* grid, int outside, int inside, const CellsToDraw& cells = {})
{
  CoarseBoxes boxes;
  grid->GetBounds(boxes.Bounds.data());
  boxes.OfOutside = outside;
  boxes.OfInside = inside;
  return MakeCoarseMesh(MeshTopology(grid), cells, boxes);
}

int GetSize(const std::array<std::uint32_t, 4>& cell)
{
  return static_cast<int>(std::find(cell.begin(), cell.end(), CoarseMesh::NoPoint) - cell.begin());
}

Vector GetCorner(vtkUnstructuredGrid* grid, const CoarseMesh& mesh, std::uint32_t corner)
{
  double x[3];
  grid->GetPoint(mesh.Points[corner], x);
  return { x[0], x[1], x[2] };
}

double GetVolume(vtkUnstructuredGrid* grid, const CoarseMesh& mesh)
{
  double volume = 0;
  for (const auto& cell : mesh.Cells)
  {
    if (GetSize(cell) == 4)
    {
      const Vector origin = GetCorner(grid, mesh, cell[0]);
      volume +=
        Dot(GetCorner(grid, mesh, cell[1]) - origin,
          Cross(GetCorner(grid, mesh, cell[2]) - origin, GetCorner(grid, mesh, cell[3]) - origin)) /
        6;
    }
  }
  return volume;
}

// How often each face of the tetrahedra occurs, and how often as an outer one.
std::map<std::array<std::uint32_t, 3>, std::pair<int, int>> CountFaces(const CoarseMesh& mesh)
{
  std::map<std::array<std::uint32_t, 3>, std::pair<int, int>> counts;
  const CellShape& shape = GetCellShape(VTK_TETRA);
  for (std::size_t i = 0; i < mesh.Cells.size(); ++i)
  {
    for (int face = 0; GetSize(mesh.Cells[i]) == 4 && face < 4; ++face)
    {
      std::array<std::uint32_t, 3> corners;
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = mesh.Cells[i][shape.FacePoints[3 * face + k]];
      }
      std::sort(corners.begin(), corners.end());
      ++counts[corners].first;
      counts[corners].second += (mesh.OuterFacets[i] & GetFacetBit(face)) != 0;
    }
  }
  return counts;
}
}

//------------------------------------------------------------------------------
// A box of cubes stays a box: fewer cells that fill it, whatever they were made of.
TEST(CoarseMesh, FillsTheSameBox)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(12, 10, 8, asPolyhedra);
    const double* bounds = grid->GetBounds();
    const double volume =
      (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]);
    const CoarseMesh coarse = MakeCoarse(grid, 4, 3);
    EXPECT_NEAR(GetVolume(grid, coarse), volume, 1e-9 * volume);
    EXPECT_LT(coarse.Cells.size(), 960u);
    EXPECT_GT(coarse.Cells.size(), 100u);
    for (const vtkIdType origin : coarse.Origins)
    {
      EXPECT_LT(origin, 960);
    }
  }
}

//------------------------------------------------------------------------------
// Without cracks: a face is between two tetrahedra or outside, and what says so goes with the
// cells. Here boxes are so large that tetrahedra fold over each other.
TEST(CoarseMesh, HasNoCracks)
{
  const Grid grid = MakeHexagonalPrisms(9);
  const CoarseMesh coarse = MakeCoarse(grid, 5, 2);
  int numberOfOuterFaces = 0;
  for (const auto& face : CountFaces(coarse))
  {
    const bool isOuter = face.second.first % 2 == 1;
    EXPECT_TRUE(!isOuter || face.second.second == face.second.first);
    numberOfOuterFaces += isOuter;
  }
  EXPECT_GT(numberOfOuterFaces, 20);
}

//------------------------------------------------------------------------------
// One layer thinner than a box is a sheet, not nothing.
TEST(CoarseMesh, KeepsThinParts)
{
  const Grid grid = MakeHexahedra(20, 20, 1, false);
  CoarseBoxes boxes;
  grid->GetBounds(boxes.Bounds.data());
  boxes.Bounds[4] -= 18; // it is within one of eight boxes
  boxes.Bounds[5] += 21;
  boxes.OfOutside = 8;
  const CoarseMesh coarse = MakeCoarseMesh(MeshTopology(grid), {}, boxes);
  double area = 0;
  for (const auto& cell : coarse.Cells)
  {
    ASSERT_EQ(GetSize(cell), 3);
    const Vector origin = GetCorner(grid, coarse, cell[0]);
    area += 0.5 *
      Norm(Cross(
        GetCorner(grid, coarse, cell[1]) - origin, GetCorner(grid, coarse, cell[2]) - origin));
  }
  const double* bounds = grid->GetBounds();
  EXPECT_GT(area, 0.9 * (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]));
}

//------------------------------------------------------------------------------
// Cells of all dimensions become such with as many corners as they need; ghosts and hidden cells
// are not there.
TEST(CoarseMesh, TakesCellsOfAllDimensions)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, 0, 9 } };
  const Grid grid = MakeGrid(points,
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_POLY_LINE, { 3, 4, 5 } }, { VTK_VERTEX, { 5 } },
      { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_TRIANGLE, { 1, 2, 4 } }, { VTK_LINE, { 0, 5 } } });
  const unsigned char ghosts[] = { 0, 0, 0, 0, vtkDataSetAttributes::DUPLICATECELL,
    vtkDataSetAttributes::HIDDENCELL };
  CellsToDraw cells;
  cells.Ghosts = ghosts;
  const CoarseMesh coarse = MakeCoarse(grid, 90, 90, cells);
  std::multiset<std::pair<int, vtkIdType>> found;
  for (std::size_t i = 0; i < coarse.Cells.size(); ++i)
  {
    found.emplace(GetSize(coarse.Cells[i]), coarse.Origins[i]);
  }
  const std::multiset<std::pair<int, vtkIdType>> expected = { { 4, 3 }, { 3, 0 }, { 3, 0 },
    { 2, 1 }, { 2, 1 }, { 1, 2 } };
  // One of the triangles of the quadrilateral lies under the tetrahedron and is its own cell all
  // the same.
  EXPECT_EQ(found, expected);
}
