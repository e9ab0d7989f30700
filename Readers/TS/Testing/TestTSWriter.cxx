// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written TS files: exact bytes, and the same mesh when they are read again.
#include "FormatTesting.h"
#include "SharedData.h"
#include "TestMeshes.h"
#include "vtkTSReader.h"
#include "vtkTSWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <limits>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, int dialect, int others = vtkTSWriter::REFUSE)
{
  return WriteWith<vtkTSWriter>(mesh, "test.ts",
    [=](vtkTSWriter* writer)
    {
      writer->SetDialect(dialect);
      writer->SetUnsupportedCells(others);
    });
}

Result Read(const std::string& bytes)
{
  return ReadWith<vtkTSReader>(File(bytes, "again.ts").Path);
}

Grid MakeTetrahedra()
{
  return MakeGrid({ { 0, 0, 0.1 }, { 1, 0, 1e-30 }, { 0, 1. / 3, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 4, 2, 3 } } });
}

Grid MakeTriangles()
{
  return MakeGrid({ { 0, 0, 0.1 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 2, 1, 3 } } });
}

void AddCellArray(vtkUnstructuredGrid* grid, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (const int value : values)
  {
    array->InsertNextValue(value);
  }
  grid->GetCellData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
TEST(TSWriter, WritesTetrahedra)
{
  const Grid grid = MakeTetrahedra();
  const Written file = Write(grid, vtkTSWriter::CAMARON);
  ASSERT_TRUE(file.Success);
  EXPECT_TRUE(file.Warnings.empty());
  EXPECT_EQ(file.Bytes,
    "5 2\n0 0 0.1 1.0\n1 0 1e-30 1.0\n0 0.3333333333333333 0 1.0\n0 0 1 1.0\n1 1 1 1.0\n0 1 2 3\n1 "
    "4 2 3\n");
  const Result again = Read(file.Bytes);
  EXPECT_TRUE(HaveSameValues(again.Grid->GetPoints()->GetData(), grid->GetPoints()->GetData()));
  EXPECT_EQ(Count(again.Grid, VTK_TETRA), 2);
  AddCellArray(grid, "a", { 1, 2 });
  EXPECT_EQ(Write(grid, vtkTSWriter::CAMARON).Warnings.size(), 1u);
  const Grid cloud = MakeGrid({ { 1, 2, 3 } }, { { VTK_VERTEX, { 0 } } });
  EXPECT_EQ(Write(cloud, vtkTSWriter::CAMARON).Bytes, "1 0\n1 2 3 1.0\n");
}

//------------------------------------------------------------------------------
TEST(TSWriter, WritesTriangles)
{
  const Grid grid = MakeTriangles();
  vtkNew<vtkFloatArray> values;
  values->SetName("two words");
  values->SetNumberOfComponents(2);
  for (const float value :
    { 0.1f, 2.f, std::numeric_limits<float>::quiet_NaN(), 1.f, 5.f, 6.f, 7.f, 8.f })
  {
    values->InsertNextValue(value);
  }
  grid->GetPointData()->AddArray(values);
  const Written file = Write(grid, vtkTSWriter::GOCAD);
  ASSERT_TRUE(file.Success);
  EXPECT_TRUE(file.Warnings.empty());
  EXPECT_EQ(file.Bytes,
    "GOCAD TSurf 1\nHEADER {\nname:surface1\n}\nPROPERTIES \"two words\"\nESIZES 2\nNO_DATA_VALUES "
    "-99999\n"
    "TFACE\nPVRTX 1 0 0 0.1 0.1 2\nPVRTX 2 1 0 0 -99999 1\nPVRTX 3 0 1 0 5 6\nPVRTX 4 1 1 0 7 8\n"
    "TRGL 1 2 3\nTRGL 3 2 4\nEND\n");
  const Result again = Read(file.Bytes);
  ASSERT_TRUE(again.Errors.empty()) << again.Errors[0];
  EXPECT_TRUE(HaveSameValues(again.Grid->GetPoints()->GetData(), grid->GetPoints()->GetData()));
  EXPECT_TRUE(HaveSameLists(
    again.Grid->GetCells(), Read(Write(again.Grid, vtkTSWriter::GOCAD).Bytes).Grid->GetCells()));
}

//------------------------------------------------------------------------------
// If this fails, a value that is the default for no data is read as NaN.
TEST(TSWriter, ValuesThatStandForNoData)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid grid = MakeTriangles();
  vtkNew<vtkDoubleArray> values;
  values->SetName("a");
  for (const double value : { -99999., -999999., nan, -99999. })
  {
    values->InsertNextValue(value);
  }
  grid->GetPointData()->AddArray(values);
  const Written file = Write(grid, vtkTSWriter::GOCAD);
  EXPECT_NE(file.Bytes.find("NO_DATA_VALUES -9999999\n"), std::string::npos) << file.Bytes;
  EXPECT_TRUE(HaveSameValues(Read(file.Bytes).Grid->GetPointData()->GetArray("a"), values));
}

