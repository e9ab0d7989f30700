// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// TRI files of Camarón and Cart3D: how they are read, and which are refused.
#include "FormatTesting.h"
#include "SharedData.h"
#include "TRIReading.h"
#include "vtkTRIReader.h"

#include "vtkErrorCode.h"
#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
Result ReadBytes(const std::string& bytes)
{
  return ReadWith<vtkTRIReader>(File(bytes, "test.tri").Path);
}

//------------------------------------------------------------------------------
/// A strip of triangles; Cart3D has components.
std::string MakeStrip(int triangles, bool cart3D, const std::string& lineEnd = "\n")
{
  const std::string vertices = std::to_string(triangles + 2);
  std::string text =
    cart3D ? vertices + " " + std::to_string(triangles) + lineEnd : vertices + lineEnd;
  for (int i = 0; i < triangles + 2; ++i)
  {
    text += std::to_string(i * 0.1) + " " + std::to_string(i % 2) + " -1.5e-3" + lineEnd;
  }
  text += cart3D ? "" : std::to_string(triangles) + lineEnd;
  const int base = cart3D ? 1 : 0;
  for (int i = 0; i < triangles; ++i)
  {
    text += std::to_string(i + base) + " " + std::to_string(i + 1 + base) + " " +
      std::to_string(i + 2 + base) + lineEnd;
  }
  for (int i = 0; cart3D && i < triangles; ++i)
  {
    text += std::to_string(i / 10) + lineEnd;
  }
  return text;
}
}

//------------------------------------------------------------------------------
TEST(TRIReader, ReadsVerticesAndTriangles)
{
  for (const char* text : { "4\n0 0 0\n1 0 0\n0 1 0.1\n0 0 1\n2\n0 1 2\n3 2 1\n",
         "\xef\xbb\xbf# a comment\r\n4\r\n\r\n0 0 0 9\r\n1 0 0\r\n# b\r\n0 1 1D-1\r\n0 0 1 "
         "more\r\n2\r\n0 1 "
         "2 7\r\n3 2 1" })
  {
    const Result result = ReadBytes(text);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    ASSERT_EQ(result.Grid->GetNumberOfPoints(), 4);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 2);
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), 2);
    EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(result.Grid->GetPoint(2)[2], 0.1);
    EXPECT_EQ(DescribeCell(result.Grid, 1, { 0, 1, 2, 3 })[0],
      (std::vector<vtkIdType>{ VTK_TRIANGLE, 3, 2, 1 }));
  }
}

//------------------------------------------------------------------------------
TEST(TRIReader, ReadsCart3D)
{
  const Result result = ReadBytes("4 2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n4 3 2\n5 -6\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(DescribeCell(result.Grid, 1, { 0, 1, 2, 3 })[0],
    (std::vector<vtkIdType>{ VTK_TRIANGLE, 3, 2, 1 }));
  vtkDataArray* components = result.Grid->GetCellData()->GetArray("Component");
  ASSERT_NE(components, nullptr);
  EXPECT_EQ(components->GetTuple1(0), 5);
  EXPECT_EQ(components->GetTuple1(1), -6);
  const Result without = ReadBytes("4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 3\n");
  EXPECT_TRUE(without.Errors.empty());
  EXPECT_EQ(without.Grid->GetCellData()->GetNumberOfArrays(), 0);
}

//------------------------------------------------------------------------------
TEST(TRIReader, VerticesAloneAreACloud)
{
  for (const char* text : { "2\n0 0 0\n1 0 0\n", "2\n0 0 0\n1 0 0\n0\n", "2 0\n0 0 0\n1 0 0\n" })
  {
    const Result result = ReadBytes(text);
    ASSERT_TRUE(result.Errors.empty()) << text;
    EXPECT_TRUE(result.Warnings.empty()) << text;
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 2) << text;
    EXPECT_EQ(Count(result.Grid, VTK_VERTEX), 2) << text;
    EXPECT_EQ(result.Grid->GetCellData()->GetNumberOfArrays(), 0);
  }
  EXPECT_TRUE(ReadBytes("0\n").Errors.empty());
}

