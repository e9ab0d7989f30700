// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written OFF files: exact bytes, and the same mesh when they are read again.
#include "PolygonOFFSamples.h"
#include "TestMeshes.h"
#include "vtkPolygonOFFWriter.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, const std::function<void(vtkPolygonOFFWriter*)>& configure = {})
{
  return WriteWith<vtkPolygonOFFWriter>(mesh, "test.off", configure);
}

void WriteBinary(vtkPolygonOFFWriter* writer)
{
  writer->SetEncoding(vtkPolygonOFFWriter::BINARY);
}

void WriteEverything(vtkPolygonOFFWriter* writer)
{
  writer->WriteNormalsOn();
  writer->WriteTextureCoordinatesOn();
  writer->SetVertexColors("RGBA");
  writer->SetFaceColors("RGBA");
}

//------------------------------------------------------------------------------
template <typename Array>
void AddArray(
  vtkDataSetAttributes* data, const char* name, int components, double first, double step)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data == nullptr ? 0 : 2 + 3 * data->IsA("vtkPointData"));
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetComponent(i / components, static_cast<int>(i % components), first + step * i);
  }
  data->AddArray(array);
}

/// A triangle and a quadrilateral with normals, texture and colors.
Grid MakeDecorated()
{
  Grid grid =
    MakeGrid({ { 0, 0, 0.1 }, { 1, 0, 1e-30 }, { 1, 1, 0 }, { 0, 1, 1.0 / 3 }, { 2, 2, 2 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUAD, { 3, 2, 1, 0 } } });
  AddArray<vtkDoubleArray>(grid->GetPointData(), "Normals", 3, 0.1, 0.01);
  grid->GetPointData()->SetActiveNormals("Normals");
  AddArray<vtkDoubleArray>(grid->GetPointData(), "TCoords", 2, 0.5, 0.025);
  grid->GetPointData()->SetActiveTCoords("TCoords");
  AddArray<vtkUnsignedCharArray>(grid->GetPointData(), "RGBA", 4, 3, 12);
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "RGBA", 4, 250, -31);
  return grid;
}

Result ReadAgain(const Written& written)
{
  return ReadBytes(written.Bytes);
}
}