//------------------------------------------------------------------------------
// If this fails, two ids become the same without a warning.
TEST(TSWriter, IntegersThatAreRounded)
{
  const Grid grid = MakeTriangles();
  vtkNew<vtkTypeInt64Array> ids;
  ids->SetName("id");
  constexpr vtkTypeInt64 exact = vtkTypeInt64(1) << 53;
  for (const vtkTypeInt64 id : { exact, exact + 1, -exact - 1, exact + 2 })
  {
    ids->InsertNextValue(id);
  }
  grid->GetPointData()->AddArray(ids);
  const Written file = Write(grid, vtkTSWriter::GOCAD);
  ASSERT_EQ(file.Warnings.size(), 1u);
  EXPECT_NE(
    file.Warnings[0].find("2 values of the array id rounded to double, the first is value 1"),
    std::string::npos)
    << file.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, a cell array with the name of a property is lost without a warning.
TEST(TSWriter, CellArraysOfTheNameOfAProperty)
{
  const Grid grid = MakeTriangles();
  AddCellArray(grid, "a", { 1, 2 });
  vtkNew<vtkFloatArray> values;
  values->SetName("a");
  values->SetNumberOfTuples(4);
  values->Fill(1);
  grid->GetPointData()->AddArray(values);
  const Written file = Write(grid, vtkTSWriter::GOCAD);
  ASSERT_EQ(file.Warnings.size(), 1u);
  EXPECT_NE(file.Warnings[0].find("not written: a of cells"), std::string::npos)
    << file.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, a surface loses parts, faces, properties or texts when read and written.
TEST(TSWriter, SurfacesStayAsTheyAre)
{
  const Result first =
    Read("GOCAD TSurf 1\nHEADER {\nname:top of "
         "salt\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nZPOSITIVE Depth\n"
         "AXIS_UNIT \"m\" \"m\" \"m\"\nEND_ORIGINAL_COORDINATE_SYSTEM\nPROPERTIES a b\nESIZES 1 "
         "2\nTFACE\n"
         "PVRTX 5 0 0 0 1 2 3\nVRTX 6 1 0 0\nVRTX 7 0 1 0\nTRGL 5 6 7\nTFACE\nVRTX 8 1 1 0\nTRGL 6 "
         "8 7\nVRTX 9 9 9 9\nEND\n"
         "GOCAD TSurf 1\nHEADER {name:b}\nPROPERTIES a\nTFACE\nVRTX 1 5 5 5\nPVRTX 2 6 5 5 7\nVRTX "
         "3 5 6 5\n"
         "TRGL 3 2 1\nEND\n");
  ASSERT_TRUE(first.Errors.empty()) << first.Errors[0];
  const Written file = Write(first.Grid, vtkTSWriter::GOCAD);
  ASSERT_TRUE(file.Success);
  ASSERT_EQ(file.Warnings.size(), 1u);
  EXPECT_NE(file.Warnings[0].find("not written: OriginalPointId"), std::string::npos);
  const Result second = Read(file.Bytes);
  ASSERT_TRUE(second.Errors.empty()) << second.Errors[0];
  first.Grid->GetPointData()->RemoveArray("OriginalPointId");
  second.Grid->GetPointData()->RemoveArray("OriginalPointId");
  ExpectSameGrid(first.Grid, second.Grid);
  for (const char* name : { "PartName", "ZPositive", "AxisUnit" })
  {
    for (vtkIdType i = 0; i < 2; ++i)
    {
      const auto get = [&](const Result& result)
      {
        return vtkStringArray::SafeDownCast(result.Grid->GetFieldData()->GetAbstractArray(name))
          ->GetValue(i);
      };
      EXPECT_EQ(get(first), get(second)) << name;
    }
  }
  EXPECT_EQ(Write(second.Grid, vtkTSWriter::GOCAD).Bytes, file.Bytes);
}

//------------------------------------------------------------------------------
// Parts that share points or are interleaved become one object, with a warning.
TEST(TSWriter, PartsThatCannotBeWritten)
{
  for (const std::vector<int>& parts : { std::vector<int>{ 0, 1 }, { 1, 0 }, { 0, 2 } })
  {
    const Grid grid = MakeTriangles();
    AddCellArray(grid, "Part", parts);
    AddCellArray(grid, "TFace", { 1, 0 });
    const Written file = Write(grid, vtkTSWriter::GOCAD);
    ASSERT_TRUE(file.Success);
    ASSERT_EQ(file.Warnings.size(), 1u);
    EXPECT_NE(file.Warnings[0].find("Part, TFace"), std::string::npos);
    const Result again = Read(file.Bytes);
    EXPECT_EQ(Count(again.Grid, VTK_TRIANGLE), 2);
    EXPECT_EQ(again.Grid->GetNumberOfPoints(), 4);
  }
}

//------------------------------------------------------------------------------
TEST(TSWriter, WhatItCannotHold)
{
  const Grid square = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  for (const int dialect : { vtkTSWriter::CAMARON, vtkTSWriter::GOCAD })
  {
    const Written refused = Write(square, dialect);
    EXPECT_EQ(refused.Success, 0);
    EXPECT_EQ(refused.Bytes, "before");
    EXPECT_EQ(refused.Errors.size(), 1u);
  }
  const Written cut = Write(square, vtkTSWriter::GOCAD, vtkTSWriter::CONVERT);
  EXPECT_EQ(Count(Read(cut.Bytes).Grid, VTK_TRIANGLE), 2);

  const Grid box = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                              { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  EXPECT_EQ(Write(box, vtkTSWriter::CAMARON).Success, 0);
  const Result tetrahedra = Read(Write(box, vtkTSWriter::CAMARON, vtkTSWriter::CONVERT).Bytes);
  EXPECT_GE(Count(tetrahedra.Grid, VTK_TETRA), 5);
  const Written surface = Write(box, vtkTSWriter::GOCAD, vtkTSWriter::CONVERT);
  EXPECT_EQ(Count(Read(surface.Bytes).Grid, VTK_TRIANGLE), 12);
}

//------------------------------------------------------------------------------
TEST(TSWriter, CollectedFilesStayAsTheyAre)
{
  CAMARON_NEEDS_SHARED_DATA("ts");
  const std::string folder = GetSharedData("ts").string();
  const Result tetrahedra = ReadWith<vtkTSReader>(folder + "/dev_tets_camaron.ts");
  ExpectSameGrid(tetrahedra.Grid, Read(Write(tetrahedra.Grid, vtkTSWriter::CAMARON).Bytes).Grid);
  const Result surface = ReadWith<vtkTSReader>(folder + "/dev_gocad_tsurf.ts");
  ExpectSameGrid(surface.Grid, Read(Write(surface.Grid, vtkTSWriter::GOCAD).Bytes).Grid);
}
