// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written PLY files: exact bytes, and the same mesh with the same arrays when they are read again.
#include "FormatTesting.h"
#include "PLYSamples.h"
#include "TestMeshes.h"
#include "vtkPolygonPLYReader.h"
#include "vtkPolygonPLYWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedShortArray.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, const std::function<void(vtkPolygonPLYWriter*)>& configure = {})
{
  return WriteWith<vtkPolygonPLYWriter>(mesh, "test.ply", configure);
}

Result Read(const Written& written)
{
  return ReadWith<vtkPolygonPLYReader>(File(written.Bytes, "again.ply").Path);
}

bool Has(const Written& written, const std::string& text)
{
  return written.Bytes.find(text) != std::string::npos;
}

Written WriteText(vtkDataObject* mesh)
{
  return Write(mesh, [](vtkPolygonPLYWriter* w) { w->SetEncoding(vtkPolygonPLYWriter::ASCII); });
}

/// With 32-bit ids, as from the reader.
Grid Narrow(Grid grid)
{
  grid->GetCells()->ConvertTo32BitStorage();
  return grid;
}

const int Encodings[] = { vtkPolygonPLYWriter::ASCII, vtkPolygonPLYWriter::BINARY_LITTLE_ENDIAN,
  vtkPolygonPLYWriter::BINARY_BIG_ENDIAN };

//------------------------------------------------------------------------------
template <typename Array>
void AddArray(vtkDataSetAttributes* attributes, const char* name, int components, vtkIdType tuples,
  double scale = 1)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < tuples * components; ++i)
  {
    array->InsertNextValue(static_cast<typename Array::ValueType>((i % 97) * scale));
  }
  attributes->AddArray(array);
}

/// A triangle, a quadrilateral and a pentagon over five points.
Grid MakePolygons()
{
  return MakeGrid({ { 0, 0, 0.1 }, { 1, 0, 1e-30 }, { 1, 1, 0 }, { 0.5, 2, 0 }, { 0, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 0, 2, 3, 4 } },
      { VTK_POLYGON, { 4, 3, 2, 1, 0 } } });
}
}

//------------------------------------------------------------------------------
// If this fails, other programs may not read our files.
TEST(PolygonPLYWriter, WritesTheUsualHeader)
{
  Grid grid = MakePolygons();
  vtkNew<vtkPoints> points; // float
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(grid->GetPoint(i));
  }
  grid->SetPoints(points);
  const Written text = WriteText(grid);
  ASSERT_TRUE(text.Success);
  EXPECT_TRUE(text.Warnings.empty());
  EXPECT_EQ(text.Bytes,
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 3\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0.1\n1 0 1e-30\n1 1 0\n0.5 2 0\n0 1 0\n3 0 1 2\n4 0 2 3 4\n5 4 3 2 1 0\n");
  const Written binary = Write(grid);
  EXPECT_TRUE(Has(binary, "format binary_little_endian 1.0\n"));
  const std::size_t body = binary.Bytes.find("end_header\n") + 11;
  EXPECT_EQ(binary.Bytes.size() - body, 5u * 12 + 3 + 12 * 4);
  EXPECT_EQ(binary.Bytes.substr(body + 60, 5), std::string("\3\0\0\0\0", 5));
}

//------------------------------------------------------------------------------
// If this fails, coordinates lose digits, or the option for single precision does not work.
TEST(PolygonPLYWriter, TypesOfCoordinates)
{
  const Grid grid = MakePolygons();
  for (const int encoding : Encodings)
  {
    const Written written = Write(grid, [&](vtkPolygonPLYWriter* w) { w->SetEncoding(encoding); });
    EXPECT_TRUE(Has(written, "property double x\n"));
    EXPECT_EQ(Read(written).Grid->GetPoint(0)[2], 0.1);
    const auto round = [&](vtkPolygonPLYWriter* w)
    {
      w->SetEncoding(encoding);
      w->SetCoordinates(vtkPolygonPLYWriter::FLOAT);
    };
    const Written rounded = Write(grid, round);
    EXPECT_TRUE(Has(rounded, "property float x\n"));
    ASSERT_EQ(rounded.Warnings.size(), 1u);
    EXPECT_NE(rounded.Warnings[0].find("2 points rounded"), std::string::npos);
    EXPECT_EQ(Read(rounded).Grid->GetPoint(0)[2], static_cast<double>(0.1f));
    const Grid large = MakePolygons();
    large->GetPoints()->SetPoint(1, 0, -1e300, 0);
    EXPECT_EQ(Write(large, round).Bytes, "before");
  }
}

