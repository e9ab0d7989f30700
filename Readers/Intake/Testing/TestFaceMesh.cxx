// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids of meshes given by faces whose coordinates are of any type, byte order and layout.
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/FacesOfCells.h"
#include "Intake/FaceMesh/GridBuilder.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{
using namespace camaron;

// Far from the origin, where floats are 0.25 apart; so are these places, and 0.001 is lost in them.
constexpr double Far = 3e6;
constexpr double Places[4][3] = { { Far, Far, Far + 0.001 }, { Far + 1, Far, Far },
  { Far, Far + 1, Far }, { Far, Far, Far + 1 } };

// The bytes of points, each with some bytes before and after it.
template <typename Real>
std::string PackPoints(bool swap, std::size_t before, std::size_t after)
{
  std::string bytes;
  for (const auto& place : Places)
  {
    bytes.append(before, '\x7f');
    for (const double x : place)
    {
      AppendBytes(bytes, static_cast<Real>(x), swap);
    }
    bytes.append(after, '\x7f');
  }
  return bytes;
}

// A tetrahedron by its faces.
FaceMesh MakeTetrahedron(const PointSource& points)
{
  static const std::int32_t faces[] = { 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3 };
  static const std::int32_t cells[] = { 4, 0, 1, 2, 3 };
  FaceMesh mesh;
  mesh.Points = points;
  const auto scan = [](const std::int32_t* words, std::size_t size, vtkIdType count,
                      vtkIdType limit, IdSet* used, IdLists& lists)
  {
    const char* bytes = reinterpret_cast<const char*>(words);
    BinaryScanner scanner("", bytes, bytes + size, GetByteOrder());
    IdLists::Expectation expected;
    expected.Limit = limit;
    expected.Used = used;
    EXPECT_TRUE(lists.Scan(scanner, count, expected, Progress()));
  };
  scan(faces, sizeof(faces), 4, 4, nullptr, mesh.Faces);
  mesh.FacesOfCells = IdSet(4);
  scan(cells, sizeof(cells), 1, 4, &mesh.FacesOfCells, mesh.Cells);
  return mesh;
}

template <typename Real>
void ExpectTetrahedron(FaceMesh mesh, int type)
{
  vtkNew<vtkUnstructuredGrid> grid;
  Warnings warnings;
  ScanError error;
  ASSERT_TRUE(BuildGrid(mesh, PieceRequest(), grid, warnings, error, Progress()));
  ASSERT_EQ(grid->GetNumberOfCells(), 1);
  EXPECT_EQ(grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(grid->GetPoints()->GetDataType(), type);
  for (int i = 0; i < 4; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(grid->GetPoint(i)[c], static_cast<Real>(Places[i][c])) << i << " " << c;
    }
  }
}

//------------------------------------------------------------------------------
// Fails if points lose precision, or bytes or strides are mistaken.
template <typename Real>
void TestSources(int type)
{
  for (const bool swap : { false, true })
  {
    for (const std::size_t gap : { 0, 5 })
    {
      const std::string bytes = PackPoints<Real>(swap, gap, 2 * gap);
      const PointSource points(
        bytes.data() + gap, 4, type == VTK_DOUBLE, swap, gap > 0 ? 3 * sizeof(Real) + 3 * gap : 0);
      ExpectTetrahedron<Real>(MakeTetrahedron(points), type);
    }
  }
}

TEST(FaceMesh, PointsHaveThePrecisionOfTheSource)
{
  TestSources<float>(VTK_FLOAT);
  TestSources<double>(VTK_DOUBLE);
}

//------------------------------------------------------------------------------
// Fails if the grid copies, or loses, coordinates that the mesh owns.
TEST(FaceMesh, TheGridTakesOwnedCoordinates)
{
  Buffer<double> coordinates(12);
  std::copy(&Places[0][0], &Places[0][0] + 12, coordinates.data());
  FaceMesh mesh =
    MakeTetrahedron(PointSource(reinterpret_cast<const char*>(coordinates.data()), 4, true));
  const double* memory = coordinates.data();
  mesh.Doubles = std::move(coordinates);
  vtkNew<vtkUnstructuredGrid> grid;
  Warnings warnings;
  ScanError error;
  ASSERT_TRUE(BuildGrid(mesh, PieceRequest(), grid, warnings, error, Progress()));
  EXPECT_EQ(grid->GetPoints()->GetVoidPointer(0), memory);
  EXPECT_EQ(grid->GetPoint(0)[2], Places[0][2]);
}

//------------------------------------------------------------------------------
Buffer<std::int32_t> Pack(const std::vector<std::int32_t>& values)
{
  Buffer<std::int32_t> buffer(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), buffer.data());
  return buffer;
}

//------------------------------------------------------------------------------
// Faces with one cell, two cells, the same one twice and none; the last cell has no face.
TEST(FaceMesh, ListsFacesOfCellsByTheirSides)
{
  const Buffer<std::int32_t> words =
    ListFacesOfCells(Pack({ 1, -1, 0, -1, 2, 2, 1, 0, -1, 0, 0, -1 }), 4);
  const std::vector<std::int32_t> found(words.data(), words.data() + words.size());
  EXPECT_EQ(found, (std::vector<std::int32_t>{ 4, 1, 3, 4, 5, 2, 0, 3, 2, 2, 2, 0 }));
}

