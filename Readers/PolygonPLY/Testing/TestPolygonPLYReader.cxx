// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// PLY files of all encodings: how they are read, and which are refused.
#include "FormatTesting.h"
#include "PLYSamples.h"
#include "PolygonPLYReading.h"
#include "SharedData.h"
#include "vtkPolygonPLYReader.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <map>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
std::vector<vtkIdType> GetCell(const Result& result, vtkIdType cell)
{
  std::vector<vtkIdType> ids(result.Grid->GetNumberOfPoints());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<vtkIdType>(i);
  }
  return DescribeCell(result.Grid, cell, ids)[0];
}

using Ids = std::vector<vtkIdType>;
}

//------------------------------------------------------------------------------
// If this fails, the result depends on the encoding of a file.
TEST(PolygonPLYReader, EncodingsSayTheSame)
{
  const Sample sample = MakeMixedSurface(40);
  const Result text = ReadBytes(sample.Encode("ascii"));
  ASSERT_TRUE(text.Errors.empty()) << text.Errors[0];
  for (const char* format : { "binary_little_endian", "binary_big_endian" })
  {
    const Result binary = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(binary.Errors.empty()) << binary.Errors[0];
    ExpectSameGrid(text.Grid, binary.Grid);
  }
}

//------------------------------------------------------------------------------
// If this fails, coordinates lose digits, or are taken from the wrong columns.
TEST(PolygonPLYReader, CoordinatesKeepTheirPrecision)
{
  const struct
  {
    const char* X;
    const char* Z;
    int Type;
    double Value;
  } cases[] = { { "float", "float", VTK_FLOAT, static_cast<double>(0.1f) },
    { "double", "double", VTK_DOUBLE, 0.1 }, { "float", "double", VTK_DOUBLE, 0.1 },
    { "short", "uchar", VTK_FLOAT, 201 }, { "int", "int", VTK_DOUBLE, 2147483647 },
    { "uint", "float", VTK_DOUBLE, 0.5 } };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    for (const auto& one : cases)
    {
      // In another order, with other properties in between and lists before and after.
      Sample sample;
      Element& vertices = sample.AddElement("vertex");
      vertices.Add("list uchar short", "before").Add(one.Z, "z").Add("uchar", "flag");
      vertices.Add(one.X, "x").Add("list ushort double", "between").Add(one.X, "y");
      vertices.Rows = { { { 1, 2 }, { one.Value }, { 7 }, { 1 }, {}, { 2 } },
        { {}, { 3 }, { 9 }, { 4 }, { 1, 2, 3 }, { 5 } } };
      const Result result = ReadBytes(sample.Encode(format));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_EQ(result.Warnings.size(), 2u); // about the two lists
      ASSERT_EQ(result.Grid->GetNumberOfPoints(), 2);
      EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), one.Type) << one.X << " " << one.Z;
      double x[3];
      result.Grid->GetPoint(0, x);
      EXPECT_EQ(x[0], 1);
      EXPECT_EQ(x[1], 2);
      EXPECT_EQ(x[2], one.Value);
      result.Grid->GetPoint(1, x);
      EXPECT_EQ(x[0], 4);
      EXPECT_EQ(x[1], 5);
      EXPECT_EQ(x[2], 3);
      EXPECT_EQ(result.Grid->GetPointData()->GetArray("flag")->GetTuple1(1), 9);
      EXPECT_EQ(Count(result.Grid, VTK_VERTEX), 2);
    }
  }
}

