// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Grids of meshes given by faces whose coordinates are of any type, byte order and layout.
#include "Intake/FaceMesh/GridBuilder.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <string>

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
}
