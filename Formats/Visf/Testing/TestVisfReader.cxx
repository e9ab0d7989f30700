// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What a good Visf file becomes.
#include "TestMeshes.h"
#include "VisfSamples.h"

#include "Mesh/CellFacets.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshTopology.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

using namespace camaron;
using namespace camaron::testing;

namespace
{
constexpr std::int32_t Triangles[4][3] = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };

//------------------------------------------------------------------------------
VisfMesh MakeTetrahedron()
{
  VisfMesh mesh;
  mesh.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  for (const auto& triangle : Triangles)
  {
    mesh.Polygons.push_back({ triangle[0], triangle[1], triangle[2] });
  }
  mesh.Polyhedra = { { 0, 1, 2, 3 } };
  return mesh;
}

//------------------------------------------------------------------------------
// Volume by the divergence theorem over plane faces; positive if they point outward.
double GetVolume(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const MeshView mesh(grid);
  double volume = 0;
  CellFacets(mesh).ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType)
    {
      double a[3], b[3], c[3];
      mesh.GetPoint(points[0], a);
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        mesh.GetPoint(points[i], b);
        mesh.GetPoint(points[i + 1], c);
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                    a[2] * (b[0] * c[1] - b[1] * c[0])) /
          6;
      }
    });
  return volume;
}

//------------------------------------------------------------------------------
// A prism over a polygon in the plane; faces run as they come.
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
std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
  {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

//------------------------------------------------------------------------------
// Faces of all cells, each face as a set, to compare meshes whose faces run differently.
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
// If this fails, the smallest files of each kind do not open.
TEST(VisfReader, SmallestMeshes)
{
  for (const Encoding encoding : Encodings)
  {
    VisfMesh mesh;
    mesh.Type = 0;
    Result result = ReadMesh(mesh, encoding);
    EXPECT_TRUE(result.IsEmpty());
    EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];

    mesh.Points = { { { 1.5f, -2, 3e10f } } };
    result = ReadMesh(mesh, encoding);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_VERTEX);
    EXPECT_EQ(result.Grid->GetPoint(0)[2], double(3e10f));
    EXPECT_TRUE(result.Warnings.empty());

    mesh = MakeTetrahedron();
    mesh.Type = 1;
    mesh.Polyhedra.clear();
    result = ReadMesh(mesh, encoding);
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), 4);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 4);
    EXPECT_TRUE(result.Warnings.empty());

    result = ReadMesh(MakeTetrahedron(), encoding);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_TETRA);
    EXPECT_NEAR(GetVolume(result.Grid, 0), 1. / 6, 1e-12);
    EXPECT_TRUE(result.Warnings.empty());
  }
}

//------------------------------------------------------------------------------
// If this fails, the encodings of one mesh give different grids.
TEST(VisfReader, EncodingsAgree)
{
  const VisfMesh mesh = MakeBar(7, 3);
  const Result expected = ReadMesh(mesh, Encoding::Ascii);
  ASSERT_TRUE(expected.Errors.empty());
  EXPECT_EQ(Count(expected.Grid, VTK_WEDGE), 6);
  EXPECT_EQ(Count(expected.Grid, VTK_POLYHEDRON), 1);
  EXPECT_EQ(Count(expected.Grid, VTK_HEXAHEDRON), 3);
  for (const Encoding encoding : Encodings)
  {
    const Result result = ReadMesh(mesh, encoding);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    ExpectSameGrid(result.Grid, expected.Grid);
  }
}

