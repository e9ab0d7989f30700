// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// OFF files and the grids that they become.
#include "PolygonOFFSamples.h"
#include "SharedData.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
constexpr char Cube[] = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n";
constexpr char CubeFaces[] = "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

//------------------------------------------------------------------------------
std::vector<double> GetTuple(vtkDataSetAttributes* attributes, const char* name, vtkIdType i)
{
  vtkDataArray* const array = attributes->GetArray(name);
  if (!array)
  {
    return {};
  }
  std::vector<double> tuple(array->GetNumberOfComponents());
  array->GetTuple(i, tuple.data());
  return tuple;
}
using Tuple = std::vector<double>;

//------------------------------------------------------------------------------
void ExpectCube(const std::string& text, std::size_t warnings = 0)
{
  const Result result = ReadBytes(text);
  ASSERT_TRUE(result.Errors.empty()) << text << result.Errors[0];
  EXPECT_EQ(result.Warnings.size(), warnings) << text;
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 8);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 6);
  EXPECT_EQ(Count(result.Grid, VTK_QUAD), 6);
  EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  double x[3];
  result.Grid->GetPoint(6, x);
  EXPECT_TRUE(x[0] == 1 && x[1] == 1 && x[2] == 1);
  EXPECT_EQ(DescribeCell(result.Grid, 5, { 0, 1, 2, 3, 4, 5, 6, 7 })[0],
    (std::vector<vtkIdType>{ VTK_QUAD, 3, 0, 4, 7 }));
}

//------------------------------------------------------------------------------
// The values of a sample as shown by the reader.
void ExpectSample(const Sample& sample, const Result& result, int vertices, const std::string& what)
{
  ASSERT_TRUE(result.Errors.empty()) << what << result.Errors[0];
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), vertices) << what;
  EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), vertices - 2);
  EXPECT_EQ(result.Warnings.size(), sample.Dimension > 3 ? 1u : 0u) << what;
  const int size = sample.Dimension ? sample.Dimension : 3;
  vtkPointData* const data = result.Grid->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), sample.HasNormals + sample.HasColors + sample.HasTexture)
    << what;
  EXPECT_EQ(data->GetNormals() != nullptr, sample.HasNormals);
  EXPECT_EQ(data->GetTCoords() != nullptr, sample.HasTexture);
  for (int i = 0; i < vertices; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(result.Grid->GetPoint(i)[c], c < size ? 0.5 * i + 10 * c : 0) << what;
      if (sample.HasNormals)
      {
        EXPECT_EQ(GetTuple(data, "Normals", i)[c], c == i % size ? 1 : 0) << what;
      }
    }
    if (sample.HasColors)
    {
      EXPECT_EQ(
        GetTuple(data, "RGBA", i), (Tuple{ std::floor(63.75 * (i % 5) + 0.5), 255, 0, 128 }))
        << what;
    }
    if (sample.HasTexture)
    {
      EXPECT_EQ(GetTuple(data, "TCoords", i), (Tuple{ 0.125 * i, 1 - 0.125 * i })) << what;
    }
  }
}
}

//------------------------------------------------------------------------------
// If this fails, headers that programs write are misread.
TEST(PolygonOFFReader, HeadersOfAllKinds)
{
  const std::string body = std::string(Cube) + CubeFaces;
  for (const char* header : { "OFF\n8 6 12\n", "OFF\n8 6 0\n", "OFF\n8 6\n", "OFF 8 6 12\n",
         "OFF8 6 12\n", "\t  OFF8 6 12 # or nah\n", "8 6 12\n", "8 6\n", "\xef\xbb\xbfOFF\n8 6 0\n",
         "# first\n\nOFF # keyword\n\n# counts\n8 6 0 # more\n\n", "OFF\n8 6\n0\n",
         "OFF\n8\n6\n0\n", "OFF\n8 6 -1\n", "OFF\n8 6 99999999999\n", "OFF\r\n8 6 12\r\n",
         "nOFF 3\n8 6 0\n", "nOFF\n3\n8 6 0\n", "nOFF 3 8 6 0\n", "OFF#8 9 10\n8 6 0\n",
         "appearance {\n +texturing # }\n texture { file a.pgm }\n}\nOFF\n8 6 0\n",
         "appearance{}OFF 8 6 0\n" })
  {
    ExpectCube(header + body);
  }
  ExpectCube("OFF\n8 6 0\n" + body + "# the end\n\n\n");
  ExpectCube("OFF\n8 6 0\n" + body + "4 0 1 2 3\n", 1);
  ExpectCube("OFF\n8 6 0\n" + body.substr(0, body.size() - 1));
}

