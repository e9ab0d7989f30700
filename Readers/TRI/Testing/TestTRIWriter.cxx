// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written TRI files: exact bytes, and the same mesh when they are read again.
#include "FormatTesting.h"
#include "TestMeshes.h"
#include "vtkTRIReader.h"
#include "vtkTRIWriter.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, const std::function<void(vtkTRIWriter*)>& configure = {})
{
  return WriteWith<vtkTRIWriter>(mesh, "test.tri", configure);
}

Grid MakeTriangles()
{
  Grid grid = MakeGrid({ { 0, 0, 0.1 }, { 1, 0, 1e-30 }, { 0, 1, 0 }, { 1, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 2, 1, 3 } } });
  vtkNew<vtkIntArray> components;
  components->SetName("Component");
  components->InsertNextValue(7);
  components->InsertNextValue(-2);
  grid->GetCellData()->AddArray(components);
  return grid;
}
}

//------------------------------------------------------------------------------
TEST(TRIWriter, WritesBothDialects)
{
  const Written camaron = Write(MakeTriangles());
  ASSERT_TRUE(camaron.Success);
  EXPECT_EQ(camaron.Bytes, "4\n0 0 0.1\n1 0 1e-30\n0 1 0\n1 1 0\n2\n0 1 2\n2 1 3\n");
  ASSERT_EQ(camaron.Warnings.size(), 1u);
  EXPECT_NE(camaron.Warnings[0].find("Component"), std::string::npos);

  const Written cart3D =
    Write(MakeTriangles(), [](vtkTRIWriter* w) { w->SetDialect(vtkTRIWriter::CART3D); });
  EXPECT_EQ(cart3D.Bytes, "4 2\n0 0 0.1\n1 0 1e-30\n0 1 0\n1 1 0\n1 2 3\n3 2 4\n7\n-2\n");
  EXPECT_TRUE(cart3D.Warnings.empty());
  const Result again = ReadWith<vtkTRIReader>(File(cart3D.Bytes, "a.tri").Path);
  ASSERT_TRUE(again.Errors.empty());
  EXPECT_EQ(again.Grid->GetCellData()->GetArray("Component")->GetTuple1(1), -2);
  EXPECT_EQ(again.Grid->GetPoint(0)[2], 0.1);
}

//------------------------------------------------------------------------------
// If this fails, a point array with the name of a written cell array is lost without a warning.
TEST(TRIWriter, ComponentsOfPointsAreLeftOut)
{
  const Grid grid = MakeTriangles();
  vtkNew<vtkIntArray> ofPoints;
  ofPoints->SetName("Component");
  ofPoints->SetNumberOfTuples(4);
  ofPoints->Fill(1);
  grid->GetPointData()->AddArray(ofPoints);
  const Written written = Write(grid, [](vtkTRIWriter* w) { w->SetDialect(vtkTRIWriter::CART3D); });
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("not written: Component of points"), std::string::npos)
    << written.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, other components are written, or numbers that no reader accepts.
TEST(TRIWriter, ComponentsThatCannotBeWritten)
{
  for (const double odd : { 0.5, 4294967296., std::nan("") })
  {
    const Grid grid = MakeTriangles();
    vtkNew<vtkDoubleArray> components;
    components->SetName("Component");
    components->InsertNextValue(1);
    components->InsertNextValue(odd);
    grid->GetCellData()->AddArray(components);
    const Written written =
      Write(grid, [](vtkTRIWriter* w) { w->SetDialect(vtkTRIWriter::CART3D); });
    ASSERT_TRUE(written.Success);
    ASSERT_EQ(written.Warnings.size(), 2u);
    EXPECT_NE(
      written.Warnings[0].find("1 cell whose Component is not a 32-bit integer"), std::string::npos)
      << written.Warnings[0];
    EXPECT_NE(written.Warnings[1].find("not written: Component"), std::string::npos);
    const Result again = ReadWith<vtkTRIReader>(File(written.Bytes, "a.tri").Path);
    EXPECT_TRUE(again.Errors.empty());
    EXPECT_EQ(Count(again.Grid, VTK_TRIANGLE), 2);
  }
}

//------------------------------------------------------------------------------
TEST(TRIWriter, FloatCoordinatesStayShort)
{
  Grid grid = MakeGrid({ { 0, 0, 0 } }, { { VTK_VERTEX, { 0 } } });
  vtkNew<vtkPoints> points; // float
  points->InsertNextPoint(0.1, 1.0 / 3, 1e20);
  grid->SetPoints(points);
  EXPECT_EQ(Write(grid).Bytes, "1\n0.1 0.33333334 1e+20\n");
}

//------------------------------------------------------------------------------
// If this fails, a cloud is read as points without cells.
TEST(TRIWriter, CloudsComeBack)
{
  const Grid cloud =
    MakeGrid({ { 0, 0, 0 }, { 1, 2, 3 } }, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  for (const int dialect : { vtkTRIWriter::CAMARON, vtkTRIWriter::CART3D })
  {
    const Written written = Write(cloud, [=](vtkTRIWriter* w) { w->SetDialect(dialect); });
    const Result again = ReadWith<vtkTRIReader>(File(written.Bytes, "a.tri").Path);
    EXPECT_EQ(Count(again.Grid, VTK_VERTEX), 2) << written.Bytes;
  }
}

//------------------------------------------------------------------------------
TEST(TRIWriter, WhatItCannotHold)
{
  const Grid square = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  const Written refused = Write(square);
  EXPECT_EQ(refused.Success, 0);
  EXPECT_EQ(refused.Bytes, "before");
  ASSERT_EQ(refused.Errors.size(), 1u);
  const Written converted =
    Write(square, [](vtkTRIWriter* w) { w->SetUnsupportedCells(vtkTRIWriter::CONVERT); });
  ASSERT_TRUE(converted.Success);
  const Result again = ReadWith<vtkTRIReader>(File(converted.Bytes, "a.tri").Path);
  EXPECT_EQ(Count(again.Grid, VTK_TRIANGLE), 2);

  // The surface of a tetrahedron.
  const Grid tetrahedron = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Written surface = Write(tetrahedron);
  ASSERT_TRUE(surface.Success);
  EXPECT_EQ(Count(ReadWith<vtkTRIReader>(File(surface.Bytes, "a.tri").Path).Grid, VTK_TRIANGLE), 4);
}