//------------------------------------------------------------------------------
TEST(PolygonOFFWriter, ExactBytes)
{
  const Grid grid = MakeDecorated();
  const Written plain = Write(grid);
  ASSERT_TRUE(plain.Success);
  EXPECT_EQ(plain.Bytes,
    "OFF\n5 2 0\n0 0 0.1\n1 0 1e-30\n1 1 0\n0 1 0.3333333333333333\n2 2 2\n3 0 1 2\n4 3 2 1 0\n");
  ASSERT_EQ(plain.Warnings.size(), 1u);
  EXPECT_NE(plain.Warnings[0].find("only written if selected; not written: Normals, TCoords, RGBA"),
    std::string::npos)
    << plain.Warnings[0];
  // Colors of points and of cells with the same name: one of them is requested.
  for (const bool ofCells : { false, true })
  {
    const Written half = Write(grid,
      [ofCells](vtkPolygonOFFWriter* w)
      {
        w->SetVertexColors(ofCells ? "" : "RGBA");
        w->SetFaceColors(ofCells ? "RGBA" : "");
      });
    ASSERT_EQ(half.Warnings.size(), 1u);
    EXPECT_NE(
      half.Warnings[0].find(ofCells ? ", RGBA of points" : ", RGBA of cells"), std::string::npos)
      << half.Warnings[0];
  }

  const Written rounded = Write(grid,
    [](vtkPolygonOFFWriter* w)
    {
      w->SetDigits(9);
      w->SetVertexColors("None");
    });
  EXPECT_EQ(rounded.Bytes.substr(34, 16), "0 1 0.333333333\n");
  const Written full = Write(grid, WriteEverything);
  EXPECT_TRUE(full.Warnings.empty());
  EXPECT_EQ(full.Bytes.substr(0, 95),
    "STCNOFF\n5 2 0\n0 0 0.1 0.1 0.11 0.12000000000000001 3 15 27 39 0.5 0.525\n1 0 1e-30 0.13 "
    "0.14 0.1");
  EXPECT_NE(
    full.Bytes.find("3 0 1 2 250 219 188 157\n4 3 2 1 0 126 95 64 33\n"), std::string::npos);

  const Grid triangle =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0.5, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  Words words;
  words << 3 << 1 << 0 << 0.f << 0.f << 0.f << 1.f << 0.f << 0.f << 0.f << 0.5f << 0.f;
  words << 3 << 0 << 1 << 2 << 0;
  EXPECT_EQ(Write(triangle, WriteBinary).Bytes, "OFF BINARY\n" + words.Bytes);
  triangle->GetPoints()->SetPoint(1, 1e300, 0, 0);
  EXPECT_EQ(Write(triangle, WriteBinary).Bytes, "before");
  EXPECT_TRUE(Write(triangle).Success);

  const Grid steep = MakeDecorated();
  steep->GetPointData()->GetNormals()->SetComponent(3, 1, 1e39);
  const Written refused = Write(steep,
    [](vtkPolygonOFFWriter* w)
    {
      WriteEverything(w);
      WriteBinary(w);
    });
  EXPECT_EQ(refused.Bytes, "before");
  ASSERT_EQ(refused.Errors.size(), 1u);
  EXPECT_NE(refused.Errors[0].find("found 1e+39 of normal 3"), std::string::npos)
    << refused.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, something is lost or changed when it is written and read again.
TEST(PolygonOFFWriter, RoundTrips)
{
  const Grid grid = MakeDecorated();
  const Result text = ReadAgain(Write(grid, WriteEverything));
  ASSERT_TRUE(text.Errors.empty()) << text.Errors[0];
  for (vtkIdType i = 0; i < 5; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(text.Grid->GetPoint(i)[c], grid->GetPoint(i)[c]);
    }
    ExpectSameTuples(text.Grid->GetPointData(), i, grid->GetPointData(), i);
  }
  for (vtkIdType i = 0; i < 2; ++i)
  {
    ExpectSameTuples(text.Grid->GetCellData(), i, grid->GetCellData(), i);
    EXPECT_EQ(
      DescribeCell(text.Grid, i, { 0, 1, 2, 3, 4 }), DescribeCell(grid, i, { 0, 1, 2, 3, 4 }));
  }
  const Written binary = Write(grid,
    [](vtkPolygonOFFWriter* w)
    {
      WriteEverything(w);
      WriteBinary(w);
    });
  ASSERT_EQ(binary.Warnings.size(), 3u); // about rounding
  EXPECT_NE(binary.Warnings[1].find("5 normals rounded to single precision"), std::string::npos)
    << binary.Warnings[1];
  EXPECT_NE(binary.Warnings[2].find("texture coordinates rounded"), std::string::npos)
    << binary.Warnings[2];
  const Result again = ReadAgain(binary);
  ASSERT_TRUE(again.Errors.empty());
  EXPECT_EQ(again.Grid->GetPoint(3)[2], static_cast<float>(1.0 / 3));
  for (vtkIdType i = 0; i < 2; ++i)
  {
    ExpectSameTuples(again.Grid->GetCellData(), i, grid->GetCellData(), i);
  }
  EXPECT_TRUE(HaveSameValues(
    again.Grid->GetPointData()->GetArray("RGBA"), grid->GetPointData()->GetArray("RGBA")));
  // Values that were float are unchanged in either encoding, and so is the file.
  for (const auto& configure : { std::function<void(vtkPolygonOFFWriter*)>(WriteEverything),
         std::function<void(vtkPolygonOFFWriter*)>(
           [](vtkPolygonOFFWriter* w)
           {
             WriteEverything(w);
             WriteBinary(w);
           }) })
  {
    const Written first = Write(again.Grid, configure);
    EXPECT_TRUE(first.Warnings.empty());
    EXPECT_EQ(Write(ReadAgain(first).Grid, configure).Bytes, first.Bytes);
  }
}

