// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written M3D and M2D files: exact bytes, and the same mesh when they are read again.
#include "FormatTesting.h"
#include "SharedData.h"
#include "TestMeshes.h"
#include "vtkM3DReader.h"
#include "vtkM3DWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, const std::string& name,
  const std::function<void(vtkM3DWriter*)>& configure = {})
{
  return WriteWith<vtkM3DWriter>(mesh, name, configure);
}

const Points Corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { .5, .5, 2 }, { 2, 0, 0 }, { 2, 0, 1 } };

Grid MakeMixed()
{
  return MakeGrid(Corners,
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_PYRAMID, { 4, 5, 6, 7, 8 } },
      { VTK_WEDGE, { 1, 2, 9, 5, 6, 10 } }, { VTK_TETRA, { 5, 10, 6, 8 } } });
}

void AddMaterial(vtkFieldData* data, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Material");
  array->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < values.size(); i += 3)
  {
    array->InsertNextTuple(values.data() + i);
  }
  data->AddArray(array);
}

void ExpectSameMesh(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  EXPECT_TRUE(HaveSameValues(a->GetPoints()->GetData(), b->GetPoints()->GetData()));
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  const auto ids = GetIds(a->GetPointData(), a->GetNumberOfPoints());
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(DescribeCell(a, cell, ids)[0], DescribeCell(b, cell, ids)[0]);
  }
}
}

//------------------------------------------------------------------------------
// If this fails, points that are not in the file are counted, or are identified by their index
// there.
TEST(M3DWriter, TellsOfRoundedPointsThatAreWritten)
{
  const Grid grid = MakeGrid(
    { { 1. / 3, 0, 0 }, { 2. / 3, 1, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1. / 3 } },
    { { VTK_LINE, { 0, 1 } }, { VTK_TETRA, { 2, 3, 4, 5 } } });
  const Written file = Write(grid, "test.m3d",
    [](vtkM3DWriter* w)
    {
      w->SetDigits(9);
      w->SetUnsupportedCells(vtkM3DWriter::SKIP);
    });
  ASSERT_TRUE(file.Success);
  const auto tells = [](const std::string& text)
  {
    return text.find(
             "1 point rounded to 9 digits (set Digits to 17 for full precision): point 5") !=
      std::string::npos;
  };
  EXPECT_EQ(std::count_if(file.Warnings.begin(), file.Warnings.end(), tells), 1);
}

