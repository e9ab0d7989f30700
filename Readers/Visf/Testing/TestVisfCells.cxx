// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells that a valid Visf file becomes: their types, and the orientation of their faces.
#include "VisfSamples.h"

#include "Mesh/CellFacets.h"
#include "Mesh/CellShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// A prism over a polygon in the plane; faces with arbitrary orientation.
VisfMesh MakePrism(const std::vector<std::array<float, 2>>& outline)
{
  VisfMesh mesh;
  const auto n = static_cast<std::int32_t>(outline.size());
  for (const float z : { 0.f, 1.f })
  {
    for (const auto& p : outline)
    {
      mesh.Points.push_back({ { p[0], p[1], z } });
    }
  }
  mesh.Polygons.resize(2);
  for (std::int32_t i = 0; i < n; ++i)
  {
    mesh.Polygons[0].push_back(i);
    mesh.Polygons[1].push_back(n + i);
    mesh.Polygons.push_back({ i, (i + 1) % n, n + (i + 1) % n, n + i });
  }
  mesh.Polyhedra.emplace_back(n + 2);
  std::iota(mesh.Polyhedra[0].begin(), mesh.Polyhedra[0].end(), 0);
  return mesh;
}

//------------------------------------------------------------------------------
// Faces of all cells, each face as a set, to compare meshes whose faces are oriented differently.
using FaceSets = std::vector<std::vector<std::vector<vtkIdType>>>;
FaceSets GetFaceSets(vtkUnstructuredGrid* grid)
{
  FaceSets cells;
  const MeshView mesh(grid);
  CellFacets facets(mesh);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    cells.emplace_back();
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        cells.back().emplace_back(points, points + size);
        std::sort(cells.back().back().begin(), cells.back().back().end());
      });
    std::sort(cells.back().begin(), cells.back().end());
  }
  return cells;
}
}

//------------------------------------------------------------------------------
// If this fails, a cell of a standard type becomes another type, is inverted or has wrong nodes,
// for some order or orientation of its faces.
TEST(VisfCells, RecognizesPrimitives)
{
  std::mt19937 random(7);
  for (const int type : { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON })
  {
    const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
    VisfMesh reference;
    // Positions that make a positive cell in VTK's order; its wedge has (0,1,2) facing out.
    const float prism[6][3] = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 },
      { 1, 0, 1 } };
    const float cube[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
      { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    for (int node = 0; node < shape.NumberOfCorners; ++node)
    {
      const float* x = type == VTK_WEDGE ? prism[node] : cube[node];
      const bool apex = type == VTK_TETRA && node == 2; // of a tetrahedron, on the y axis
      reference.Points.push_back({ { apex ? 0 : x[0], x[1], x[2] } });
    }
    if (type == VTK_TETRA)
    {
      reference.Points[3] = { { 0, 0, 1 } };
    }
    for (int f = 0; f < shape.NumberOfFaces; ++f)
    {
      reference.Polygons.emplace_back(
        shape.FacePoints + shape.FaceOffsets[f], shape.FacePoints + shape.FaceOffsets[f + 1]);
    }
    reference.Polyhedra.emplace_back(shape.NumberOfFaces);
    std::iota(reference.Polyhedra[0].begin(), reference.Polyhedra[0].end(), 0);

    // Faces in VTK's order give the original nodes.
    Result result = ReadMesh(reference, Encoding::Little03);
    ASSERT_EQ(result.Grid->GetCellType(0), type);
    for (int node = 0; node < shape.NumberOfCorners; ++node)
    {
      EXPECT_EQ(MeshView(result.Grid).GetCellPoints(0)[node], node);
    }
    const double volume = GetMeasure(result.Grid, 0);
    EXPECT_GT(volume, 0);

    for (int i = 0; i < 200; ++i)
    {
      VisfMesh mesh = reference;
      std::shuffle(mesh.Polyhedra[0].begin(), mesh.Polyhedra[0].end(), random);
      for (auto& polygon : mesh.Polygons)
      {
        std::rotate(polygon.begin(), polygon.begin() + random() % polygon.size(), polygon.end());
        if (random() % 2)
        {
          std::reverse(polygon.begin(), polygon.end());
        }
      }
      if (i % 2) // the mirror image, which must not become inverted
      {
        for (auto& point : mesh.Points)
        {
          point[0] = -point[0];
        }
      }
      result = ReadMesh(mesh, Encoding::Little03);
      ASSERT_EQ(result.Grid->GetCellType(0), type);
      EXPECT_NEAR(GetMeasure(result.Grid, 0), volume, 1e-12);
      EXPECT_EQ(
        GetFaceSets(result.Grid), GetFaceSets(ReadMesh(reference, Encoding::Little03).Grid));
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells whose counts match a standard type are treated as one.
TEST(VisfCells, RefusesFalsePrimitives)
{
  // Two triangles, each twice.
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polyhedra = { { 0, 0, 1, 1 } };
  Result result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(result.Warnings.size(), 1u);

  // A cube with one face whose vertices are listed crosswise.
  mesh = MakeBar(1);
  std::swap(mesh.Polygons[0][1], mesh.Polygons[0][2]);
  EXPECT_EQ(ReadMesh(mesh, Encoding::Ascii).Grid->GetCellType(0), VTK_POLYHEDRON);

  // Four triangles that do not share their points.
  mesh = MakeTetrahedron();
  mesh.Points.insert(mesh.Points.end(), mesh.Points.begin(), mesh.Points.end());
  mesh.Polygons[3] = { 4, 6, 5 };
  result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(MeshView(result.Grid).GetCellPoints(0).Size, 7);

  // A triangle with a repeated vertex.
  mesh = MakeTetrahedron();
  mesh.Polygons[1] = { 1, 1, 3 };
  result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(result.Warnings.size(), 2u); // a repeated vertex, a cell that is not closed
}

//------------------------------------------------------------------------------
// An L, for which tests against a center fail, a hexagon, and the volume of prisms over them.
const std::vector<std::array<float, 2>> Outlines[] = { { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } },
                                                         { { 1, 1 } }, { { 1, 2 } }, { { 0, 2 } } },
  { { { 2, 0 } }, { { 1, 2 } }, { { -1, 2 } }, { { -2, 0 } }, { { -1, -2 } }, { { 1, -2 } } } };
constexpr double Volumes[] = { 3, 12 };

//------------------------------------------------------------------------------
// Reverses some faces, and shuffles those of the cell.
static void TurnAtRandom(VisfMesh& mesh, std::mt19937& random)
{
  for (auto& polygon : mesh.Polygons)
  {
    if (random() % 2)
    {
      std::reverse(polygon.begin() + 1, polygon.end());
    }
  }
  std::shuffle(mesh.Polyhedra[0].begin(), mesh.Polyhedra[0].end(), random);
}

//------------------------------------------------------------------------------
// If this fails, faces of polyhedra point inward for some of the orientations in which a file lists
// them.
TEST(VisfCells, TurnsFacesOutward)
{
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i)
  {
    VisfMesh mesh = MakePrism(Outlines[i % 2]);
    TurnAtRandom(mesh, random);
    const Result result = ReadMesh(mesh, Encoding::Big03);
    ASSERT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_NEAR(GetMeasure(result.Grid, 0), Volumes[i % 2], 1e-12);
  }
}

