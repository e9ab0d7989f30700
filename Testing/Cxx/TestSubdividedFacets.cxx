// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces of curved cells as small triangles.
#include "Drawing/CellTetrahedra.h"
#include "Drawing/DrawableFaces.h"
#include "Drawing/SubdividedFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include "TestMeshes.h"

#include "vtkCell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

namespace camaron
{
namespace testing
{
namespace
{
//------------------------------------------------------------------------------
// Cells of a type side by side along x, bent: nodes are moved by a quadratic map.
Grid MakeBent(int type, int numberOfCells)
{
  Points points;
  std::map<std::array<long, 3>, vtkIdType> known;
  Cells cells;
  const auto size =
    static_cast<std::size_t>(GetCellShape(static_cast<unsigned char>(type)).NumberOfNodes);
  std::vector<vtkIdType> nodes(size);
  std::iota(nodes.begin(), nodes.end(), 0);
  const Grid one = MakeGrid(Points(size), { { type, nodes } });
  const double* const parametric = one->GetCell(0)->GetParametricCoords();
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType node = 0; node < one->GetNumberOfPoints(); ++node)
    {
      const double x = parametric[3 * node] + cell, y = parametric[3 * node + 1],
                   z = parametric[3 * node + 2];
      const auto [place, isNew] =
        known.try_emplace({ std::lround(x * 8), std::lround(y * 8), std::lround(z * 8) },
          static_cast<vtkIdType>(points.size()));
      if (isNew)
      {
        points.push_back({ x, y + 0.1 * x * x, z * (1 + 0.2 * x * x) - 0.2 * y * y });
      }
      ids.push_back(place->second);
    }
    cells.emplace_back(type, ids);
  }
  return MakeGrid(points, cells);
}

//------------------------------------------------------------------------------
// The grid with the new points.
Grid AddPoints(vtkUnstructuredGrid* grid, const SubdividedFacets& facets)
{
  auto made = Grid::New();
  made->DeepCopy(grid);
  for (vtkIdType i = 0; i < facets.GetNumberOfNewPoints(); ++i)
  {
    const SubdividedFacets::Stencil stencil = facets.GetStencil(i);
    double place[3] = { 0, 0, 0 };
    for (vtkIdType k = 0; k < stencil.Size; ++k)
    {
      for (int d = 0; d < 3; ++d)
      {
        const vtkIdType node = grid->GetCell(stencil.Cell)->GetPointId(stencil.Nodes[k]);
        place[d] += stencil.Weights[k] * grid->GetPoint(node)[d];
      }
    }
    made->GetPoints()->InsertNextPoint(place);
  }
  return made;
}

//------------------------------------------------------------------------------
// Volume by the divergence theorem of triangles that must be oriented outward.
double GetVolume(vtkUnstructuredGrid* grid, const DrawableFaces& faces)
{
  const MeshView mesh(grid);
  double volume = 0;
  for (const auto& triangle : faces.Triangles)
  {
    volume += Dot(mesh.GetPoint(triangle[0]),
                Cross(mesh.GetPoint(triangle[1]), mesh.GetPoint(triangle[2]))) /
      6;
  }
  return volume;
}
}

//------------------------------------------------------------------------------
TEST(SubdividedFacets, LevelOneNeedsNoPoints)
{
  const Grid grid = MakeBent(VTK_QUADRATIC_HEXAHEDRON, 2);
  EXPECT_EQ(
    SubdividedFacets::Make(MeshTopology(grid), 1, SubdividedFacets::Extent::Faces), nullptr);
  const auto straight =
    SubdividedFacets::Make(MeshTopology(grid), 0, SubdividedFacets::Extent::Faces);
  ASSERT_NE(straight, nullptr);
  EXPECT_TRUE(straight->AreStraight());
  const MeshTopology topology(grid);
  CellsToDraw cells;
  cells.Subdivided = straight.get();
  EXPECT_EQ(MakeDrawableFaces(topology, cells, FacesToDraw::Outer).Triangles.size(), 20u);
}

