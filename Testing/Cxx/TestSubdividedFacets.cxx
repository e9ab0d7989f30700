// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces of curved cells as small triangles.
#include "Drawing/CellTetrahedra.h"
#include "Drawing/DrawableFaces.h"
#include "Drawing/SubdividedFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include "CollapsedForms.h"
#include "TestMeshes.h"

#include "vtkCell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>

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

//------------------------------------------------------------------------------
double GetVolumeOfTetrahedra(vtkUnstructuredGrid* grid, int level)
{
  const auto facets =
    SubdividedFacets::Make(MeshTopology(grid), level, SubdividedFacets::Extent::Cells);
  const Grid drawn = facets ? AddPoints(grid, *facets) : Grid(grid);
  const MeshView mesh(drawn);
  double volume = 0;
  for (const auto& points : MakeCellTetrahedra(mesh, facets.get()).Points)
  {
    const Vector origin = mesh.GetPoint(points[0]);
    volume += Dot(mesh.GetPoint(points[1]) - origin,
                Cross(mesh.GetPoint(points[2]) - origin, mesh.GetPoint(points[3]) - origin)) /
      6;
  }
  return std::abs(volume);
}

//------------------------------------------------------------------------------
// A picture of the outer faces: their points, the sides of triangles that are edges, and the number
// of triangles that are not collapsed. Places are rounded.
struct Picture
{
  using Place = std::array<long, 3>;
  std::set<Place> Points;
  std::set<std::pair<Place, Place>> Edges;
  int Triangles = 0;
};