//------------------------------------------------------------------------------
// If this fails, arrays are lost or changed when they are written and read.
TEST(PolygonPLYWriter, ArraysComeBack)
{
  Grid grid = MakePolygons();
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(grid->GetPointData()),
         static_cast<vtkDataSetAttributes*>(grid->GetCellData()) })
  {
    const vtkIdType size = data == grid->GetPointData() ? 5 : 3;
    AddArray<vtkSignedCharArray>(data, "a", 1, size, -1);
    AddArray<vtkUnsignedCharArray>(data, "b", 2, size);
    AddArray<vtkShortArray>(data, "c", 1, size, -300);
    AddArray<vtkUnsignedShortArray>(data, "d", 3, size, 600);
    AddArray<vtkIntArray>(data, "e", 1, size, -1e7);
    AddArray<vtkFloatArray>(data, "f", 9, size, 0.1);
    AddArray<vtkDoubleArray>(data, "Volume", 1, size, 0.1);
    AddArray<vtkUnsignedCharArray>(data, "RGBA", 4, size);
    AddArray<vtkFloatArray>(data, "Normals", 3, size, 0.25);
    data->GetArray("Volume")->SetComponent(1, 0, std::nan(""));
  }
  AddArray<vtkDoubleArray>(grid->GetPointData(), "TCoords", 2, 5, 0.1);
  for (const int encoding : Encodings)
  {
    const Written written = Write(grid, [&](vtkPolygonPLYWriter* w) { w->SetEncoding(encoding); });
    ASSERT_TRUE(written.Success);
    EXPECT_TRUE(written.Warnings.empty());
    EXPECT_TRUE(Has(written, "property float nx\n") && Has(written, "property uchar alpha\n") &&
      Has(written, "property double texture_u\n") && Has(written, "property ushort d_2\n"));
    const Result again = Read(written);
    ASSERT_TRUE(again.Errors.empty()) << again.Errors[0];
    EXPECT_TRUE(again.Warnings.empty());
    ExpectSameArrays(grid->GetPointData(), again.Grid->GetPointData());
    ExpectSameArrays(grid->GetCellData(), again.Grid->GetCellData());
    EXPECT_EQ(again.Grid->GetPointData()->GetArray("f")->GetNumberOfComponents(), 9);
    EXPECT_NE(again.Grid->GetPointData()->GetNormals(), nullptr);
  }
}

//------------------------------------------------------------------------------
// If this fails, other programs cannot read a file because of a name or a type.
TEST(PolygonPLYWriter, NamesAndTypesThatPLYKnows)
{
  Grid grid = MakePolygons();
  vtkPointData* points = grid->GetPointData();
  AddArray<vtkIntArray>(points, "x", 1, 5);
  AddArray<vtkIntArray>(points, "two words", 1, 5);
  AddArray<vtkIntArray>(points, "a b", 1, 5, 1);
  AddArray<vtkIntArray>(points, "a_b", 1, 5, 2);
  AddArray<vtkIntArray>(points, nullptr, 1, 5);
  AddArray<vtkIntArray>(points, "v", 2, 5);
  AddArray<vtkIntArray>(points, "v_1", 1, 5);
  AddArray<vtkIdTypeArray>(points, "small", 1, 5, -1);
  AddArray<vtkIdTypeArray>(points, "large", 1, 5, 1e9);
  AddArray<vtkIdTypeArray>(points, "larger", 1, 5, -1e15);
  AddArray<vtkIdTypeArray>(points, "largest", 1, 5, 1e18);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfTuples(5);
  points->AddArray(words);
  AddArray<vtkIntArray>(grid->GetCellData(), "vertex_indices", 1, 3);
  const Written written = WriteText(grid);
  ASSERT_TRUE(written.Success);
  for (const char* line : { "property int x_\n", "property int two_words\n", "property int array\n",
         "property int v_0\n", "property int v_1_\n", "property int small\n",
         "property uint large\n", "property double larger\n", "property double largest\n",
         "property int vertex_indices_\n", "comment components v 2\n" })
  {
    EXPECT_TRUE(Has(written, line)) << line << written.Bytes;
  }
  ASSERT_EQ(written.Warnings.size(), 3u);
  EXPECT_NE(written.Warnings[0].find(
              "fixed names: x to x_, two words to two_words, a b to a_b_ (a_b is another), an "
              "unnamed array to array, v_1 to v_1_"),
    std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Warnings[1].find("vertex_indices to vertex_indices_"), std::string::npos);
  EXPECT_NE(written.Warnings[2].find("not written: words"), std::string::npos);
  const Result again = Read(written);
  ASSERT_TRUE(again.Errors.empty());
  EXPECT_EQ(again.Grid->GetPointData()->GetArray("a_b")->GetTuple1(1),
    points->GetArray("a_b")->GetTuple1(1));
  EXPECT_EQ(again.Grid->GetPointData()->GetArray("larger")->GetTuple1(4), -4e15);
  EXPECT_EQ(again.Grid->GetPoint(1)[0], 1);
}

