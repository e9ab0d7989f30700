// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// M3D and M2D files: how they are read, and which are refused.
#include "Criteria/Evaluation.h"
#include "FormatTesting.h"
#include "M3DReading.h"
#include "SharedData.h"
#include "vtkM3DReader.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <map>

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::string NodesHeading = "[Nodes, ARRAY1<STRING>]\n";
const std::string ElementsHeading = "\n[Elements, ARRAY1<STRING>]\n";

Result ReadBytes(const std::string& bytes)
{
  return ReadWith<vtkM3DReader>(File(bytes, "test.m3d").Path);
}

//------------------------------------------------------------------------------
/// A unit cube, a pyramid on it, and a prism next to it.
std::string MakeNodes()
{
  return NodesHeading +
    "11\n\n1 0 0 0\n1 1 0 0\n1 1 1 0\n1 0 1 0\n1 0 0 1\n1 1 0 1\n1 1 1 1\n1 0 1 1\n1 .5 .5 2\n"
    "1 2 0 0\n1 2 0 1\n";
}

//------------------------------------------------------------------------------
/// Cells of every type, codes and materials that differ, in a long file.
std::string MakeLong(int blocks, const std::string& lineEnd = "\n")
{
  std::string text =
    "[Nodes, ARRAY1<STRING>]" + lineEnd + std::to_string(7 * blocks) + lineEnd + lineEnd;
  for (int b = 0; b < blocks; ++b)
  {
    const std::string z = std::to_string(b * 0.3);
    text += "1 0 0 " + z + lineEnd + "2 1 0 " + z + " 0 0.5 -1e-1" + lineEnd + "1 1 1 " + z +
      lineEnd + "3 0 1 " + z + " 7 7 7" + lineEnd + "1 0 0 9" + z + lineEnd + "4 1 0 9" + z +
      lineEnd + "1 1 1 9" + z + lineEnd;
  }
  text += lineEnd + "[Elements, ARRAY1<STRING>]" + lineEnd + std::to_string(3 * blocks) + lineEnd +
    lineEnd;
  for (int b = 0; b < blocks; ++b)
  {
    const auto id = [b](int i) { return " " + std::to_string(7 * b + i); };
    text += "T" + id(0) + id(1) + id(2) + id(4) + " 1000.0 0.45 1.0" + lineEnd + "P" + id(0) +
      id(1) + id(2) + id(3) + id(4) + " 1000.0 0.45 " + std::to_string(b) + lineEnd + "R" + id(0) +
      id(1) + id(2) + id(4) + id(5) + id(6) + " 1000.0 0.45 1.0" + lineEnd;
  }
  return text;
}

//------------------------------------------------------------------------------
std::vector<double> GetVolumes(vtkUnstructuredGrid* grid)
{
  std::vector<double> volumes(grid->GetNumberOfCells());
  Evaluate(MeshTopology(grid), {}, { { FindCriterion("Volume"), volumes.data() } },
    [](double) { return true; });
  return volumes;
}

}

//------------------------------------------------------------------------------
// If this fails, elements are inverted, or of the wrong type.
TEST(M3DReader, ReadsEveryElement)
{
  const Result result = ReadBytes(MakeNodes() + ElementsHeading +
    "4\n\nH 0 1 2 3 4 5 6 7 1000.0 0.45 1.0\nP 4 5 6 7 8\nR 1 9 2 5 10 6\nT4 5 10 6 8\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_TRUE(result.Warnings.empty());
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 11);
  EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 4);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_EQ(result.Grid->GetCellType(1), VTK_PYRAMID);
  EXPECT_EQ(result.Grid->GetCellType(2), VTK_WEDGE);
  EXPECT_EQ(result.Grid->GetCellType(3), VTK_TETRA);
  const std::vector<double> expected = { 1, 1. / 3, 0.5, 1. / 6 };
  const std::vector<double> volumes = GetVolumes(result.Grid);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(volumes[i], expected[i], 1e-15) << i;
  }
  EXPECT_EQ(result.Grid->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(result.Grid->GetCellData()->GetNumberOfArrays(), 0);
}