//------------------------------------------------------------------------------
// If this fails, arrays of other types are written incorrectly or without a warning.
TEST(PolygonOFFWriter, ColorsOfAllTypes)
{
  Grid grid = MakeDecorated();
  AddArray<vtkFloatArray>(grid->GetPointData(), "real", 3, -0.1, 0.1);
  AddArray<vtkIntArray>(grid->GetCellData(), "ColorIndex", 1, -1, 8);
  const auto setColors = [](const char* vertices, const char* faces)
  {
    return [=](vtkPolygonOFFWriter* w)
    {
      w->SetVertexColors(vertices);
      w->SetFaceColors(faces);
    };
  };
  for (const int encoding : { vtkPolygonOFFWriter::ASCII, vtkPolygonOFFWriter::BINARY })
  {
    const Written written = Write(grid,
      [&](vtkPolygonOFFWriter* w)
      {
        setColors("real", "ColorIndex")(w);
        w->SetEncoding(encoding);
      });
    EXPECT_TRUE(std::any_of(written.Warnings.begin(), written.Warnings.end(),
      [](const std::string& warning)
      {
        return warning.find("points with a color outside") != std::string::npos &&
          warning.find("the first is point 0") != std::string::npos;
      }));
    const Result result = ReadAgain(written);
    ASSERT_TRUE(result.Errors.empty());
    double color[4];
    result.Grid->GetPointData()->GetArray("RGBA")->GetTuple(4, color);
    EXPECT_TRUE(color[0] == 255 && color[1] == 255 && color[2] == 255 && color[3] == 255);
    result.Grid->GetPointData()->GetArray("RGBA")->GetTuple(0, color);
    EXPECT_TRUE(color[0] == 0 && color[1] == 0 && color[2] == 26 && color[3] == 255);
    vtkDataArray* const indices = result.Grid->GetCellData()->GetArray("ColorIndex");
    ASSERT_NE(indices, nullptr);
    EXPECT_EQ(indices->GetTuple1(0), -1);
    EXPECT_EQ(indices->GetTuple1(1), 7);
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("RGBA"), nullptr);
  }
  for (const auto& wrong :
    { setColors("missing", ""), setColors("TCoords", ""), setColors("", "missing") })
  {
    const Written refused = Write(grid, wrong);
    EXPECT_EQ(refused.Success, 0);
    EXPECT_EQ(refused.Bytes, "before");
    ASSERT_EQ(refused.Errors.size(), 1u);
    EXPECT_NE(refused.Errors[0].find("three or four components"), std::string::npos)
      << refused.Errors[0];
  }
  const Written without = Write(MakeGrid({ { 0, 0, 0 } }, { { VTK_VERTEX, { 0 } } }),
    [](vtkPolygonOFFWriter* w)
    {
      w->WriteNormalsOn();
      w->WriteTextureCoordinatesOn();
    });
  EXPECT_EQ(without.Bytes, "OFF\n1 0 0\n0 0 0\n");
  EXPECT_EQ(without.Warnings.size(), 2u);
  for (const int components : { 1, 3 })
  {
    const Grid grid = MakeDecorated();
    AddArray<vtkDoubleArray>(grid->GetPointData(), "UVW", components, 0, 0.1);
    grid->GetPointData()->SetActiveTCoords("UVW");
    const Written changed =
      Write(grid, [](vtkPolygonOFFWriter* w) { w->WriteTextureCoordinatesOn(); });
    ASSERT_TRUE(changed.Success);
    const auto tells = [](const std::string& text)
    { return text.find("two texture coordinates") != std::string::npos; };
    EXPECT_EQ(std::count_if(changed.Warnings.begin(), changed.Warnings.end(), tells), 1)
      << components;
  }
}