//------------------------------------------------------------------------------
// If this fails, files without one record per line are misread.
TEST(PolygonOFFReader, LinesOfAllKinds)
{
  std::string body = std::string("OFF\n8 6 0\n") + Cube + CubeFaces;
  const auto replace = [&](const std::string& from, const std::string& to)
  {
    std::string text;
    for (const char c : body)
    {
      text += std::string(1, c) == from ? to : std::string(1, c);
    }
    return text;
  };
  for (const char* lineEnd :
    { "\n", "\r\n", "\r", "\n\n", " # comment 1 2 3\n", "\t \n  \n# 9\n  " })
  {
    ExpectCube(replace("\n", lineEnd));
  }
  // The ids of a face on lines of their own, with blank lines between.
  std::string wrapped = std::string("OFF\n8 6 0\n") + Cube;
  for (const char c : std::string(CubeFaces))
  {
    wrapped += c == ' ' ? std::string("\n\n") : std::string(1, c);
  }
  ExpectCube(wrapped);
  // One coordinate per line.
  std::string tall = "OFF\n8 6 0\n";
  for (const char c : std::string(Cube))
  {
    tall += c == ' ' ? '\n' : c;
  }
  ExpectCube(tall + CubeFaces);
  // More values on the lines of vertices.
  ExpectCube("OFF\n8 6 0\n0 0 0 255 0 0\n" + std::string(Cube).substr(6) + CubeFaces, 1);
}

//------------------------------------------------------------------------------
// If this fails, columns of vertices are confused.
TEST(PolygonOFFReader, EveryKeyword)
{
  for (const Sample& sample : GetSamples())
  {
    const std::string name = sample.Keyword + " " + std::to_string(sample.Dimension);
    ExpectSample(sample, ReadBytes(sample.GetText(9)), 11, name);
    ExpectSample(sample, ReadBytes(sample.GetText(9, "\r\n")), 11, name);
    ExpectSample(sample, ReadBytes(sample.GetBinary(9)), 11, name + " binary");
  }
}

//------------------------------------------------------------------------------
// If this fails, colors of vertices are lost or wrong. MeshLab writes them before normals.
TEST(PolygonOFFReader, ColorsOfVertices)
{
  const auto read = [](const std::string& keyword, const std::string& lines)
  { return ReadBytes(keyword + "\n3 1 0\n" + lines + "3 0 1 2\n"); };
  const auto get = [](const Result& result, vtkIdType i)
  { return GetTuple(result.Grid->GetPointData(), "RGBA", i); };
  Result result = read("COFF", "0 0 0 192 191 190 255\n1 0 0 1 1 1 1\n0 1 0 300 -4 0\n");
  EXPECT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u); // changes are reported
  EXPECT_NE(result.Warnings[0].find("outside 0 to 255"), std::string::npos);
  EXPECT_NE(result.Warnings[0].find("vertex 2"), std::string::npos);
  EXPECT_EQ(get(result, 0), (Tuple{ 192, 191, 190, 255 }));
  EXPECT_EQ(get(result, 1), (Tuple{ 1, 1, 1, 1 }));
  EXPECT_EQ(get(result, 2), (Tuple{ 255, 0, 0, 255 }));
  result =
    read("COFF", "0 0 0 1 0.5 0 1\n1 0 0 1 1 0\n0 1 0 0 0 1 0\n"); // white is not a dark gray
  EXPECT_EQ(get(result, 0), (Tuple{ 255, 128, 0, 255 }));
  EXPECT_EQ(get(result, 1), (Tuple{ 255, 255, 0, 255 }));
  EXPECT_EQ(get(result, 2), (Tuple{ 0, 0, 255, 0 }));
  result = read(
    "NCSTOFF", "0 0 0 1 2 3 4 0 0 1 .5 .25\n1 0 0 5 6 7 8 0 1 0 0 0\n0 1 0 9 9 9 9 1 0 0 1 1\n");
  EXPECT_EQ(get(result, 1), (Tuple{ 5, 6, 7, 8 }));
  EXPECT_EQ(GetTuple(result.Grid->GetPointData(), "Normals", 1), (Tuple{ 0, 1, 0 }));
  EXPECT_EQ(GetTuple(result.Grid->GetPointData(), "TCoords", 0), (Tuple{ 0.5, 0.25 }));
  result = read("COFF", "0 0 0 5\n1 0 0 6\n0 1 0 7\n");
  EXPECT_EQ(GetTuple(result.Grid->GetPointData(), "ColorIndex", 2), (Tuple{ 7 }));
  EXPECT_EQ(result.Grid->GetPointData()->GetNumberOfArrays(), 1);
  result = read("COFF", "0 0 0 5 5 5\n1 0 0\n0 1 0 7 7 7 7 7\n");
  EXPECT_EQ(result.Warnings.size(), 2u);
  EXPECT_EQ(get(result, 1), (Tuple{ 170, 170, 170, 170 }));
  EXPECT_EQ(get(result, 2), (Tuple{ 7, 7, 7, 7 }));
}