//------------------------------------------------------------------------------
// If this fails, nodes with projections are misplaced, or their codes are lost.
TEST(M3DReader, ReadsCodes)
{
  const std::string text = NodesHeading +
    "5\n\n2 0 0 0 .25 .5 -1\n3 1 0 0 9 9 9\n1 0 1 0 8 8 8\n0 0 0 1\n"
    "2 1 1 1 0 0 0\n" +
    ElementsHeading + "1\nT 0 1 2 3\n";
  const Result result = ReadBytes(text);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  double x[3];
  result.Grid->GetPoint(0, x);
  EXPECT_TRUE(x[0] == 0.25 && x[1] == 0.5 && x[2] == -1);
  result.Grid->GetPoint(1, x);
  EXPECT_TRUE(x[0] == 1 && x[1] == 0 && x[2] == 0);
  vtkDataArray* codes = result.Grid->GetPointData()->GetArray("NodeCode");
  vtkDataArray* projections = result.Grid->GetPointData()->GetArray("Projection");
  ASSERT_TRUE(codes && projections);
  const int expected[] = { 2, 3, 1, 0, 2 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(codes->GetTuple1(i), expected[i]);
  }
  EXPECT_EQ(projections->GetComponent(0, 2), -1);
  EXPECT_EQ(projections->GetComponent(1, 0), 9);
  EXPECT_EQ(projections->GetComponent(2, 0), 0); // not a projection, just more on the line
}

//------------------------------------------------------------------------------
// If this fails, materials are lost, or attached to the wrong elements.
TEST(M3DReader, ReadsMaterials)
{
  const std::string start = MakeNodes() + ElementsHeading + "3\n";
  const Result differ = ReadBytes(
    start + "T 0 1 3 4 1000.0 0.45 1.0\nT 0 1 3 5 2e3 0.45 1.0\nT 0 1 3 6 1000.0 0.45 1.0 7\n");
  ASSERT_TRUE(differ.Errors.empty()) << differ.Errors[0];
  vtkDataArray* array = differ.Grid->GetCellData()->GetArray("Material");
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetNumberOfComponents(), 3);
  EXPECT_EQ(array->GetComponent(1, 0), 2000);
  EXPECT_EQ(array->GetComponent(2, 1), 0.45);

  const Result same =
    ReadBytes(start + "T 0 1 3 4 3 0.45 1.0\nT 0 1 3 5 3 0.45 1.0 7\nT 0 1 3 6 3 0.45 1.0\n");
  EXPECT_EQ(same.Grid->GetCellData()->GetNumberOfArrays(), 0);
  ASSERT_NE(same.Grid->GetFieldData()->GetArray("Material"), nullptr);
  EXPECT_EQ(same.Grid->GetFieldData()->GetArray("Material")->GetComponent(0, 0), 3);
  // A longer number is another one.
  const Result longer =
    ReadBytes(start + "T 0 1 3 4 3 0.45 1\nT 0 1 3 5 3 0.45 12\nT 0 1 3 6 3 0.45 1\n");
  ASSERT_NE(longer.Grid->GetCellData()->GetArray("Material"), nullptr);
  EXPECT_EQ(longer.Grid->GetCellData()->GetArray("Material")->GetComponent(1, 2), 12);

  for (const char* row :
    { "T 0 1 3 5\n", "T 0 1 3 5 7 8\n", "T 0 1 3 5 7 8 steel\n", "T 0 1 3 5 # 1 2 3\n" })
  {
    const std::string first = "T 0 1 3 4 1 2 3\n", last = "T 0 1 3 6 1 2 4\n";
    for (const std::string& rows : { first + row + last, first + last + row })
    {
      const Result some = ReadBytes(start + rows);
      ASSERT_TRUE(some.Errors.empty());
      EXPECT_EQ(some.Grid->GetNumberOfCells(), 3);
      EXPECT_EQ(some.Grid->GetCellData()->GetNumberOfArrays(), 0);
      EXPECT_EQ(some.Grid->GetFieldData()->GetArray("Material"), nullptr);
      ASSERT_EQ(some.Warnings.size(), 1u);
      EXPECT_NE(some.Warnings[0].find("materials are not read"), std::string::npos);
    }
  }
  const Result dropped = ReadBytes(start + "T 0 1 3 4 1 2 3\nT 0 1 3 5\nT 0 1 3 6 1 2 3\n");
  EXPECT_TRUE(dropped.Warnings.empty());
  EXPECT_EQ(dropped.Grid->GetFieldData()->GetArray("Material"), nullptr);
}

