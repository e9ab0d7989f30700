// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// TS files, tetrahedra of Camarón and surfaces of GOCAD: how they are read, and which are refused.
#include "Criteria/Evaluation.h"
#include "FormatTesting.h"
#include "SharedData.h"
#include "TSReading.h"
#include "vtkTSReader.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <cmath>

using namespace camaron;
using namespace camaron::testing;

namespace
{
Result ReadBytes(const std::string& bytes)
{
  return ReadWith<vtkTSReader>(File(bytes, "test.ts").Path);
}

const std::string Corners = "0 0 0 1.0\n1 0 0 1.0\n0 1 0 1.0\n0 0 1 1.0\n";

//------------------------------------------------------------------------------
std::string MakeChain(int tetrahedra, const std::string& lineEnd = "\n")
{
  std::string text = std::to_string(tetrahedra + 3) + " " + std::to_string(tetrahedra) + lineEnd;
  for (int i = 0; i < tetrahedra + 3; ++i)
  {
    text += std::to_string(i * 0.1) + " " + std::to_string(i % 2) + " -1.5e-3 1.0" + lineEnd;
  }
  for (int i = 0; i < tetrahedra; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      text += std::to_string(i + c) + (c < 3 ? " " : lineEnd);
    }
  }
  return text + "#Exported by a test";
}

//------------------------------------------------------------------------------
/// Surfaces with all features, and ids with gaps.
std::string MakeSurfaces(int surfaces, int rows, const std::string& lineEnd = "\n")
{
  std::string text;
  for (int s = 0; s < surfaces; ++s)
  {
    text += "GOCAD TSurf 1\nHEADER {\nname: s" + std::to_string(s) +
      "\n}\nPROPERTIES a uvw\nESIZES 1 3\nNO_DATA_VALUES -99999 -1\n# a remark\nTFACE\n";
    int id = 7;
    for (int i = 0; i < rows; ++i, id += 3)
    {
      const std::string x = std::to_string(i * 0.1) + " " + std::to_string(s) + " ";
      text += i % 3 == 0 ? "VRTX " + std::to_string(id) + " " + x + "1D0 CNXYZ\n"
                         : "PVRTX " + std::to_string(id) + " " + x + "0.5 " +
          std::to_string(i % 5 ? i : -99999) + " 1 2 3\n";
      if (i == rows / 2)
      {
        text += "TFACE\nATOM 1 7\nPATOM 2 " + std::to_string(id) + " 5 5 5 5\n";
      }
      if (i >= 2)
      {
        text += "TRGL " + std::to_string(i % 4 ? id : id - 3) + " " + std::to_string(id - 6) + " " +
          std::to_string(i > rows / 2 ? 1 + i % 2 : 7 + 3 * (i % 2)) + "\n";
      }
    }
    text += "BSTONE 7\nBORDER 99 7 10\nEND\n";
  }
  if (lineEnd != "\n")
  {
    std::string other;
    for (const char c : text)
    {
      other += c == '\n' ? lineEnd : std::string(1, c);
    }
    return other;
  }
  return text;
}

vtkDataArray* GetPointArray(const Result& result, const char* name)
{
  return result.Grid->GetPointData()->GetArray(name);
}
std::string GetText(const Result& result, const char* name, vtkIdType i)
{
  auto* array = vtkStringArray::SafeDownCast(result.Grid->GetFieldData()->GetAbstractArray(name));
  return array ? array->GetValue(i) : "no array";
}
std::vector<vtkIdType> GetCorners(const Result& result, vtkIdType cell)
{
  return DescribeCell(
    result.Grid, cell, GetIds(result.Grid->GetPointData(), result.Grid->GetNumberOfPoints()))[0];
}
}

//------------------------------------------------------------------------------
TEST(TSReader, ReadsTetrahedra)
{
  for (const std::string& text : { "4 1\n" + Corners + "0 1 2 3\n",
         "\xef\xbb\xbf# c\r\n4 1 and more\r\n\r\n0 0 0\r\n1 0 0 7 8\r\n0 1d0 0\r\n0 0 +1\r\n0 1 2 "
         "3 4\r\n#Expo" +
           std::string("rted") })
  {
    const Result result = ReadBytes(text);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 4);
    EXPECT_EQ(result.Grid->GetPoints()->GetDataType(), VTK_DOUBLE);
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1);
    EXPECT_EQ(GetCorners(result, 0), (std::vector<vtkIdType>{ VTK_TETRA, 0, 1, 2, 3 }));
  }
  EXPECT_EQ(Count(ReadBytes("4 0\n" + Corners).Grid, VTK_VERTEX), 4);
}

