// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Written decks: exact bytes, and the same mesh with the same arrays when they are read again.
#include "MAPDLSamples.h"
#include "SharedData.h"
#include "TestMeshes.h"
#include "vtkMAPDLWriter.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkLongLongArray.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

#include <limits>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
Written Write(vtkDataObject* mesh, const std::function<void(vtkMAPDLWriter*)>& configure = {})
{
  return WriteWith<vtkMAPDLWriter>(mesh, "test.cdb", configure);
}

Written WriteAll(vtkDataObject* mesh)
{
  return Write(mesh, [](vtkMAPDLWriter* writer) { writer->SetDigits(17); });
}

template <typename Array>
void AddArray(vtkFieldData* data, const char* name, const std::vector<int>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const int value : values)
  {
    array->InsertNextTuple1(value);
  }
  data->AddArray(array);
}

const Points Corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { .5, .5, 2 } };
}

//------------------------------------------------------------------------------
// The default digits are enough for any mesh: an edge of some ulps is noise, and none to lose.
TEST(MAPDLWriter, WritesEdgesOfNoise)
{
  const double next = 1 + std::numeric_limits<double>::epsilon();
  const Written result = Write(
    MakeGrid({ { 1, 0, 0 }, { next, 0, 0 }, { 1, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  EXPECT_EQ(result.Success, 1) << (result.Errors.empty() ? "" : result.Errors[0]);
}

//------------------------------------------------------------------------------
// If this fails, files do not have the columns that they declare, and no program reads them.
TEST(MAPDLWriter, Bytes)
{
  Grid grid = MakeGrid(Corners,
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_PYRAMID, { 4, 5, 6, 7, 8 } },
      { VTK_TETRA, { 4, 5, 6, 8 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_VERTEX, { 3 } } });
  grid->GetPoints()->SetPoint(1, -1.0 / 3, 1e-120, 0);
  AddArray<vtkUnsignedCharArray>(grid->GetPointData(), "base", { 1, 1, 1, 1, 0, 0, 1, 0, 1 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "SHELLS", { 0, 0, 0, 1, 0 });
  const Written result = Write(grid);
  EXPECT_EQ(result.Success, 1);
  ASSERT_EQ(result.Warnings.size(), 2u);
  EXPECT_NE(result.Warnings[0].find("converted to valid ones: base to BASE\n"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("1 point rounded to 14 digits"), std::string::npos);
  EXPECT_EQ(result.Bytes,
    "/COM,Mesh written by Camaron for ParaView\n"
    "/PREP7\n"
    "/NOPR\n"
    "ET,1,185\n"
    "ET,2,285\n"
    "ET,3,181\n"
    "ET,4,21\n"
    "NBLOCK,6,SOLID,         9,         9\n"
    "(3i9,6e21.13e3)\n"
    "        1        0        0 0.0000000000000E+000 0.0000000000000E+000 0.0000000000000E+000\n"
    "        2        0        0-3.3333333333333E-001 1.0000000000000E-120 0.0000000000000E+000\n"
    "        3        0        0 1.0000000000000E+000 1.0000000000000E+000 0.0000000000000E+000\n"
    "        4        0        0 0.0000000000000E+000 1.0000000000000E+000 0.0000000000000E+000\n"
    "        5        0        0 0.0000000000000E+000 0.0000000000000E+000 1.0000000000000E+000\n"
    "        6        0        0 1.0000000000000E+000 0.0000000000000E+000 1.0000000000000E+000\n"
    "        7        0        0 1.0000000000000E+000 1.0000000000000E+000 1.0000000000000E+000\n"
    "        8        0        0 0.0000000000000E+000 1.0000000000000E+000 1.0000000000000E+000\n"
    "        9        0        0 5.0000000000000E-001 5.0000000000000E-001 2.0000000000000E+000\n"
    "N,UNBL,LOC,       -1,\n"
    "EBLOCK,19,SOLID,         5,         5\n"
    "(19i10)\n"
    "         1         1         1         1         0         0         0         0         8"
    "         0         1         1         2         3         4         5         6         7"
    "         8\n"
    "         1         1         1         1         0         0         0         0         8"
    "         0         2         5         6         7         8         9         9         9"
    "         9\n"
    "         1         2         1         1         0         0         0         0         4"
    "         0         3         5         6         7         9\n"
    "         1         3         1         1         0         0         0         0         4"
    "         0         4         1         2         3         3\n"
    "         1         4         1         1         0         0         0         0         1"
    "         0         5         4\n"
    "        -1\n"
    "CMBLOCK,BASE,NODE,       4\n"
    "(8i10)\n"
    "         1        -4         7         9\n"
    "CMBLOCK,SHELLS,ELEM,       1\n"
    "(8i10)\n"
    "         4\n"
    "/GO\n"
    "FINISH\n");
}

//------------------------------------------------------------------------------
// If this fails, cells of some type are written with nodes in the wrong order.
TEST(MAPDLWriter, CellsOfEveryKindComeBack)
{
  const std::pair<int, int> kinds[] = { { VTK_VERTEX, 1 }, { VTK_LINE, 2 },
    { VTK_QUADRATIC_EDGE, 3 }, { VTK_TRIANGLE, 3 }, { VTK_QUADRATIC_TRIANGLE, 6 }, { VTK_QUAD, 4 },
    { VTK_QUADRATIC_QUAD, 8 }, { VTK_TETRA, 4 }, { VTK_QUADRATIC_TETRA, 10 }, { VTK_PYRAMID, 5 },
    { VTK_QUADRATIC_PYRAMID, 13 }, { VTK_WEDGE, 6 }, { VTK_QUADRATIC_WEDGE, 15 },
    { VTK_HEXAHEDRON, 8 }, { VTK_QUADRATIC_HEXAHEDRON, 20 } };
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 20; ++i)
  {
    double x[3];
    GetPlace(i, x);
    points->InsertNextPoint(x[0] / 3, x[1], x[2]);
  }
  grid->SetPoints(points);
  for (const auto& kind : kinds)
  {
    std::vector<vtkIdType> ids;
    for (int i = 0; i < kind.second; ++i)
    {
      ids.push_back((7 * i + 3) % 20);
    }
    grid->InsertNextCell(kind.first, kind.second, ids.data());
  }
  const Written written = WriteAll(grid);
  ASSERT_EQ(written.Success, 1);
  const Result result = ReadDeck(written.Bytes);
  ASSERT_TRUE(result.Errors.empty() && result.Warnings.empty()) << written.Bytes;
  EXPECT_TRUE(HaveSameValues(points->GetData(), result.Grid->GetPoints()->GetData()));
  ASSERT_EQ(result.Grid->GetNumberOfCells(), grid->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell), grid->GetCellType(cell));
    vtkNew<vtkIdList> a, b;
    grid->GetCellPoints(cell, a);
    result.Grid->GetCellPoints(cell, b);
    ASSERT_EQ(a->GetNumberOfIds(), b->GetNumberOfIds());
    for (vtkIdType i = 0; i < a->GetNumberOfIds(); ++i)
    {
      EXPECT_EQ(a->GetId(i), b->GetId(i)) << kinds[cell].first;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, reading and writing a deck changes it.
TEST(MAPDLWriter, ArraysComeBack)
{
  const std::string deck = MakeNodes(3, 30) + "N,2000000000,1,1,1\n" +
    "ET,7,45\nET,4,186\nET,9,200,10\nET,2,170\nET,3,174\nET,5,63\n"
    "EBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(50, 7, { 3, 4, 5, 6, 7, 8, 9, 10 }) + MakeRow(20, 4, { 3, 4, 5, 5, 7, 8, 9, 9 }) +
    MakeRow(30, 9, { 3, 4, 5, 6, 7, 7, 7, 7 }) + MakeRow(31, 2, { 3 }) + MakeRow(32, 2, { 3, 4 }) +
    MakeRow(33, 3, { 3, 4, 5, 6, 7, 8, 9, 10 }) + MakeRow(34, 5, { 3, 4, 5, 5 }) +
    "-1\nMAT,9\nTYPE,5\nREAL,8\nSECNUM,11\nEN,1,3,4,5,6\n"
    "CMBLOCK,TOP,NODE,3\n(8i10)\n         3       -10        30\n"
    "CMBLOCK,NONE,ELEM,0\n(8i10)\nCMBLOCK,SOME.X,ELEM,2\n(8i10)\n        30       -32\n";
  const Result original = ReadDeck(deck);
  ASSERT_TRUE(original.Errors.empty()) << original.Errors[0];
  ASSERT_EQ(original.Grid->GetNumberOfCells(), 8);
  const Written written = WriteAll(original.Grid);
  EXPECT_TRUE(written.Warnings.empty()) << written.Warnings[0];
  const Result again = ReadDeck(written.Bytes);
  ASSERT_TRUE(again.Errors.empty() && again.Warnings.empty());
  ExpectSameGrid(original.Grid, again.Grid);
  EXPECT_EQ(again.Grid->GetFieldData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(WriteAll(again.Grid).Bytes, written.Bytes);
  EXPECT_NE(written.Bytes.find("ET,9,200\nKEYOP,9,1,10\n"), std::string::npos);
  EXPECT_NE(written.Bytes.find("(3i10,"), std::string::npos);

  const Written counted =
    Write(original.Grid, [](vtkMAPDLWriter* writer) { writer->OriginalIdsOff(); });
  const Result renumbered = ReadDeck(counted.Bytes);
  EXPECT_EQ(GetNodes(renumbered.Grid, 0), (std::vector<int>{ 1, 2, 3, 4, 5, 6, 7, 8 }));
  EXPECT_EQ(GetValue(renumbered.Grid, "ElementId", 7), 8);
  EXPECT_EQ(GetValue(renumbered.Grid, "Material", 7), 9);
}

//------------------------------------------------------------------------------
// If this fails, the warning suggests that decks cannot store arrays at all.
TEST(MAPDLWriter, TellsOfOtherArrays)
{
  Grid grid = MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_QUAD, { 0, 1, 2, 3 } } });
  AddArray<vtkIntArray>(grid->GetCellData(), "pressure", { 2, 1 });
  const Written written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("MAPDL stores no other arrays; not written: pressure"),
    std::string::npos)
    << written.Warnings[0];
}

//------------------------------------------------------------------------------
// If this fails, it is not reported which of two arrays becomes the component.
TEST(MAPDLWriter, NamesThatBecomeTheSame)
{
  Grid grid = MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_QUAD, { 0, 1, 2, 3 } } });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "lower", { 0, 1 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "LOWER", { 1, 0 });
  const Written written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(
    written.Warnings[0].find("converted to valid ones: lower to LOWER\n"), std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Warnings[1].find("collide after conversion: LOWER (LOWER is lower)\n"),
    std::string::npos)
    << written.Warnings[1];
  EXPECT_EQ(GetValue(ReadDeck(written.Bytes).Grid, "LOWER", 0), 0);
}

