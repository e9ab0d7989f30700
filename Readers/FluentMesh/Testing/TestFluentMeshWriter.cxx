// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written Fluent files: exact bytes, and the same cells when they are read again.
#include "FluentMeshWriting.h"
#include "SharedData.h"

#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
TEST(FluentMeshWriter, WritesText)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } } });
  const Written written = Write(grid);
  EXPECT_EQ(written.Success, 1);
  EXPECT_TRUE(written.Warnings.empty());
  EXPECT_EQ(written.Bytes,
    "(0 \"Camaron\")\n(2 3)\n(10 (0 1 5 0 3))\n(12 (0 1 2 0))\n(13 (0 1 7 0))\n"
    "(10 (1 1 5 1 3)(\n0 0 0\n1 0 0\n0 1 0\n0 0 0.1\n1 1 1\n))\n"
    "(12 (2 1 2 1 2))\n"
    "(13 (3 1 1 2 3)(\n2 4 3 1 2\n))\n"
    "(13 (4 2 7 3 3)(\n1 2 3 1 0\n1 3 4 1 0\n1 4 2 1 0\n2 4 5 2 0\n2 5 3 2 0\n3 5 4 2 0\n))\n"
    "(45 (2 fluid fluid-2)())\n(45 (3 interior interior-3)())\n(45 (4 wall wall-4)())\n");
}

//------------------------------------------------------------------------------
// If this fails, binary sections are not as Fluent, or any reader, expects them.
TEST(FluentMeshWriter, WritesBinary)
{
  const Grid grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0.1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const int encoding :
    { vtkFluentMeshWriter::BINARY_SINGLE, vtkFluentMeshWriter::BINARY_DOUBLE })
  {
    const bool single = encoding == vtkFluentMeshWriter::BINARY_SINGLE;
    const std::string base = single ? "20" : "30";
    const Written written = WriteAs(grid, encoding);
    ASSERT_EQ(written.Success, 1);
    EXPECT_EQ(written.Warnings.size(), single ? 1u : 0u); // 0.1 is rounded
    const Grid large = MakeGrid({ { 0, 0, 0 }, { 1e300, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } });
    EXPECT_EQ(WriteAs(large, encoding).Success, single ? 0 : 1);
    EXPECT_NE(written.Bytes.find("(4 (60 "), std::string::npos);
    const std::string nodes = "(" + base + "10 (1 1 4 1 3)\n(";
    const std::size_t begin = written.Bytes.find(nodes);
    ASSERT_NE(begin, std::string::npos);
    const std::string end = ")\nEnd of Binary Section   " + base + "10)\n";
    EXPECT_EQ(written.Bytes.find(end, begin), begin + nodes.size() + (single ? 48 : 96));
    EXPECT_NE(
      written.Bytes.find("(" + base + "12 (2 1 1 1 2)\nEnd of Binary Section   " + base + "12)\n"),
      std::string::npos);
    ExpectSameCells(grid, Read(written.Bytes).Grid, single);
  }
}

//------------------------------------------------------------------------------
// If this fails, polyhedra of a reader that gives a face to both its cells without reversing it, as
// ParaView's of Fluent's HDF5 files, fall apart.
TEST(FluentMeshWriter, OrientsFacesOfPolyhedra)
{
  const Grid hexahedra = MakeHexahedra(3, 2, 2, false);
  std::vector<Faces> mixed, outward;
  for (vtkIdType cell = 0; cell < hexahedra->GetNumberOfCells(); ++cell)
  {
    outward.push_back(GetFaces(hexahedra, cell));
    mixed.push_back(outward.back());
    for (std::size_t face = static_cast<std::size_t>(cell) % 3; face < 6; face += 3)
    {
      std::reverse(mixed.back()[face].begin(), mixed.back()[face].end());
    }
  }
  const Written written = Write(MakePolyhedra(hexahedra->GetPoints(), mixed));
  EXPECT_TRUE(written.Warnings.empty()) << written.Warnings[0];
  const Result result = Read(written.Bytes);
  ASSERT_TRUE(result.Errors.empty());
  ExpectSameCells(MakePolyhedra(hexahedra->GetPoints(), outward), result.Grid);
}