//------------------------------------------------------------------------------
// The outer faces are closed, and approach the exact volume with each level; edges are those of the
// cells.
TEST(SubdividedFacets, ApproachTheCells)
{
  struct Case
  {
    int Type;
    std::size_t Triangles, Edges; ///< of the outer faces of two cells, at level 0; sides of faces
    double Volume;                ///< of two cells
  };
  const Case cases[] = { { VTK_QUADRATIC_HEXAHEDRON, 20, 40, 2 + 0.2 * 8 / 3 },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 20, 40, 2 + 0.2 * 8 / 3 } };
  for (const Case& one : cases)
  {
    const Grid grid = MakeBent(one.Type, 2);
    double error = 1;
    for (const int level : { 2, 3, 4 })
    {
      const auto facets =
        SubdividedFacets::Make(MeshTopology(grid), level, SubdividedFacets::Extent::Cells);
      ASSERT_NE(facets, nullptr);
      const Grid drawn = AddPoints(grid, *facets);
      const MeshTopology topology(drawn);
      CellsToDraw cells;
      cells.Subdivided = facets.get();
      const DrawableFaces faces = MakeDrawableFaces(topology, cells, FacesToDraw::Outer);
      const std::size_t parts = std::size_t(1) << level;
      EXPECT_EQ(faces.Triangles.size(), one.Triangles * parts * parts);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
      std::size_t edges = 0;
      for (const auto& triangle : faces.Triangles)
      {
        for (int i = 0; i < 3; ++i)
        {
          const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
          sides[std::minmax(a, b)] += a < b ? 1 : -1;
          edges += triangle[3] >> i & 1;
        }
      }
      for (const auto& side : sides)
      {
        EXPECT_EQ(side.second, 0); // once in each direction
      }
      EXPECT_EQ(edges, one.Edges * parts);
      const double next = std::abs(GetVolume(drawn, faces) - one.Volume);
      EXPECT_LT(next, error / 3.5) << one.Type;
      error = next;

      // The same outer faces without the others.
      const auto outer =
        SubdividedFacets::Make(MeshTopology(grid), level, SubdividedFacets::Extent::Boundary);
      EXPECT_LT(outer->GetNumberOfNewPoints(), facets->GetNumberOfNewPoints());
      CellsToDraw outerCells;
      outerCells.Subdivided = outer.get();
      EXPECT_EQ(MakeDrawableFaces(topology, outerCells, FacesToDraw::Outer).Triangles.size(),
        faces.Triangles.size());

      // Tetrahedra fill the same volume, and every interior face has two sides.
      const DrawableFaces all = MakeDrawableFaces(topology, cells, FacesToDraw::All);
      EXPECT_EQ(all.Triangles.size(), faces.Triangles.size() + 2 * parts * parts);
      const MeshView mesh(drawn);
      double volume = 0;
      const CellTetrahedra tetrahedra = MakeCellTetrahedra(mesh, facets.get());
      for (const auto& points : tetrahedra.Points)
      {
        const Vector origin = mesh.GetPoint(points[0]);
        volume += Dot(mesh.GetPoint(points[1]) - origin,
                    Cross(mesh.GetPoint(points[2]) - origin, mesh.GetPoint(points[3]) - origin)) /
          6;
      }
      EXPECT_NEAR(std::abs(volume), GetVolume(drawn, faces), 1e-12);
    }
  }
}

//------------------------------------------------------------------------------
// New points of all types are where VTK evaluates the cell, whatever the order of its nodes is; a
// face has no nodes of the rest of the cell.
TEST(SubdividedFacets, PointsAreOnTheCell)
{
  for (const int type : { VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_TRIANGLE, VTK_QUADRATIC_QUAD,
         VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_LINEAR_QUAD, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_WEDGE,
         VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_QUADRATIC_LINEAR_WEDGE,
         VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_PYRAMID, VTK_TRIQUADRATIC_PYRAMID })
  {
    const Grid grid = MakeBent(type, 1);
    const auto facets =
      SubdividedFacets::Make(MeshTopology(grid), 2, SubdividedFacets::Extent::Cells);
    ASSERT_NE(facets, nullptr) << type;
    const Grid drawn = AddPoints(grid, *facets);
    vtkCell* const cell = grid->GetCell(0);
    for (vtkIdType i = 0; i < facets->GetNumberOfNewPoints(); ++i)
    {
      double sum = 0;
      const SubdividedFacets::Stencil stencil = facets->GetStencil(i);
      for (vtkIdType k = 0; k < stencil.Size; ++k)
      {
        sum += stencil.Weights[k];
      }
      EXPECT_NEAR(sum, 1, 1e-12) << type;
      const bool isInside = cell->GetCellDimension() == 3 &&
        i + grid->GetNumberOfPoints() >= facets->GetInside(0).First;
      EXPECT_LE(stencil.Size, isInside ? cell->GetNumberOfPoints() : 9) << type;
      double place[3], closest[3], parametric[3], distance = 0;
      std::vector<double> weights(cell->GetNumberOfPoints());
      int sub = 0;
      drawn->GetPoint(grid->GetNumberOfPoints() + i, place);
      if (cell->GetCellDimension() == 3 && type != VTK_TRIQUADRATIC_PYRAMID &&
        type != VTK_QUADRATIC_PYRAMID)
      {
        cell->EvaluatePosition(place, closest, sub, parametric, distance, weights.data());
        EXPECT_LT(distance, 1e-6) << type;
      }
    }
    const int local = 0;
    if (cell->GetCellDimension() == 3)
    {
      EXPECT_GE(facets->GetInside(0).First, grid->GetNumberOfPoints()) << type;
    }
    EXPECT_EQ(facets->Get(0, local).Count,
      (cell->GetCellDimension() == 2 ? cell->GetNumberOfEdges()
                                     : cell->GetFace(0)->GetNumberOfEdges()) == 3
        ? 16
        : 32)
      << type;
  }
}
}
}