//------------------------------------------------------------------------------
// Active attributes get standard property names, and lose their own.
TEST(PolygonPLYWriter, TellsOfNamesOfNormals)
{
  Grid grid = MakePolygons();
  vtkPointData* points = grid->GetPointData();
  AddArray<vtkFloatArray>(points, "Direction", 3, 5);
  AddArray<vtkFloatArray>(points, "TCoords", 2, 5);
  points->SetActiveNormals("Direction");
  points->SetActiveTCoords("TCoords");
  const Written written = WriteText(grid);
  ASSERT_TRUE(written.Success);
  EXPECT_TRUE(Has(written, "property float nx\n")) << written.Bytes;
  EXPECT_TRUE(Has(written, "property float texture_u\n")) << written.Bytes;
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find(": Direction to Normals"), std::string::npos)
    << written.Warnings[0];
  EXPECT_EQ(written.Warnings[0].find("to TCoords"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(PolygonPLYWriter, LinesBecomeEdges)
{
  const Points points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } };
  Grid before = MakeGrid(points, { { VTK_LINE, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 2 } } });
  Grid after = MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_POLY_LINE, { 2, 1, 0 } } });
  Grid between = MakeGrid(points,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 0, 2 } }, { VTK_TRIANGLE, { 2, 1, 0 } } });
  for (const Grid& grid : { before, after, between })
  {
    AddArray<vtkIntArray>(grid->GetCellData(), "Quality", 1, grid->GetNumberOfCells(), 5);
  }
  const Result first = Read(WriteText(before));
  ExpectSameGrid(Narrow(before), first.Grid);
  const Result last = Read(WriteText(after));
  ASSERT_EQ(last.Grid->GetNumberOfCells(), 3);
  EXPECT_EQ(last.Grid->GetCellType(0), VTK_TRIANGLE);
  EXPECT_EQ(DescribeCell(last.Grid, 2, { 0, 1, 2 })[0], (std::vector<vtkIdType>{ VTK_LINE, 1, 0 }));
  EXPECT_EQ(last.Grid->GetCellData()->GetArray("Quality")->GetTuple1(2), 5);
  const Written mixed = WriteText(between);
  ASSERT_EQ(mixed.Warnings.size(), 1u);
  EXPECT_NE(mixed.Warnings[0].find("another order"), std::string::npos);
  const Result reordered = Read(mixed);
  EXPECT_EQ(reordered.Grid->GetCellType(1), VTK_TRIANGLE);
  EXPECT_EQ(reordered.Grid->GetCellData()->GetArray("Quality")->GetTuple1(2), 5);
}

//------------------------------------------------------------------------------
TEST(PolygonPLYWriter, Clouds)
{
  Grid cloud =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  const Written points = WriteText(cloud);
  EXPECT_FALSE(Has(points, "element face"));
  ExpectSameGrid(Narrow(cloud), Read(points).Grid);
  AddArray<vtkIntArray>(cloud->GetCellData(), "Mass", 1, 2, 5); // a cloud has no cells in the file
  const Written faces = WriteText(cloud);
  EXPECT_TRUE(Has(faces, "element face 2"));
  ExpectSameGrid(Narrow(cloud), Read(faces).Grid);
  const Written none = WriteText(MakeGrid({}, {}));
  ASSERT_TRUE(none.Success);
  EXPECT_TRUE(Read(none).Errors.empty());
}