//------------------------------------------------------------------------------
// If this fails, a mesh changes when it is written and read, in some encoding.
TEST(FluentMeshWriter, RoundTrips)
{
  FluentSample polyhedra = MakeMixed(3);
  for (FluentSample::Cell& cell : polyhedra.Cells)
  {
    cell.Element = 7;
  }
  FluentSample inverted = MakeMixed(2);
  for (auto& point : inverted.Points)
  {
    point[2] = -point[2];
  }
  for (const FluentSample& mesh : { MakeMixed(3), polyhedra, inverted, MakeFlat(8) })
  {
    const Result first = Read(Encode(mesh));
    ASSERT_TRUE(first.Errors.empty());
    for (int encoding = 0; encoding < 3; ++encoding)
    {
      const Written written = WriteAs(first.Grid, encoding);
      ASSERT_EQ(written.Success, 1);
      const Result second = Read(written.Bytes);
      ASSERT_TRUE(second.Errors.empty()) << second.Errors[0];
      EXPECT_TRUE(second.Warnings.empty());
      const bool isSplit = mesh.Cells.size() > 1 && mesh.Cells[1].Zone != mesh.Cells[0].Zone;
      EXPECT_TRUE(!written.Warnings.empty() || !isSplit);
      ExpectSameCells(first.Grid, second.Grid, encoding == vtkFluentMeshWriter::BINARY_SINGLE);
      EXPECT_TRUE(HaveSameValues(
        first.Grid->GetCellData()->GetArray("Zone"), second.Grid->GetCellData()->GetArray("Zone")));
      // And the file does not depend on the order of nodes, nor on threads.
      if (encoding != vtkFluentMeshWriter::BINARY_SINGLE)
      {
        Written again;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(3, "STDThread", false),
          [&] { again = WriteAs(second.Grid, encoding); });
        EXPECT_EQ(again.Bytes, written.Bytes);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, meshes that Fluent cannot store are written as something else.
TEST(FluentMeshWriter, RefusesWhatItCannotHold)
{
  const auto refuse = [](vtkDataObject* mesh, const std::string& message)
  {
    const Written written = Write(mesh);
    EXPECT_EQ(written.Success, 0);
    EXPECT_EQ(written.Bytes, "before") << "the file that was there must stay";
    ASSERT_EQ(written.Errors.size(), 1u);
    EXPECT_NE(written.Errors[0].find(message), std::string::npos) << written.Errors[0];
  };
  refuse(MakeGrid({ { 0, 0, 0 } }, { { VTK_VERTEX, { 0 } } }), "two or three dimensions");
  refuse(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.5 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }),
    "in a plane of constant z");
  refuse(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 1, 1, 1 } },
           { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 2, 1, 4 } },
             { VTK_TETRA, { 0, 1, 2, 5 } } }),
    "at most two cells, found 1 with more");
  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  refuse(MakePolyhedron(corners, {}), "none of them has faces");
  refuse(MakeGrid({}, { { VTK_POLYGON, {} } }), "cells with faces");
}

//------------------------------------------------------------------------------
// Lines and vertices in 3D meshes are neither cells of the file nor faces.
TEST(FluentMeshWriter, CellsOfMuchLowerDimensions)
{
  const Grid solid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_LINE, { 0, 1 } }, { VTK_VERTEX, { 3 } } });
  const Written refused = Write(solid);
  EXPECT_EQ(refused.Success, 0);
  ASSERT_EQ(refused.Errors.size(), 1u);
  EXPECT_NE(
    refused.Errors[0].find("1 cell of type vertex (cell 2) and 1 cell of type line (cell 1); set "
                           "Unsupported Cells to Skip to omit them"),
    std::string::npos)
    << refused.Errors[0];
  const Written skipped = Write(solid,
    [](vtkFluentMeshWriter* writer) { writer->SetUnsupportedCells(vtkFluentMeshWriter::SKIP); });
  EXPECT_EQ(skipped.Success, 1);
  EXPECT_EQ(skipped.Warnings.size(), 2u);
  const Grid tetra = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  EXPECT_EQ(skipped.Bytes, Write(tetra).Bytes);

  const Grid flat = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_VERTEX, { 0 } } });
  EXPECT_EQ(Write(flat).Success, 0);
}