//------------------------------------------------------------------------------
// If this fails, a v0.1 file whose first bytes look like another version is not told apart.
TEST(VisfReader, HeaderlessFilesOfAllSizes)
{
  for (const Encoding encoding : { Encoding::Little01, Encoding::Big01 })
  {
    for (const int points : { 0, 1, 2, 255, 256, 257, 512, 65536 })
    {
      VisfMesh mesh;
      mesh.Type = 0;
      mesh.Points.resize(points);
      const Result result = ReadMesh(mesh, encoding);
      EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_EQ(result.Grid->GetNumberOfPoints(), points);
      if (points > 2)
      {
        mesh.Type = 1;
        mesh.Polygons = { { 0, 1, 2 } };
        EXPECT_EQ(ReadMesh(mesh, encoding).Grid->GetNumberOfCells(), 1);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, a cell of a standard type comes out as another type, inside out or with wrong nodes,
// for some order or direction of its faces.
TEST(VisfReader, RecognisesPrimitives)
{
  std::mt19937 random(7);
  for (const int type : { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON })
  {
    const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
    VisfMesh reference;
    // Places that make a positive cell in VTK's order; its wedge has (0,1,2) facing out.
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
      reference.Polygons.emplace_back(shape.FacePoints + shape.FaceOffsets[f],
        shape.FacePoints + shape.FaceOffsets[f + 1]);
    }
    reference.Polyhedra.emplace_back(shape.NumberOfFaces);
    std::iota(reference.Polyhedra[0].begin(), reference.Polyhedra[0].end(), 0);

    // Faces in VTK's order give the nodes back.
    Result result = ReadMesh(reference, Encoding::Little03);
    ASSERT_EQ(result.Grid->GetCellType(0), type);
    for (int node = 0; node < shape.NumberOfCorners; ++node)
    {
      EXPECT_EQ(MeshView(result.Grid).GetCellPoints(0)[node], node);
    }
    const double volume = GetVolume(result.Grid, 0);
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
      if (i % 2) // the mirror image, which must not come out inverted
      {
        for (auto& point : mesh.Points)
        {
          point[0] = -point[0];
        }
      }
      result = ReadMesh(mesh, Encoding::Little03);
      ASSERT_EQ(result.Grid->GetCellType(0), type);
      EXPECT_NEAR(GetVolume(result.Grid, 0), volume, 1e-12);
      EXPECT_EQ(GetFaceSets(result.Grid), GetFaceSets(ReadMesh(reference, Encoding::Little03).Grid));
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells that only look like a standard type by their numbers are taken for one.
TEST(VisfReader, RefusesFalsePrimitives)
{
  // Two triangles, each twice.
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polyhedra = { { 0, 0, 1, 1 } };
  Result result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(result.Warnings.size(), 1u);

  // A cube with one face whose corners are given crosswise.
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

  // A triangle with the same corner twice.
  mesh = MakeTetrahedron();
  mesh.Polygons[1] = { 1, 1, 3 };
  result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(result.Warnings.size(), 2u); // a repeated vertex, a cell that is not closed
}

//------------------------------------------------------------------------------
// An L, which no test against a centre gets right, and a hexagon; and what prisms over them hold.
const std::vector<std::array<float, 2>> Outlines[] = {
  { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 1 } }, { { 1, 2 } }, { { 0, 2 } } },
  { { { 2, 0 } }, { { 1, 2 } }, { { -1, 2 } }, { { -2, 0 } }, { { -1, -2 } }, { { 1, -2 } } }
};
constexpr double Volumes[] = { 3, 12 };

//------------------------------------------------------------------------------
// Some faces the other way round, and those of the cell in another order.
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
// If this fails, faces of polyhedra point inward for some of the directions in which a file lists them.
TEST(VisfReader, TurnsFacesOutward)
{
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i)
  {
    VisfMesh mesh = MakePrism(Outlines[i % 2]);
    TurnAtRandom(mesh, random);
    const Result result = ReadMesh(mesh, Encoding::Big03);
    ASSERT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_NEAR(GetVolume(result.Grid, 0), Volumes[i % 2], 1e-12);
  }
}

//------------------------------------------------------------------------------
// If this fails, the faces around a void point into the cell, and the void counts as if it were filled twice.
TEST(VisfReader, TurnsFacesIntoVoids)
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
    EXPECT_NEAR(GetVolume(result.Grid, 0), Volumes[i % 2] * (1 - 1.0 / 32), 1e-12);
  }
}

//------------------------------------------------------------------------------
// If this fails, a void from corner to corner of its cell is taken for a part of it, as Euler's formula has 2 for both.
TEST(VisfReader, VoidsThatTouchTheWall)
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
  const double a[] = { edge(8, 0), edge(8, 1), edge(8, 2) }, b[] = { edge(9, 0), edge(9, 1), edge(9, 2) };
  // Of the tetrahedron between (0, 0, 0), (1, 1, 1), a and b.
  const double sixth = a[1] * b[2] - a[2] * b[1] + a[2] * b[0] - a[0] * b[2] + a[0] * b[1] - a[1] * b[0];
  ASSERT_GT(std::fabs(sixth), 0.01);
  EXPECT_NEAR(GetVolume(result.Grid, 0), 1 - std::fabs(sixth) / 6, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, a shared face is given to both cells in the same direction.
TEST(VisfReader, SharedFacesPointOutwardForBothCells)
{
  VisfMesh mesh = MakeBar(5, 2);
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  double volume = 0;
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_GT(GetVolume(result.Grid, cell), 0);
    volume += GetVolume(result.Grid, cell);
  }
  EXPECT_NEAR(volume, 5, 1e-12);
}