//------------------------------------------------------------------------------
// If this fails, some cells get another type without a warning, because others keep theirs.
TEST(MAPDLWriter, TypesThatSomeCellsCannotKeep)
{
  Grid grid = MakeGrid(Corners,
    { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 5 } },
      { VTK_TETRA, { 0, 1, 3, 4 } } });
  AddArray<vtkIntArray>(grid->GetCellData(), "TypeId", { 1, 2, 1, 0 });
  AddArray<vtkIntArray>(grid->GetCellData(), "ElementType", { 285, 0, 187, 0 });
  const Written written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 1u);
  EXPECT_NE(written.Warnings[0].find("2 cells written with another TypeId or ElementType"),
    std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Warnings[0].find("the first is cell 1 (counted from 0)"), std::string::npos);
  const Result result = ReadDeck(written.Bytes);
  EXPECT_EQ(GetValue(result.Grid, "TypeId", 0), 1);
  EXPECT_EQ(GetValue(result.Grid, "ElementType", 0), 285);
  EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUAD);
}

//------------------------------------------------------------------------------
// If this fails, mismatched arrays lead to decks that are read as other meshes, or not at all.
TEST(MAPDLWriter, ArraysThatDoNotFit)
{
  Grid grid = MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_QUAD, { 0, 1, 2, 3 } } });
  AddArray<vtkIntArray>(grid->GetPointData(), "NodeId", { 1, 2, 2, 3, 4, 5, 6, 7, 8 });
  AddArray<vtkIntArray>(grid->GetCellData(), "ElementId", { 5, -5 });
  AddArray<vtkIntArray>(grid->GetCellData(), "TypeId", { 3, 3 });
  AddArray<vtkIntArray>(grid->GetCellData(), "ElementType", { 181, 185 });
  AddArray<vtkDoubleArray>(grid->GetCellData(), "Material", { 5, 6 });
  AddArray<vtkIntArray>(grid->GetCellData(), "Real", { 7, -2147483647 });
  AddArray<vtkUnsignedCharArray>(grid->GetPointData(), "Many", { 0, 1, 2, 3, 4, 5, 6, 7, 8 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "a,b!$", { 0, 1 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "1 x\"\xc3\xa9", { 0, 1 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "All", { 0, 1 });
  AddArray<vtkUnsignedCharArray>(grid->GetCellData(), "_Good.1", { 0, 1 });
  const Written written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 5u);
  EXPECT_NE(written.Warnings[0].find(": a,b!$ to A_B__, 1 x\"\xc3\xa9 to C_1_X___, All to C_ALL, "
                                     "_Good.1 to _GOOD.1\n"),
    std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Warnings[1].find("1 value of Real cannot be stored"), std::string::npos)
    << written.Warnings[1];
  EXPECT_NE(written.Warnings[2].find("Many, TypeId, ElementType, Material"), std::string::npos)
    << written.Warnings[2];
  EXPECT_NE(written.Warnings[3].find("NodeId"), std::string::npos);
  EXPECT_NE(written.Warnings[4].find("ElementId"), std::string::npos);
  const Result result = ReadDeck(written.Bytes);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUAD);
  EXPECT_EQ(GetValue(result.Grid, "ElementId", 1), 2);
  EXPECT_EQ(GetValue(result.Grid, "ElementType", 0), 285);
  EXPECT_EQ(GetValue(result.Grid, "ElementType", 1), 181);
  EXPECT_EQ(GetValue(result.Grid, "Material", 1), 1);
  EXPECT_EQ(GetValue(result.Grid, "Real", 0), 7);
  EXPECT_EQ(GetValue(result.Grid, "Real", 1), 1);
  EXPECT_EQ(GetValue(result.Grid, "A_B__", 1), 1);
  EXPECT_EQ(GetValue(result.Grid, "C_1_X___", 1), 1);
  EXPECT_EQ(GetValue(result.Grid, "C_ALL", 1), 1);
  EXPECT_EQ(GetValue(result.Grid, "_GOOD.1", 1), 1);
}