//------------------------------------------------------------------------------
TEST(TRIReader, WarnsOfOddThings)
{
  const Result result = ReadBytes("3\n0 0 0\n1 0 nan\n0 1 0\n2\n0 1 2\n0 0 2\nmore\n");
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 3u);
  EXPECT_NE(result.Warnings[0].find("1 triangle"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("more data"), std::string::npos);
  EXPECT_NE(result.Warnings[2].find("1 point"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(TRIReader, RefusesWhatIsWrong)
{
  const struct
  {
    const char* Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", vtkErrorCode::UnrecognizedFileTypeError, "test.tri:1: expected a TRI file" },
    { "GOCAD TSurf 1\n", vtkErrorCode::UnrecognizedFileTypeError,
      "test.tri:1: expected a TRI file" },
    { "1 2 3 4\n", vtkErrorCode::UnrecognizedFileTypeError, "whose first line is one number" },
    { "999999999\n0 0 0\n", vtkErrorCode::PrematureEndOfFileError,
      "test.tri:1: expected at least" },
    { "-3\n0 0 0\n", vtkErrorCode::FileFormatError, "found -3" },
    { "3\n0 0 0\n1 0 0\n0 x 0\n1\n0 1 2\n", vtkErrorCode::FileFormatError,
      "test.tri:4: expected a coordinate of a vertex, found 'x'" },
    { "3\n0 0 0\n1 0 # short\n0 1 0\n1\n0 1 2\n", vtkErrorCode::FileFormatError,
      "test.tri:3: expected a coordinate of a vertex, found the end of the line" },
    { "3\n0 0 0\n1 0 0\n0 1 0\n2\n0 1 2\n", vtkErrorCode::PrematureEndOfFileError,
      "expected at least" },
    { "3\n0 0 0\n1 0 0\n0 1 0\n2\n0 1 2\n0 111 2\n", vtkErrorCode::FileFormatError,
      "test.tri:7: expected a vertex of a triangle from 0 to 2, found 111" },
    { "3\n0 0 0\n1 0 0\n0 1 0\n1\n1 2 3\n", vtkErrorCode::FileFormatError,
      "test.tri:6: expected a vertex of a triangle from 0 to 2, found 3" },
    { "3 2\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n3 2 1\n7", vtkErrorCode::PrematureEndOfFileError,
      "the component of a triangle" },
  };
  for (const auto& wrong : cases)
  {
    const Result result = ReadBytes(wrong.Text);
    ASSERT_TRUE(result.IsProperError()) << wrong.Text;
    EXPECT_EQ(result.ErrorCode, wrong.Code) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(TRIReader, ThreadsAndChunksChangeNothing)
{
  for (const std::string& text : { MakeStrip(2000, false), MakeStrip(2000, true),
         MakeStrip(2000, false, " # \r\n\r\n"), MakeStrip(2000, true, "\r") })
  {
    const File file(text, "test.tri");
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(ReadTRI(file.Path, {}, expected, warnings, error)) << error.Message;
    EXPECT_EQ(expected->GetNumberOfCells(), 2000);
    for (const int threads : { 1, 3 })
    {
      for (const vtkIdType chunk : { 50, 1000, 20000 })
      {
        vtkNew<vtkUnstructuredGrid> grid;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
          [&] { ASSERT_TRUE(ReadTRI(file.Path, {}, grid, warnings, error, Progress(), chunk)); });
        ExpectSameGrid(expected, grid);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(TRIReader, PiecesMakeTheWhole)
{
  const File file(MakeStrip(100, true), "test.tri");
  ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 3, 0);
  ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 3, 2);
  ExpectPiecesMakeTheWhole<vtkTRIReader>(file.Path, 120, 1);
}

//------------------------------------------------------------------------------
TEST(TRIReader, KnowsItsFiles)
{
  vtkNew<vtkTRIReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.tri").Path.c_str()); };
  EXPECT_EQ(canRead("3\n0 0 0\n1 0 0\n0 1 0\n1\n0 1 2\n"), 1);
  EXPECT_EQ(canRead("3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n"), 1);
  EXPECT_EQ(canRead("OFF\n3 1 0\n0 0 0\n"), 0);
  EXPECT_EQ(canRead("3 1 0\n0 0 0\n1 0 0\n0 1 0\n"), 0);
  EXPECT_EQ(canRead(std::string("3\n\0\0\0", 5)), 0);
  EXPECT_EQ(reader->CanReadFile("/nonexistent.tri"), 0);
}

//------------------------------------------------------------------------------
TEST(TRIReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("tri");
  const std::string folder = GetSharedData("tri").string();
  const struct
  {
    const char* Name;
    vtkIdType Points, Triangles;
  } files[] = { { "camaron_polygon_mesh", 8, 18 }, { "dev_surface", 231, 466 } };
  for (const auto& file : files)
  {
    const Result result = ReadWith<vtkTRIReader>(folder + "/" + file.Name + ".tri");
    EXPECT_TRUE(result.Errors.empty() && result.Warnings.empty());
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points);
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), file.Triangles);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), file.Triangles);
  }
}