//------------------------------------------------------------------------------
// If this fails, colors of faces out of range are changed without a warning, or real numbers are
// taken for indices.
TEST(PolygonOFFReader, ColorsOutOfRange)
{
  const auto count = [](const std::string& color)
  { return ReadBytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + color + "\n").Warnings.size(); };
  EXPECT_EQ(count("0 255 0"), 0u);
  EXPECT_EQ(count("0 256 0"), 1u);
  EXPECT_EQ(count("0 -1 0"), 1u);
  EXPECT_EQ(count("0.0 1.0 0.0 0.5"), 0u);
  EXPECT_EQ(count("0.0 1.5 0.0 0.5"), 1u);
  EXPECT_EQ(count("-7"), 0u); // an index into a color map
  EXPECT_EQ(count("0.5"), 1u);
}

//------------------------------------------------------------------------------
// If this fails, faces with few vertices or colors of faces are lost or wrong.
TEST(PolygonOFFReader, FacesOfAllKinds)
{
  const Result result = ReadBytes(MakeMixedText(1));
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  vtkUnstructuredGrid* const grid = result.Grid;
  ASSERT_EQ(grid->GetNumberOfCells(), 10);
  const int types[] = { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_LINE, VTK_VERTEX, VTK_TRIANGLE,
    VTK_TRIANGLE, VTK_POLYGON, VTK_TRIANGLE, VTK_TRIANGLE };
  const Tuple gray{ 170, 170, 170, 170 };
  const Tuple colors[] = { gray, { 255, 0, 128, 255 }, { 1, 2, 3, 4 }, gray, gray, gray,
    { 128, 64, 255, 255 }, { 255, 0, 0, 128 }, gray, gray };
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_EQ(grid->GetCellType(i), types[i]) << i;
    EXPECT_EQ(GetTuple(grid->GetCellData(), "RGBA", i), colors[i]) << i;
    EXPECT_EQ(GetTuple(grid->GetCellData(), "ColorIndex", i), Tuple{ i == 5 ? 17. : -1. }) << i;
  }
  EXPECT_EQ(DescribeCell(grid, 7, { 0, 1, 2, 3, 4, 5 })[0],
    (std::vector<vtkIdType>{ VTK_POLYGON, 0, 1, 2, 3, 4, 5 }));
  const char* const warnings[] = { "1 vertex with more", "1 face without vertices",
    "1 face with one vertex", "1 face with two vertices", "2 faces with data after",
    "1 face that" };
  ASSERT_EQ(result.Warnings.size(), 6u);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_NE(result.Warnings[i].find(warnings[i]), std::string::npos) << result.Warnings[i];
  }
  // Integers of 0 and 1 are bytes, unless other faces have real numbers.
  const std::string faces = "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 1\n";
  const auto first = [](const Result& r) { return GetTuple(r.Grid->GetCellData(), "RGBA", 0); };
  EXPECT_EQ(first(ReadBytes(faces + "3 0 1 2 0 0 0 1\n")), (Tuple{ 1, 0, 1, 255 }));
  EXPECT_EQ(first(ReadBytes(faces + "3 0 1 2 0.0 0 0 1\n")), (Tuple{ 255, 0, 255, 255 }));
  EXPECT_EQ(first(ReadBytes(faces + "3 0 1 2\n")), (Tuple{ 1, 0, 1, 255 }));
}