//------------------------------------------------------------------------------
TEST(M3DReader, ReadsM2D)
{
  const Result result =
    ReadBytes(MakeNodes() + ElementsHeading + "2\nq 0 1 2 3 1 2 3\nt 1 9 2 1 2 3\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 2);
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(DescribeCell(result.Grid, 1, GetIds(result.Grid->GetPointData(), 11))[0],
    (std::vector<vtkIdType>{ VTK_TRIANGLE, 1, 9, 2 }));
}

//------------------------------------------------------------------------------
// A digit after a letter is the number of nodes. If this fails, elements with such digits are
// refused, or read as others.
TEST(M3DReader, ReadsNumbersOfNodes)
{
  const struct
  {
    const char* Element;
    int Type;
  } cases[] = { { "t3 0 1 2", VTK_TRIANGLE }, { "q4 0 1 2 3", VTK_QUAD },
    { "T4 0 1 2 4", VTK_TETRA }, { "P5 0 1 2 3 4", VTK_PYRAMID }, { "R6 0 1 3 4 5 7", VTK_WEDGE },
    { "H8 0 1 2 3 4 5 6 7", VTK_HEXAHEDRON } };
  for (const auto& one : cases)
  {
    const Result result = ReadBytes(MakeNodes() + ElementsHeading + "1\n" + one.Element + "\n");
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(result.Grid->GetCellType(0), one.Type) << one.Element;
  }
  const Result few = ReadBytes(MakeNodes() + ElementsHeading + "1\nT3 0 1 2\n");
  ASSERT_TRUE(few.IsProperError());
  EXPECT_NE(few.Errors[0].find("of type T with 4 nodes, found 'T3'"), std::string::npos);
}

//------------------------------------------------------------------------------
// Layouts with the same meaning.
TEST(M3DReader, ReadsEveryLayout)
{
  const std::string plain = NodesHeading + "4\n\n1 0 0 0\n1 1 0 0\n1 0 1 0\n1 0 0 1\n" +
    ElementsHeading + "1\n\nT 0 1 2 3\n";
  const Result expected = ReadBytes(plain);
  ASSERT_TRUE(expected.Errors.empty());
  std::string returns = plain, both;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  for (const char c : plain)
  {
    both += c == '\n' ? "\r\n" : std::string(1, c);
  }
  for (const std::string& text :
    { returns, both, "\xef\xbb\xbf" + plain, "# a remark\n\n[Title, X]\nsomething\n" + plain,
      std::string("[NODES, array1<string>] 4\n+1 0 0 0 more\n\n1 1D+00 0 0\n1 0 1e0 0\n1 0 0 1\n"
                  "[Groups, ARRAY1<STRING>]\n1\nx\n[elements, Array1<String>]\n1\nT 0 1 2 3") })
  {
    const Result result = ReadBytes(text);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0] << "\n" << text;
    ExpectSameGrid(expected.Grid, result.Grid);
  }
  const Result cloud = ReadBytes(NodesHeading + "2\n1 0 0 0\n1 1 1 1\n" + ElementsHeading + "0\n");
  EXPECT_EQ(Count(cloud.Grid, VTK_VERTEX), 2);
}