//------------------------------------------------------------------------------
Picture MakePicture(vtkUnstructuredGrid* grid, int level, SubdividedFacets::Extent extent)
{
  const auto facets = SubdividedFacets::Make(MeshTopology(grid), level, extent);
  const Grid drawn = facets ? AddPoints(grid, *facets) : Grid(grid);
  const MeshTopology topology(drawn);
  CellsToDraw cells;
  cells.Subdivided = facets.get();
  Picture picture;
  const auto getPlace = [&](std::uint32_t point)
  {
    Picture::Place place;
    for (int k = 0; k < 3; ++k)
    {
      place[k] = std::lround(1e6 * drawn->GetPoint(point)[k]);
    }
    return place;
  };
  for (const auto& triangle : MakeDrawableFaces(topology, cells, FacesToDraw::Outer).Triangles)
  {
    const std::set<Picture::Place> points = { getPlace(triangle[0]), getPlace(triangle[1]),
      getPlace(triangle[2]) };
    picture.Points.insert(points.begin(), points.end());
    picture.Triangles += points.size() == 3;
    for (int i = 0; i < 3; ++i)
    {
      const Picture::Place a = getPlace(triangle[i]), b = getPlace(triangle[(i + 1) % 3]);
      if ((triangle[3] >> i & 1) && a != b)
      {
        picture.Edges.insert(std::minmax(a, b));
      }
    }
  }
  return picture;
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
      EXPECT_NEAR(GetVolumeOfTetrahedra(grid, level), GetVolume(drawn, faces), 1e-12);
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

//------------------------------------------------------------------------------
// A cell written with coincident corners looks like the cell that it is, at all levels.
TEST(SubdividedFacets, CollapsedCellsLookLikeWhatRemains)
{
  const std::vector<int> wedge = { 0, 1, 2, 2, 3, 4, 5, 5 },
                         tetrahedron = { 0, 1, 2, 2, 3, 3, 3, 3 };
  const Collapse examples[] = { { VTK_QUADRATIC_HEXAHEDRON, 20, tetrahedron, VTK_QUADRATIC_TETRA,
                                  10 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, { 0, 1, 2, 3, 4, 4, 4, 4 }, VTK_QUADRATIC_PYRAMID, 13 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, wedge, VTK_QUADRATIC_WEDGE, 15 },
    { VTK_QUADRATIC_HEXAHEDRON, 20, { 0, 0, 1, 2, 3, 3, 4, 5 }, VTK_QUADRATIC_WEDGE, 15 },
    { VTK_QUADRATIC_QUAD, 8, { 0, 1, 2, 2 }, VTK_QUADRATIC_TRIANGLE, 6 },
    { VTK_QUADRATIC_WEDGE, 15, { 0, 1, 2, 3, 3, 3 }, VTK_QUADRATIC_TETRA, 10 },
    { VTK_TRIQUADRATIC_HEXAHEDRON, 27, tetrahedron, VTK_QUADRATIC_TETRA, 10 },
    { VTK_LAGRANGE_HEXAHEDRON, 64, wedge, VTK_LAGRANGE_WEDGE, 40 } };
  std::mt19937 random(3);
  for (const Collapse& example : examples)
  {
    const auto [remaining, collapsed] = MakeCollapsed(example, 0.1, random);
    for (int level = 0; level <= SubdividedFacets::MaxLevel; ++level)
    {
      for (const auto extent :
        { SubdividedFacets::Extent::Boundary, SubdividedFacets::Extent::Cells })
      {
        if (level > 2 && extent == SubdividedFacets::Extent::Cells)
        {
          continue; // takes long
        }
        const Picture expected = MakePicture(remaining, level, extent),
                      found = MakePicture(collapsed, level, extent);
        const std::string what = std::to_string(example.Type) + " as " +
          std::to_string(example.Remaining) + " at level " + std::to_string(level);
        EXPECT_EQ(expected.Triangles, found.Triangles) << what;
        EXPECT_EQ(expected.Points, found.Points) << what;
        EXPECT_EQ(expected.Edges, found.Edges) << what;
      }
      // Others may be cut along other diagonals.
      if (example.Remaining == VTK_QUADRATIC_TETRA && level <= 2)
      {
        EXPECT_NEAR(
          GetVolumeOfTetrahedra(remaining, level), GetVolumeOfTetrahedra(collapsed, level), 1e-12)
          << example.Type;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The face of a cell between two others, of which one is written in another form, has one side for
// each, and no points of its own.
TEST(SubdividedFacets, CollapsedCellsShareFaces)
{
  // Two quadratic tetrahedra on both sides of a triangle.
  Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { .3, .3, -1 } };
  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
  const auto getMiddle = [&](vtkIdType a, vtkIdType b)
  {
    const auto [known, isNew] =
      middles.try_emplace(std::minmax(a, b), static_cast<vtkIdType>(points.size()));
    if (isNew)
    {
      const Point p = points[a], q = points[b];
      points.push_back({ (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2 + 0.1 });
    }
    return known->second;
  };
  const auto m = getMiddle;
  const std::vector<vtkIdType> native = { 0, 2, 1, 4, m(0, 2), m(2, 1), m(1, 0), m(0, 4), m(2, 4),
    m(1, 4) };
  const std::vector<vtkIdType> tetrahedron = { 0, 1, 2, 3, m(0, 1), m(1, 2), m(2, 0), m(0, 3),
    m(1, 3), m(2, 3) };
  const std::vector<vtkIdType> hexahedron = { 0, 1, 2, 2, 3, 3, 3, 3, m(0, 1), m(1, 2), 2, m(2, 0),
    3, 3, 3, 3, m(0, 3), m(1, 3), m(2, 3), m(2, 3) };
  for (const int level : { 2, 3 })
  {
    const auto count = [level](const Grid& grid)
    {
      return SubdividedFacets::Make(MeshTopology(grid), level, SubdividedFacets::Extent::Faces)
        ->GetNumberOfNewPoints();
    };
    EXPECT_EQ(count(MakeGrid(
                points, { { VTK_QUADRATIC_TETRA, native }, { VTK_QUADRATIC_TETRA, tetrahedron } })),
      count(MakeGrid(
        points, { { VTK_QUADRATIC_TETRA, native }, { VTK_QUADRATIC_HEXAHEDRON, hexahedron } })));
  }
}
}
}
