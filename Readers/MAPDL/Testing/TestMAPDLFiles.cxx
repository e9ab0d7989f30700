// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Decks of programs: their content; which files are decks; which are refused, and how.
#include "MAPDLSamples.h"
#include "SharedData.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"

#include <map>

using namespace camaron;
using namespace camaron::testing;

namespace
{
std::map<int, vtkIdType> CountTypes(vtkUnstructuredGrid* grid)
{
  std::map<int, vtkIdType> counts;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    ++counts[grid->GetCellType(cell)];
  }
  return counts;
}

vtkIdType CountNames(vtkUnstructuredGrid* grid)
{
  vtkIdType names = 0;
  for (const char* list : { "NodeComponents", "ElementComponents" })
  {
    vtkAbstractArray* const array = grid->GetFieldData()->GetAbstractArray(list);
    names += array ? array->GetNumberOfValues() : 0;
  }
  return names;
}
}

//------------------------------------------------------------------------------
// Numbers of nodes, elements by type and components are those that other programs found in the
// files.
TEST(MAPDLFiles, CollectedFiles)
{
  CAMARON_NEEDS_SHARED_DATA("ansys_cdb");
  const std::string folder = GetSharedData("ansys_cdb").string() + "/";
  const struct
  {
    const char* Name;
    vtkIdType Points;
    std::map<int, vtkIdType> Types;
    vtkIdType Components;
  } files[] = {
    { "acp_minimal_plate.cdb", 18, { { VTK_QUAD, 9 }, { VTK_VERTEX, 18 } }, 9 },
    { "acp_solid_mesh.cdb", 567, { { VTK_HEXAHEDRON, 384 } }, 24 },
    { "archive_ErnoRadiation.cdb", 65, { { VTK_HEXAHEDRON, 27 }, { VTK_QUAD, 9 } }, 3 },
    { "archive_HexBeam.cdb", 321, { { VTK_QUADRATIC_HEXAHEDRON, 40 } }, 4 },
    // Two of its elements are targets with one node, defined by commands that use parameters.
    { "archive_Panel_Transient.dat", 1265,
      { { VTK_QUADRATIC_HEXAHEDRON, 160 }, { VTK_QUADRATIC_QUAD, 176 }, { VTK_VERTEX, 2 } }, 5 },
    { "archive_TetBeam.cdb", 1041, { { VTK_TETRA, 3913 } }, 0 },
    { "archive_all_solid_cells.cdb", 52,
      { { VTK_QUADRATIC_HEXAHEDRON, 1 }, { VTK_QUADRATIC_WEDGE, 1 }, { VTK_QUADRATIC_PYRAMID, 1 },
        { VTK_QUADRATIC_TETRA, 1 } },
      0 },
    { "archive_etblock.cdb", 4, { { VTK_QUAD, 1 } }, 0 },
    { "archive_hypermesh.cdb", 105, { { VTK_QUAD, 80 } }, 0 },
    // 584 nodes, and 23 points for missing mid-side nodes.
    { "archive_mixed_missing_midside.cdb", 607,
      { { VTK_HEXAHEDRON, 21 }, { VTK_QUADRATIC_TETRA, 236 }, { VTK_QUADRATIC_PYRAMID, 8 },
        { VTK_QUAD, 10 }, { VTK_QUADRATIC_TRIANGLE, 12 } },
      0 },
    { "archive_sector.cdb", 655, { { VTK_HEXAHEDRON, 101 }, { VTK_WEDGE, 4 } }, 1 },
    { "archive_workbench_193.cdb", 3, {}, 0 },
    { "dev_mixed_blocked_Dexp.cdb", 331,
      { { VTK_HEXAHEDRON, 60 }, { VTK_WEDGE, 60 }, { VTK_PYRAMID, 60 }, { VTK_TETRA, 60 } }, 1 },
    { "dev_mixed_unblocked.cdb", 331,
      { { VTK_HEXAHEDRON, 60 }, { VTK_WEDGE, 60 }, { VTK_PYRAMID, 60 }, { VTK_TETRA, 60 } }, 1 },
    { "prime_hex.cdb", 343, { { VTK_HEXAHEDRON, 216 } }, 0 },
  };
  vtkNew<vtkMAPDLReader> reader;
  std::map<std::string, vtkSmartPointer<vtkUnstructuredGrid>> grids;
  for (const auto& file : files)
  {
    const std::string path = folder + file.Name;
    EXPECT_EQ(reader->CanReadFile(path.c_str()), 1) << file.Name;
    const Result result = ReadWith<vtkMAPDLReader>(path);
    EXPECT_TRUE(result.Errors.empty()) << file.Name;
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), file.Points) << file.Name;
    EXPECT_EQ(CountTypes(result.Grid), file.Types) << file.Name;
    EXPECT_EQ(CountNames(result.Grid), file.Components) << file.Name;
    ExpectPiecesMakeTheWhole<vtkMAPDLReader>(path, 3, 1);
    grids[file.Name] = result.Grid;
  }
  // The same mesh, once in blocks and once in commands; coordinates differ in the last digits.
  vtkUnstructuredGrid* const blocked = grids["dev_mixed_blocked_Dexp.cdb"];
  vtkUnstructuredGrid* const commands = grids["dev_mixed_unblocked.cdb"];
  EXPECT_TRUE(HaveSameLists(blocked->GetCells(), commands->GetCells()));
  for (vtkIdType i = 0; i < blocked->GetNumberOfPoints(); ++i)
  {
    double x[3];
    blocked->GetPoint(i, x);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(x[c], commands->GetPoint(i)[c], 1e-6);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, errors do not describe the problem or its position.
TEST(MAPDLFiles, SaysWhatIsWrongAndWhere)
{
  using Code = vtkErrorCode;
  const std::string nodes = "NBLOCK,3,,3,3\n(1i9,3e9.1)\n        1      0.0\n        2      1.0\n";
  const std::string elements = MakeNodes(1, 3) + "ET,1,185\nEBLOCK,19,SOLID,,2\n(19i4)\n";
  const struct
  {
    std::string Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", Code::UnrecognizedFileTypeError, "test.cdb: expected a Mechanical APDL deck with nodes" },
    { "*HEADING\n*NODE\n1, 0, 0, 0\n", Code::UnrecognizedFileTypeError,
      "expected a Mechanical APDL deck" },
    { "/PREP7\nK,1,0,0,0\nFINISH\n", Code::UnrecognizedFileTypeError, "(NBLOCK or N), found none" },
    { "*Node, nset=all\n1, 0, 0, 0\n", Code::UnrecognizedFileTypeError,
      "(NBLOCK or N), found an Abaqus deck" },
    { "N,1\rN,2,1\r", Code::FileFormatError,
      "test.cdb: expected lines that end with LF or CRLF, found CR" },
    { "NBLOCK,6,SOLID\n1 0 0 0.5\n-1\n", Code::FileFormatError,
      "test.cdb:2: expected a format of rows with at least 1 integer" },
    { "NBLOCK,6,SOLID\n(what)\n1 0 0 0.5\n-1\n", Code::FileFormatError,
      "test.cdb:2: expected a format of rows" },
    { "ETBLOCK,1,1\n(2i9,19a9)\n        1    SOLID\n-1\n", Code::FileFormatError,
      "test.cdb:3: expected the number of an element in columns 10 to 18, found 'SOLID'" },
    { "/PREP7\nN,1,(1/24)\nN,2,A\n", Code::UnrecognizedFileTypeError,
      "(NBLOCK or N), found none whose coordinates are numbers or known parameters" },
    { nodes, Code::PrematureEndOfFileError,
      "test.cdb:5: expected more nodes, or the end of their block, found the end of the file" },
    { nodes + "     ?   3      2.0\n", Code::FileFormatError,
      "test.cdb:5: expected the number of a" },
    { nodes + "     1x       2.0\n-1\n", Code::FileFormatError,
      "test.cdb:5: expected the number of a node from 1 to 2147483647 in columns 1 to 9, found "
      "'1x'" },
    { nodes + "        0      2.0\n-1\n", Code::FileFormatError,
      "test.cdb:5: expected the number of a node from 1 to 2147483647, found 0" },
    { nodes + "       -5      2.0\n-1\n", Code::FileFormatError, "found -5" },
    { nodes + "        3      2..0\n-1\n", Code::FileFormatError,
      "test.cdb:5: expected a coordinate of a node in columns 10 to 18, found '2..'" },
    { nodes + "        3 2.0 0.0\n-1\n", Code::FileFormatError,
      "test.cdb:5: expected a coordinate of a node in columns 10 to 18, found '2.0 0.0'" },
    { nodes + std::string("        3      \0.0\n-1\n", 22), Code::FileFormatError,
      "test.cdb:5: expected a coordinate of a node in columns 10 to 18, found '?.0'" },
    { "N,1,0,1x\n", Code::FileFormatError,
      "test.cdb:1: expected a coordinate of a node, found '1x'" },
    { "N,-1,0\n", Code::FileFormatError, "test.cdb:1: expected the number of a node" },
    { MakeNodes(1, 3) + "ET,1,181\nE,1,2,4\n", Code::FileFormatError,
      "test.cdb:5: expected an element whose nodes are defined, found node 4" },
    { "N,1\nN,2,-DIST\nN,3,1\nFILL,1,3\nE,1,2\n", Code::FileFormatError,
      "found node 2, which is omitted because its N command needs a parameter of unknown value" },
    { "N,1\nN,4,1\nFILL\nNUMCMP,ALL\nE,1,2\n", Code::FileFormatError,
      "found node 2, which may be defined by commands that are not executed: FILL" },
    { "N,1\nN,A,1\nE,1,2\n", Code::FileFormatError,
      "that are not executed: commands with parameters of unknown value" },
    { "N,1\nN,2,(8/12\nN,3,8..12\n", Code::FileFormatError,
      "test.cdb:3: expected a coordinate of a node, found '8..12'" },
    { MakeNodes(1, 3) + "ET,1,181\nE,1,,3\n", Code::FileFormatError, "found node 0" },
    { MakeNodes(1, 3) + "ET,1,181\nE,1,2,3x\n", Code::FileFormatError,
      "test.cdb:5: expected a node of an element, found '3x'" },
    { MakeNodes(1, 3) + "EN,0,1\n", Code::FileFormatError, "the number of an element, at least 1" },
    { elements + MakeRow(1, 1, { 1, 2, 3 }, 4), Code::PrematureEndOfFileError,
      "test.cdb:8: expected more elements, or the end of their block" },
    // Rows with damage where a command would begin.
    { nodes + "      nan      2.0\n-1\n", Code::FileFormatError,
      "test.cdb:5: expected more nodes, or the end of their block, found 'nan'" },
    { nodes + "        x        3      2.0\n-1\n", Code::FileFormatError, "test.cdb:5: expected" },
    { elements + MakeRow(1, 1, { 1, 2, 3 }, 4) + " nan" + MakeRow(2, 1, { 1, 2, 3 }, 4).substr(4) +
        "-1\n",
      Code::FileFormatError,
      "test.cdb:8: expected more elements, or the end of their block, found 'nan'" },
    { MakeNodes(1, 3) + "ET,1,185\nEBLOCK,19,SOLID\n(19i4)\n" + "inf" +
        MakeRow(2, 1, { 1, 2, 3 }, 4).substr(3) + "-1\n",
      Code::FileFormatError, "test.cdb:7: expected more elements" },
    { elements + MakeRow(0, 1, { 1 }, 4) + "-1\n", Code::FileFormatError,
      "test.cdb:7: expected the number of an element, at least 1, found 0" },
    { elements + "   1   1   1   1   0   0   0   09999   0   1   1\n-1\n", Code::FileFormatError,
      "test.cdb:7: expected the number of nodes of an element from 0 to 1000, found 9999" },
    { elements +
        "   1   1   1   1   0   0   0   0  20   0   1   1   2   3   3   3   3   3   3\n-1\n",
      Code::PrematureEndOfFileError, "test.cdb:8: expected more nodes of an element, found '-1'" },
    { elements + "   1   ?   1   1   0   0   0   0   1   0   1   1\n-1\n", Code::FileFormatError,
      "test.cdb:7: expected the type of an element in columns 5 to 8, found '?'" },
    { MakeNodes(1, 3) + "CMBLOCK,A,NODE,9\n(8i10)\n         1         2\n",
      Code::PrematureEndOfFileError, "more members of a component" },
    { MakeNodes(1, 3) + "CMBLOCK,A,NODE,2\n(8i10)\n         1         x\n", Code::FileFormatError,
      "test.cdb:6: expected the number of a member of a component in columns 11 to 20, found 'x'" },
    { MakeNodes(1, 3) + "CMBLOCK,A,NODE,2\n(8i10)\n         5        -2\n", Code::FileFormatError,
      "found -2" },
  };
  for (const auto& wrong : cases)
  {
    const Result result = ReadDeck(wrong.Text);
    ASSERT_TRUE(result.IsProperError()) << wrong.Text;
    EXPECT_EQ(result.ErrorCode, wrong.Code) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
  }
  // Blocks without end are complete if they have the declared number of rows.
  EXPECT_TRUE(ReadDeck(nodes + "        3      2.0").Errors.empty());
  // Commands end only these; before an end mark, fewer rows than declared cause a warning.
  for (const char* end : { "FINISH\n", "/GO\n", "C***\n" })
  {
    EXPECT_TRUE(ReadDeck(nodes + end).IsProperError()) << end;
    EXPECT_TRUE(ReadDeck(nodes + "        3      2.0\n" + end).Errors.empty()) << end;
  }
  for (const char* end : { "-1\n", "N,R5.3,LOC,-1,\n" })
  {
    const Result result = ReadDeck(nodes + end);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 1u) << end;
    EXPECT_NE(result.Warnings[0].find("1 block has more or fewer rows than it declares"),
      std::string::npos);
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 2);
  }
}

