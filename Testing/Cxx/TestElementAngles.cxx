// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Angles around edges and vertices of meshes, and what goes by them.
#include "Criteria/Evaluation.h"
#include "MeshElementsTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Around an inner edge the cells fill 360 degrees, around an inner vertex 4 pi; neither at the
// boundary.
TEST(ElementAngles, AnglesAroundInnerElements)
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
      EXPECT_GE(
        Get(elements.Edges, "EdgeMaxDihedralAngle", i) * Get(elements.Edges, "EdgeCellCount", i),
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
// Of a closed surface the angles that are missing to 360 degrees are two full circles together.
TEST(ElementAngles, AngleDefects)
{
  const Points cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const Elements closed(MakeGrid(cube,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 0, 1, 5, 4 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_PIXEL, { 3, 0, 7, 4 } }, { VTK_TRIANGLE, { 4, 5, 6 } },
      { VTK_TRIANGLE, { 4, 6, 7 } } }));
  EXPECT_NEAR(8 * 360 - Sum(closed.Vertices, "VertexAngleSum"), 720, 1e-9);
  EXPECT_EQ(Sum(closed.Edges, "BoundaryEdge") + Sum(closed.Edges, "NonManifoldEdge"), 0);

  // A reflex corner, and three polygons at one edge.
  const Elements open(MakeGrid(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 1, 0, 1 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4, 5 } }, { VTK_TRIANGLE, { 0, 6, 1 } },
      { VTK_TRIANGLE, { 0, 1, 6 } } }));
  EXPECT_NEAR(Get(open.Vertices, "VertexAngleSum", 3), 270, 1e-9);
  EXPECT_NEAR(Get(open.Vertices, "VertexAngleSum", 0), 90 + 45 + 45, 1e-9);
  EXPECT_EQ(Sum(open.Edges, "NonManifoldEdge"), 1);
  EXPECT_EQ(Sum(open.Edges, "BoundaryEdge"), 5);
  EXPECT_NEAR(Get(open.Faces, "FaceConcavity", 0), 90, 1e-9);
  EXPECT_EQ(Sum(open.Faces, "Warpage"), 0);
}

//------------------------------------------------------------------------------
// Where two cubes meet in a point only, and where a cell has none of its volume.
TEST(ElementAngles, PinchedPointsAndFlatCells)
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
  const Elements collapsed(
    MakeGrid({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 1 }, { 1, 0, 1 } },
      { { VTK_WEDGE, { 0, 1, 2, 3, 4, 5 } } }));
  EXPECT_TRUE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 0)));
  EXPECT_TRUE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 3)));
  EXPECT_FALSE(std::isnan(Get(collapsed.Vertices, "VertexAngleSum", 5)));
}

//------------------------------------------------------------------------------
// Points in the middle of an edge or a face of a cell, where finer cells meet it.
TEST(ElementAngles, AnglesAtHangingPoints)
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