//------------------------------------------------------------------------------
// Each name becomes an array, which VTK compares with all others.
TEST(PolygonPLYReader, ManyNames)
{
  for (const bool ofOneElement : { true, false })
  {
    std::string bytes = "ply\nformat ascii 1.0\nelement vertex 1\n";
    for (int i = 0; i < 10001; ++i)
    {
      const std::string number = std::to_string(i);
      bytes += (ofOneElement || i == 0 ? "" : "element e" + number + " 0\n") + "property char p" +
        number + "\n";
    }
    const Result result = ReadBytes(bytes + "end_header\n");
    ASSERT_EQ(result.Errors.size(), 1);
    EXPECT_NE(
      result.Errors[0].find("expected at most 10000 elements and properties"), std::string::npos)
      << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, binary values begin a byte too early or too late.
TEST(PolygonPLYReader, LineEndsOfTheHeader)
{
  const Sample sample = MakeMixedSurface(3);
  const Result expected = ReadBytes(sample.Encode("ascii"));
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    for (const char* lineEnd : { "\n", "\r\n", "\r", "\n\r" })
    {
      const Result result = ReadBytes(sample.Encode(format, lineEnd));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      ExpectSameGrid(expected.Grid, result.Grid);
    }
  }
  // Values that look like line ends.
  for (const std::string lineEnd : { "\n", "\r\n", "\r", "\n\r" })
  {
    for (const std::string values : { "\n\r\n", "\r\n\r", "\n\n\n", "\r\r\r" })
    {
      std::string bytes;
      for (const char* line : { "ply", "format binary_little_endian 1.0", "element vertex 1",
             "property char x", "property char y", "property char z", "end_header" })
      {
        bytes += line + lineEnd;
      }
      const Result result = ReadBytes(bytes + values);
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_EQ(result.Grid->GetPoint(0)[i], values[i]);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, NormalsColorsAndTextures)
{
  const Result result = ReadBytes(
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "property double nx\nproperty double ny\nproperty double nz\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty float s\n"
    "property float t\nelement face 1\nproperty list uchar int vertex_indices\n"
    "property float diffuse_red\nproperty float diffuse_green\nproperty float diffuse_blue\n"
    "property int red\nend_header\n"
    "0 0 0 0 0 1 1 2 3 4 0.25 0.5\n1 0 0 0 0 1 255 0 0 255 0 1\n0 1 0 0 0 -1 9 9 9 9 1 1\n"
    "3 0 1 2 0 0.5 7 -5\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  vtkPointData* points = result.Grid->GetPointData();
  ASSERT_NE(points->GetNormals(), nullptr);
  EXPECT_EQ(points->GetNormals()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(points->GetNormals()->GetComponent(2, 2), -1);
  ASSERT_NE(points->GetTCoords(), nullptr);
  EXPECT_EQ(points->GetTCoords()->GetComponent(0, 1), 0.5);
  vtkDataArray* colors = points->GetArray("RGBA");
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(colors->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(colors->GetComponent(0, 3), 4);
  vtkDataArray* faceColors = result.Grid->GetCellData()->GetArray("RGB");
  ASSERT_NE(faceColors, nullptr);
  EXPECT_EQ(faceColors->GetComponent(0, 0), 0);
  EXPECT_EQ(faceColors->GetComponent(0, 1), 128);
  EXPECT_EQ(faceColors->GetComponent(0, 2), 255);
  EXPECT_EQ(result.Grid->GetCellData()->GetArray("red")->GetTuple1(0), -5);
}

//------------------------------------------------------------------------------
// If this fails, colors are changed without a warning.
TEST(PolygonPLYReader, ColorsBeyondTheirRange)
{
  for (const char* format : { "ascii", "binary_little_endian" })
  {
    Sample sample;
    Element& vertices = sample.AddElement("vertex");
    vertices.Add("float", "x").Add("float", "y").Add("float", "z");
    vertices.Add("float", "red").Add("float", "green").Add("float", "blue");
    vertices.Rows = { { { 0 }, { 0 }, { 0 }, { 0 }, { 127 }, { 0.5 } },
      { { 1 }, { 0 }, { 0 }, { -1 }, { 1 }, { 255 } } };
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 1u);
    EXPECT_NE(
      result.Warnings[0].find("3 color values of 'vertex' outside 0 to 1"), std::string::npos)
      << result.Warnings[0];
    EXPECT_EQ(result.Grid->GetPointData()->GetArray("RGB")->GetComponent(0, 1), 255);
  }
}

//------------------------------------------------------------------------------
// If this fails, vectors that our writer split are not joined, or others are.
TEST(PolygonPLYReader, VectorsThatCommentsTellOf)
{
  const Result result = ReadBytes(
    "ply\nformat ascii 1.0\ncomment components v 2\ncomment components w 3\nelement vertex 1\n"
    "property float x\nproperty float y\nproperty float z\nproperty short v_0\nproperty short v_1\n"
    "property float w_0\nproperty float w_1\nend_header\n0 0 0 5 6 7 8\n");
  ASSERT_TRUE(result.Errors.empty());
  vtkDataArray* vector = result.Grid->GetPointData()->GetArray("v");
  ASSERT_NE(vector, nullptr);
  EXPECT_EQ(vector->GetNumberOfComponents(), 2);
  EXPECT_EQ(vector->GetComponent(0, 1), 6);
  EXPECT_NE(result.Grid->GetPointData()->GetArray("w_1"), nullptr);
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, FacesOfAnySize)
{
  Sample sample;
  sample.AddVertices(6);
  Element& faces = sample.AddElement("face");
  faces.Add("uchar", "before").Add("list ushort uint", "vertex_index").Add("double", "after");
  faces.Rows = { { { 1 }, { 0, 1, 2, 3, 4, 5 }, { .1 } }, { { 2 }, { 5, 4, 3 }, { .2 } },
    { { 3 }, {}, { .3 } }, { { 4 }, { 0, 1, 2, 3 }, { .4 } }, { { 5 }, { 2 }, { .5 } },
    { { 6 }, { 2, 4 }, { .6 } } };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 2u);
    EXPECT_NE(result.Warnings[0].find("1 list without vertices"), std::string::npos)
      << result.Warnings[0];
    EXPECT_NE(result.Warnings[1].find("2 faces with fewer than 3"), std::string::npos);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 5);
    EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_POLYGON, 0, 1, 2, 3, 4, 5 }));
    EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_TRIANGLE, 5, 4, 3 }));
    EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_QUAD, 0, 1, 2, 3 }));
    EXPECT_EQ(GetCell(result, 3), (Ids{ VTK_VERTEX, 2 }));
    EXPECT_EQ(GetCell(result, 4), (Ids{ VTK_LINE, 2, 4 }));
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("before")->GetTuple1(2), 4);
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("after")->GetTuple1(4), .6);
  }
}

