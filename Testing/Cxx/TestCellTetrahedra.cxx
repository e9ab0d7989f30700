// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Vector.h"
#include "CriteriaTesting.h"
#include "Drawing/CellTetrahedra.h"
#include "Mesh/MeshView.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
double GetVolume(vtkUnstructuredGrid* grid, const std::array<std::uint32_t, 4>& points)
{
  Vector x[4];
  for (int i = 0; i < 4; ++i)
  {
    double p[3];
    grid->GetPoint(points[i], p);
    x[i] = { p[0], p[1], p[2] };
  }
  return Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0])) / 6;
}
}

//------------------------------------------------------------------------------
// The tetrahedra of a cell fill it, whichever type it has: unit cells have known volumes.
TEST(CellTetrahedra, FillCells)
{
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(3, 3, 3, asPolyhedra);
    double bounds[6];
    grid->GetBounds(bounds);
    const CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(grid));
    EXPECT_EQ(tetrahedra.Points.size(), 27u * 6);
    double sum = 0;
    for (const auto& points : tetrahedra.Points)
    {
      sum += std::abs(GetVolume(grid, points));
    }
    EXPECT_NEAR(
      sum, (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4]), 1e-12);
  }
  for (const int type : StandardTypes3D)
  {
    const Grid cell = MakeStandardCell(type);
    const CellTetrahedra standard = MakeCellTetrahedra(MeshView(cell));
    const Grid polyhedron = ToPolyhedra(cell);
    const CellTetrahedra same = MakeCellTetrahedra(MeshView(polyhedron));
    double volumes[2] = { 0, 0 };
    for (const auto& points : standard.Points)
    {
      volumes[0] += std::abs(GetVolume(cell, points));
    }
    for (const auto& points : same.Points)
    {
      volumes[1] += std::abs(GetVolume(polyhedron, points));
    }
    EXPECT_GT(volumes[0], 0) << type;
    EXPECT_NEAR(volumes[0], volumes[1], 1e-12) << type;
  }
}

//------------------------------------------------------------------------------
// Else isosurfaces would have cracks: every triangle between two cells is one of both. In a block
// of cells each triangle occurs twice, but for two on each outer face.
TEST(CellTetrahedra, FitAtSharedFaces)
{
  for (const bool asPolyhedra : { false, true })
  {
    const int n = 4;
    const Grid grid = MakeHexahedra(n, n, n, asPolyhedra);
    std::map<std::array<std::uint32_t, 3>, int> triangles;
    for (const auto& points : MakeCellTetrahedra(MeshView(grid)).Points)
    {
      for (int without = 0; without < 4; ++without)
      {
        std::array<std::uint32_t, 3> triangle{ { points[(without + 1) % 4],
          points[(without + 2) % 4], points[(without + 3) % 4] } };
        std::sort(triangle.begin(), triangle.end());
        ++triangles[triangle];
      }
    }
    int once = 0;
    for (const auto& triangle : triangles)
    {
      EXPECT_LE(triangle.second, 2);
      once += triangle.second == 1;
    }
    EXPECT_EQ(once, 6 * n * n * 2);
  }
}

//------------------------------------------------------------------------------
// A block's range holds the values of its cells, and no NaN.
TEST(CellTetrahedra, BlockRanges)
{
  const Grid grid = MakeHexahedra(200, 1, 1, false);
  const MeshView mesh(grid);
  std::vector<float> values(grid->GetNumberOfPoints());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(grid->GetPoint(static_cast<vtkIdType>(i))[0]);
  }
  values[0] = std::numeric_limits<float>::quiet_NaN();
  const auto ranges = FindBlockRanges(mesh, values);
  const CellTetrahedra tetrahedra = MakeCellTetrahedra(mesh);
  ASSERT_EQ(ranges.size(), 4u);
  ASSERT_EQ(tetrahedra.Blocks.size(), 5u);
  for (std::size_t block = 0; block < ranges.size(); ++block)
  {
    float low = 1e30f, high = -1e30f;
    for (std::uint32_t t = tetrahedra.Blocks[block]; t < tetrahedra.Blocks[block + 1]; ++t)
    {
      EXPECT_EQ(
        (tetrahedra.Cells[t] >> CellTetrahedra::OuterFaceBits) / CellTetrahedra::CellsPerBlock,
        block);
      for (const std::uint32_t point : tetrahedra.Points[t])
      {
        low = std::fmin(low, values[point]);
        high = std::fmax(high, values[point]);
      }
    }
    EXPECT_EQ(ranges[block][0], low);
    EXPECT_EQ(ranges[block][1], high);
  }
}