//------------------------------------------------------------------------------
// A tetrahedron whose faces point outward, and one whose faces point inward: it is inverted, and
// stays so. If a type is declared that does not fit, they are polyhedra, and all faces point
// outward.
TEST(FaceMesh, SidesDefineTheOrientation)
{
  for (const int variant : { 0, 1, 2, 3 })
  {
    const bool isInward = variant % 2 == 1, isPolyhedron = variant >= 2;
    FaceMesh mesh = MakeTetrahedron(PointSource());
    mesh.HasSides = true;
    mesh.Points.Count = 4;
    const std::int32_t first = isInward ? 0 : -1, second = -1 - first;
    mesh.Sides = Pack({ first, second, first, second, first, second, first, second });
    mesh.Types = Buffer<unsigned char>(1);
    mesh.Types[0] = isPolyhedron ? VTK_WEDGE : VTK_TETRA;
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(BuildGrid(mesh, PieceRequest(), grid, warnings, error, Progress()));
    ASSERT_EQ(grid->GetCellType(0), isPolyhedron ? VTK_POLYHEDRON : VTK_TETRA);
    vtkNew<vtkIdList> ids;
    if (isPolyhedron)
    {
      grid->GetFaceStream(0, ids);
      ASSERT_EQ(ids->GetNumberOfIds(), 17);
      EXPECT_EQ(ids->GetId(2), 0); // of the face 0 2 1
      EXPECT_EQ(ids->GetId(3), isInward ? 1 : 2);
      continue;
    }
    grid->GetCells()->GetCellAtId(0, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 4);
    double x[4][3] = {};
    for (int i = 0; i < 4; ++i)
    {
      if (const vtkIdType point = ids->GetId(i); point > 0)
      {
        x[i][point - 1] = 1;
      }
    }
    double edges[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(x[i + 1], x[0], edges[i]);
    }
    EXPECT_EQ(vtkMath::Determinant3x3(edges[0], edges[1], edges[2]) > 0, !isInward);
  }
}

//------------------------------------------------------------------------------
// Fails if a piece of a mesh with sides loses its points, its orientation or the order of its
// faces.
TEST(FaceMesh, SidesDefineTheOrientationInPieces)
{
  for (const std::int32_t first : { 0, -1 })
  {
    int found = 0;
    for (int piece = 0; piece < 2; ++piece)
    {
      const std::string bytes = PackPoints<double>(false, 0, 0);
      FaceMesh mesh = MakeTetrahedron(PointSource(bytes.data(), 4, true));
      const std::int32_t second = -1 - first;
      mesh.HasSides = true;
      mesh.Sides = Pack({ first, second, first, second, first, second, first, second });
      mesh.PointsOfFaces = IdSet(4);
      mesh.PointsOfFaces.AddMissing(IdSet(4)); // all
      vtkNew<vtkUnstructuredGrid> grid;
      Warnings warnings;
      ScanError error;
      ASSERT_TRUE(BuildGrid(mesh, { piece, 2, 0 }, grid, warnings, error, Progress()));
      if (grid->GetNumberOfCells() == 0)
      {
        continue;
      }
      ++found;
      vtkNew<vtkIdList> ids;
      grid->GetCells()->GetCellAtId(0, ids);
      ASSERT_EQ(ids->GetNumberOfIds(), 4);
      double edges[3][3];
      for (int i = 0; i < 3; ++i)
      {
        double origin[3];
        grid->GetPoint(ids->GetId(0), origin);
        vtkMath::Subtract(grid->GetPoint(ids->GetId(i + 1)), origin, edges[i]);
      }
      EXPECT_EQ(vtkMath::Determinant3x3(edges[0], edges[1], edges[2]) > 0, first < 0);
    }
    EXPECT_EQ(found, 1);
  }
}

//------------------------------------------------------------------------------
// Edges in any order, that pass a point twice, with loops, and that are not closed.
TEST(FaceMesh, RingsOfEdges)
{
  CellRing ring;
  const auto make = [&ring](const std::vector<std::int32_t>& points)
  {
    std::vector<IdList> edges;
    std::vector<FaceDirection> directions;
    for (std::size_t i = 0; i < points.size(); i += 2)
    {
      edges.push_back({ reinterpret_cast<const char*>(&points[i]), 2, 0 });
      directions.push_back(i % 4 == 0 ? FaceDirection::Inward : FaceDirection::Outward);
    }
    const auto size = static_cast<std::int32_t>(edges.size());
    return ring.Make(edges.data(), directions.data(), size) ? ring.GetPoints()
                                                            : std::vector<std::int32_t>();
  };
  using Points = std::vector<std::int32_t>;
  EXPECT_EQ(make({ 4, 7, 9, 7, 9, 2, 4, 2 }), (Points{ 4, 7, 9, 2 }));
  EXPECT_EQ(make({ 0, 1, 2, 1, 2, 0, 3, 0, 3, 4, 0, 4 }), (Points{ 0, 1, 2, 0, 3, 4 }));
  EXPECT_EQ(make({ 4, 7, 7, 7, 7, 2, 4, 2 }), (Points{ 4, 7, 7, 2 }));
  EXPECT_EQ(make({ 0, 1, 0, 1, 0, 3, 0, 3, 0, 0 }), (Points{ 0, 0, 1, 0, 3 }));
  EXPECT_EQ(make({ 0, 1, 0, 1, 0, 3, 0, 3, 0, 0, 5, 5 }), Points());
  EXPECT_EQ(make({ 4, 7, 9, 7, 9, 2, 2, 4 }), Points()); // the last edge runs the other way
  EXPECT_EQ(make({ 4, 7, 4, 7, 2, 3, 2, 3 }), Points()); // two parts
  EXPECT_EQ(make({ 4, 7, 4, 7, 5, 5 }), Points());       // a loop elsewhere
}
}