//------------------------------------------------------------------------------
// If this fails, triangles of strips are reversed, lost or invented.
TEST(PolygonPLYReader, StripsAlternate)
{
  Sample sample;
  sample.AddVertices(7);
  Element& strips = sample.AddElement("tristrips");
  strips.Add("list int int", "vertex_indices").Add("uchar", "material");
  strips.Rows = { { { 0, 1, 2, 3, 3, 4, -1, 4, 5, -1, 1, 2, 6, 5 }, { 8 } },
    { { 6, 5, 4 }, { 9 } } };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 5);
    EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_TRIANGLE, 0, 1, 2 }));
    EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_TRIANGLE, 1, 3, 2 }));
    // (2, 3, 3) and (3, 4, 3) are not triangles.
    EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_TRIANGLE, 1, 2, 6 }));
    EXPECT_EQ(GetCell(result, 3), (Ids{ VTK_TRIANGLE, 2, 5, 6 }));
    EXPECT_EQ(GetCell(result, 4), (Ids{ VTK_TRIANGLE, 6, 5, 4 }));
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("material"), nullptr);
    ASSERT_EQ(result.Warnings.size(), 1u);
    EXPECT_NE(
      result.Warnings[0].find("the values of triangle strips are omitted"), std::string::npos)
      << result.Warnings[0];
  }
  // Unsigned types have no -1.
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    strips.Properties[0].Type = "list int uint";
    const Result refused = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(refused.IsProperError());
    EXPECT_NE(refused.Errors[0].find("expected a vertex of a strip from 0 to 6"), std::string::npos)
      << refused.Errors[0];
    EXPECT_NE(refused.Errors[0].find("4294967295"), std::string::npos) << refused.Errors[0];
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, EdgesBesideFaces)
{
  Sample sample;
  Element& edges = sample.AddElement("edge");
  edges.Add("uchar", "kind").Add("int", "vertex2").Add("short", "vertex1").Add("float", "length");
  edges.Rows = { { { 3 }, { 2 }, { 0 }, { 1.5 } } };
  sample.AddVertices(3);
  Element& faces = sample.AddElement("face");
  faces.Add("list uchar int", "vertex_indices").Add("double", "length");
  faces.Rows = { { { 0, 1, 2 }, { 2.5 } } };
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 2);
    EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_LINE, 0, 2 }));
    EXPECT_EQ(GetCell(result, 1), (Ids{ VTK_TRIANGLE, 0, 1, 2 }));
    vtkDataArray* lengths = result.Grid->GetCellData()->GetArray("length");
    EXPECT_EQ(lengths->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(lengths->GetTuple1(0), 1.5);
    EXPECT_EQ(lengths->GetTuple1(1), 2.5);
    vtkDataArray* kinds = result.Grid->GetCellData()->GetArray("kind");
    EXPECT_EQ(kinds->GetTuple1(0), 3);
    EXPECT_EQ(kinds->GetTuple1(1), 0); // faces lack this property
  }
}

