// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// PLY: lists that are values of points, cells and other elements.
#include "PLYSamples.h"

#include "vtkFieldData.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
/// A fan of triangles, with lists of constant and varying length at points, faces, edges and a
/// camera.
Sample MakeLists(int triangles)
{
  Sample sample;
  Element& vertices = sample.AddElement("vertex");
  vertices.Add("list uchar float", "pair").Add("float", "x").Add("float", "y").Add("float", "z");
  vertices.Add("list ushort double", "descriptor")
    .Add("short", "mass")
    .Add("list int uchar", "bytes");
  for (int i = 0; i < triangles + 2; ++i)
  {
    vertices.Rows.push_back({ { i + 0.5, -i * 1. }, { std::cos(0.1 * i) }, { std::sin(0.1 * i) },
      { 0 }, std::vector<double>(static_cast<std::size_t>(2 + i % 2), i), { i * 2. },
      { i % 200 * 1., 255 } });
  }
  Element& faces = sample.AddElement("face");
  faces.Add("list uchar int", "vertex_indices")
    .Add("list uchar float", "texcoord")
    .Add("int", "texnumber");
  for (int i = 0; i < triangles; ++i)
  {
    faces.Rows.push_back({ { 0, i + 1., i + 2. }, { 0, 0, 1, 0, 1, i * 1. }, { i % 3 * 1. } });
  }
  Element& edges = sample.AddElement("edge");
  edges.Add("int", "vertex1").Add("int", "vertex2").Add("list uchar int64", "tags");
  edges.Rows = { { { 0 }, { 1 }, { 7, 8, 9 } }, { { 0 }, { 2 }, { -1, -2 } } };
  Element& camera = sample.AddElement("camera");
  camera.Add("list uint float", "matrix").Add("float", "focus");
  camera.Rows = { { { 1, 2, 3, 4 }, { 35 } } };
  return sample;
}

//------------------------------------------------------------------------------
void ExpectTuple(
  vtkDataArray* array, vtkIdType tuple, const std::vector<double>& values, const std::string& name)
{
  ASSERT_NE(array, nullptr) << name;
  ASSERT_EQ(array->GetNumberOfComponents(), static_cast<int>(values.size())) << name;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    const double found = array->GetComponent(tuple, static_cast<int>(c));
    EXPECT_TRUE(found == values[c] || (std::isnan(found) && std::isnan(values[c])))
      << name << c << ": " << found;
  }
}
}

//------------------------------------------------------------------------------
// If this fails, lists are lost, or get values of others.
TEST(PolygonPLYLists, BecomeArrays)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::string format : Formats)
  {
    const Result result = ReadBytes(MakeLists(5).Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << format << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 2u) << format; // for lists of varying length
    EXPECT_NE(result.Warnings[0].find(
                "the lists 'descriptor' of 7 elements 'vertex' become an array with 3 components"),
      std::string::npos)
      << result.Warnings[0];
    EXPECT_NE(result.Warnings[1].find("'tags'"), std::string::npos) << result.Warnings[1];
    vtkPointData* const points = result.Grid->GetPointData();
    ExpectTuple(points->GetArray("pair"), 4, { 4.5, -4 }, format);
    ExpectTuple(points->GetArray("descriptor"), 4, { 4, 4, nan }, format);
    ExpectTuple(points->GetArray("descriptor"), 5, { 5, 5, 5 }, format);
    ExpectTuple(points->GetArray("descriptor_length"), 4, { 2 }, format);
    ExpectTuple(points->GetArray("descriptor_length"), 5, { 3 }, format);
    ExpectTuple(points->GetArray("bytes"), 3, { 3, 255 }, format);
    ExpectTuple(points->GetArray("mass"), 3, { 6 }, format);
    EXPECT_EQ(points->GetArray("descriptor")->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(points->GetArray("bytes")->GetDataType(), VTK_UNSIGNED_CHAR);
    vtkCellData* const cells = result.Grid->GetCellData();
    ExpectTuple(cells->GetArray("texcoord"), 3, { 0, 0, 1, 0, 1, 3 }, format);
    ExpectTuple(cells->GetArray("texnumber"), 2, { 2 }, format);
    ExpectTuple(cells->GetArray("tags"), 5, { 7, 8, 9 }, format);
    ExpectTuple(cells->GetArray("tags"), 6, { -1, -2, 0 }, format);
    ExpectTuple(cells->GetArray("tags_length"), 6, { 2 }, format);
    ExpectTuple(result.Grid->GetFieldData()->GetArray("camera.matrix"), 0, { 1, 2, 3, 4 }, format);
  }
}

