// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells created from the faces of a Fluent file: identical for all methods, threads and pieces.
#include "FluentMeshReading.h"
#include "FluentMeshSamples.h"

#include "Intake/Rows/TextLines.h"
#include "Mesh/MeshTopology.h"
#include "Sanitized.h"

#include "vtkSMPTools.h"

#include <random>
#include <utility>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// A cube of hexahedra.
FluentSample MakeHexahedra(int size)
{
  FluentSample mesh;
  const auto point = [size](int i, int j, int k) { return i + (size + 1) * (j + (size + 1) * k); };
  for (int p = 0; p < (size + 1) * (size + 1) * (size + 1); ++p)
  {
    mesh.AddPoint(p % (size + 1), p / (size + 1) % (size + 1), p / ((size + 1) * (size + 1)));
  }
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int k = 0; k < size; ++k)
      {
        mesh.AddVTKCell(4, VTK_HEXAHEDRON,
          { point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k), point(i, j + 1, k),
            point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1),
            point(i, j + 1, k + 1) });
      }
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Cubes of six tetrahedra along a line.
FluentSample MakeTetrahedra(int size)
{
  FluentSample mesh;
  for (int p = 0; p < 4 * (size + 1); ++p)
  {
    mesh.AddPoint(p / 4, p % 2, p / 2 % 2);
  }
  // Along the edges of the cube from its first to its last vertex.
  const int steps[6][2] = { { 4, 1 }, { 1, 2 }, { 2, 4 }, { 1, 4 }, { 2, 1 }, { 4, 2 } };
  for (int i = 0; i < size; ++i)
  {
    for (const auto& step : steps)
    {
      const int a = 4 * i, b = a + step[0], c = b + step[1];
      mesh.AddVTKCell(2, VTK_TETRA, { a, b, c, a + 7 });
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Polyhedra; pairs need not be connected, and may have a face on both sides.
FluentSample MakePolyhedra(int columns, bool arePairs)
{
  FluentSample mesh = MakeMixed(columns);
  if (arePairs)
  {
    mesh.Cells.resize((mesh.Cells.size() + 1) / 2);
    for (FluentSample::Face& face : mesh.Faces)
    {
      for (int& cell : face.Cells)
      {
        cell = cell < 0 ? cell : cell / 2;
      }
    }
  }
  for (FluentSample::Cell& cell : mesh.Cells)
  {
    cell.Element = 7;
  }
  return mesh;
}
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(FluentMeshCells, ThreadsAndChunksChangeNothing)
{
  for (const FluentSample& mesh :
    { MakeMixed(60), MakeFlat(200), MakeTetrahedra(50), MakePolyhedra(60, true) })
  {
    for (const FluentEncoding& how : GetEncodings())
    {
      const File file(Encode(mesh, how), "test.msh");
      vtkNew<vtkUnstructuredGrid> expected;
      Warnings warnings;
      ScanError error;
      ASSERT_TRUE(ReadFluentMesh(file.Path, {}, expected, nullptr, warnings, error, Progress()));
      EXPECT_EQ(expected->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
      for (const int threads : IsSanitized ? std::vector<int>{ 3 } : std::vector<int>{ 1, 3 })
      {
        for (const vtkIdType chunk : { 50, 1000, 20000 })
        {
          vtkNew<vtkUnstructuredGrid> grid;
          const vtkIdType usual = std::exchange(TextLines::DefaultChunk, chunk);
          vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
            [&]
            {
              ASSERT_TRUE(ReadFluentMesh(file.Path, {}, grid, nullptr, warnings, error, Progress()))
                << error.Message;
            });
          TextLines::DefaultChunk = usual;
          ExpectSameGrid(expected, grid);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells of standard types, which are created while the faces are read, differ from
// those created from all faces of a cell, as cells of unknown type are. Faces come in any order,
// with any first node and any orientation.
TEST(FluentMeshCells, BothWaysFindTheSameNodes)
{
  std::mt19937 random(5);
  for (FluentSample mesh : { MakeMixed(40), MakeFlat(2), MakeHexahedra(4), MakeTetrahedra(9) })
  {
    for (int round = 0; round < 20; ++round)
    {
      std::shuffle(mesh.Faces.begin(), mesh.Faces.end(), random);
      for (FluentSample::Face& face : mesh.Faces)
      {
        face.Zone = 9; // one section
        std::rotate(face.Nodes.begin(),
          face.Nodes.begin() + (mesh.Dimension == 3 ? random() % face.Nodes.size() : 0),
          face.Nodes.end());
        if (random() % 2)
        {
          std::reverse(face.Nodes.begin(), face.Nodes.end());
          std::swap(face.Cells[0], face.Cells[1]);
        }
      }
      for (const int size : { 0, 4 })
      {
        FluentEncoding how;
        how.RealSize = size;
        how.Uniform = round % 2 == 1;
        FluentSample unknown = mesh;
        for (FluentSample::Cell& cell : unknown.Cells)
        {
          cell.Element = 0;
        }
        const Result standard = ReadBytes(Encode(mesh, how));
        const Result general = ReadBytes(Encode(unknown, how));
        ASSERT_TRUE(standard.Errors.empty() && general.Errors.empty());
        ExpectSameGrid(standard.Grid, general.Grid);
        EXPECT_TRUE(standard.Warnings.empty());
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, tetrahedra are created from wrong faces: the sums of node ids alone do not
// distinguish 1 5 6 from 3 4 5.
TEST(FluentMeshCells, SumsOfNodesAreNotEnough)
{
  FluentSample mesh;
  for (int p = 0; p < 6; ++p)
  {
    mesh.AddPoint(p % 2, p % 3, p * p);
  }
  mesh.AddVTKCell(2, VTK_TETRA, { 2, 3, 4, 5 });
  ASSERT_EQ(ReadBytes(Encode(mesh)).Grid->GetCellType(0), VTK_TETRA);
  for (FluentSample::Face& face : mesh.Faces)
  {
    std::vector<int> sorted = face.Nodes;
    std::sort(sorted.begin(), sorted.end());
    if (sorted == std::vector<int>{ 2, 3, 4 })
    {
      for (int& node : face.Nodes)
      {
        node = node == 2 ? 0 : node + 1;
      }
    }
  }
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_POLYHEDRON);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(
    result.Warnings[0].find("1 cell whose faces do not match the declared type"), std::string::npos)
    << result.Warnings[0];
}

//------------------------------------------------------------------------------
TEST(FluentMeshCells, PiecesMakeTheWhole)
{
  FluentSample orphans = MakeMixed(6);
  orphans.AddPoint(9, 9, 9);
  for (const FluentSample& mesh :
    { orphans, MakePolyhedra(6, false), MakePolyhedra(6, true), MakeFlat(20), MakeTetrahedra(8) })
  {
    for (const int size : { 0, 8 })
    {
      FluentEncoding how;
      how.RealSize = size;
      const File file(Encode(mesh, how), "test.msh");
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 3, 0);
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 3, 2);
      ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(file.Path, 40, 1);
    }
  }
  const File hanging(MakeHanging(true, 4), "test.msh");
  ExpectPiecesMakeTheWhole<vtkFluentMeshReader>(hanging.Path, 3, 1);
}

//------------------------------------------------------------------------------
// If this fails, evaluation finds other neighbors than the mesh has: faces passed on are wrong.
TEST(FluentMeshCells, HandsOverFaces)
{
  FluentSample mesh = MakeMixed(8);
  for (std::size_t i = 0; i < mesh.Cells.size(); i += 2)
  {
    mesh.Cells[i].Element = 7;
  }
  const File file(Encode(mesh), "test.msh");
  for (const int pieces : { 1, 2 })
  {
    const Result result = ReadWith<vtkFluentMeshReader>(file.Path, pieces - 1, pieces, 1);
    ASSERT_TRUE(result.Errors.empty());
    vtkNew<vtkUnstructuredGrid> copy;
    copy->DeepCopy(result.Grid);
    MeshTopology given(result.Grid), found(copy);
    ASSERT_EQ(given.GetFaces().GetNumberOfFacets(), found.GetFaces().GetNumberOfFacets());
    std::vector<Index> a, b;
    for (Index face = 0; face < found.GetFaces().GetNumberOfFacets(); ++face)
    {
      given.GetFaces().GetCells(face, a);
      found.GetFaces().GetCells(face, b);
      EXPECT_EQ(a, b) << face;
    }
  }
}
