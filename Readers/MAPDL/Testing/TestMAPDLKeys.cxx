// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks with a key: COMPACT and unsupported ones.
#include "MAPDLSamples.h"

#include "MAPDLReading.h"

#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkSMPTools.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Nodes = std::vector<int>;

//------------------------------------------------------------------------------
Nodes Count(int first, int last)
{
  Nodes nodes;
  for (int id = first; id <= last; ++id)
  {
    nodes.push_back(id);
  }
  return nodes;
}

//------------------------------------------------------------------------------
// A row of a compact block: the number of the element and its nodes, this many numbers per line.
std::string MakeCompactRow(int id, const Nodes& nodes, int perLine, int width = 9)
{
  std::string text = Format("%*d", width, id);
  int fields = 1;
  for (const int node : nodes)
  {
    text += Format("%s%*d", fields % perLine == 0 ? "\n" : "", width, node);
    ++fields;
  }
  return text + "\n";
}

std::string GetFormat(int perLine, int width = 9)
{
  return Format("(%di%d)\n", perLine, width);
}

//------------------------------------------------------------------------------
// Expects two elements with these nodes and the attributes of MakeHead.
void ExpectElements(const std::string& deck, const Nodes& first, const Nodes& second)
{
  const Result result = ReadDeck(deck);
  ASSERT_TRUE(result.Errors.empty()) << deck << result.Errors[0];
  EXPECT_EQ(result.Warnings.size(), 0u) << deck << result.Warnings[0];
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 2) << deck;
  EXPECT_EQ(GetNodes(result.Grid, 0), first) << deck;
  EXPECT_EQ(GetNodes(result.Grid, 1), second) << deck;
  EXPECT_EQ(GetValue(result.Grid, "ElementId", 0), 10);
  EXPECT_EQ(GetValue(result.Grid, "ElementId", 1), 11);
  for (int cell = 0; cell < 2; ++cell)
  {
    EXPECT_EQ(GetValue(result.Grid, "TypeId", cell), 3);
    EXPECT_EQ(GetValue(result.Grid, "Material", cell), 5);
    EXPECT_EQ(GetValue(result.Grid, "Real", cell), 7);
    EXPECT_EQ(GetValue(result.Grid, "Section", cell), 9);
  }
}

std::string MakeHead(const std::string& type)
{
  return MakeNodes(1, 40) + (type.empty() ? "" : "ET,3," + type + "\n") +
    "MAT,5 $ TYPE,3 $ REAL,7\nSECNUM,9\n";
}
}