//------------------------------------------------------------------------------
// If this fails, arrays depend on the encoding, or on the number of processes.
TEST(PolygonPLYLists, PiecesMakeTheWhole)
{
  const Result expected = ReadBytes(MakeLists(60).Encode("ascii"));
  for (const char* format : Formats)
  {
    const File file(MakeLists(60).Encode(format), "test.ply");
    ExpectSameGrid(expected.Grid, ReadWith<vtkPolygonPLYReader>(file.Path).Grid);
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(file.Path, 3, 0);
    ExpectPiecesMakeTheWhole<vtkPolygonPLYReader>(file.Path, 3, 1);
  }
}

//------------------------------------------------------------------------------
// Lists of few values would need much memory; empty lists contain nothing.
TEST(PolygonPLYLists, LeftOut)
{
  for (const char* format : Formats)
  {
    Sample sample;
    Element& vertices = sample.AddVertices(10);
    vertices.Add("list ushort float", "rare")
      .Add("list int int", "long")
      .Add("list uchar int", "empty");
    for (std::size_t i = 0; i < vertices.Rows.size(); ++i)
    {
      vertices.Rows[i].push_back(std::vector<double>(i == 3 ? 50 : 0, 1));
      vertices.Rows[i].push_back(std::vector<double>(1025, 2));
      vertices.Rows[i].emplace_back();
    }
    const Result result = ReadBytes(sample.Encode(format));
    ASSERT_TRUE(result.Errors.empty()) << format << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 2u) << format;
    EXPECT_NE(result.Warnings[0].find(
                "the lists 'rare' of 10 elements 'vertex', of 0 to 50 values, are omitted"),
      std::string::npos)
      << result.Warnings[0];
    EXPECT_NE(result.Warnings[1].find("'long'"), std::string::npos) << result.Warnings[1];
    EXPECT_EQ(result.Grid->GetPointData()->GetNumberOfArrays(), 1);
    ExpectTuple(result.Grid->GetPointData()->GetArray("mass"), 9, { 9 }, format);
  }
}

//------------------------------------------------------------------------------
// If this fails, an error is reported for another list, or the list is read nevertheless.
TEST(PolygonPLYLists, SaysWhatIsWrong)
{
  const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty list uchar uchar bytes\nend_header\n";
  const struct
  {
    const char* Rows;
    const char* Message;
  } cases[] = { { "0 0 0 2 1 2\n0 0 0 2 1 256\n",
                  "expected a value of 'bytes' of 'vertex' (uchar), found '256'" },
    { "0 0 0 2 1 2\n0 0 0 2 1 x\n", "expected a value of 'bytes'" },
    { "0 0 0 2 1 2\n0 0 0 2 1\n", "expected a value of 'bytes'" },
    { "0 0 0 2 1 2\n0 0 0 -2 1 1\n", "expected the length of the list 'bytes'" } };
  for (const auto& wrong : cases)
  {
    const Result result = ReadBytes(header + wrong.Rows);
    ASSERT_TRUE(result.IsProperError()) << wrong.Rows;
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find("test.ply:10"), std::string::npos) << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
TEST(PolygonPLYLists, CollectedFile)
{
  const char* const folder = std::getenv("CAMARON_SHARED_DATA");
  const std::string path = std::string(folder ? folder : "") + "/reports/ply_vertex_lists.ply";
  if (!folder || !std::filesystem::exists(path))
  {
    GTEST_SKIP() << "CAMARON_SHARED_DATA has no file reports/ply_vertex_lists.ply";
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Result result = ReadWith<vtkPolygonPLYReader>(path);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Warnings.size(), 1u);
  ExpectTuple(
    result.Grid->GetPointData()->GetArray("descriptor"), 0, { 0.5, 0.25, nan }, "descriptor");
  ExpectTuple(result.Grid->GetPointData()->GetArray("descriptor"), 1, { 1, 2, 3 }, "descriptor");
  ExpectTuple(result.Grid->GetPointData()->GetArray("descriptor_length"), 2, { 0 }, "length");
  ExpectTuple(
    result.Grid->GetCellData()->GetArray("texcoord"), 1, { 0, 0, 1, 1, 0, 1 }, "texcoord");
}