//------------------------------------------------------------------------------
// If this fails, edges that Camarón writes without declaring them in the header are lost.
TEST(PolygonPLYReader, EdgesOfCamaron)
{
  const std::string header =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element edge 2\nend_header\n";
  const Result text = ReadBytes(
    "ply\nformat ascii 1.0\n" + header + "0 0 0\n1 0 0\n0 1 0\n0 1 150 0 3\n1 2 0 255 1\n");
  ASSERT_TRUE(text.Errors.empty()) << text.Errors[0];
  EXPECT_EQ(GetCell(text, 1), (Ids{ VTK_LINE, 1, 2 }));
  vtkDataArray* colors = text.Grid->GetCellData()->GetArray("RGB");
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(colors->GetComponent(0, 0), 150);
  EXPECT_EQ(colors->GetComponent(1, 2), 1);

  std::string binary = "ply\nformat binary_big_endian 1.0\n" + header;
  for (const float x : { 0, 0, 0, 1, 0, 0, 0, 1, 0 })
  {
    AppendBytes(binary, x, GetByteOrder() == ByteOrder::Little);
  }
  for (const std::int32_t i : { 0, 1, 150, 0, 3, 1, 2, 0, 255, 1 })
  {
    AppendBytes(binary, i, GetByteOrder() == ByteOrder::Little);
  }
  const Result same = ReadBytes(binary);
  ASSERT_TRUE(same.Errors.empty()) << same.Errors[0];
  ExpectSameGrid(text.Grid, same.Grid);
}