//------------------------------------------------------------------------------
// If this fails, cells are lost, or written as others.
TEST(PolygonOFFWriter, CellsOfAllKinds)
{
  const Points corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const Written mixed = Write(MakeGrid(corners,
    { { VTK_POLYGON, { 0, 1, 2, 3, 4 } }, { VTK_LINE, { 3, 4 } }, { VTK_VERTEX, { 2 } },
      { VTK_TRIANGLE_STRIP, { 0, 1, 3, 2 } }, { VTK_PIXEL, { 0, 1, 3, 2 } },
      { VTK_POLY_LINE, { 0, 1, 2 } } }));
  ASSERT_TRUE(mixed.Success) << mixed.Errors[0];
  EXPECT_NE(mixed.Bytes.find("\n5 8 0\n"), std::string::npos) << mixed.Bytes;
  EXPECT_EQ(mixed.Bytes.substr(mixed.Bytes.find("5 0 1 2 3 4\n")),
    "5 0 1 2 3 4\n2 3 4\n1 2\n3 0 1 3\n3 1 2 3\n4 0 1 2 3\n2 0 1\n2 1 2\n");
  ASSERT_EQ(mixed.Warnings.size(), 1u);
  EXPECT_NE(mixed.Warnings[0].find("with two vertices: 3, vertices as faces with one: 1;"),
    std::string::npos);

  // All points as vertices are a cloud; others are faces with one vertex.
  const auto vertices = [&](std::vector<vtkIdType> ids)
  {
    Cells cells;
    for (const vtkIdType id : ids)
    {
      cells.push_back({ VTK_VERTEX, { id } });
    }
    return Write(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, cells)).Bytes;
  };
  EXPECT_EQ(vertices({ 0, 1 }), "OFF\n2 0 0\n0 0 0\n1 0 0\n");
  EXPECT_EQ(vertices({ 1, 0 }), "OFF\n2 2 0\n0 0 0\n1 0 0\n1 1\n1 0\n");
  EXPECT_EQ(vertices({ 1 }), "OFF\n2 1 0\n0 0 0\n1 0 0\n1 1\n");

  // Two tetrahedra: six boundary faces, seven in all.
  const Grid tetrahedra =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } });
  EXPECT_EQ(Count(ReadAgain(Write(tetrahedra)).Grid, VTK_TRIANGLE), 6);
  const Written every = Write(
    tetrahedra, [](vtkPolygonOFFWriter* w) { w->SetFacesOfVolumes(vtkPolygonOFFWriter::EVERY); });
  EXPECT_EQ(Count(ReadAgain(every).Grid, VTK_TRIANGLE), 7);

  const Grid curved = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0, 0 }, { 0.5, 0.5, 0 }, { 0, 0.5, 0 } },
    { { VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 } } });
  const Written corner = Write(curved);
  EXPECT_EQ(corner.Bytes, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(corner.Warnings.size(), 1u);
  const Written empty = Write(MakeGrid({ { 0, 0, 0 } }, { { VTK_EMPTY_CELL, {} } }));
  EXPECT_EQ(empty.Success, 0);
  EXPECT_EQ(empty.Bytes, "before");
}

//------------------------------------------------------------------------------
// If this fails, the bytes of a file depend on threads.
TEST(PolygonOFFWriter, ThreadsChangeNothing)
{
  Sample colored;
  colored.Keyword = "STCNOFF";
  colored.HasTexture = colored.HasColors = colored.HasNormals = true;
  const Result mesh = ReadBytes(colored.GetText(20000));
  ASSERT_TRUE(mesh.Errors.empty());
  for (const int encoding : { vtkPolygonOFFWriter::ASCII, vtkPolygonOFFWriter::BINARY })
  {
    std::string expected;
    for (const int threads : { 1, 2, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
        [&]
        {
          const Written written = Write(mesh.Grid,
            [&](vtkPolygonOFFWriter* w)
            {
              w->WriteNormalsOn();
              w->WriteTextureCoordinatesOn();
              w->SetVertexColors("RGBA");
              w->SetEncoding(encoding);
            });
          expected = expected.empty() ? written.Bytes : expected;
          EXPECT_EQ(written.Bytes == expected, true);
        });
    }
  }
}