//------------------------------------------------------------------------------
TEST(PolygonOFFReader, VerticesAloneAreACloud)
{
  const Result result = ReadBytes("OFF\n2 0 0\n0 0 0\n1 0 0\n");
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_EQ(Count(result.Grid, VTK_VERTEX), 2);
  for (const char* empty : { "OFF 0 0 0\n", "OFF\n0 0\n", "0 0 0" })
  {
    const Result none = ReadBytes(empty);
    EXPECT_TRUE(none.Errors.empty() && none.Warnings.empty() && none.IsEmpty()) << empty;
  }
}

//------------------------------------------------------------------------------
// If this fails, binary files are misread.
TEST(PolygonOFFReader, BinaryFaces)
{
  Words body;
  body << 4 << 7 << 0 << 0.f << 0.f << 0.f << 1.f << 0.f << 0.f << 1.f << 1.f << 0.f << 0.f << 1.f
       << 0.1f;
  body << 3 << 0 << 1 << 2 << 0;
  body << 4 << 3 << 2 << 1 << 0 << 3 << 1.f << 0.5f << 0.f;
  body << 3 << 1 << 2 << 3 << 1 << 5.f;
  body << 3 << 1 << 2 << 3 << 1 << 6; // an index as an integer
  body << 2 << 0 << 1 << 4 << 0.f << 0.f << 0.f << 0.f;
  body << 0 << 0;
  body << 1 << 3 << 2 << 0.f << 0.f;
  for (const char* lineEnd : { "\n", "\r\n", "\r", " # binary\n" })
  {
    const Result result = ReadBytes("OFF BINARY" + std::string(lineEnd) + body.Bytes);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    vtkUnstructuredGrid* const grid = result.Grid;
    EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(grid->GetPoint(3)[2], 0.1f);
    ASSERT_EQ(grid->GetNumberOfCells(), 6);
    EXPECT_EQ(
      DescribeCell(grid, 1, { 0, 1, 2, 3 })[0], (std::vector<vtkIdType>{ VTK_QUAD, 3, 2, 1, 0 }));
    EXPECT_EQ(grid->GetCellType(5), VTK_VERTEX);
    EXPECT_EQ(GetTuple(grid->GetCellData(), "RGBA", 1), (Tuple{ 255, 128, 0, 255 }));
    EXPECT_EQ(GetTuple(grid->GetCellData(), "RGBA", 4), (Tuple{ 0, 0, 0, 0 }));
    EXPECT_EQ(GetTuple(grid->GetCellData(), "ColorIndex", 2), Tuple{ 5 });
    EXPECT_EQ(GetTuple(grid->GetCellData(), "ColorIndex", 3), Tuple{ 6 });
    EXPECT_EQ(result.Warnings.size(), 4u);
  }
  // In little endian, only files without numbers of color components are known.
  const Result little = ReadBytes(Sample().GetBinary(5, ByteOrder::Little));
  ASSERT_TRUE(little.IsProperError());
  EXPECT_NE(
    little.Errors[0].find("byte 163: expected the end of the file after little-endian faces "
                          "without numbers of color components, found 44 bytes"),
    std::string::npos)
    << little.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, files of pmp-library are refused, or files with errors are accepted as such.
TEST(PolygonOFFReader, BinaryFacesWithoutColorSizes)
{
  const auto toBytes = [](const std::vector<std::int32_t>& words)
  {
    std::string bytes;
    for (const std::int32_t word : words)
    {
      AppendBytes(bytes, word, GetByteOrder() != ByteOrder::Little);
    }
    return bytes;
  };
  const std::string head =
    "OFF BINARY\n" + toBytes({ 4, 3, 0 }) + std::string(static_cast<std::size_t>(4 * 12), '\0');
  const std::string faces = toBytes({ 3, 0, 1, 2, 4, 3, 2, 1, 0, 3, 1, 2 });
  const Result result = ReadBytes(head + faces + toBytes({ 3 }));
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 3);
  EXPECT_EQ(DescribeCell(result.Grid, 1, { 0, 1, 2, 3 })[0],
    (std::vector<vtkIdType>{ VTK_QUAD, 3, 2, 1, 0 }));
  ASSERT_EQ(result.Warnings.size(), 2u);
  EXPECT_NE(result.Warnings[0].find("the file is little endian"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("the faces lack the number of their color"), std::string::npos);
  // Neither layout: an id out of range, too few bytes, too many.
  for (const std::string& end : { toBytes({ 9 }), std::string(), toBytes({ 3, 0 }) })
  {
    EXPECT_EQ(ReadBytes(head + faces + end).Errors.size(), 1u);
  }
}

//------------------------------------------------------------------------------
// If this fails, files are misread whose faces have the same total length as if all were like the
// first.
TEST(PolygonOFFReader, BinaryFacesWithoutColors)
{
  Words body;
  body << 5 << 4 << 0;
  for (int i = 0; i < 15; ++i)
  {
    body << static_cast<float>(i);
  }
  body << 3 << 0 << 1 << 2 << 0;
  body << 4 << 3 << 2 << 1 << 0 << 0;
  body << 2 << 1 << 1 << 0;
  const Result alike =
    ReadBytes("OFF BINARY\n" + body.Bytes + (Words() << 3 << 4 << 3 << 2 << 0).Bytes);
  const Result other =
    ReadBytes("OFF BINARY\n" + body.Bytes + (Words() << 5 << 4 << 3 << 2 << 1 << 0 << 0).Bytes);
  for (const Result* result : { &alike, &other })
  {
    ASSERT_TRUE(result->Errors.empty()) << result->Errors[0];
    ASSERT_EQ(result->Grid->GetNumberOfCells(), 4);
    EXPECT_EQ(result->Grid->GetCellType(0), VTK_TRIANGLE);
    EXPECT_EQ(DescribeCell(result->Grid, 1, { 0, 1, 2, 3, 4 })[0],
      (std::vector<vtkIdType>{ VTK_QUAD, 3, 2, 1, 0 }));
    EXPECT_EQ(result->Grid->GetCellType(2), VTK_LINE);
    ASSERT_EQ(result->Warnings.size(), 2u);
    EXPECT_NE(result->Warnings[0].find("1 face with two vertices"), std::string::npos);
    EXPECT_NE(result->Warnings[1].find("1 face with repeated points"), std::string::npos);
  }
  EXPECT_EQ(alike.Grid->GetCellType(3), VTK_TRIANGLE);
  EXPECT_EQ(DescribeCell(other.Grid, 3, { 0, 1, 2, 3, 4 })[0],
    (std::vector<vtkIdType>{ VTK_POLYGON, 4, 3, 2, 1, 0 }));
}

//------------------------------------------------------------------------------
TEST(PolygonOFFReader, KnowsItsFiles)
{
  vtkNew<vtkPolygonOFFReader> reader;
  const auto canRead = [&](const std::string& bytes, const char* name = "test.off")
  { return reader->CanReadFile(File(bytes, name).Path.c_str()); };
  for (const Sample& sample : GetSamples())
  {
    EXPECT_EQ(canRead(sample.GetText(1), "test"), 1) << sample.Keyword;
    EXPECT_EQ(canRead(sample.GetBinary(1), "test"), 1) << sample.Keyword;
  }
  EXPECT_EQ(canRead("# comment\n\nOFF8 6 12\n"), 1);
  EXPECT_EQ(canRead("4OFF\n5 10 10 5\n"), 1); // to report that it is unsupported
  EXPECT_EQ(canRead("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), 1);
  EXPECT_EQ(canRead("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "test.OFF"), 1);
  EXPECT_EQ(canRead("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "test.tri"), 0);
  for (const char* other : { "", " ", "OFF", "OFF the record\n", "OFFICE 1 2\n",
         "ply\nformat ascii 1.0\n", "SKEL\n8 6\n", "appearance", "appearance {", "appearance { }",
         "appearance { OFF 8 6 0\n", "appearance OFF 8 6 0\n", "off\n8 6 0\n", "COCOFF\n3 1 0\n",
         "3 x 0\n", "-3 1 0\n0 0 0\n", "3 1 0\n0 0 y\n", "<?xml version=\"1.0\"?>",
         "\x7f"
         "ELF" })
  {
    EXPECT_EQ(canRead(other), 0) << other;
  }
  EXPECT_EQ(reader->CanReadFile("/nonexistent.off"), 0);
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
}

//------------------------------------------------------------------------------
// Counts are those of the README.md there, from an independent program.
TEST(PolygonOFFReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("off");
  const std::string folder = GetSharedData("off").string();
  const struct
  {
    const char* Name;
    vtkIdType Points, Cells, Triangles, Quads, Vertices;
    int PointArrays, CellArrays;
  } files[] = { { "assimp_Wuson", 3205, 3732, 3732, 0, 0, 0, 0 },
    { "camaron_ball", 660, 1316, 1316, 0, 0, 0, 0 },
    { "camaron_bunny", 1573, 3000, 3000, 0, 0, 0, 0 }, { "camaron_cube", 8, 6, 0, 6, 0, 0, 0 },
    { "camaron_polygon_mesh", 8, 6, 0, 6, 0, 0, 0 },
    { "camaron_vertex_cloud", 8, 8, 0, 0, 8, 0, 0 }, { "dev_4off", 231, 220, 0, 202, 0, 0, 0 },
    { "dev_binary", 231, 220, 0, 202, 0, 0, 0 },
    { "dev_binary_coff_facecolors", 231, 220, 0, 202, 0, 1, 2 },
    { "dev_noff2d", 231, 220, 0, 202, 0, 0, 0 }, { "dev_noheader", 231, 220, 0, 202, 0, 0, 0 },
    { "dev_stcnoff", 231, 220, 0, 202, 0, 3, 2 },
    { "libigl_halftunnel", 831, 784, 0, 784, 0, 0, 0 },
    { "octree_all_facecolors", 426, 428, 12, 416, 0, 0, 1 },
    { "polylla_cube_comments_colors", 8, 6, 0, 6, 0, 0, 1 },
    { "tgt_boeing", 2741, 2564, 2564, 0, 0, 0, 0 }, { "tgt_cactus", 620, 1236, 1236, 0, 0, 1, 0 },
    { "tgt_double-torus-example", 231, 220, 0, 202, 0, 0, 0 },
    { "tgt_hole", 20, 28, 16, 12, 0, 0, 0 }, { "tgt_mpi", 90, 52, 13, 12, 0, 0, 0 },
    { "trimesh_comments", 8, 6, 0, 6, 0, 0, 1 },
    { "trimesh_whitespace_glued_count", 8, 6, 0, 6, 0, 0, 1 } };
  vtkNew<vtkPolygonOFFReader> reader;
  for (const auto& file : files)
  {
    const std::string path = folder + "/" + file.Name + ".off";
    EXPECT_EQ(reader->CanReadFile(path.c_str()), 1) << file.Name;
    const Result result = ReadWith<vtkPolygonOFFReader>(path);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points) << file.Name;
    EXPECT_EQ(result.Grid->GetNumberOfCells(), file.Cells) << file.Name;
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), file.Triangles) << file.Name;
    EXPECT_EQ(Count(result.Grid, VTK_QUAD), file.Quads) << file.Name;
    EXPECT_EQ(Count(result.Grid, VTK_VERTEX), file.Vertices) << file.Name;
    EXPECT_EQ(
      Count(result.Grid, VTK_POLYGON), file.Cells - file.Triangles - file.Quads - file.Vertices);
    EXPECT_EQ(result.Grid->GetPointData()->GetNumberOfArrays(), file.PointArrays) << file.Name;
    EXPECT_EQ(result.Grid->GetCellData()->GetNumberOfArrays(), file.CellArrays) << file.Name;
    EXPECT_EQ(result.Warnings.size(), 0u) << file.Name << ": " << result.Warnings[0];
  }
  const auto get = [&](const char* name, const char* array, bool ofCells, vtkIdType i)
  {
    const auto grid = ReadWith<vtkPolygonOFFReader>(folder + "/" + name + ".off").Grid;
    return ofCells ? GetTuple(grid->GetCellData(), array, i)
                   : GetTuple(grid->GetPointData(), array, i);
  };
  EXPECT_EQ(get("dev_stcnoff", "RGBA", false, 1), (Tuple{ 26, 128, 255, 255 }));
  EXPECT_EQ(get("dev_stcnoff", "TCoords", false, 0), (Tuple{ 0.5, 0.25 }));
  EXPECT_EQ(get("dev_stcnoff", "RGBA", true, 219), (Tuple{ 26, 51, 77, 255 }));
  EXPECT_EQ(get("dev_stcnoff", "RGBA", true, 218), (Tuple{ 255, 128, 0, 255 }));
  EXPECT_EQ(get("dev_stcnoff", "ColorIndex", true, 217), (Tuple{ 7 }));
  EXPECT_EQ(get("tgt_cactus", "RGBA", false, 619), (Tuple{ 192, 192, 192, 255 }));
  EXPECT_EQ(get("polylla_cube_comments_colors", "RGBA", true, 1), (Tuple{ 0, 255, 0, 255 }));
}