//------------------------------------------------------------------------------
// If this fails, lists lose their length beyond 255.
TEST(PolygonPLYWriter, LongLists)
{
  const int size = 300;
  const Points ring = MakeRegularPolygon(size, 0);
  std::vector<vtkIdType> ids;
  for (int i = 0; i < size; ++i)
  {
    ids.push_back(i);
  }
  const Grid grid = MakeGrid(ring, { { VTK_POLYGON, ids } });
  for (const int encoding : Encodings)
  {
    const Written written = Write(grid, [&](vtkPolygonPLYWriter* w) { w->SetEncoding(encoding); });
    EXPECT_TRUE(Has(written, "property list int int vertex_indices\n"));
    EXPECT_EQ(written.Warnings.size(), 1u);
    ExpectSameGrid(Narrow(grid), Read(written).Grid);
  }
}

//------------------------------------------------------------------------------
// If this fails, the surface of a volume has holes, is oriented inward or has wrong values.
TEST(PolygonPLYWriter, SurfacesOfVolumes)
{
  Grid grid = MakeHexahedra(2, 1, 1, false);
  AddArray<vtkIntArray>(grid->GetCellData(), "Zone", 1, 2, 7);
  const Result boundary = Read(Write(grid));
  EXPECT_EQ(Count(boundary.Grid, VTK_QUAD), 10);
  EXPECT_EQ(boundary.Grid->GetCellData()->GetArray("Zone")->GetTuple1(0), 0);
  EXPECT_EQ(boundary.Grid->GetCellData()->GetArray("Zone")->GetTuple1(9), 7);
  const Written every =
    Write(grid, [](vtkPolygonPLYWriter* w) { w->SetFacesOfVolumes(vtkPolygonPLYWriter::EVERY); });
  EXPECT_EQ(Count(Read(every).Grid, VTK_QUAD), 11);
  EXPECT_EQ(every.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
// If this fails, polyhedra change when they are written and read.
TEST(PolygonPLYWriter, CellsComeBack)
{
  const Result mixed =
    ReadWith<vtkPolygonPLYReader>(File(MakeCells().Encode("ascii"), "a.ply").Path);
  Grid prisms = MakeHexagonalPrisms(3);
  for (Grid grid : { mixed.Grid, ToPolyhedra(prisms), MakeHexahedra(2, 2, 2, false) })
  {
    AddArray<vtkDoubleArray>(grid->GetCellData(), "Volume", 1, grid->GetNumberOfCells(), 0.5);
    AddArray<vtkIntArray>(grid->GetPointData(), "Id", 1, grid->GetNumberOfPoints());
    for (const int encoding : Encodings)
    {
      const auto configure = [&](vtkPolygonPLYWriter* w)
      {
        w->SetEncoding(encoding);
        w->WriteCellsOn();
      };
      const Written once = Write(grid, configure);
      ASSERT_TRUE(once.Success);
      EXPECT_TRUE(Has(once, "property list uchar int face_indices\n"));
      const Result read = Read(once);
      ASSERT_TRUE(read.Errors.empty()) << read.Errors[0];
      EXPECT_TRUE(read.Warnings.empty()) << read.Warnings[0];
      ASSERT_EQ(read.Grid->GetNumberOfCells(), grid->GetNumberOfCells());
      std::vector<vtkIdType> ids;
      for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
      {
        ids.push_back(i);
      }
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        auto expected = DescribeCell(grid, cell, ids), found = DescribeCell(read.Grid, cell, ids);
        // The points of a polyhedron have no order; its faces are compared.
        std::sort(expected[0].begin() + 1, expected[0].end());
        std::sort(found[0].begin() + 1, found[0].end());
        EXPECT_EQ(expected[0], found[0]) << cell;
      }
      EXPECT_TRUE(HaveSameValues(
        grid->GetCellData()->GetArray("Volume"), read.Grid->GetCellData()->GetArray("Volume")));
      EXPECT_TRUE(HaveSameValues(
        grid->GetPointData()->GetArray("Id"), read.Grid->GetPointData()->GetArray("Id")));
      // A mesh that was read is always written as the same bytes.
      const Written twice = Write(read.Grid, configure);
      ExpectSameGrid(read.Grid, Read(twice).Grid);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, inverted cells are corrected without a warning.
TEST(PolygonPLYWriter, TellsOfInvertedCells)
{
  const Grid grid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 1, 0, 2, 3 } } });
  const Written written = Write(grid, [](vtkPolygonPLYWriter* w) { w->WriteCellsOn(); });
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(
    written.Warnings[0].find("1 cell with inverted orientation, which is lost because PLY files"),
    std::string::npos)
    << written.Warnings[0];
}