//------------------------------------------------------------------------------
// If this fails, a cell that is not closed is changed instead of being shown as it is.
TEST(VisfReader, KeepsOpenCells)
{
  VisfMesh mesh = MakePrism({ { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 1, 1 } }, { { 0, 2 } } });
  mesh.Polyhedra[0].pop_back();
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("1 cell not closed"), std::string::npos);
  const MeshView view(result.Grid);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 2); // and the polygon that is left over
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
// If this fails, two cells that are not closed have a common face in the same direction.
TEST(VisfReader, OpenCellsShareFacesInOppositeDirections)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polyhedra = { { 0, 1, 2 }, { 1, 2 }, { 2, 2 } };
  const Result result = ReadMesh(mesh, Encoding::Little03);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 4); // and the last triangle
  const bool reversed[3][3] = { { false, false, false }, { true, true }, { false, true } };
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

//------------------------------------------------------------------------------
// If this fails, cells and polygons lose the order of the file, or polygons without cells are lost.
TEST(VisfReader, PolygonsWithoutCellsFollow)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Polygons.insert(mesh.Polygons.begin(), { 3, 1, 0 }); // same points as a face of the cell
  mesh.Polygons.push_back({ 0, 1 });
  mesh.Polygons.push_back({ 2 });
  mesh.Polygons.push_back({});
  mesh.Polygons.push_back({ 0, 1, 2, 3 });
  mesh.Polygons.push_back({ 0, 1, 2, 3, 0 });
  mesh.Polyhedra = { {}, { 1, 2, 3, 4 } };
  mesh.Points.push_back({ { 9, 9, 9 } }); // of no polygon
  const Result result = ReadMesh(mesh, Encoding::Ascii);
  EXPECT_TRUE(result.Errors.empty());
  const int expected[] = { VTK_EMPTY_CELL, VTK_TETRA, VTK_TRIANGLE, VTK_LINE, VTK_VERTEX, VTK_QUAD,
    VTK_POLYGON };
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 7);
  for (vtkIdType cell = 0; cell < 7; ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell), expected[cell]);
  }
  EXPECT_EQ(MeshView(result.Grid).GetCellPoints(2)[0], 3);
  EXPECT_EQ(result.Grid->GetNumberOfPoints(), 5);
  // No vertices, fewer than 3, the same twice (0,1,2,3,0), no polygons.
  EXPECT_EQ(result.Warnings.size(), 4u);
}

//------------------------------------------------------------------------------
// If this fails, text that people or other programs write is refused or misread.
TEST(VisfReader, TextInAllItsForms)
{
  VisfMesh mesh = MakeBar(3, 1);
  mesh.Neighbors.resize(mesh.Polygons.size(), { 0, 1 });
  const std::string text = Encode(mesh, Encoding::Ascii);
  const Result expected = ReadBytes(text);
  ASSERT_TRUE(expected.Errors.empty());
  const std::string forms[] = {
    Replace(text, "\n", "\r\n"),
    Replace(text, "\n", "\r"),
    "\xef\xbb\xbf" + text,
    "# Generated by hand\n\n  # and again\n" + text,
    Replace(text, "\n", "\n\n \t\n# between 1 2 3\n"),
    Replace(text, " ", " \t "),
    Replace(text, " \n", "   # 1 2 3\n"),
    Replace(text, "\n", "\r\n# a comment\r\n"),
    text.substr(0, text.size() - 2), // no last newline
    "\n\n" + text + "\n\n# the end",
  };
  for (const std::string& form : forms)
  {
    const Result result = ReadBytes(form);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
    ExpectSameGrid(result.Grid, expected.Grid);
  }
  // Extra columns: colours, normals, text. Not in the lists of neighbours, which are free.
  mesh.Neighbors.clear();
  const std::string plain = Encode(mesh, Encoding::Ascii);
  ExpectSameGrid(ReadBytes(Replace(plain, "\n", "0.5 0.5 x\n")).Grid, expected.Grid);
  ExpectSameGrid(
    ReadBytes(Replace(Encode(mesh, Encoding::Web), "\n", " 255 0 0\n")).Grid, expected.Grid);
  // One record over several lines.
  ExpectSameGrid(
    ReadBytes(Replace(Replace(plain, "2 2 \n", "2\n2\n"), " 0 ", "\n0\n")).Grid, expected.Grid);
}