//------------------------------------------------------------------------------
// If this fails, cells of types unknown to Fluent change.
TEST(FluentMeshWriter, WritesOtherTypes)
{
  const Written prism = Write(MakeStandardCell(VTK_PENTAGONAL_PRISM));
  ASSERT_EQ(prism.Success, 1);
  const Result polyhedron = Read(prism.Bytes);
  ASSERT_TRUE(polyhedron.Errors.empty());
  EXPECT_EQ(polyhedron.Grid->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_GT(GetMeasure(polyhedron.Grid, 0), 0);
  const Written voxel = Write(MakeStandardCell(VTK_VOXEL));
  ASSERT_EQ(voxel.Success, 1);
  const Result hexahedron = Read(voxel.Bytes);
  EXPECT_EQ(hexahedron.Grid->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_GT(GetMeasure(hexahedron.Grid, 0), 0);
  const Written quadratic =
    Write(MakeGrid({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
      { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 } } }));
  ASSERT_EQ(quadratic.Success, 1);
  EXPECT_EQ(quadratic.Warnings.size(), 1u);
  EXPECT_EQ(Read(quadratic.Bytes).Grid->GetNumberOfPoints(), 3);
}

//------------------------------------------------------------------------------
// If this fails, cells with the same orientation at a common face are inverted when read again.
TEST(FluentMeshWriter, KeepsCellsThatDisagree)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } } });
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(
    written.Warnings[0].find("1 face with the same orientation in both cells"), std::string::npos);
  ExpectSameCells(grid, Read(written.Bytes).Grid);
}

//------------------------------------------------------------------------------
// If this fails, a face with a repeated node is written differently each time.
TEST(FluentMeshWriter, RepeatedNodes)
{
  FluentSample mesh = MakeMixed(1);
  mesh.Cells[0].Element = 7;
  for (FluentSample::Face& face : mesh.Faces)
  {
    if (face.Cells[0] == 0 && face.Cells[1] < 0 && face.Nodes.size() == 4)
    {
      face.Nodes[3] = face.Nodes[1] = 0;
    }
  }
  const Written first = Write(Read(Encode(mesh)).Grid);
  ASSERT_EQ(first.Success, 1);
  EXPECT_EQ(Write(Read(first.Bytes).Grid).Bytes, first.Bytes);
}

//------------------------------------------------------------------------------
// If this fails, collapsed quadrilaterals are lost, or files get edges from a point to itself.
TEST(FluentMeshWriter, CollapsedQuadrilaterals)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { VTK_QUAD, { 0, 1, 2, 2 } }, { VTK_QUAD, { 0, 2, 3, 3 } } });
  const Written written = Write(grid);
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("2 edges with one point, omitted"), std::string::npos)
    << written.Warnings[0];
  const Result result = Read(written.Bytes);
  EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 2);
  for (const vtkIdType cell : { 0, 1 })
  {
    EXPECT_EQ(result.Grid->GetCellType(cell), VTK_TRIANGLE);
    EXPECT_NEAR(GetMeasure(result.Grid, cell), 0.5, 1e-12);
  }
}

//------------------------------------------------------------------------------
// A rotated mesh is flat except for rounding errors.
TEST(FluentMeshWriter, RoundedPlanes)
{
  const Written written = Write(MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 1e-17 }, { 0, 1, -2e-16 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("not exactly in the plane z = 0"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(FluentMeshWriter, CollectedFilesRoundTrip)
{
  CAMARON_NEEDS_SHARED_DATA("ansys_fluent");
  for (const auto& entry : std::filesystem::directory_iterator(GetSharedData("ansys_fluent")))
  {
    const Result first = ReadWith<vtkFluentMeshReader>(entry.path().string());
    ASSERT_TRUE(first.Errors.empty()) << entry.path();
    for (const int encoding : { vtkFluentMeshWriter::ASCII, vtkFluentMeshWriter::BINARY_DOUBLE })
    {
      const Written written = WriteAs(first.Grid, encoding);
      ASSERT_EQ(written.Success, 1) << entry.path();
      const Result second = Read(written.Bytes);
      ASSERT_TRUE(second.Errors.empty()) << entry.path() << second.Errors[0];
      // Text has the digits of single precision if the points are float.
      ExpectSameCells(first.Grid, second.Grid, first.Grid->GetPoints()->GetDataType() == VTK_FLOAT);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, degenerate faces crash the writer, get into files that Fluent refuses, or are
// omitted without a warning.
TEST(FluentMeshWriter, SaysWhichFacesOfPolyhedraItLeavesOut)
{
  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Faces faces = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  Faces more = faces;
  more.insert(more.begin(), { {}, { 3 }, { 0, 1 } });
  const Written written = Write(MakePolyhedron(corners, more));
  ASSERT_EQ(written.Success, 1);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(
    written.Warnings[0].find("3 faces with fewer than 3 points, omitted"), std::string::npos)
    << written.Warnings[0];
  EXPECT_EQ(written.Bytes, Write(MakePolyhedron(corners, faces)).Bytes);
}