//------------------------------------------------------------------------------
// If this fails, damaged files are read as valid ones, or errors lack the position.
TEST(MAPDLFiles, CollectedDamagedFile)
{
  CAMARON_NEEDS_SHARED_DATA("malformed/cdb_corrupt_a.cdb");
  const std::string path = GetSharedData("malformed/cdb_corrupt_a.cdb").string();
  const Result result = ReadWith<vtkMAPDLReader>(path);
  ASSERT_TRUE(result.IsProperError());
  EXPECT_EQ(result.ErrorCode, static_cast<unsigned long>(vtkErrorCode::FileFormatError));
  EXPECT_NE(result.Errors[0].find("cdb_corrupt_a.cdb:143: expected a coordinate of a node"),
    std::string::npos)
    << result.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, files of other programs are read as decks, or decks are not recognized.
TEST(MAPDLFiles, CanReadFile)
{
  vtkNew<vtkMAPDLReader> reader;
  std::vector<std::string> messages;
  Observe(reader, vtkCommand::ErrorEvent, messages);
  Observe(reader, vtkCommand::WarningEvent, messages);
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.dat").Path.c_str()); };
  EXPECT_EQ(canRead(MakeBar(2, true)), 1);
  EXPECT_EQ(canRead(MakeBar(2, true, "\r\n")), 1);
  EXPECT_EQ(canRead("\xef\xbb\xbf/prep7\nnblock,3,,3\n(1i9,3e20.9)\n"), 1);
  EXPECT_EQ(canRead("! by hand\nn,1\nn,2,1\n"), 1);
  EXPECT_EQ(canRead("/PREP7\nN,1\nN,2\nE,1,2\n"), 1);
  EXPECT_EQ(canRead("ET,1,40\nN,1\n"), 1);
  EXPECT_EQ(canRead("N,R5.3,LOC,1,0,0,0,0,0\n"), 1);
  EXPECT_EQ(canRead("*IF,A,EQ,1,THEN\n*ELSE\n*ENDIF\nNBLOCK,6,SOLID\n"), 1);
  EXPECT_EQ(canRead(", no name\nNBLOCK,6,SOLID\n"), 1);
  std::string late = "/PREP7\n";
  while (late.size() < 300000)
  {
    late += "*SET,A,1.0\nMP,EX,1,2e11\n";
  }
  EXPECT_EQ(canRead(late + "N,1,1\n"), 1);
  for (const std::string& other :
    { std::string(), std::string("*HEADING\n*NODE\n1,0.,0.,0.\n"),
      std::string("** Abaqus\n*NODE, NSET=ALL\n1, 0, 0, 0\nN,1,2,3\n"),
      std::string("*Part, name=N\n*Node\nN,1,2,3\n"),
      std::string("(0 \"fluent18.0.0\")\n(33 (25740 39030 13290))\n"), std::string("[TITLE]\nx\n"),
      std::string("1.0 2.0 3.0\n4.0 5.0 6.0\n"), std::string("TITLE = \"x\"\nVARIABLES = X, Y\n"),
      std::string("GRID,1,,0.,0.,0.\nCQUAD4,1,1,1,2,3,4\n"), std::string("/PREP7\nK,1,0,0\n"),
      std::string("8 1 0 0 0\n1 0 0 0\n"), std::string("name,x,y\nn,a,b\n"),
      std::string("NBLOCK,6,SOLID\n\0\0\0\0x", 20) })
  {
    EXPECT_EQ(canRead(other), 0) << other;
  }
  EXPECT_EQ(reader->CanReadFile("/nonexistent.cdb"), 0);
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
  EXPECT_TRUE(messages.empty());
}