//------------------------------------------------------------------------------
// The faces of tetrahedra that lie in faces of cells cover these, and no others do.
TEST(CellTetrahedra, WallsCoverCells)
{
  const auto sumWalls = [](vtkUnstructuredGrid* grid)
  {
    double sum = 0;
    const CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(grid));
    for (std::size_t t = 0; t < tetrahedra.Points.size(); ++t)
    {
      for (int without = 0; without < 4; ++without)
      {
        if (tetrahedra.Cells[t] >> without & 1)
        {
          Vector x[3];
          for (int i = 0; i < 3; ++i)
          {
            double p[3];
            grid->GetPoint(tetrahedra.Points[t][(without + 1 + i) % 4], p);
            x[i] = { p[0], p[1], p[2] };
          }
          sum += Norm(Cross(x[1] - x[0], x[2] - x[0])) / 2;
        }
      }
    }
    return sum;
  };
  for (const bool asPolyhedra : { false, true })
  {
    const Grid grid = MakeHexahedra(3, 3, 3, asPolyhedra);
    double bounds[6];
    grid->GetBounds(bounds);
    const double x = bounds[1] - bounds[0], y = bounds[3] - bounds[2], z = bounds[5] - bounds[4];
    EXPECT_NEAR(sumWalls(grid), 2 * 3 * (x * y + y * z + z * x), 1e-12);
  }
  for (const int type : StandardTypes3D)
  {
    const Grid cell = MakeStandardCell(type);
    const Grid polyhedron = ToPolyhedra(cell);
    const double area = EvaluateAll(polyhedron).at("SurfaceArea")[0];
    EXPECT_NEAR(sumWalls(cell), area, 1e-12 * area) << type;
    EXPECT_NEAR(sumWalls(polyhedron), area, 1e-12 * area) << type;
  }
}

//------------------------------------------------------------------------------
// Lines of tetrahedra that are edges of the cell are all of these, and no diagonals. A quadratic
// cell has two for each.
TEST(CellTetrahedra, EdgesAreThoseOfCells)
{
  const auto findEdges = [](vtkUnstructuredGrid* grid)
  {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    const CellTetrahedra tetrahedra = MakeCellTetrahedra(MeshView(grid));
    for (std::size_t t = 0; t < tetrahedra.Points.size(); ++t)
    {
      int bit = 0;
      for (int i = 0; i < 4; ++i)
      {
        for (int k = i + 1; k < 4; ++k, ++bit)
        {
          if (tetrahedra.Edges[t] >> bit & 1)
          {
            edges.insert(std::minmax(tetrahedra.Points[t][i], tetrahedra.Points[t][k]));
          }
        }
      }
    }
    return edges;
  };
  std::vector<Grid> cells;
  for (const int type : StandardTypes3D)
  {
    cells.push_back(MakeStandardCell(type));
    EXPECT_EQ(findEdges(cells.back()), findEdges(ToPolyhedra(cells.back()))) << type;
  }
  for (const int type :
    { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID })
  {
    vtkNew<vtkGenericCell> unit;
    unit->SetCellType(type);
    const double* x = unit->GetParametricCoords();
    Points points;
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < unit->GetNumberOfPoints(); ++i, x += 3)
    {
      points.push_back({ x[0], x[1], x[2] });
      ids.push_back(i);
    }
    cells.push_back(MakeGrid(points, { { type, ids } }));
  }
  for (const Grid& cell : cells)
  {
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    vtkCell* ofVTK = cell->GetCell(0);
    for (int e = 0; e < ofVTK->GetNumberOfEdges(); ++e)
    {
      // The node of a curved edge comes last.
      vtkIdList* ids = ofVTK->GetEdge(e)->GetPointIds();
      const auto add = [&](vtkIdType i, vtkIdType k)
      {
        const auto a = static_cast<std::uint32_t>(ids->GetId(i)),
                   b = static_cast<std::uint32_t>(ids->GetId(k));
        expected.emplace(std::min(a, b), std::max(a, b));
      };
      const vtkIdType last = ids->GetNumberOfIds() - 1;
      add(0, last);
      if (last == 2)
      {
        add(2, 1);
      }
    }
    EXPECT_EQ(findEdges(cell), expected) << ofVTK->GetCellType();
  }
}

//------------------------------------------------------------------------------
TEST(CellTetrahedra, BlockBounds)
{
  const Grid grid = MakeHexahedra(100, 1, 1, false);
  double all[6];
  grid->GetBounds(all);
  const auto bounds = FindBlockBounds(MeshView(grid));
  ASSERT_EQ(bounds.size(), 2u);
  const double middle = all[0] + 0.64 * (all[1] - all[0]);
  for (const auto& [side, block] : { std::pair<double, int>{ all[0], 0 }, { all[1], 1 } })
  {
    EXPECT_NEAR(bounds[block][block], side, 1e-12);
    EXPECT_NEAR(bounds[block][1 - block], middle, 1e-12);
    EXPECT_EQ(bounds[block][2], all[2]);
    EXPECT_EQ(bounds[block][5], all[5]);
  }
}