//------------------------------------------------------------------------------
TEST(M3DReader, WarnsOfOddThings)
{
  const Result result =
    ReadBytes(NodesHeading + "4\n1 0 0 0\n1 1 0 nan\n1 0 1 0\n1 0 0 1\n1 5 5 5\n" +
      "[Gro\x7f\xffups\t]\nx" + ElementsHeading + "1\nT 0 1 1 3\nT 0 1 2 3\n[Loads, X]\n1\n");
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 5u);
  EXPECT_NE(result.Warnings[0].find("the section of nodes has more lines"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("1 element"), std::string::npos);
  EXPECT_NE(result.Warnings[2].find("more data"), std::string::npos);
  EXPECT_NE(result.Warnings[3].find("not read: 2, the first is '[Gro??ups'"), std::string::npos);
  EXPECT_NE(result.Warnings[4].find("1 point"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(M3DReader, RefusesWhatIsWrong)
{
  using Code = vtkErrorCode;
  const std::string nodes = NodesHeading + "4\n\n1 0 0 0\n1 1 0 0\n1 0 1 0\n1 0 0 1\n";
  const std::string start = nodes + ElementsHeading;
  const struct
  {
    std::string Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", Code::UnrecognizedFileTypeError, "test.m3d:1: expected an M3D file" },
    { "3DMO\1\2", Code::UnrecognizedFileTypeError, "a binary Model 3D file" },
    { "OFF\n8 6 0\n", Code::UnrecognizedFileTypeError, "found 'OFF'" },
    { NodesHeading, Code::PrematureEndOfFileError, "the number of nodes" },
    { NodesHeading + "-4\n", Code::FileFormatError, "test.m3d:2: expected the number of nodes" },
    { NodesHeading + "99999999999\n", Code::FileFormatError, "below 2147483648" },
    { NodesHeading + "2000000000\n1 0 0 0\n", Code::PrematureEndOfFileError,
      "at least 16000000000 bytes" },
    { NodesHeading + "2\n1 0 0 0\n1 0 x 0\n" + ElementsHeading, Code::FileFormatError,
      "test.m3d:4: expected a coordinate of a node, found 'x'" },
    { NodesHeading + "2\n1 0 0\n1 0 0 0\n" + ElementsHeading + "0\n", Code::FileFormatError,
      "test.m3d:3: expected a coordinate of a node, found the end of the line" },
    { NodesHeading + "2\n1 0 0 0\n2 0 0 0\n" + ElementsHeading + "0\n", Code::FileFormatError,
      "test.m3d:4: expected the projection of a node of code 2 or 3, found the end of the line" },
    { NodesHeading + "1\n1.5 0 0 0\n" + ElementsHeading, Code::FileFormatError,
      "the code of a node" },
    { nodes, Code::PrematureEndOfFileError, "the section '[Elements,', found the end of the file" },
    { start + "2\nT 0 1 2 3\n", Code::PrematureEndOfFileError, "at least 16 bytes" },
    { start + "2\nT 0 1 2 3 1000.0 0.45 1.0\n", Code::PrematureEndOfFileError,
      "expected an element (T, P, R, H, t or q), found the end of the file" },
    { start + "1\nT 0 1 2 4\n", Code::FileFormatError,
      "test.m3d:11: expected a node of an element from 0 to 3, found 4" },
    { start + "1\nT 0 1 2 -1\n", Code::FileFormatError, "found -1" },
    { start + "1\nT 0 1 2 1000.0\n", Code::FileFormatError, "found '1000.0'" },
    { start + "1\nX 0 1 2 3\n", Code::FileFormatError,
      "test.m3d:11: expected an element (T, P, R, H, t or q), found 'X'" },
    { start + "1\nP6 0 1 2 3 0 1\n", Code::FileFormatError,
      "test.m3d:11: expected an element of type P with 5 nodes, found 'P6'" },
    { start + "1\nT 0 1 2", Code::PrematureEndOfFileError, "" },
    { "MIXED\n3 1\n0 0 0\n1 0 0\n0 1 0\nT 0 1 2\n", Code::UnrecognizedFileTypeError,
      "test.m3d:1: expected an M3D file, which begins with '[Nodes, ARRAY1<STRING>]', found "
      "'MIXED'" },
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
TEST(M3DReader, ThreadsAndChunksChangeNothing)
{
  for (const std::string lineEnd : { "\n", "\r", "  \r\n\r\n" })
  {
    const File file(MakeLong(500, lineEnd), "test.m3d");
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(ReadM3D(file.Path, {}, expected, warnings, error)) << error.Message;
    EXPECT_EQ(expected->GetNumberOfCells(), 1500);
    EXPECT_NE(expected->GetCellData()->GetArray("Material"), nullptr);
    EXPECT_NE(expected->GetPointData()->GetArray("NodeCode"), nullptr);
    for (const int threads : { 1, 2, 3 })
    {
      for (const vtkIdType chunk : { 50, 1000, 20000 })
      {
        vtkNew<vtkUnstructuredGrid> grid;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
          [&] { ASSERT_TRUE(ReadM3D(file.Path, {}, grid, warnings, error, Progress(), chunk)); });
        ExpectSameGrid(expected, grid);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(M3DReader, PiecesMakeTheWhole)
{
  const File file(MakeLong(40), "test.m3d");
  ExpectPiecesMakeTheWhole<vtkM3DReader>(file.Path, 3, 0);
  ExpectPiecesMakeTheWhole<vtkM3DReader>(file.Path, 3, 2);
  ExpectPiecesMakeTheWhole<vtkM3DReader>(file.Path, 130, 1);
}

//------------------------------------------------------------------------------
TEST(M3DReader, KnowsItsFiles)
{
  vtkNew<vtkM3DReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.m3d").Path.c_str()); };
  EXPECT_EQ(canRead(MakeNodes()), 1);
  EXPECT_EQ(canRead("\r\n[nodes, array1<string>]\r\n0\r\n"), 1);
  EXPECT_EQ(canRead("MIXED\n3 1\n"), 0);
  EXPECT_EQ(canRead("3DMO\1\2\3"), 0);
  EXPECT_EQ(canRead("3\n0 0 0\n"), 0);
  EXPECT_EQ(canRead(""), 0);
  EXPECT_EQ(reader->CanReadFile("/nonexistent.m3d"), 0);
}

//------------------------------------------------------------------------------
TEST(M3DReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("m3d");
  const std::string folder = GetSharedData("m3d").string() + "/";
  const struct
  {
    const char* Name;
    vtkIdType Points, Tetrahedra, Pyramids, Prisms, Hexahedra;
  } files[] = { { "camaron_cube", 8, 0, 0, 0, 1 }, { "camaron_tetrahedrons", 8, 6, 0, 0, 0 },
    { "dev_codes23", 331, 60, 60, 60, 60 }, { "mesher_roi_cortex", 2230, 2095, 1938, 622, 456 },
    { "mesher_roi_cyl50", 6683, 1544, 2592, 2792, 2816 } };
  for (const auto& file : files)
  {
    const Result result = ReadWith<vtkM3DReader>(folder + file.Name + ".m3d");
    EXPECT_TRUE(result.Errors.empty() && result.Warnings.empty());
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points);
    EXPECT_EQ(Count(result.Grid, VTK_TETRA), file.Tetrahedra);
    EXPECT_EQ(Count(result.Grid, VTK_PYRAMID), file.Pyramids);
    EXPECT_EQ(Count(result.Grid, VTK_WEDGE), file.Prisms);
    EXPECT_EQ(Count(result.Grid, VTK_HEXAHEDRON), file.Hexahedra);
    for (const double volume : GetVolumes(result.Grid))
    {
      EXPECT_GT(volume, 0) << file.Name;
    }
  }
  // The same file with the projections removed from the nodes, by the generator of both.
  const Result codes = ReadWith<vtkM3DReader>(folder + "dev_codes23.m3d");
  vtkDataArray* array = codes.Grid->GetPointData()->GetArray("NodeCode");
  ASSERT_NE(array, nullptr);
  std::map<double, int> histogram;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    ++histogram[array->GetTuple1(i)];
  }
  EXPECT_EQ(histogram, (std::map<double, int>{ { 1, 241 }, { 2, 66 }, { 3, 24 } }));
}