//------------------------------------------------------------------------------
// If this fails, coordinates lose bits, or depend on the user's language.
TEST(VisfReader, ReadsNumbersExactly)
{
  const std::string head = "2 0\n7\n";
  const std::string text = head +
    "0.1 1e-45 3.4028235e38\n+1.5 -.5 5.\n1.0D+00 1d-1 2.E2\n"
    "16777217 33554435 0.500000029802322388\n1.17549430e-38 7e-46 1e39\nnan inf -INF\n-0 0 1e-400\n";
  const float expected[] = { 0.1f, 1e-45f, 3.4028235e38f, 1.5f, -.5f, 5.f, 1.f, .1f, 200.f,
    16777216.f, 33554436.f, 0.50000006f, 1.17549430e-38f, 0.f, INFINITY, NAN, INFINITY, -INFINITY, -0.f,
    0.f, 0.f };
  const Result result = ReadBytes(text);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  for (int i = 0; i < 21; ++i)
  {
    const auto value =
      static_cast<float>(result.Grid->GetPoints()->GetData()->GetComponent(i / 3, i % 3));
    if (std::isnan(expected[i]))
    {
      EXPECT_TRUE(std::isnan(value));
      continue;
    }
    EXPECT_EQ(value, expected[i]) << i;
    EXPECT_EQ(std::signbit(value), std::signbit(expected[i])) << i;
  }
  ASSERT_EQ(result.Warnings.size(), 1u); // 1e39 overflows; nan and inf
  EXPECT_NE(result.Warnings[0].find("2 vertices with a coordinate that is not finite, the first is "
                                    "vertex 4"),
    std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, a file says one thing and holds another without a word, or is refused for it.
TEST(VisfReader, WarnsOfOddHeaders)
{
  VisfMesh mesh = MakeTetrahedron();
  mesh.Type = 0;
  Result result = ReadMesh(mesh, Encoding::Little03);
  EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("polyhedron mesh (2)"), std::string::npos);

  for (const Encoding encoding : Encodings)
  {
    result = ReadBytes(Encode(MakeBar(2), encoding) + "more");
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 2);
    EXPECT_EQ(result.Warnings.size(), 1u);
  }
  // No polygons: the flag may be there or not.
  for (const char* tail : { "0\n", "0\n0\n", "0\n0\n0\n" })
  {
    result = ReadBytes(std::string("2 0\n1\n1 2 3\n") + tail);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_TRUE(result.Warnings.empty());
  }
  result = ReadBytes("2 0\n1\n1 2 3\n0\n0\n7\n");
  EXPECT_EQ(result.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
// If this fails, the faces of a file with polyhedra are not those that MeshTopology finds by itself.
TEST(VisfReader, HandsOverTheRightFaces)
{
  for (const int wedges : { 0, 2 })
  {
    VisfMesh mesh = MakeBar(6, wedges);
    std::reverse(mesh.Polyhedra[3].begin(), mesh.Polyhedra[3].end());
    // A face given twice, once for each of its cells.
    const std::int32_t twin = mesh.Polyhedra.back().front();
    mesh.Polygons.push_back(mesh.Polygons[twin]);
    mesh.Polyhedra.back().front() = static_cast<std::int32_t>(mesh.Polygons.size() - 1);
    const Result result = ReadMesh(mesh, Encoding::Ascii);
    auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    copy->DeepCopy(result.Grid);
    const FacetTable& given = MeshTopology(result.Grid).GetFaces();
    const FacetTable& found = MeshTopology(copy).GetFaces();
    ASSERT_EQ(given.GetNumberOfFacets(), found.GetNumberOfFacets());
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      for (Index f = 0; f < found.GetCellFacets(cell).size(); ++f)
      {
        EXPECT_EQ(given.GetCellFacets(cell)[f].Packed, found.GetCellFacets(cell)[f].Packed);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, arrays are larger than need be: every entry must be in use, in 32 bits.
TEST(VisfReader, ArraysAreExact)
{
  const Result result = ReadMesh(MakeBar(9, 4), Encoding::Little03);
  vtkCellArray* const lists[] = { result.Grid->GetCells(), result.Grid->GetPolyhedronFaces(),
    result.Grid->GetPolyhedronFaceLocations() };
  for (vtkCellArray* list : lists)
  {
    EXPECT_FALSE(list->IsStorage64Bit());
    EXPECT_EQ(list->GetConnectivityArray()->GetSize(), list->GetNumberOfConnectivityIds());
    EXPECT_EQ(list->GetOffsetsArray()->GetSize(), list->GetNumberOfCells() + 1);
  }
  EXPECT_EQ(result.Grid->GetPoints()->GetData()->GetSize(), 3 * result.Grid->GetNumberOfPoints());
  // No face belongs to two cells.
  EXPECT_EQ(result.Grid->GetPolyhedronFaces()->GetNumberOfCells(),
    result.Grid->GetPolyhedronFaceLocations()->GetNumberOfConnectivityIds());
}

//------------------------------------------------------------------------------
// If this fails, a reader that is stopped leaves half a mesh, or does not stop.
TEST(VisfReader, StopsWhenAsked)
{
  const File file(Encode(MakeBar(50000), Encoding::Little03));
  vtkNew<vtkVisfReader> reader;
  reader->SetFileName(file.Path.c_str());
  int reports = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&reports);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  reader->AddObserver(vtkCommand::ProgressEvent, count);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 50000);
  EXPECT_GT(reports, 10);
  EXPECT_LT(reports, 150);

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkVisfReader*>(caller)->SetAbortExecuteAndUpdateTime(); });
  reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// If this fails, files of other programs do not open. Numbers from an independent counter.
TEST(VisfReader, CollectedFiles)
{
  const char* folder = std::getenv("CAMARON_SHARED_DATA");
  if (!folder || !std::filesystem::exists(std::filesystem::path(folder) / "visf"))
  {
    GTEST_SKIP() << "CAMARON_SHARED_DATA names no folder with visf files";
  }
  using Counts = std::map<int, vtkIdType>;
  const Counts mixed = { { VTK_TETRA, 60 }, { VTK_PYRAMID, 60 }, { VTK_WEDGE, 60 },
    { VTK_HEXAHEDRON, 60 } };
  const Counts quads = { { VTK_QUAD, 6 } };
  const struct
  {
    const char* Name;
    vtkIdType Points;
    Counts Cells;
  } files[] = {
    { "camaron_ascii", 8, { { VTK_HEXAHEDRON, 1 } } },
    { "camaron_big_endian", 8, quads },
    { "camaron_hr3", 414, { { VTK_TETRA, 32 }, { VTK_PYRAMID, 68 }, { VTK_HEXAHEDRON, 256 } } },
    { "camaron_little_endian", 8, quads },
    { "camaron_old_v01_headerless", 8, quads },
    { "camaron_polyhedron_mesh", 8, { { VTK_HEXAHEDRON, 1 } } },
    { "camaron_vertex_cloud", 8, { { VTK_VERTEX, 8 } } },
    { "dev_cloud_v03_big", 231, { { VTK_VERTEX, 231 } } },
    { "dev_mixed_ascii_crlf_comments", 331, mixed },
    { "dev_mixed_ascii_web_dialect", 331, mixed },
    { "dev_mixed_v01_headerless", 331, mixed },
    { "dev_mixed_v02_big", 331, mixed },
    { "dev_mixed_v02_little", 331, mixed },
    { "dev_mixed_v03_big", 331, mixed },
    { "dev_mixed_v03_little_noneigh", 331, mixed },
    { "dev_surface_v03_big", 231, { { VTK_QUAD, 202 }, { VTK_POLYGON, 18 } } },
    { "polylla_basic", 8, { { VTK_POLYHEDRON, 1 } } },
    { "polylla_minimal_dupfaces", 8, { { VTK_POLYHEDRON, 1 }, { VTK_TRIANGLE, 4 } } },
    { "polylla_socket_dupfaces", 836,
      { { VTK_POLYHEDRON, 304 }, { VTK_TETRA, 55 }, { VTK_TRIANGLE, 1926 } } },
  };
  for (const auto& file : files)
  {
    const auto path = std::filesystem::path(folder) / "visf" / (std::string(file.Name) + ".visf");
    vtkNew<vtkVisfReader> reader;
    EXPECT_EQ(reader->CanReadFile(path.string().c_str()), 1) << file.Name;
    const Result result = ReadFile(path.string());
    EXPECT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points) << file.Name;
    Counts counts;
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      ++counts[result.Grid->GetCellType(cell)];
      if (result.Grid->GetCell(cell)->GetCellDimension() == 3 && result.Warnings.empty())
      {
        EXPECT_GT(GetVolume(result.Grid, cell), 0) << file.Name << " cell " << cell;
      }
    }
    EXPECT_EQ(counts, file.Cells) << file.Name;
  }
}