//------------------------------------------------------------------------------
// If this fails, elements of compact blocks are read in another layout, or their attributes are
// lost.
TEST(MAPDLKeys, CompactElements)
{
  const struct
  {
    const char* Type;
    int Nodes;
  } types[] = { { "185", 8 }, { "SOLID186", 20 }, { "187", 10 }, { "285", 4 }, { "181", 4 },
    { "281", 8 }, { "200,10", 8 }, { "200,11", 20 }, { "90", 20 }, { "45", 8 } };
  for (const auto& type : types)
  {
    const Nodes first = Count(1, type.Nodes), second = Count(21, 20 + type.Nodes);
    // Ansys Workbench gives a line to every element; others continue on the next one.
    for (const int perLine : { type.Nodes + 1, 5, 6, 9, 11, 19, 30 })
    {
      for (const int width : { 9, 3 })
      {
        const std::string rows = GetFormat(perLine, width) +
          MakeCompactRow(10, first, perLine, width) + MakeCompactRow(11, second, perLine, width);
        for (const std::string key :
          { "EBLOCK,8,COMPACT,,2\n", "eblock,21,compact,,2\n", "EBLO, , Compact ,11,2\n" })
        {
          ExpectElements(MakeHead(type.Type) + key + rows + "       -1\n", first, second);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, elements of several sizes are mixed up, as rows do not show where they end.
TEST(MAPDLKeys, CompactElementsOfUnknownSize)
{
  const auto makeBlock = [](int perLine, const Nodes& nodes, const char* count)
  {
    return Format("EBLOCK,%d,COMPACT,,%s\n", perLine, count) + GetFormat(perLine) +
      MakeCompactRow(10, nodes, perLine) + MakeCompactRow(11, nodes, perLine) + "-1\n";
  };
  // The number of elements determines it.
  for (const char* type : { "174", "" })
  {
    for (const int perLine : { 5, 9 })
    {
      const Result result = ReadDeck(MakeHead(type) + makeBlock(perLine, Count(1, 8), "2"));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      ASSERT_EQ(result.Grid->GetNumberOfCells(), 2);
      EXPECT_EQ(GetNodes(result.Grid, 1), Count(1, 8));
    }
  }
  for (const char* count : { "", "0", "3" })
  {
    const Result refused = ReadDeck(MakeHead("185") + makeBlock(9, Count(1, 8), count));
    ASSERT_TRUE(refused.IsProperError()) << count;
    EXPECT_NE(
      refused.Errors[0].find("test.cdb:44: expected the number of elements as field 4 of "
                             "EBLOCK with the key COMPACT, each on the same number of lines"),
      std::string::npos)
      << refused.Errors[0];
    EXPECT_NE(refused.Errors[0].find("elements on 2 lines"), std::string::npos);
  }
}

//------------------------------------------------------------------------------
// If this fails, a block is read with the attributes or in the layout of another.
TEST(MAPDLKeys, BlocksOfSeveralKinds)
{
  const Nodes brick = Count(1, 8), shell{ 2, 3, 4, 5 };
  const std::string deck = MakeNodes(1, 20) + "ET,1,185\nET,2,181\n" +
    "EBLOCK,9,COMPACT,,1\n(9i9)\n" + MakeCompactRow(1, brick, 9) + "-1\n" + //
    "TYPE,2\nMAT,4\nEBLOCK,5,COMPACT,,1\n(5i8)\n" + MakeCompactRow(2, shell, 5, 8) + "-1\n" +
    "REAL,6\nEBLOCK,5,COMPACT,,1\n(5i9)\n" + MakeCompactRow(3, shell, 5) + "-1\n" +
    "EBLOCK,19,SOLID,,1\n(19i9)\n" + MakeRow(4, 1, brick) + "-1\n" +
    "EBLOCK,10,,,1\n(15i9)\n        5        2        8        9        0        2        3        "
    "4        5\n"
    "-1\nE,2,3,4,5\n";
  const Result result = ReadDeck(deck);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 6);
  const int expected[6][4] = { { 1, 1, 1, 1 }, { 2, 2, 4, 1 }, { 3, 2, 4, 6 }, { 4, 1, 2, 3 },
    { 5, 2, 9, 8 }, { 6, 2, 4, 6 } };
  for (int cell = 0; cell < 6; ++cell)
  {
    EXPECT_EQ(GetValue(result.Grid, "ElementId", cell), expected[cell][0]);
    EXPECT_EQ(GetValue(result.Grid, "TypeId", cell), expected[cell][1]) << cell;
    EXPECT_EQ(GetValue(result.Grid, "Material", cell), expected[cell][2]) << cell;
    EXPECT_EQ(GetValue(result.Grid, "Real", cell), expected[cell][3]) << cell;
    EXPECT_EQ(GetNodes(result.Grid, cell), expected[cell][1] == 1 ? brick : shell) << cell;
  }
}

//------------------------------------------------------------------------------
// If this fails, a block is read in the layout of another key, or columns with numbers of nodes as
// their coordinates.
TEST(MAPDLKeys, OtherKeysAreRefused)
{
  const std::string head = MakeNodes(1, 8) + "ET,1,185\n";
  const std::string row = "(19i9)\n" + MakeRow(1, 1, Count(1, 8)) + "-1\n";
  for (const char* key : { "PACKED", "SOL", "SOLIDS", "COMPACTED", "COM", "1", "0", "NODE" })
  {
    const Result result = ReadDeck(head + "EBLOCK,19," + key + ",1,1\n" + row);
    ASSERT_TRUE(result.IsProperError()) << key;
    EXPECT_EQ(result.ErrorCode, static_cast<unsigned long>(vtkErrorCode::FileFormatError));
    EXPECT_NE(result.Errors[0].find(
                "test.cdb:10: expected SOLID or COMPACT or nothing as the key of EBLOCK, found '" +
                std::string(key) + "'"),
      std::string::npos)
      << result.Errors[0];
  }
  EXPECT_TRUE(ReadDeck(head + "EBLOCK,19,SOLI,1,1\n" + row).Errors.empty());
  for (const std::string fields :
    { "19,,COMPACT", "19,SOLID,SOLID,1", "SOLID,,1,1", "19,SOLID,1,few" })
  {
    const Result result = ReadDeck(head + "EBLOCK," + fields + "\n" + row);
    ASSERT_TRUE(result.IsProperError()) << fields;
    EXPECT_NE(result.Errors[0].find("expected a number or nothing as field"), std::string::npos)
      << result.Errors[0];
  }
  const std::string coordinates = "(1i9,3e20.9e3)\n        1     1.500000000e+00\n-1\n";
  for (const char* key : { "COMPACT", "3", "ALL" })
  {
    const Result result = ReadDeck("NBLOCK,3," + std::string(key) + "\n" + coordinates);
    ASSERT_TRUE(result.IsProperError()) << key;
    EXPECT_NE(result.Errors[0].find("test.cdb:1: expected SOLID or nothing as the key of NBLOCK"),
      std::string::npos)
      << result.Errors[0];
  }
  const Result columns =
    ReadDeck("NBLOCK,6,SOLID\n(6i9)\n        1        0        0        5\n-1\n");
  ASSERT_TRUE(columns.IsProperError());
  EXPECT_NE(columns.Errors[0].find("test.cdb:1: expected a format with columns for coordinates"),
    std::string::npos)
    << columns.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, coordinates are read after a wrong number of integer columns.
TEST(MAPDLKeys, NodesBehindAnyNumberOfIntegers)
{
  for (const char* integers : { "", "        0", "        0        0" })
  {
    const int count = 1 + static_cast<int>(std::string(integers).size()) / 9;
    for (const char* key : { "NBLOCK,3,,1", "nblock,6,SOLID,1,1", "NBLOCK,3" })
    {
      const std::string row = Format(
        "        1%s     1.500000000e+00    -2.000000000e+00     3.000000000e+00\n", integers);
      const Result result = ReadDeck(
        std::string(key) + Format("\n(%di9,3e20.9e3)\n", count) + row + "N,R5.3,LOC,-1,\n");
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      ASSERT_EQ(result.Grid->GetNumberOfPoints(), 1);
      EXPECT_EQ(result.Grid->GetPoint(0)[0], 1.5) << key << integers;
      EXPECT_EQ(result.Grid->GetPoint(0)[1], -2);
      EXPECT_EQ(result.Grid->GetPoint(0)[2], 3);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(MAPDLKeys, ThreadsAndChunksChangeNothing)
{
  for (const int perLine : { 21, 11, 9, 5 })
  {
    std::string text = MakeNodes(1, 40) + "ET,1,186\nEBLOCK,,COMPACT,,200\n" + GetFormat(perLine);
    for (int id = 1; id <= 200; ++id)
    {
      text += MakeCompactRow(id, Count(1 + id % 20, 20 + id % 20), perLine);
    }
    const File file(text + "-1\n");
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(ReadMAPDL(file.Path, {}, {}, expected, warnings, error)) << error.Message;
    ASSERT_EQ(expected->GetNumberOfCells(), 200);
    EXPECT_EQ(GetNodes(expected, 150), Count(12, 31));
    for (const vtkIdType chunk : { 50, 333, 5000 })
    {
      vtkNew<vtkUnstructuredGrid> grid;
      vtkSMPTools::LocalScope(vtkSMPTools::Config(3),
        [&]
        {
          ASSERT_TRUE(ReadMAPDL(file.Path, {}, {}, grid, warnings, error, Progress(), chunk))
            << error.Message;
        });
      ExpectSameGrid(expected, grid);
    }
  }
}