//------------------------------------------------------------------------------
TEST(M3DWriter, WritesWhatGeneratorsWrite)
{
  const Grid grid = MakeGrid(
    { { 0, -0.1, 1. / 3 }, { 1, 0, 0 }, { 0, 1e-30, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 } },
    { { VTK_WEDGE, { 0, 2, 1, 3, 5, 4 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Written file = Write(grid, "test.m3d", [](vtkM3DWriter* w) { w->SetDigits(9); });
  ASSERT_TRUE(file.Success);
  ASSERT_EQ(file.Warnings.size(), 1u);
  EXPECT_NE(file.Warnings[0].find(
              "1 point rounded to 9 digits (set Digits to 17 for full precision): point 0"),
    std::string::npos)
    << file.Warnings[0];
  EXPECT_EQ(file.Bytes,
    "[Nodes, ARRAY1<STRING>]\n6\n\n"
    "1 +0.00000000E+00 -1.00000000E-01 +3.33333333E-01\n"
    "1 +1.00000000E+00 +0.00000000E+00 +0.00000000E+00\n"
    "1 +0.00000000E+00 +1.00000000E-30 +0.00000000E+00\n"
    "1 +0.00000000E+00 +0.00000000E+00 +1.00000000E+00\n"
    "1 +1.00000000E+00 +0.00000000E+00 +1.00000000E+00\n"
    "1 +0.00000000E+00 +1.00000000E+00 +1.00000000E+00\n"
    "\n[Elements, ARRAY1<STRING>]\n2\n\n"
    "R 0 1 2 3 4 5 1000.0 0.45 1.0\nT 0 1 2 3 1000.0 0.45 1.0\n");
}

//------------------------------------------------------------------------------
// If this fails, the mesh read again differs from that written.
TEST(M3DWriter, RoundTrips)
{
  const Grid flat =
    MakeGrid(Corners, { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 9, 2 } } });
  const Grid cloud =
    MakeGrid({ { 1, 2, 3 }, { 4, 5, 6 } }, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  const struct
  {
    Grid Mesh;
    const char* Name;
  } cases[] = { { MakeMixed(), "a.m3d" }, { flat, "a.M2D" }, { cloud, "a.m3d" } };
  for (const auto& c : cases)
  {
    const Written file = Write(c.Mesh, c.Name);
    ASSERT_TRUE(file.Success) << (file.Errors.empty() ? "" : file.Errors[0]);
    const Result again = ReadWith<vtkM3DReader>(File(file.Bytes, "b.m3d").Path);
    ASSERT_TRUE(again.Errors.empty()) << again.Errors[0];
    ExpectSameMesh(c.Mesh, again.Grid);
    EXPECT_EQ(Write(again.Grid, c.Name).Bytes, file.Bytes);
  }
}

//------------------------------------------------------------------------------
TEST(M3DWriter, KeepsDigits)
{
  const Grid grid = MakeGrid({ { 0.1, 1. / 3, 1e300 / 7 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const int digits : { 0, 17 })
  {
    const Written file =
      Write(grid, "test.m3d", [digits](vtkM3DWriter* writer) { writer->SetDigits(digits); });
    EXPECT_TRUE(file.Warnings.empty());
    const Result again = ReadWith<vtkM3DReader>(File(file.Bytes, "b.m3d").Path);
    ExpectSameMesh(grid, again.Grid);
  }
}

//------------------------------------------------------------------------------
TEST(M3DWriter, SaysWhatItsDigitsLose)
{
  const auto makeAt = [](double x)
  {
    return MakeGrid({ { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } });
  };
  const auto round = [](vtkM3DWriter* writer)
  {
    writer->SetDigits(9);
    writer->SetAllowRounding(true);
  };
  EXPECT_TRUE(Write(makeAt(9), "test.m3d").Warnings.empty());
  EXPECT_TRUE(Write(makeAt(1e15), "test.m3d").Warnings.empty());
  const Written file = Write(makeAt(1e15), "test.m3d", round);
  ASSERT_EQ(file.Warnings.size(), 1u);
  EXPECT_NE(
    file.Warnings[0].find("coordinates are rounded to multiples of 1e+07"), std::string::npos)
    << file.Warnings[0];
  EXPECT_NE(file.Warnings[0].find(", because it is far from the origin; "), std::string::npos)
    << file.Warnings[0];
  EXPECT_TRUE(Write(makeAt(1e8), "test.m3d").Warnings.empty()); // 9 digits are enough
  const Written few =
    Write(makeAt(1. / 3), "test.m3d", [](vtkM3DWriter* writer) { writer->SetDigits(6); });
  ASSERT_EQ(few.Warnings.size(), 1u);
  EXPECT_NE(
    few.Warnings[0].find(", because they have 6 digits; set Digits to 17"), std::string::npos)
    << few.Warnings[0];
}

//------------------------------------------------------------------------------
// Digits that leave nothing of a cell are as bad as single precision.
TEST(M3DWriter, RefusesDigitsThatSpoilCells)
{
  const auto write = [](double x, int digits)
  {
    const Grid mesh = MakeGrid({ { x, 0, 0 }, { x + 1, 0, 0 }, { x, 1, 0 }, { x, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } });
    return Write(mesh, "test.m3d", [digits](vtkM3DWriter* writer) { writer->SetDigits(digits); });
  };
  EXPECT_TRUE(write(1e6 / 3, 9).Success);
  EXPECT_TRUE(write(1e9 / 3, 17).Success);
  const Written spoiled = write(1e6 / 3, 5);
  EXPECT_FALSE(spoiled.Success);
  EXPECT_EQ(spoiled.Bytes, "before");
  ASSERT_EQ(spoiled.Errors.size(), 1u);
  EXPECT_NE(spoiled.Errors[0].find("expected cells that keep their shape with coordinates of 5 "
                                   "digits, found an edge of cell 0 that changes by 100 %"),
    std::string::npos)
    << spoiled.Errors[0];

  const auto writeTetrahedron = [](double z)
  {
    const Grid mesh = MakeGrid({ { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 0.25, 0.25, z } },
      { { VTK_TETRA, { 0, 1, 2, 3 } } });
    return Write(mesh, "test.m3d", [](vtkM3DWriter* writer) { writer->SetDigits(7); });
  };
  const Written flattened = writeTetrahedron(1.0000004);
  ASSERT_EQ(flattened.Errors.size(), 1u);
  EXPECT_NE(
    flattened.Errors[0].find("found cell 0, which rounding inverts or flattens"), std::string::npos)
    << flattened.Errors[0];
  EXPECT_TRUE(writeTetrahedron(1).Success); // flat before, too
}

//------------------------------------------------------------------------------
TEST(M3DWriter, WritesMaterials)
{
  Grid grid = MakeMixed();
  AddMaterial(grid->GetFieldData(), { 5, 0.25, 1e-3 });
  const Written common = Write(grid, "test.m3d");
  EXPECT_NE(common.Bytes.find("T 5 10 6 8 5.0 0.25 0.001\n"), std::string::npos);
  AddMaterial(grid->GetCellData(), { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 });
  const Written both = Write(grid, "test.m3d");
  ASSERT_EQ(both.Warnings.size(), 1u);
  EXPECT_NE(both.Warnings[0].find("field data; not written: Material"), std::string::npos)
    << both.Warnings[0];
  grid->GetFieldData()->Initialize();
  const Written each = Write(grid, "test.m3d");
  EXPECT_TRUE(each.Warnings.empty());
  const Result again = ReadWith<vtkM3DReader>(File(each.Bytes, "b.m3d").Path);
  EXPECT_TRUE(HaveSameValues(
    again.Grid->GetCellData()->GetArray("Material"), grid->GetCellData()->GetArray("Material")));

  // An array of this name that is not a material, as from other readers, is reported as such.
  Grid number = MakeMixed();
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Material");
  numbers->SetNumberOfTuples(number->GetNumberOfCells());
  numbers->Fill(7);
  number->GetCellData()->AddArray(numbers);
  const Written unlike = Write(number, "test.m3d");
  ASSERT_EQ(unlike.Warnings.size(), 1u);
  EXPECT_NE(
    unlike.Warnings[0].find("materials need 3 components, this array has 1"), std::string::npos)
    << unlike.Warnings[0];
  EXPECT_NE(unlike.Bytes.find("1000.0 0.45 1.0"), std::string::npos);

  // The warning about other arrays does not claim that none can be stored.
  Grid other = MakeMixed();
  vtkNew<vtkDoubleArray> pressure;
  pressure->SetName("pressure");
  pressure->SetNumberOfTuples(other->GetNumberOfCells());
  pressure->Fill(1);
  other->GetCellData()->AddArray(pressure);
  const Written lost = Write(other, "test.m3d");
  ASSERT_EQ(lost.Warnings.size(), 1u);
  EXPECT_NE(
    lost.Warnings[0].find("M3D cannot store some arrays; not written: pressure"), std::string::npos)
    << lost.Warnings[0];
}

//------------------------------------------------------------------------------
TEST(M3DWriter, WhatItCannotHold)
{
  Grid grid = MakeMixed();
  grid->InsertNextCell(VTK_QUAD, 4, std::array<vtkIdType, 4>{ 0, 1, 2, 3 }.data());
  const Written refused = Write(grid, "test.m3d");
  EXPECT_EQ(refused.Success, 0);
  EXPECT_EQ(refused.Bytes, "before");
  EXPECT_EQ(refused.Errors.size(), 1u);
  const Written skipped =
    Write(grid, "test.m3d", [](vtkM3DWriter* w) { w->SetUnsupportedCells(vtkM3DWriter::SKIP); });
  ASSERT_TRUE(skipped.Success);
  EXPECT_EQ(skipped.Warnings.size(), 1u);
  EXPECT_EQ(ReadWith<vtkM3DReader>(File(skipped.Bytes, "b.m3d").Path).Grid->GetNumberOfCells(), 4);

  // Materials follow the parts of a split cell, and cells after an omitted one.
  Grid prism = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0.5, 2, 0 }, { 0, 1, 0 } },
    { { VTK_POLYGON, { 0, 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 0, 1, 2 } } });
  AddMaterial(prism->GetCellData(), { 1, 2, 3, 4, 5, 6 });
  const Written cut = Write(
    prism, "test.m2d", [](vtkM3DWriter* w) { w->SetUnsupportedCells(vtkM3DWriter::CONVERT); });
  const Result again = ReadWith<vtkM3DReader>(File(cut.Bytes, "b.m3d").Path);
  ASSERT_EQ(Count(again.Grid, VTK_TRIANGLE), 4);
  vtkDataArray* material = again.Grid->GetCellData()->GetArray("Material");
  ASSERT_NE(material, nullptr);
  EXPECT_EQ(material->GetComponent(2, 0), 1);
  EXPECT_EQ(material->GetComponent(3, 0), 4);

  const Grid voxel = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 }, { 0, 0, 1 },
                                { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 } },
    { { VTK_VOXEL, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  EXPECT_NE(Write(voxel, "test.m3d").Bytes.find("H 0 1 3 2 4 5 7 6 "), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(M3DWriter, ExtensionDecides)
{
  EXPECT_EQ(Write(MakeMixed(), "test.m2d").Success, 0);
  EXPECT_EQ(Write(MakeMixed(), "test").Bytes, Write(MakeMixed(), "test.m3d").Bytes);
}

//------------------------------------------------------------------------------
// Rows are formatted by several threads.
TEST(M3DWriter, ThreadsChangeNothing)
{
  Points points;
  Cells cells;
  for (int i = 0; i < 20000; ++i)
  {
    points.push_back({ i * 0.1, i % 7 * 1., i % 5 * 1. });
    cells.push_back({ VTK_TETRA, { i, (i + 1) % 20000, (i + 2) % 20000, (i + 3) % 20000 } });
  }
  const Grid grid = MakeGrid(points, cells);
  std::vector<std::string> files;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads), [&] { files.push_back(Write(grid, "test.m3d").Bytes); });
  }
  EXPECT_EQ(files[0], files[1]);
  EXPECT_GT(files[0].size(), 1000000u);
}

//------------------------------------------------------------------------------
// If this fails, files of mesh generators change when they are read and written.
TEST(M3DWriter, CollectedFilesStayAsTheyAre)
{
  CAMARON_NEEDS_SHARED_DATA("m3d");
  const std::string folder = GetSharedData("m3d").string();
  for (const char* name : { "mesher_roi_cortex", "mesher_roi_cyl50" })
  {
    const std::string path = folder + "/" + name + ".m3d";
    const Result result = ReadWith<vtkM3DReader>(path);
    EXPECT_TRUE(Write(result.Grid, "test.m3d").Bytes == GetBytes(path)) << name;
  }
}