//------------------------------------------------------------------------------
// Camarón also counts polyhedra that it does not write.
TEST(TSReader, ReadsFewerTetrahedra)
{
  for (const char* rest : { "", "#Exported with Vis" })
  {
    const Result result = ReadBytes("4 1000\n" + Corners + "0 1 2 3\n3 2 1 0\n" + rest);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_EQ(Count(result.Grid, VTK_TETRA), 2);
    ASSERT_EQ(result.Warnings.size(), 1u);
    EXPECT_NE(result.Warnings[0].find("2 tetrahedra, not 1000"), std::string::npos);
  }
}

//------------------------------------------------------------------------------
TEST(TSReader, ReadsSurfaces)
{
  const Result result = ReadBytes(
    "GOCAD TSURF 1.0\nHEADER {\nname: top of salt\n*solid*color:1 0 0\n}\n"
    "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_UNIT \"m\" \"m\" \"ft\"\nZPOSITIVE "
    "Depth\n"
    "END_ORIGINAL_COORDINATE_SYSTEM\nPROPERTIES a \"u v\" b\nPROP_LEGAL_RANGES **none** **none**\n"
    "ESIZES 1 3 2\nNO_DATA_VALUES -99999 none -1\nPROPERTY_CLASS_HEADER a {\nkind: "
    "depth\nTFACE\n}\n"
    "TFACE\nVRTX 5 0 0 0 CNXYZ\n  PVRTX 100 1 0 0 2.5 1 2 3 4 5\nPVRTX -7 0 1 0 -99999 1 2 3 4 -1\n"
    "TRGL 5 100 -7 and more\nTFACE 2\n# a remark\nATOM 104 100\nPATOM 102 5 9 8 7 6 5 4\n"
    "PVRTX 6 1 1 0 3 1 2 3 4 5\nTRGL 104 6 102\nBSTONE 5\nBORDER 105 5 "
    "100\nSOMETHING else\nEND\n"
    "GOCAD PLine 1\nVRTX 1 9 9 9\nSEG 1 1\nEND\n"
    "GOCAD TSurf 1\nHEADER{name:b}\nPROPERTIES a\nVRTX 1 5 5 5\nPVRTX 2 6 5 5 77\nVRTX 3 5 6 "
    "5\nTRGL 3 2 1\nEND\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Warnings.size(), 2u);
  EXPECT_NE(result.Warnings[0].find("'PLine'"), std::string::npos);
  EXPECT_NE(
    result.Warnings[1].find("atoms with properties, which are not read: 1"), std::string::npos);
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 7);
  ASSERT_EQ(Count(result.Grid, VTK_TRIANGLE), 3);
  EXPECT_EQ(GetCorners(result, 0), (std::vector<vtkIdType>{ VTK_TRIANGLE, 0, 1, 2 }));
  EXPECT_EQ(GetCorners(result, 1), (std::vector<vtkIdType>{ VTK_TRIANGLE, 1, 3, 0 }));
  EXPECT_EQ(GetCorners(result, 2), (std::vector<vtkIdType>{ VTK_TRIANGLE, 6, 5, 4 }));
  const int parts[] = { 0, 0, 1 }, faces[] = { 0, 1, 0 }, ids[] = { 5, 100, -7, 6, 1, 2, 3 };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("Part")->GetTuple1(i), parts[i]);
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("TFace")->GetTuple1(i), faces[i]);
  }
  for (vtkIdType i = 0; i < 7; ++i)
  {
    EXPECT_EQ(GetPointArray(result, "OriginalPointId")->GetTuple1(i), ids[i]);
  }
  vtkDataArray* a = GetPointArray(result, "a");
  ASSERT_NE(a, nullptr);
  EXPECT_TRUE(std::isnan(a->GetTuple1(0))); // not that of the atom
  EXPECT_EQ(a->GetTuple1(1), 2.5);
  EXPECT_TRUE(std::isnan(a->GetTuple1(2)));
  EXPECT_TRUE(std::isnan(a->GetTuple1(4)));
  EXPECT_EQ(a->GetTuple1(5), 77); // of the other surface
  vtkDataArray* uv = GetPointArray(result, "u v");
  ASSERT_NE(uv, nullptr);
  EXPECT_EQ(uv->GetNumberOfComponents(), 3);
  EXPECT_EQ(uv->GetComponent(3, 1), 2);
  vtkDataArray* second = GetPointArray(result, "b");
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(second->GetComponent(1, 1), 5);
  EXPECT_TRUE(std::isnan(second->GetComponent(2, 1)));
  EXPECT_EQ(GetText(result, "PartName", 0), "top of salt");
  EXPECT_EQ(GetText(result, "PartName", 1), "b");
  EXPECT_EQ(GetText(result, "ZPositive", 0), "Depth");
  EXPECT_EQ(GetText(result, "AxisUnit", 0), "\"m\" \"m\" \"ft\"");
}