//------------------------------------------------------------------------------
// If this fails, a material equal to the end mark drops the cells after it, or numbers and ids
// change without a warning.
TEST(MAPDLWriter, NumbersThatDecksCannotHave)
{
  Grid grid = MakeGrid(Corners,
    { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_QUAD, { 4, 5, 6, 7 } },
      { VTK_TRIANGLE, { 0, 1, 2 } } });
  AddArray<vtkIntArray>(grid->GetCellData(), "Material", { 3, -1, 0, -2 });
  AddArray<vtkDoubleArray>(grid->GetCellData(), "ElementId", { 5, 6, 7, 8 });
  Written written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("1 value of Material cannot be stored (-1 or outside"),
    std::string::npos)
    << written.Warnings[0];
  EXPECT_NE(written.Warnings[1].find("ElementId"), std::string::npos) << written.Warnings[1];
  const Result result = ReadDeck(written.Bytes);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 4);
  const int expected[] = { 3, 1, 0, -2 };
  for (int cell = 0; cell < 4; ++cell)
  {
    EXPECT_EQ(GetValue(result.Grid, "Material", cell), expected[cell]);
  }
  // Numbers with more than 32 bits.
  for (const char* name : { "Material", "ElementId" })
  {
    vtkNew<vtkLongLongArray> large;
    large->SetName(name);
    for (const long long value : { 1ll, 2ll, 2147483648ll, 4ll })
    {
      large->InsertNextValue(value);
    }
    grid->GetCellData()->AddArray(large);
  }
  written = WriteAll(grid);
  ASSERT_EQ(written.Warnings.size(), 2u);
  EXPECT_NE(written.Warnings[0].find("1 value of Material"), std::string::npos);
  EXPECT_NE(written.Warnings[1].find("values of ElementId are not unique"), std::string::npos);
  EXPECT_EQ(GetValue(ReadDeck(written.Bytes).Grid, "ElementId", 2), 3);
}