//------------------------------------------------------------------------------
TEST(PolygonPLYWriter, WhatItCannotHold)
{
  // A quadratic triangle loses its mid-edge nodes, which are not written.
  const Grid quadratic =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { .5, 0, 0 }, { .5, .5, 0 }, { 0, .5, 0 } },
      { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 } } });
  const Written corners = WriteText(quadratic);
  ASSERT_TRUE(corners.Success);
  EXPECT_EQ(corners.Warnings.size(), 1u);
  EXPECT_EQ(Count(Read(corners).Grid, VTK_TRIANGLE), 1);
  EXPECT_EQ(Read(corners).Grid->GetNumberOfPoints(), 3);

  const Grid empty = MakeGrid({ { 0, 0, 0 } }, { { VTK_EMPTY_CELL, {} }, { VTK_VERTEX, { 0 } } });
  const Written refused = Write(empty);
  EXPECT_EQ(refused.Success, 0);
  EXPECT_EQ(refused.Bytes, "before");
  ASSERT_EQ(refused.Errors.size(), 1u);
  EXPECT_TRUE(Write(empty,
    [](vtkPolygonPLYWriter* w)
    {
      w->SetUnsupportedCells(vtkPolygonPLYWriter::SKIP);
    }).Success);
}

//------------------------------------------------------------------------------
// If this fails, a file depends on the number of threads.
TEST(PolygonPLYWriter, ThreadsChangeNothing)
{
  const File file(MakeMixedSurface(10000).Encode("binary_little_endian"), "large.ply");
  const Result mesh = ReadWith<vtkPolygonPLYReader>(file.Path);
  for (const int encoding : Encodings)
  {
    const auto write = [&](int threads)
    {
      Written written;
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads), [&]
        { written = Write(mesh.Grid, [&](vtkPolygonPLYWriter* w) { w->SetEncoding(encoding); }); });
      return written.Bytes;
    };
    const std::string expected = write(1);
    EXPECT_EQ(write(2), expected);
    EXPECT_EQ(write(3), expected);
    ExpectSameGrid(mesh.Grid, ReadWith<vtkPolygonPLYReader>(File(expected, "b.ply").Path).Grid);
  }
}

//------------------------------------------------------------------------------
// If this fails, integers are rounded without a warning, or there is a warning without rounding.
TEST(PolygonPLYWriter, IntegersThatAreRounded)
{
  constexpr vtkTypeInt64 exact = vtkTypeInt64(1) << 53;
  const struct
  {
    vtkTypeInt64 Value;
    bool IsRounded;
  } ids[] = { { exact, false }, { exact + 1, true }, { -exact - 1, true }, { exact + 2, false },
    { exact + 3, true }, { INT64_MIN, false }, { INT64_MAX, true } };
  for (const auto& id : ids)
  {
    const Grid grid =
      MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
    vtkNew<vtkTypeInt64Array> array;
    array->SetName("id");
    array->InsertNextValue(id.Value);
    grid->GetCellData()->AddArray(array);
    const Written written = Write(grid);
    EXPECT_EQ(written.Warnings.size(), id.IsRounded ? 1u : 0u) << id.Value;
    EXPECT_EQ(!written.Warnings.empty() &&
        written.Warnings[0].find("1 value of the array id rounded to double") != std::string::npos,
      id.IsRounded)
      << id.Value;
  }
}