//------------------------------------------------------------------------------
TEST(TSReader, ReadsEveryLineEnd)
{
  const Result expected = ReadBytes(MakeSurfaces(2, 20));
  ASSERT_TRUE(expected.Errors.empty()) << expected.Errors[0];
  EXPECT_EQ(expected.Grid->GetNumberOfPoints(), 40);
  for (const char* lineEnd : { "\r\n", " \n\n" })
  {
    const Result result = ReadBytes(MakeSurfaces(2, 20, lineEnd));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ExpectSameGrid(expected.Grid, result.Grid);
  }
  const std::string plain = "GOCAD TSurf 1\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\n";
  const Result cloud = ReadBytes(plain + "END");
  EXPECT_EQ(Count(cloud.Grid, VTK_VERTEX), 3);
  EXPECT_EQ(GetPointArray(cloud, "OriginalPointId"), nullptr);
  EXPECT_EQ(ReadBytes("GOCAD TSurf 1\nEND\n").Grid->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// If this fails, blanks before a keyword change its meaning.
TEST(TSReader, LinesMayBeIndented)
{
  const std::string lines[] = { "GOCAD TSurf 1", "TFACE", "VRTX 1 0 0 0", "VRTX 2 1 0 0",
    "VRTX 3 0 1 0", "TRGL 1 2 3", "END" };
  for (const std::string indent : { "", "  ", "\t", " \t " })
  {
    std::string text;
    for (int object = 0; object < 2; ++object)
    {
      for (const std::string& line : lines)
      {
        text += indent + line + "\n";
      }
    }
    const Result result = ReadBytes(text);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
    EXPECT_EQ(Count(result.Grid, VTK_TRIANGLE), 2);
    EXPECT_EQ(result.Grid->GetCellData()->GetArray("Part")->GetTuple1(1), 1);
  }
  const Result other = ReadBytes("GOCAD TSurf 1\nVRTX 1 0 0 0\nBEND\nx END\nENDS\n");
  EXPECT_EQ(other.Errors.size(), 1u);
}

//------------------------------------------------------------------------------
TEST(TSReader, WarnsOfOddThings)
{
  const Result tetrahedra = ReadBytes("4 1\n0 0 nan\n1 0 0\n0 1 0\n0 0 1\n0 1 1 3\n1 2 3 0\n");
  ASSERT_EQ(tetrahedra.Warnings.size(), 3u);
  EXPECT_NE(tetrahedra.Warnings[0].find("1 tetrahedron"), std::string::npos);
  EXPECT_NE(tetrahedra.Warnings[1].find("more data"), std::string::npos);
  EXPECT_NE(tetrahedra.Warnings[2].find("1 point"), std::string::npos);
  const Result surface = ReadBytes(
    "GOCAD TSurf 1\nPROPERTIES a b\nVRTX 1 0 0 inf\nPVRTX 2 0 1 0 6 7\nPVRTX 2 1 0 0 5 6\n"
    "PATOM 4 2 5 CNXYZ\nTRGL 1 2 2\nEND\nand more\n");
  ASSERT_TRUE(surface.Errors.empty()) << surface.Errors[0];
  ASSERT_EQ(surface.Warnings.size(), 5u);
  EXPECT_NE(surface.Warnings[0].find("1 surface with more data after END"), std::string::npos);
  EXPECT_NE(
    surface.Warnings[1].find("the id of another vertex of their surface: 1"), std::string::npos);
  EXPECT_NE(surface.Warnings[2].find("atoms with properties"), std::string::npos);
  EXPECT_NE(surface.Warnings[3].find("1 triangle"), std::string::npos);
  EXPECT_NE(surface.Warnings[4].find("1 point"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, values of properties are mixed up.
TEST(TSReader, ReadsProperties)
{
  const Result result =
    ReadBytes("GOCAD TSurf 1\nPROPERTIES a b\nESIZES 1 2\nNO_DATA_VALUES -1 -2\n"
              "PVRTX 1 0 0 0 5 6 7\nPVRTX 2 1 0 0 -1 -1 -2 CNXYZ\nEND\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_TRUE(result.Warnings.empty());
  ASSERT_EQ(GetPointArray(result, "b")->GetNumberOfComponents(), 2);
  EXPECT_EQ(GetPointArray(result, "b")->GetComponent(0, 1), 7);
  EXPECT_TRUE(std::isnan(GetPointArray(result, "a")->GetComponent(1, 0)));
  EXPECT_TRUE(std::isnan(GetPointArray(result, "b")->GetComponent(1, 1)));
}

//------------------------------------------------------------------------------
// If this fails, an array without name is created, which ParaView does not show.
TEST(TSReader, NamesEveryArray)
{
  using namespace std::string_literals;
  const Result result =
    ReadBytes("GOCAD TSurf 1\nPROPERTIES \0 a\0b\nPVRTX 1 0 0 0 5 6\nPVRTX 2 1 0 0 5 6\n"
              "PVRTX 3 0 1 0 5 6\nTRGL 1 2 3\nEND\n"s);
  vtkPointData* data = result.Grid->GetPointData();
  for (const char* name : { "Property", "a" })
  {
    EXPECT_TRUE(data->HasArray(name)) << name;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    EXPECT_STRNE(data->GetArrayName(i), "");
  }
}

//------------------------------------------------------------------------------
TEST(TSReader, RefusesWhatIsWrong)
{
  using Code = vtkErrorCode;
  const std::string tsurf = "GOCAD TSurf 1\n";
  std::string mpeg(400, '\0');
  mpeg[0] = mpeg[188] = mpeg[376] = 'G';
  const struct
  {
    std::string Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", Code::UnrecognizedFileTypeError, "test.ts:1: expected a TS file" },
    { "import { A } from './a';\n", Code::UnrecognizedFileTypeError,
      "found 'import' (TypeScript prog" },
    { "<?xml version='1.0'?>\n<TS>\n", Code::UnrecognizedFileTypeError, "Qt translations" },
    { mpeg, Code::UnrecognizedFileTypeError, "MPEG streams" },
    { "8\n0 0 0\n", Code::UnrecognizedFileTypeError, "test.ts:1: expected a TS file" },
    { "-4 1\n" + Corners, Code::FileFormatError, "the number of vertices, found -4" },
    { "4 -1\n" + Corners, Code::FileFormatError, "the number of tetrahedra" },
    { "999999999 1\n" + Corners, Code::PrematureEndOfFileError, "at least 5999999994 bytes" },
    { "4 99999999999\n" + Corners, Code::FileFormatError, "found 99999999999" },
    { "4 1\n0 0 0\n1 0\n0 1 0\n0 0 1\n0 1 2 3\n", Code::FileFormatError,
      "test.ts:3: expected a coordinate of a vertex, found the end of the line" },
    { "4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1e\n0 1 2 3\n", Code::FileFormatError, "found '1e'" },
    { "4 1\n0 0 0\n1 0 0\n", Code::PrematureEndOfFileError, "test.ts" },
    { "4 1\n" + Corners + "0 1 2 4\n", Code::FileFormatError,
      "test.ts:6: expected a vertex of a tetrahedron from 0 to 3, found 4" },
    { "4 2\n" + Corners + "0 1 2 3\n0 1 2", Code::PrematureEndOfFileError,
      "test.ts:7: expected a vertex of a tetrahedron, found the end of the file" },
    { "GOCAD VSet 1\nVRTX 1 0 0 0\nEND\n", Code::FileFormatError, "only 'VSet'" },
    { "GOCAD V\x01Set 1\nVRTX 1 0 0 0\nEND\n", Code::FileFormatError, "only 'V?Set'" },
    { tsurf + "VRTX 1 0 0 0\n", Code::PrematureEndOfFileError, "expected the line END of a TSurf" },
    { tsurf + "VRTX 1 0 0 0\n" + tsurf + "END\n", Code::PrematureEndOfFileError,
      "test.ts:3: expected the line END of a TSurf, found 'GOCAD'" },
    { tsurf + "VRTX 1 0 0\nEND\n", Code::FileFormatError,
      "test.ts:2: expected a coordinate of a vertex, found the end of the line" },
    { tsurf + "VRTX x 0 0 0\nEND\n", Code::FileFormatError,
      "expected the id of a vertex, found 'x'" },
    { tsurf + "VRTX 3000000000 0 0 0\nEND\n", Code::FileFormatError,
      "test.ts:2: expected a vertex id below 2147483648, found '3000000000'" },
    { tsurf + "VRTX 1 0 0 0\nTRGL 1 1\nEND\n", Code::FileFormatError,
      "test.ts:3: expected the id of a vertex, found the end of the line" },
    { tsurf + "VRTX 1 0 0 0\nTRGL 1 1 1\nTRGL 1 2 3\nEND\n", Code::FileFormatError,
      "test.ts:4: expected the id of a vertex of the surface, found 2" },
    { tsurf + "VRTX 1 0 0 0\nEND\n" + tsurf + "VRTX 2 0 0 0\nTRGL 2 2 1\nEND\n",
      Code::FileFormatError, "test.ts:6: expected the id of a vertex of the surface, found 1" },
    { tsurf + "VRTX 1 0 0 0\nATOM 2 9\nTRGL 1 1 5\nEND\n", Code::FileFormatError,
      "test.ts:3: expected the id of a vertex of the surface, found 9" },
    { tsurf + "VRTX 1 0 0 0\nATOM 2 1\nATOM 3 2\nEND\n", Code::FileFormatError,
      "test.ts:4: expected the id of a vertex of the surface, found 2" },
    { tsurf + "VRTX 1 0 0 0\rEND\n", Code::FileFormatError,
      "test.ts:2: expected lines that end with LF or CRLF, found CR" },
    { tsurf + "ESIZES 1 2\nPROPERTIES a b\nEND\n", Code::FileFormatError,
      "test.ts:2: expected the line PROPERTIES before this one" },
    { tsurf + "PROPERTIES a b\nPVRTX 1 0 0 0 5\nEND\n", Code::FileFormatError,
      "test.ts:3: expected a value of a property, found the end of the line" },
    { tsurf + "PROPERTIES a b\nPVRTX 1 0 0 0 5 CNXYZ\nEND\n", Code::FileFormatError,
      "test.ts:3: expected a value of a property, found 'CNXYZ'" },
    { tsurf + "PROPERTIES a a\nPVRTX 1 0 0 0 5 6\nEND\n", Code::FileFormatError,
      "test.ts:3: expected properties with a name of their own" },
    { tsurf + "ATOM 2\nEND\n", Code::FileFormatError, "found the end of the line" },
    { tsurf + "PROPERTIES a\nPVRTX 1 0 0 0 x\nEND\n", Code::FileFormatError,
      "test.ts:3: expected a value of a property, found 'x'" },
    { tsurf + "PROPERTIES a\nESIZES 0\nPVRTX 1 0 0 0 1\nEND\n", Code::FileFormatError,
      "test.ts:3: " },
    { tsurf + "PROPERTIES a\nESIZES 2000\nPVRTX 1 0 0 0 1\nEND\n", Code::FileFormatError,
      "expected properties for a larger part of the vertices, found 2000 values per vertex" },
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
TEST(TSReader, ThreadsAndChunksChangeNothing)
{
  for (const std::string& text :
    { MakeChain(2000), MakeChain(2000, " # \r\n\r\n"), MakeChain(2000, "\r"), MakeSurfaces(3, 700),
      MakeSurfaces(300, 5), MakeSurfaces(3, 700, "\r\n") })
  {
    const File file(text, "test.ts");
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(ReadTS(file.Path, {}, expected, warnings, error)) << error.Message;
    EXPECT_GT(expected->GetNumberOfCells(), 800);
    for (const int threads : { 1, 2, 3 })
    {
      for (const vtkIdType chunk : { 50, 1000, 20000 })
      {
        vtkNew<vtkUnstructuredGrid> grid;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
          [&] { ASSERT_TRUE(ReadTS(file.Path, {}, grid, warnings, error, Progress(), chunk)); });
        ExpectSameGrid(expected, grid);
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, it depends on threads which of several errors is reported.
TEST(TSReader, TellsTheFirstError)
{
  std::string text = MakeSurfaces(1, 500);
  const std::size_t at = text.find("VRTX", text.size() / 2);
  text.replace(at, 4, "VRTX x");
  text.replace(text.find("TRGL", at), 4, "TRGL y");
  const File file(text, "test.ts");
  std::set<std::string> messages;
  for (const int threads : { 1, 3 })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
      [&] { EXPECT_FALSE(ReadTS(file.Path, {}, grid, warnings, error, Progress(), 100)); });
    messages.insert(error.Message);
  }
  EXPECT_EQ(messages.size(), 1u);
  EXPECT_NE(messages.begin()->find("found 'x'"), std::string::npos) << *messages.begin();
}

//------------------------------------------------------------------------------
TEST(TSReader, PiecesMakeTheWhole)
{
  for (const std::string& text : { MakeChain(100), MakeSurfaces(2, 40) })
  {
    const File file(text, "test.ts");
    ExpectPiecesMakeTheWhole<vtkTSReader>(file.Path, 3, 0);
    ExpectPiecesMakeTheWhole<vtkTSReader>(file.Path, 3, 2);
    ExpectPiecesMakeTheWhole<vtkTSReader>(file.Path, 120, 1);
  }
}

//------------------------------------------------------------------------------
TEST(TSReader, KnowsItsFiles)
{
  vtkNew<vtkTSReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.ts").Path.c_str()); };
  EXPECT_EQ(canRead("4 1\n" + Corners + "0 1 2 3\n"), 1);
  EXPECT_EQ(canRead("\xef\xbb\xbfGOCAD TSurf 1\n"), 1);
  EXPECT_EQ(canRead("GOCAD TSURF 1.0\r"), 1);
  EXPECT_EQ(canRead("GOCAD VSet 1\n"), 0);
  EXPECT_EQ(canRead("GOCAD SGrid 1\nHEADER {name:a}\nEND\nGOCAD VSet 1\nEND\n"), 0);
  EXPECT_EQ(canRead("GOCAD SGrid 1\nHEADER {name:a}\nEND\nGOCAD TSurf 1\nEND\n"), 0);
  EXPECT_EQ(canRead("4\n0 0 0\n"), 0);
  EXPECT_EQ(canRead("4 1\nx\n"), 0);
  EXPECT_EQ(canRead("export const a = 1;\n"), 0);
  EXPECT_EQ(canRead("<!DOCTYPE TS>"), 0);
  EXPECT_EQ(canRead(std::string("G\0\0", 3)), 0);
  EXPECT_EQ(canRead(""), 0);
  EXPECT_EQ(reader->CanReadFile("/nonexistent.ts"), 0);
}

//------------------------------------------------------------------------------
TEST(TSReader, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("ts");
  const std::string folder = GetSharedData("ts").string() + "/";
  const Result tetrahedra = ReadWith<vtkTSReader>(folder + "dev_tets_camaron.ts");
  EXPECT_TRUE(tetrahedra.Errors.empty() && tetrahedra.Warnings.empty());
  EXPECT_EQ(tetrahedra.Grid->GetNumberOfPoints(), 296);
  EXPECT_EQ(Count(tetrahedra.Grid, VTK_TETRA), 240);
  EXPECT_EQ(tetrahedra.Grid->GetNumberOfCells(), 240);
  std::vector<double> volumes(240);
  Evaluate(MeshTopology(tetrahedra.Grid), {}, { { FindCriterion("Volume"), volumes.data() } },
    [](double) { return true; });
  EXPECT_GT(*std::min_element(volumes.begin(), volumes.end()), 0);

  const Result surface = ReadWith<vtkTSReader>(folder + "dev_gocad_tsurf.ts");
  EXPECT_TRUE(surface.Errors.empty() && surface.Warnings.empty());
  EXPECT_EQ(surface.Grid->GetNumberOfPoints(), 231);
  EXPECT_EQ(Count(surface.Grid, VTK_TRIANGLE), 466);
  EXPECT_EQ(surface.Grid->GetNumberOfCells(), 466);
  EXPECT_EQ(surface.Grid->GetCellData()->GetArray("TFace")->GetRange()[1], 1);
  EXPECT_EQ(GetPointArray(surface, "uvw")->GetNumberOfComponents(), 3);
  EXPECT_EQ(GetPointArray(surface, "a")->GetTuple1(2), 2);
  EXPECT_TRUE(std::isnan(GetPointArray(surface, "a")->GetTuple1(0)));
  EXPECT_EQ(GetText(surface, "ZPositive", 0), "Depth");
}