//------------------------------------------------------------------------------
// If this fails, cells that a deck cannot store are lost without a warning.
TEST(MAPDLWriter, UnsupportedCells)
{
  Grid grid = MakeGrid(Corners,
    { { VTK_POLYGON, { 0, 1, 2, 3, 4 } }, { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  AddArray<vtkIntArray>(grid->GetCellData(), "ElementId", { 8, 9 });
  const Written refused = Write(grid);
  EXPECT_EQ(refused.Success, 0);
  EXPECT_EQ(refused.Bytes, "before");
  EXPECT_EQ(refused.Errors.size(), 1u);
  const Written skipped =
    Write(grid, [](vtkMAPDLWriter* w) { w->SetUnsupportedCells(vtkMAPDLWriter::SKIP); });
  EXPECT_EQ(skipped.Warnings.size(), 1u);
  const Result one = ReadDeck(skipped.Bytes);
  ASSERT_EQ(one.Grid->GetNumberOfCells(), 1);
  EXPECT_EQ(GetValue(one.Grid, "ElementId", 0), 9);
  const Written cut =
    Write(grid, [](vtkMAPDLWriter* w) { w->SetUnsupportedCells(vtkMAPDLWriter::CONVERT); });
  const Result pieces = ReadDeck(cut.Bytes);
  ASSERT_TRUE(pieces.Errors.empty());
  EXPECT_EQ(Count(pieces.Grid, VTK_TRIANGLE), 3); // of the polygon; their ids are not unique
  EXPECT_EQ(Count(pieces.Grid, VTK_HEXAHEDRON), 1);
  EXPECT_EQ(GetValue(pieces.Grid, "ElementId", 3), 4);
}

//------------------------------------------------------------------------------
TEST(MAPDLWriter, MissingNodesBecomeNodes)
{
  const Result original = ReadDeck(MakeNodes(1, 12) + "ET,1,187\nEBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(1, 1, { 1, 2, 3, 4, 0, 6, 7, 8, 9, 10 }) + "-1\n");
  const Result again = ReadDeck(WriteAll(original.Grid).Bytes);
  EXPECT_TRUE(again.Warnings.empty());
  EXPECT_EQ(GetNodes(again.Grid, 0), (std::vector<int>{ 1, 2, 3, 4, 13, 6, 7, 8, 9, 10 }));
}

//------------------------------------------------------------------------------
TEST(MAPDLWriter, ThreadsChangeNothing)
{
  const Result original = ReadDeck(MakeBar(3000, true));
  std::string expected;
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
      [&]
      {
        const Written written = Write(original.Grid);
        EXPECT_EQ(written.Success, 1);
        EXPECT_TRUE(expected.empty() || expected == written.Bytes);
        expected = written.Bytes;
      });
  }
}

//------------------------------------------------------------------------------
// If this fails, decks of other programs change when they are read and written.
TEST(MAPDLWriter, CollectedFilesComeBack)
{
  CAMARON_NEEDS_SHARED_DATA("ansys_cdb");
  for (const auto& entry : std::filesystem::directory_iterator(GetSharedData("ansys_cdb")))
  {
    const Result original = ReadWith<vtkMAPDLReader>(entry.path().string());
    const Written written = WriteAll(original.Grid);
    EXPECT_EQ(written.Success, 1);
    EXPECT_TRUE(written.Warnings.empty()) << entry.path();
    const Result again = ReadDeck(written.Bytes);
    ASSERT_TRUE(again.Errors.empty() && again.Warnings.empty()) << entry.path();
    if (entry.path().filename().string().find("missing") != std::string::npos)
    {
      // Points that replace missing nodes have ids now.
      for (vtkUnstructuredGrid* grid : { original.Grid.Get(), again.Grid.Get() })
      {
        grid->GetPointData()->RemoveArray("NodeId");
      }
    }
    SCOPED_TRACE(entry.path().string());
    ExpectSameGrid(original.Grid, again.Grid);
  }
}