//------------------------------------------------------------------------------
// If this fails, the faces around a void point into the cell, and the void is counted as filled.
TEST(VisfCells, TurnsFacesIntoVoids)
{
  std::mt19937 random(12);
  for (int i = 0; i < 100; ++i)
  {
    VisfMesh mesh = MakePrism(Outlines[i % 2]);
    const VisfMesh inner = MakePrism(Outlines[i % 2]);
    for (const auto& p : inner.Points)
    {
      mesh.Points.push_back({ { 0.25f + p[0] / 4, 0.25f + p[1] / 4, 0.25f + p[2] / 2 } });
    }
    for (auto polygon : inner.Polygons)
    {
      for (auto& id : polygon)
      {
        id += static_cast<std::int32_t>(inner.Points.size());
      }
      mesh.Polyhedra[0].push_back(static_cast<std::int32_t>(mesh.Polygons.size()));
      mesh.Polygons.push_back(polygon);
    }
    TurnAtRandom(mesh, random);
    const Result result = ReadMesh(mesh, Encoding::Little03);
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_NEAR(GetMeasure(result.Grid, 0), Volumes[i % 2] * (1 - 1.0 / 32), 1e-12);
  }
}

//------------------------------------------------------------------------------
// If this fails, a void that touches opposite vertices of its cell is treated as part of it, as
// Euler's formula gives 2 for both.
TEST(VisfCells, VoidsThatTouchTheWall)
{
  VisfMesh mesh = MakePrism({ { { 0, 0 } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } });
  mesh.Points.push_back({ { 0.4f, 0.3f, 0.6f } });
  mesh.Points.push_back({ { 0.6f, 0.3f, 0.4f } });
  for (const std::vector<std::int32_t>& polygon :
    std::vector<std::vector<std::int32_t>>{ { 0, 8, 9 }, { 0, 6, 8 }, { 6, 8, 9 }, { 0, 6, 9 } })
  {
    mesh.Polyhedra[0].push_back(static_cast<std::int32_t>(mesh.Polygons.size()));
    mesh.Polygons.push_back(polygon);
  }
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  const auto edge = [&](int point, int c) { return result.Grid->GetPoint(point)[c]; };
  const double a[] = { edge(8, 0), edge(8, 1), edge(8, 2) },
               b[] = { edge(9, 0), edge(9, 1), edge(9, 2) };
  // Of the tetrahedron between (0, 0, 0), (1, 1, 1), a and b.
  const double sixth =
    a[1] * b[2] - a[2] * b[1] + a[2] * b[0] - a[0] * b[2] + a[0] * b[1] - a[1] * b[0];
  ASSERT_GT(std::fabs(sixth), 0.01);
  EXPECT_NEAR(GetMeasure(result.Grid, 0), 1 - std::fabs(sixth) / 6, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, both cells get a shared face with the same orientation.
TEST(VisfCells, SharedFacesPointOutwardForBothCells)
{
  VisfMesh mesh = MakeBar(5, 2);
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  double volume = 0;
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_GT(GetMeasure(result.Grid, cell), 0);
    volume += GetMeasure(result.Grid, cell);
  }
  EXPECT_NEAR(volume, 5, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, a cell that is not closed is changed instead of shown as it is.
TEST(VisfCells, KeepsOpenCells)
{
  VisfMesh mesh =
    MakePrism({ { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 1 } }, { { 0, 2 } } });
  mesh.Polyhedra[0].pop_back();
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("1 cell not closed"), std::string::npos);
  const MeshView view(result.Grid);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 2); // and the remaining polygon
  EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUAD);
  for (vtkIdType f = 0; f < view.GetPolyhedronFaces(0).Size; ++f)
  {
    const IndexRange face = view.GetPolyhedronFacePoints(view.GetPolyhedronFaces(0)[f]);
    const auto& polygon = mesh.Polygons[mesh.Polyhedra[0][f]];
    ASSERT_EQ(face.Size, static_cast<vtkIdType>(polygon.size()));
    for (vtkIdType i = 0; i < face.Size; ++i)
    {
      EXPECT_EQ(face[i], polygon[i]);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, a closed cell without volume is turned when its polygons are stored the other way
// round, so that a file changes each time that it is read and written.
TEST(VisfCells, FlatCellsDoNotDependOnDirections)
{
  std::mt19937 random(1);
  VisfMesh mesh =
    MakePrism({ { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 1 } }, { { 0, 2 } } });
  const double angle = random() % 100;
  for (auto& point : mesh.Points)
  { // in a plane in which products of coordinates are rounded
    const double x = point[0], y = point[1];
    point = { { float(x * std::cos(angle) + 0.1), float(x * std::sin(angle) + y / 3),
      float(x / 7 + y) } };
  }
  const auto getRings = [&mesh]
  {
    const Result result = ReadMesh(mesh, Encoding::Ascii);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
    const MeshView view(result.Grid);
    std::vector<std::vector<vtkIdType>> rings;
    for (const vtkIdType face : view.GetPolyhedronFaces(0))
    {
      rings.emplace_back();
      for (const vtkIdType id : view.GetPolyhedronFacePoints(face))
      {
        rings.back().push_back(id);
      }
      std::vector<vtkIdType>& ring = rings.back();
      std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    }
    return rings;
  };
  const auto rings = getRings();
  for (int i = 0; i < 10; ++i)
  {
    for (auto& polygon : mesh.Polygons)
    {
      if (random() % 2)
      {
        std::reverse(polygon.begin(), polygon.end());
      }
    }
    EXPECT_EQ(getRings(), rings);
  }
}

//------------------------------------------------------------------------------
// If this fails, two cells that are not closed have a common face with the same orientation.
TEST(VisfCells, OpenCellsShareFacesInOppositeDirections)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polyhedra = { { 0, 1, 2 }, { 1, 2 }, { 2, 2 } };
  const Result result = ReadMesh(mesh, Encoding::Little03);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 4); // and the last triangle
  // The last cell is closed and flat.
  const bool reversed[3][3] = { { false, false, false }, { true, true }, { true, false } };
  const MeshView view(result.Grid);
  for (vtkIdType cell = 0; cell < 3; ++cell)
  {
    const IndexRange faces = view.GetPolyhedronFaces(cell);
    ASSERT_EQ(faces.Size, static_cast<vtkIdType>(mesh.Polyhedra[cell].size()));
    for (vtkIdType f = 0; f < faces.Size; ++f)
    {
      const IndexRange face = view.GetPolyhedronFacePoints(faces[f]);
      const auto& polygon = mesh.Polygons[mesh.Polyhedra[cell][f]];
      EXPECT_EQ(face[0], polygon[0]);
      EXPECT_EQ(face[1], polygon[reversed[cell][f] ? 2 : 1]) << cell << " " << f;
    }
  }
}