//------------------------------------------------------------------------------
// If this fails, cells given by faces are not recognized, or values go to the wrong cells.
TEST(PolygonPLYReader, CellsOfFaces)
{
  const Sample sample = MakeCells();
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    // A hexahedron and a pyramid on it, a separate face and an edge.
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 4);
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 10);
    EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    EXPECT_EQ(result.Grid->GetCellType(1), VTK_PYRAMID);
    EXPECT_EQ(GetCell(result, 2), (Ids{ VTK_TRIANGLE, 0, 1, 9 }));
    EXPECT_EQ(GetCell(result, 3), (Ids{ VTK_LINE, 0, 9 }));
    vtkDataArray* zones = result.Grid->GetCellData()->GetArray("zone");
    EXPECT_EQ(zones->GetTuple1(0), 7);
    EXPECT_EQ(zones->GetTuple1(1), 8);
    EXPECT_EQ(zones->GetTuple1(2), 0);
    vtkDataArray* areas = result.Grid->GetCellData()->GetArray("area");
    EXPECT_TRUE(std::isnan(areas->GetTuple1(0)));
    EXPECT_EQ(areas->GetTuple1(2), 3);
    EXPECT_EQ(result.Grid->GetPointData()->GetArray("mass")->GetTuple1(9), 9);
    ASSERT_EQ(result.Warnings.size(), 1u); // about the values of the other faces
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, OtherElementsBecomeFieldArrays)
{
  const Result result = ReadBytes(
    "ply\nformat ascii 1.0\nelement camera 2\nproperty float view\nproperty list uchar int seen\n"
    "property short id\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n"
    "1.5 2 1 2 10\n2.5 0 11\n3 4\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetPoint(0)[0], 3);
  EXPECT_EQ(result.Grid->GetPoint(0)[2], 0); // without a property z
  vtkDataArray* ids = result.Grid->GetFieldData()->GetArray("camera.id");
  ASSERT_NE(ids, nullptr);
  EXPECT_EQ(ids->GetDataType(), VTK_SHORT);
  EXPECT_EQ(ids->GetTuple1(1), 11);
  EXPECT_EQ(result.Warnings.size(), 2u); // about the list, and z
}

//------------------------------------------------------------------------------
// If this fails, text of other programs, or edited by hand, is refused or misread.
TEST(PolygonPLYReader, LaysTextOutFreely)
{
  const std::string header =
    "\xef\xbb\xbf# first\n\n  ply \nformat ascii 1.0\nobj_info x\n#\nelement vertex 3\n\tproperty "
    "float "
    "x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int "
    "vertex_indices\nend_header\n";
  for (const char* body : { "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         "# vertices\n\n 0 0 0\r\n1 0 0 # one\n\n+0 1e0 0\n#faces\n3.0 0 1 2" })
  {
    const Result result = ReadBytes(header + body);
    if (std::string(body).find("3.0") != std::string::npos)
    {
      EXPECT_TRUE(result.IsProperError()); // a length must be an integer
      continue;
    }
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_EQ(GetCell(result, 0), (Ids{ VTK_TRIANGLE, 0, 1, 2 }));
    EXPECT_EQ(result.Grid->GetPoint(2)[1], 1);
  }
  // Blender 2.47 wrote such a line.
  const Result blender =
    ReadBytes("ply\nformat ascii 1.0\nCreated by Blender3D 247\nelement vertex "
              "1\nproperty float x\nproperty float y\nend_header\n0 0\n");
  EXPECT_TRUE(blender.Errors.empty());
  EXPECT_EQ(blender.Warnings.size(), 2u); // also about z
  // A sequence of numbers.
  const Result stream = ReadBytes(header + "0 0 0 1 0\n0 0 1 0 3\n0\n1 2\n");
  ASSERT_TRUE(stream.Errors.empty()) << stream.Errors[0];
  EXPECT_EQ(GetCell(stream, 0), (Ids{ VTK_TRIANGLE, 0, 1, 2 }));
  EXPECT_EQ(stream.Warnings.size(), 1u);
  // More values than declared.
  const Result more = ReadBytes(header + "0 0 0 9\n1 0 0\n0 1 0 8 7\n3 0 1 2 6\n");
  ASSERT_TRUE(more.Errors.empty()) << more.Errors[0];
  ASSERT_EQ(more.Warnings.size(), 2u);
  EXPECT_NE(more.Warnings[0].find("2 rows of 'vertex'"), std::string::npos) << more.Warnings[0];
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, NothingToShow)
{
  const Result none =
    ReadBytes("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty "
              "float y\nproperty float z\nelement face 0\nproperty list uchar int "
              "vertex_indices\nend_header\n");
  EXPECT_TRUE(none.Errors.empty() && none.Warnings.empty() && none.IsEmpty());
  const Result elsewhere =
    ReadBytes("ply\nformat ascii 1.0\nelement thing 1\nproperty int a\nend_header\n1\n");
  EXPECT_TRUE(elsewhere.Errors.empty() && elsewhere.IsEmpty());
  EXPECT_EQ(elsewhere.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, RefusesWhatIsWrong)
{
  const std::string vertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string text = "ply\nformat ascii 1.0\n" + vertices + face + "0 0 0\n1 0 0\n0 1 0\n";
  const std::string binary =
    "ply\nformat binary_little_endian 1.0\n" + vertices + face + std::string(36, '\0');
  const struct
  {
    std::string Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", vtkErrorCode::UnrecognizedFileTypeError, "test.ply:1: expected a PLY file" },
    { "plyx\n", vtkErrorCode::UnrecognizedFileTypeError, "test.ply:1: expected a PLY file" },
    { "ply\nformat ascii 1.0\n", vtkErrorCode::PrematureEndOfFileError, "expected 'end_header'" },
    { "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n0\n",
      vtkErrorCode::PrematureEndOfFileError, "test.ply:5: expected 'end_header'" },
    { "ply\nformat binary 1.0\n", vtkErrorCode::FileFormatError, "test.ply:2: expected 'ascii'" },
    { "ply\nformat ascii 1.0\nelement vertex -1\n", vtkErrorCode::FileFormatError, "found '-1'" },
    { "ply\nformat ascii 1.0\nelement vertex 3000000000\n", vtkErrorCode::FileFormatError,
      "from 0 to 2147483647" },
    { "ply\nformat ascii 1.0\nelement vertex\n", vtkErrorCode::FileFormatError,
      "a name and a count" },
    { "ply\nproperty float x\n", vtkErrorCode::FileFormatError, "an element before" },
    { "ply\nelement a 1\nproperty real x\nend_header\n", vtkErrorCode::FileFormatError,
      "test.ply:3: expected a type" },
    { "ply\nelement a 1\nproperty list float int x\nend_header\n", vtkErrorCode::FileFormatError,
      "an integer type" },
    { "ply\nsomething else\nend_header\n", vtkErrorCode::FileFormatError, "found 'something'" },
    { "ply\nelement vertex 99999\nproperty float x\nproperty float y\nend_header\n0 0\n",
      vtkErrorCode::PrematureEndOfFileError, "at least 399996 bytes" },
    { "ply\nelement vertex 1\nproperty float a\nend_header\n0\n", vtkErrorCode::FileFormatError,
      "'x'" },
    { text + "3 0 1 3\n", vtkErrorCode::FileFormatError,
      "test.ply:13: expected a vertex of a face from 0 to 2, found '3'" },
    { text + "3 0 1 -1\n", vtkErrorCode::FileFormatError, "found '-1'" },
    { text + "3 0 1 x\n", vtkErrorCode::FileFormatError, "found 'x'" },
    { text + "3 0 1\n", vtkErrorCode::PrematureEndOfFileError, "found the end of the file" },
    { text + "3 0 1\n9\n", vtkErrorCode::FileFormatError, "found the end of the line" },
    { text + "-3 0 1 2\n", vtkErrorCode::FileFormatError, "found '-3'" },
    { text + "", vtkErrorCode::PrematureEndOfFileError, "'face'" },
    { "ply\nelement vertex 1\nproperty uchar x\nproperty float y\nend_header\n256 0\n",
      vtkErrorCode::FileFormatError, "'x' of 'vertex' (uchar), found '256'" },
    { "ply\nelement vertex 1\nproperty uchar x\nproperty float y\nend_header\n1.5 0\n",
      vtkErrorCode::FileFormatError, "found '1.5'" },
    { "ply\nelement vertex 1\nproperty float x\nproperty float y\nelement edge 1\nproperty int "
      "vertex1\nproperty int vertex2\nend_header\n0 0\n0 1\n",
      vtkErrorCode::FileFormatError,
      "test.ply:10: expected a vertex of an edge from 0 to 0, found '1'" },
    { binary, vtkErrorCode::PrematureEndOfFileError,
      "expected at least 1 bytes of 1 elements 'face'" },
    { binary + "\3\1\1", vtkErrorCode::PrematureEndOfFileError,
      "list 'vertex_indices' of 'face' 0" },
    { binary + std::string("\3\0\0\0\0\1\0\0\0\7\0\0\0", 13), vtkErrorCode::FileFormatError,
      "test.ply: byte 214: expected a vertex of a face from 0 to 2 in 'face' 0, found 7" },
    { binary.substr(0, 180), vtkErrorCode::PrematureEndOfFileError, "3 elements 'vertex'" },
  };
  for (const auto& wrong : cases)
  {
    const Result result = ReadBytes(wrong.Text);
    ASSERT_TRUE(result.IsProperError()) << wrong.Message;
    EXPECT_EQ(result.ErrorCode, wrong.Code) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(PolygonPLYReader, ThreadsAndChunksChangeNothing)
{
  for (const Sample& sample : { MakeMixedSurface(3000), MakeCells() })
  {
    for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
    {
      for (const char* lineEnd : { "\n", "\r\n", "\r" })
      {
        const File file(sample.Encode(format, lineEnd), "test.ply");
        vtkNew<vtkUnstructuredGrid> expected;
        Warnings warnings;
        ScanError error;
        ASSERT_TRUE(ReadPolygonPLY(file.Path, {}, expected, warnings, error)) << error.Message;
        for (const int threads : { 1, 2, 3 })
        {
          for (const vtkIdType chunk : { 60, 3000, 20000 })
          {
            Warnings others;
            vtkNew<vtkUnstructuredGrid> grid;
            vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
              [&]
              {
                ASSERT_TRUE(ReadPolygonPLY(file.Path, {}, grid, others, error, Progress(), chunk));
              });
            ExpectSameGrid(expected, grid);
            EXPECT_EQ(warnings.GetSentences(), others.GetSentences());
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, PiecesMakeTheWhole)
{
  for (const char* format : { "ascii", "binary_little_endian" })
  {
    Sample sample = MakeMixedSurface(50);
    sample.AddElement("camera").Add("short", "id").Rows = { { { 10 } }, { { 11 } } };
    const File surface(sample.Encode(format), "test.ply");
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(surface.Path, 3, 0);
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(surface.Path, 3, 2);
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(surface.Path, 70, 1);
    const File cells(MakeCells().Encode(format), "cells.ply");
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(cells.Path, 2, 0);
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(cells.Path, 3, 1);
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, KnowsItsFiles)
{
  vtkNew<vtkPolygonPLYReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.ply").Path.c_str()); };
  EXPECT_EQ(canRead("ply\nformat ascii 1.0\nend_header\n"), 1);
  EXPECT_EQ(canRead("ply\r\nformat ascii 1.0\r\n"), 1);
  EXPECT_EQ(canRead("ply\rformat ascii 1.0\r"), 1);
  EXPECT_EQ(canRead("# by hand\n\nply\nformat ascii 1.0\n"), 1);
  EXPECT_EQ(canRead("OFF\n3 1 0\n"), 0);
  EXPECT_EQ(canRead("plywood\n"), 0);
  EXPECT_EQ(canRead(""), 0);
  EXPECT_EQ(reader->CanReadFile("/nonexistent.ply"), 0);
}

//------------------------------------------------------------------------------
TEST(PolygonPLYReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("ply");
  const std::string folder = GetSharedData("ply").string();
  using Types = std::map<int, vtkIdType>;
  const struct
  {
    const char* Name;
    vtkIdType Points;
    Types Cells;
    int PointArrays, CellArrays;
    std::size_t Warnings;
  } files[] = {
    { "assimp_cube", 8, { { VTK_QUAD, 6 } }, 0, 0, 0 },
    { "assimp_cube_binary_starts_with_nl", 8, { { VTK_QUAD, 6 } }, 0, 0, 0 },
    { "assimp_float-color", 3, { { VTK_TRIANGLE, 1 } }, 1, 0, 0 },
    { "camaron_additional_edges", 8, { { VTK_LINE, 4 } }, 0, 1, 0 },
    { "camaron_ascii", 8, { { VTK_QUAD, 6 } }, 0, 0, 0 },
    { "camaron_binary_big", 8, { { VTK_QUAD, 6 } }, 0, 0, 0 },
    { "camaron_binary_little", 8, { { VTK_QUAD, 6 } }, 0, 0, 0 },
    { "camaron_hippo_tristrips", 23105, { { VTK_TRIANGLE, 46202 } }, 0, 0, 0 },
    { "camaron_other_property_types", 8, { { VTK_QUAD, 6 } }, 1, 0, 0 },
    { "camaron_vertex_cloud", 8, { { VTK_VERTEX, 8 } }, 0, 0, 0 },
    { "dev_big_double_props", 231, { { VTK_QUAD, 202 }, { VTK_POLYGON, 18 }, { VTK_LINE, 1 } }, 4,
      2, 1 },
    { "dev_polyhedra_octree_style", 331,
      { { VTK_HEXAHEDRON, 60 }, { VTK_WEDGE, 60 }, { VTK_PYRAMID, 60 }, { VTK_TETRA, 60 } }, 0, 0,
      0 },
    { "happly_platonic_shelf", 50, { { VTK_TRIANGLE, 32 }, { VTK_QUAD, 6 }, { VTK_POLYGON, 12 } },
      0, 0, 0 },
    { "happly_platonic_shelf_ascii", 50,
      { { VTK_TRIANGLE, 32 }, { VTK_QUAD, 6 }, { VTK_POLYGON, 12 } }, 0, 0, 0 },
    { "tgt_sphere", 162, { { VTK_TRIANGLE, 320 } }, 0, 0, 0 },
    { "trimesh_empty", 0, {}, 1, 0, 0 },
    { "trimesh_fuze", 502, { { VTK_TRIANGLE, 1000 } }, 1, 2, 0 },
    { "trimesh_metadata", 4, { { VTK_TRIANGLE, 2 } }, 0, 1, 0 },
    { "trimesh_multi", 4, { { VTK_QUAD, 1 } }, 2, 0, 0 },
    { "trimesh_ply_empty_bin", 0, {}, 1, 0, 0 },
    { "trimesh_points_ascii_with_lists", 5, { { VTK_VERTEX, 5 } }, 0, 0, 2 },
    { "trimesh_suzanne", 1966, { { VTK_QUAD, 468 }, { VTK_TRIANGLE, 32 } }, 2, 0, 0 },
  };
  for (const auto& file : files)
  {
    SCOPED_TRACE(file.Name);
    const Result result = ReadWith<vtkPolygonPLYReader>(folder + "/" + file.Name + ".ply");
    EXPECT_TRUE(result.Errors.empty());
    EXPECT_EQ(result.Warnings.size(), file.Warnings);
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points);
    Types types;
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      ++types[result.Grid->GetCellType(cell)];
    }
    EXPECT_EQ(types, file.Cells);
    EXPECT_EQ(result.Grid->GetPointData()->GetNumberOfArrays(), file.PointArrays);
    EXPECT_EQ(result.Grid->GetCellData()->GetNumberOfArrays(), file.CellArrays);
  }
}
