// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Decks of Mechanical APDL: every form of nodes, elements, types and components.
#include "MAPDLSamples.h"

#include "vtkFieldData.h"
#include "vtkSMPTools.h"
#include "vtkStringArray.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
using Nodes = std::vector<int>;

// A block of nodes 1, 2, 3 with a format, and a triangle of them.
std::string MakeTriangle(const std::string& header, const std::string& rows)
{
  return header + "\n" + rows + "N,R5.3,LOC,       -1,\nET,1,181\nE,1,2,3\n";
}

void ExpectTriangle(const std::string& deck, std::size_t warnings = 0)
{
  const Result result = ReadDeck(deck);
  ASSERT_TRUE(result.Errors.empty()) << deck << result.Errors[0];
  EXPECT_EQ(result.Warnings.size(), warnings) << deck;
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 3) << deck;
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 1) << deck;
  const double expected[3][3] = { { 0, 0, 0 }, { 1.5, 0, 0 }, { -1.25e-3, 2, 1e-105 } };
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_DOUBLE_EQ(result.Grid->GetPoint(i)[c], expected[i][c]) << deck;
    }
  }
  EXPECT_EQ(GetNodes(result.Grid, 0), (Nodes{ 1, 2, 3 }));
}
}

//------------------------------------------------------------------------------
// If this fails, coordinates of some format are split at wrong positions.
TEST(MAPDLReader, NodesOfEveryFormat)
{
  ExpectTriangle(MakeTriangle("NBLOCK,6,SOLID,3,3\n(3i9,6e21.13e3)",
    "        1        0        0\n"
    "        2        0        0 1.5000000000000E+000\n"
    "        3        0        0-1.2500000000000E-003 2.0000000000000E+000 "
    "1.0000000000000E-105\n"));
  // Touching columns, D and missing letters of exponents, blank fields, rotations, CRLF.
  ExpectTriangle(MakeTriangle("nblock,6,solid\r\n(1I7,2i9,6E12.5)\r",
    "      1                                                         4.50000E+01\r\n"
    "      2        9        9 1.50000D+00\r\n"
    "      3        0        0-1.25000E-03        2.0 1.00000-105\r\n"));
  ExpectTriangle(MakeTriangle("nblo,3,,3\n(1i9,3e20.9e3)",
    "        1\n        2     1.500000000e+00\n"
    "        3    -1.250000000e-03     2.000000000e+00    1.000000000e-105\n"));
  // Wrong counts, with a warning; blank lines; comments.
  ExpectTriangle(MakeTriangle("NBLOCK,6,SOLID,99,99\n(3i8,6g16.9)",
                   "       1       0       0\n\n"
                   "       2       0       0             1.5 \n! a comment\n"
                   "       3       0       0        -0.00125               2        1.e-105\n"),
    1);
}

//------------------------------------------------------------------------------
// If this fails, decks written by hand or without blocks lose nodes.
TEST(MAPDLReader, NodeCommands)
{
  ExpectTriangle("N,1\nN, 2 , 1.5,,\nn,3,-1.25e-3,2,1E-105 ! last\nET,1,181\nE,1,2,3\n");
  ExpectTriangle("N,1 $ N,2,1.5 $ N,3,-1.25d-3,2,1E-105,45,30\nET,1,SHELL181 $ E,1,2,3\n");
  ExpectTriangle("N,R5.1,LOC,1,0,0,0,0,0\nN,UNBL,LOC,2,0,0,1.5,0,0\nN,UNBL,ANG,2,0,0,90\n"
                 "N,R5.3,LOC,3,0,0,-1.25e-3,2,1e-105\nN,R5.3,LOC,-1,\nET,1,63\nE,1,2,3,3\n");
  ExpectTriangle(
    "*SET,B,3\nx=1.5 ! parameters\nN,1\nN,,X\nN,b,-1.25e-3,2,1E-105\nET,1,181\nE,1,2,b\n");
  const Result unknown =
    ReadDeck("N,1\nN,2\nN,3\n*GET,A,NODE,,NUM,MAX\nN,4,A\nET,1,181\nE,1,2,3\nE,1,2,A\n");
  ASSERT_EQ(unknown.Warnings.size(), 1u);
  EXPECT_NE(
    unknown.Warnings[0].find("2 commands need a parameter or an expression"), std::string::npos);
  EXPECT_EQ(unknown.Grid->GetNumberOfPoints(), 3);
  EXPECT_EQ(unknown.Grid->GetNumberOfCells(), 1);
  // Expressions are not evaluated.
  for (const char* expression : { "-DIST", "(8/12)", "2*A", "+(1-B)**2", "1.5e3 - SIN(A", "A(1)/2",
         "-2*(SQRT(2)+A1)", "%A%", "-1%A+1%.5" })
  {
    const Result result =
      ReadDeck(std::string("N,1\nN,2\nN,3\nN,4,") + expression + "\nE,1,2,3\nE,1,2," + expression);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Warnings.size(), 2u) << expression;
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 3);
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
  }
}

//------------------------------------------------------------------------------
// If this fails, nodes and elements after an omitted one do not have the number that they have in
// the program, and elements use wrong nodes.
TEST(MAPDLReader, WhatIsLeftOutKeepsItsNumber)
{
  const std::string head = "ET,1,180\nN,1\n";
  for (const char* nodes : { "N,2,-L\n", "N,,-L\n" })
  {
    const Result result = ReadDeck(head + nodes + "N,,5\nE,1,3\n");
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfPoints(), 2);
    EXPECT_EQ(result.Grid->GetPointData()->GetArray("NodeId")->GetTuple1(1), 3);
    EXPECT_EQ(result.Grid->GetPoint(1)[0], 5);
    const Result refused = ReadDeck(head + nodes + "N,,5\nE,1,2\n");
    ASSERT_EQ(refused.Errors.size(), 1u);
    EXPECT_NE(refused.Errors[0].find("omitted because its N command"), std::string::npos)
      << refused.Errors[0];
  }
  // An unknown number may be the greatest one.
  const Result unknown = ReadDeck(head + "N,L,3\nN,,5\nN,4,2\nE,1,4\n");
  ASSERT_TRUE(unknown.Errors.empty()) << unknown.Errors[0];
  EXPECT_EQ(unknown.Grid->GetNumberOfPoints(), 2);
  ASSERT_EQ(unknown.Warnings.size(), 1u);
  EXPECT_NE(unknown.Warnings[0].find("2 commands need a parameter"), std::string::npos);
  const Result elements = ReadDeck(head + "N,2,1\nN,3,2\nE,1,2\nE,2,-L\nE,2,3\n");
  ASSERT_EQ(elements.Grid->GetNumberOfCells(), 2);
  EXPECT_EQ(GetValue(elements.Grid, "ElementId", 1), 3);
}

//------------------------------------------------------------------------------
// If this fails, some form of elements is lost, or its attributes are.
TEST(MAPDLReader, ElementsOfEveryForm)
{
  const std::string head = MakeNodes(1, 20) + "ET,5,185\nET,6,186\n";
  const Nodes brick{ 1, 2, 3, 4, 5, 6, 7, 8 };
  Nodes brick20;
  for (int id = 1; id <= 20; ++id)
  {
    brick20.push_back(id);
  }
  const std::string blocks[] = {
    "EBLOCK,19,SOLID,8,2\n(19i9)\n" + MakeRow(7, 5, brick) + MakeRow(8, 6, brick20) + "       -1\n",
    "eblock,19,solid,,2\n(19i4)\n" + MakeRow(7, 5, brick, 4) + MakeRow(8, 6, brick20, 4) +
      "FINISH\n",
    "EBLOCK,19,SOLID,,2\n(19I8)\n" + MakeRow(7, 5, brick, 8) + MakeRow(8, 6, brick20, 8),
  };
  for (const std::string& block : blocks)
  {
    const Result result = ReadDeck(head + block);
    ASSERT_TRUE(result.Errors.empty()) << block << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 2) << block;
    EXPECT_EQ(result.Grid->GetCellType(0), VTK_HEXAHEDRON);
    EXPECT_EQ(GetNodes(result.Grid, 0), brick);
    EXPECT_EQ(result.Grid->GetCellType(1), VTK_QUADRATIC_HEXAHEDRON);
    EXPECT_EQ(GetNodes(result.Grid, 1), brick20);
    EXPECT_EQ(GetValue(result.Grid, "ElementId", 1), 8);
    EXPECT_EQ(GetValue(result.Grid, "Material", 1), 2);
    EXPECT_EQ(GetValue(result.Grid, "TypeId", 1), 6);
    EXPECT_EQ(GetValue(result.Grid, "ElementType", 1), 186);
    EXPECT_EQ(GetValue(result.Grid, "Real", 1), 3);
    EXPECT_EQ(GetValue(result.Grid, "Section", 1), 4);
  }
  // Without SOLID there is no number of nodes.
  const auto readPlain = [](const std::string& before, const std::string& rows)
  { return ReadDeck(before + "eblock,10,,,2\n(15i4)\n" + rows + "-1\n"); };
  const std::string full = "   8   6   6   6   0   1   2   3   4   5   6   7   8   9  10\n";
  const Result plain = readPlain(
    head, "   7   5   9   2   0   1   2   3   4   5   6   7   8\n   9   5   9   2   0   5\n");
  ASSERT_TRUE(plain.Errors.empty()) << plain.Errors[0];
  ASSERT_EQ(plain.Grid->GetNumberOfCells(), 2);
  EXPECT_EQ(GetNodes(plain.Grid, 0), brick);
  EXPECT_EQ(GetValue(plain.Grid, "Material", 0), 2);
  EXPECT_EQ(GetValue(plain.Grid, "Real", 0), 9);
  const Result tetrahedra = readPlain(MakeNodes(1, 20) + "ET,6,187\n", full + full + "\n! last\n");
  ASSERT_EQ(tetrahedra.Errors.size(), 0u) << tetrahedra.Errors[0];
  EXPECT_EQ(tetrahedra.Grid->GetNumberOfCells(), 1);
  EXPECT_EQ(tetrahedra.Grid->GetCellType(0), VTK_QUADRATIC_TETRA);
  // So a full row of a brick might continue on the next line.
  for (const char* type : { "", "ET,6,186\n" })
  {
    const Result unclear = readPlain(MakeNodes(1, 20) + type, full + "  11  12  13  14\n");
    ASSERT_TRUE(unclear.IsProperError()) << type;
    const std::string place = *type ? "test.cdb:24: " : "test.cdb:23: ";
    EXPECT_NE(
      unclear.Errors[0].find(place + "expected the key SOLID for elements"), std::string::npos)
      << unclear.Errors[0];
    EXPECT_NE(unclear.Errors[0].find("found type 6"), std::string::npos);
  }
  // Commands: numbers continue from the greatest so far, attributes are those set last.
  const Result commands = ReadDeck(head +
    "EN,30,1,2,3,4,5,6,7,8\nTYPE, 6 $ MAT,8 $ REAL, 9\nSECNUM,10\nE,1,2,3,4,5,6,7,8\n"
    "EMORE,9,10,11,12,13,14,15,16 $ EMORE,17,18,19,20\n"
    "EN,R5.5,ATTR,20,2,6,3,4,0,50,0,0\nEN,R5.5,NODE,1,2,3,4,5,6,7,8\n"
    "EN,R5.5,NODE,9,10,11,12,13,14,15,16\nEN,R5.5,NODE,17,18,19,20\nEN,R5.5,ATTR,-1,\n");
  ASSERT_TRUE(commands.Errors.empty()) << commands.Errors[0];
  ASSERT_EQ(commands.Grid->GetNumberOfCells(), 3);
  EXPECT_EQ(GetNodes(commands.Grid, 0), brick);
  EXPECT_EQ(GetNodes(commands.Grid, 1), brick20);
  EXPECT_EQ(GetNodes(commands.Grid, 2), brick20);
  EXPECT_EQ(GetValue(commands.Grid, "ElementId", 1), 31);
  EXPECT_EQ(GetValue(commands.Grid, "Material", 1), 8);
  EXPECT_EQ(GetValue(commands.Grid, "Real", 1), 9);
  EXPECT_EQ(GetValue(commands.Grid, "Section", 1), 10);
  EXPECT_EQ(GetValue(commands.Grid, "TypeId", 0), 1);
  EXPECT_EQ(GetValue(commands.Grid, "ElementId", 2), 50);
  EXPECT_EQ(GetValue(commands.Grid, "Section", 2), 4);
}

//------------------------------------------------------------------------------
// If this fails, cells have the wrong type or order of points. Expected orders are from the element
// reference: degenerate bricks, mid-side nodes Q to B on edges IJ JK KL LI MN NO OP PM IM JN KO LP.
TEST(MAPDLReader, CellsOfEveryKind)
{
  const struct
  {
    const char* Type;
    Nodes Element;
    int CellType;
    Nodes Cell;
  } cases[] = {
    { "185", { 1, 2, 3, 4, 5, 5, 5, 5 }, VTK_PYRAMID, { 1, 2, 3, 4, 5 } },
    { "185", { 1, 2, 3, 3, 5, 5, 5, 5 }, VTK_TETRA, { 1, 2, 3, 5 } },
    { "186", { 1, 2, 3, 3, 5, 5, 5, 5, 9, 10, 3, 12, 5, 5, 5, 5, 17, 18, 19, 19 },
      VTK_QUADRATIC_TETRA, { 1, 2, 3, 5, 9, 10, 12, 17, 18, 19 } },
    { "186", { 1, 2, 3, 4, 5, 5, 5, 5, 9, 10, 11, 12, 5, 5, 5, 5, 17, 18, 19, 20 },
      VTK_QUADRATIC_PYRAMID, { 1, 2, 3, 4, 5, 9, 10, 11, 12, 17, 18, 19, 20 } },
    { "186", { 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }, VTK_HEXAHEDRON,
      { 1, 2, 3, 4, 5, 6, 7, 8 } },
    { "SOLID285", { 4, 3, 2, 1 }, VTK_TETRA, { 4, 3, 2, 1 } },
    { "187", { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, VTK_QUADRATIC_TETRA,
      { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 } },
    { "92", { 1, 2, 3, 3, 5, 5, 5, 5 }, VTK_TETRA, { 1, 2, 3, 5 } },
    { "181", { 1, 2, 3, 4 }, VTK_QUAD, { 1, 2, 3, 4 } },
    { "181", { 1, 2, 3, 3 }, VTK_TRIANGLE, { 1, 2, 3 } },
    { "281", { 1, 2, 3, 4, 5, 6, 7, 8 }, VTK_QUADRATIC_QUAD, { 1, 2, 3, 4, 5, 6, 7, 8 } },
    { "281", { 1, 2, 3, 3, 5, 6, 3, 8 }, VTK_QUADRATIC_TRIANGLE, { 1, 2, 3, 5, 6, 8 } },
    { "PLANE2", { 1, 2, 3, 4, 5, 6 }, VTK_QUADRATIC_TRIANGLE, { 1, 2, 3, 4, 5, 6 } },
    { "152", { 1, 2, 3, 4, 9 }, VTK_QUAD, { 1, 2, 3, 4 } },
    { "152", { 1, 2, 3, 4, 5, 6, 7, 8, 9 }, VTK_QUADRATIC_QUAD, { 1, 2, 3, 4, 5, 6, 7, 8 } },
    { "170", { 7 }, VTK_VERTEX, { 7 } },
    { "170", { 7, 8 }, VTK_LINE, { 7, 8 } },
    { "174", { 7, 8, 9 }, VTK_TRIANGLE, { 7, 8, 9 } },
    { "BEAM188", { 1, 2, 3 }, VTK_LINE, { 1, 2 } },
    { "189", { 1, 2, 3, 4 }, VTK_QUADRATIC_EDGE, { 1, 2, 3 } },
    { "189", { 1, 2, 0, 4 }, VTK_LINE, { 1, 2 } },
    { "MASS21", { 3 }, VTK_VERTEX, { 3 } },
    { "MASS166", { 3 }, VTK_VERTEX, { 3 } },
    { "500", { 3 }, VTK_VERTEX, { 3 } },
    { "200,3", { 1, 2, 3 }, VTK_QUADRATIC_EDGE, { 1, 2, 3 } },
    { "200,4", { 1, 2, 3 }, VTK_TRIANGLE, { 1, 2, 3 } },
    { "200\nKEYOPT,1,1,9", { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }, VTK_QUADRATIC_TETRA,
      { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 } },
    { "MESH200\nkeyo, 1 , 1 , 10", { 1, 2, 3, 4, 5, 6, 7, 8 }, VTK_HEXAHEDRON,
      { 1, 2, 3, 4, 5, 6, 7, 8 } },
  };
  for (const auto& one : cases)
  {
    const Result result = ReadDeck(MakeNodes(1, 20) + "ET,1," + one.Type +
      "\nEBLOCK,19,SOLID\n(19i9)\n" + MakeRow(1, 1, one.Element) + "-1\n");
    ASSERT_TRUE(result.Errors.empty()) << one.Type << result.Errors[0];
    ASSERT_EQ(result.Grid->GetNumberOfCells(), 1) << one.Type;
    EXPECT_EQ(result.Grid->GetCellType(0), one.CellType) << one.Type;
    EXPECT_EQ(GetNodes(result.Grid, 0), one.Cell) << one.Type;
  }
}

//------------------------------------------------------------------------------
// If this fails, wedges are inverted, or their mid-side nodes are on the wrong edges.
TEST(MAPDLReader, WedgesHavePositiveVolume)
{
  // A prism over the triangle 1 2 3 with its mid-side nodes in the middle.
  const char* const nodes = "N,1,0,0,0\nN,2,1,0,0\nN,3,0,1,0\nN,5,0,0,1\nN,6,1,0,1\nN,7,0,1,1\n"
                            "N,9,.5,0,0\nN,10,.5,.5,0\nN,12,0,.5,0\nN,13,.5,0,1\nN,14,.5,.5,1\n"
                            "N,16,0,.5,1\nN,17,0,0,.5\nN,18,1,0,.5\nN,19,0,1,.5\n";
  const Nodes brick{ 1, 2, 3, 3, 5, 6, 7, 7 };
  Nodes brick20 = brick;
  brick20.insert(brick20.end(), { 9, 10, 3, 12, 13, 14, 7, 16, 17, 18, 19, 19 });
  const Result result = ReadDeck(std::string(nodes) + "ET,1,186\nEBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(1, 1, brick) + MakeRow(2, 1, brick20) + "-1\n");
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Grid->GetCellType(0), VTK_WEDGE);
  ASSERT_EQ(result.Grid->GetCellType(1), VTK_QUADRATIC_WEDGE);
  const MeshView mesh(result.Grid);
  for (const vtkIdType cell : { 0, 1 })
  {
    // All faces are oriented outward: the sum over them of tetrahedra with the origin is the
    // volume.
    double volume = 0;
    CellFacets(mesh).ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        for (vtkIdType i = 2; i < size; ++i)
        {
          double a[3], b[3], c[3];
          mesh.GetPoint(points[0], a);
          mesh.GetPoint(points[i - 1], b);
          mesh.GetPoint(points[i], c);
          volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                      a[2] * (b[0] * c[1] - b[1] * c[0])) /
            6;
        }
      });
    EXPECT_NEAR(volume, 0.5, 1e-12);
  }
  // Mid-side nodes in VTK's order of edges.
  const int edges[9][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 },
    { 1, 4 }, { 2, 5 } };
  const IndexRange points = mesh.GetCellPoints(1);
  for (int e = 0; e < 9; ++e)
  {
    double a[3], b[3], m[3];
    mesh.GetPoint(points[edges[e][0]], a);
    mesh.GetPoint(points[edges[e][1]], b);
    mesh.GetPoint(points[6 + e], m);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_DOUBLE_EQ(m[c], 0.5 * (a[c] + b[c])) << e;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, cells with missing mid-side nodes are lost or have points at the origin.
TEST(MAPDLReader, MissingMidSideNodes)
{
  const std::string deck = MakeNodes(1, 20) + "ET,1,187\nEBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(1, 1, { 1, 2, 3, 4, 0, 6, 7, 8, 9, 10 }) +
    MakeRow(2, 1, { 2, 1, 3, 5, 0, 11, 12, 13, 14, 0 }) + "-1\n";
  const Result result = ReadDeck(deck);
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("2 mid-side nodes are missing"), std::string::npos);
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 22); // the edge of nodes 1 and 2 is shared
  EXPECT_EQ(GetNodes(result.Grid, 0), (Nodes{ 1, 2, 3, 4, 0, 6, 7, 8, 9, 10 }));
  vtkNew<vtkIdList> a, b;
  result.Grid->GetCellPoints(0, a);
  result.Grid->GetCellPoints(1, b);
  EXPECT_EQ(a->GetId(4), 20);
  EXPECT_EQ(b->GetId(4), 20);
  EXPECT_EQ(b->GetId(9), 21);
  double x[3], y[3];
  GetPlace(1, x);
  GetPlace(2, y);
  EXPECT_DOUBLE_EQ(result.Grid->GetPoint(20)[2], 0.5 * (x[2] + y[2]));
  // Rows of shells end before trailing zeros.
  const Result shell = ReadDeck(MakeNodes(1, 8) + "ET,1,281\nEBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(1, 1, { 1, 2, 3, 4, 5, 6, 7 }) + MakeRow(2, 1, { 1, 2, 3, 3, 5, 6, 3 }) + "-1\n");
  EXPECT_EQ(shell.Grid->GetNumberOfPoints(), 10);
  EXPECT_EQ(shell.Grid->GetCellType(0), VTK_QUADRATIC_QUAD);
  EXPECT_EQ(GetNodes(shell.Grid, 1), (Nodes{ 1, 2, 3, 5, 6, 0 }));
  // All cells linear.
  const Result linear = ReadWith<vtkMAPDLReader>(
    File(deck).Path, 0, 1, 0, [](vtkMAPDLReader* reader) { reader->LinearOn(); });
  EXPECT_TRUE(linear.Warnings.empty());
  EXPECT_EQ(linear.Grid->GetNumberOfPoints(), 20);
  EXPECT_EQ(linear.Grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(GetNodes(linear.Grid, 1), (Nodes{ 2, 1, 3, 5 }));
}

//------------------------------------------------------------------------------
// If this fails, earlier definitions are used, or only the first block is.
TEST(MAPDLReader, SeveralBlocksAndLaterDefinitions)
{
  const Result result = ReadDeck(
    "NBLOCK,3\n(1i9,3e9.1)\n        1      1.0\n        2      2.0\n        3      3.0\n-1\n"
    "ET,1,181\nEBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(1, 1, { 1, 2, 3 }) + MakeRow(2, 1, { 1, 3, 2 }) +
    "-1\nNBLOCK,3\n(1i9,3e9.1)\n        4      4.0\n        2      9.0\n-1\nN,5,5\n"
    "EBLOCK,19,SOLID\n(19i9)\n" +
    MakeRow(3, 1, { 2, 4, 5 }) + MakeRow(1, 1, { 5, 4, 3 }) +
    "-1\n"
    "CMBLOCK,C,ELEM,1\n(8i10)\n         1\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Warnings.size(), 2u);
  ASSERT_EQ(result.Grid->GetNumberOfPoints(), 5);
  ASSERT_EQ(result.Grid->GetNumberOfCells(), 3);
  const Nodes ids{ 1, 3, 4, 2, 5 };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(result.Grid->GetPointData()->GetArray("NodeId")->GetTuple1(i), ids[i]);
  }
  EXPECT_EQ(result.Grid->GetPoint(3)[0], 9);
  EXPECT_EQ(GetNodes(result.Grid, 0), (Nodes{ 1, 3, 2 }));
  EXPECT_EQ(GetNodes(result.Grid, 1), (Nodes{ 2, 4, 5 }));
  EXPECT_EQ(GetNodes(result.Grid, 2), (Nodes{ 5, 4, 3 }));
  EXPECT_EQ(GetValue(result.Grid, "ElementId", 2), 1);
  EXPECT_EQ(GetValue(result.Grid, "C", 0), 0);
  EXPECT_EQ(GetValue(result.Grid, "C", 2), 1);
}

//------------------------------------------------------------------------------
TEST(MAPDLReader, Types)
{
  const std::string nodes = MakeNodes(1, 8);
  const Result block = ReadDeck(nodes +
    "ETBLOCK,2,9\n(2i9,19a9)\n        7      200        6        0\n        9      185\n       -1\n"
    "TYPE,7\nE,1,2,3,4\nTYPE,9\nE,1,2,3,4,5,6,7,8\n");
  EXPECT_TRUE(block.Warnings.empty());
  EXPECT_EQ(block.Grid->GetCellType(0), VTK_QUAD);
  EXPECT_EQ(block.Grid->GetCellType(1), VTK_HEXAHEDRON);
  // Types given by parameters, as Workbench writes them.
  const Result parameters = ReadDeck(
    nodes + "*set,tid,4\ncid=3\net,cid,174\net,tid,170\ntype,tid\nen,9,5\ntype,CID\ne,1,2,3,4\n");
  EXPECT_TRUE(parameters.Warnings.empty());
  EXPECT_EQ(GetValue(parameters.Grid, "ElementType", 0), 170);
  EXPECT_EQ(GetValue(parameters.Grid, "ElementType", 1), 174);
  // No types: the number of nodes decides.
  const Result none = ReadDeck(nodes + "E,1,2,3,4,5,6,7,8\nE,1,2,3,4\nE,1\nE,1,2\n");
  ASSERT_EQ(none.Warnings.size(), 1u);
  EXPECT_NE(
    none.Warnings[0].find("4 elements of types that the deck does not define"), std::string::npos);
  const unsigned char types[] = { VTK_HEXAHEDRON, VTK_QUAD, VTK_VERTEX, VTK_LINE };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(none.Grid->GetCellType(i), types[i]);
  }
}

//------------------------------------------------------------------------------
// If this fails, commands are confused with others that begin alike.
TEST(MAPDLReader, NamesOfOtherCommands)
{
  const Result result = ReadDeck(MakeNodes(1, 3) +
    "ET,1,181\nREAL,3\nrealvar,11,10\nREALV,9\nFILLDATA,2\nE,1,2,3\nreal,4\nE,1,3,2\nFILL,1,2\n");
  EXPECT_EQ(GetValue(result.Grid, "Real", 0), 3);
  EXPECT_EQ(GetValue(result.Grid, "Real", 1), 4);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("1 command that changes the mesh is not executed: "),
    std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, options remove too much or too little.
TEST(MAPDLReader, OptionsForElements)
{
  const File file(MakeNodes(1, 8) +
    "ET,1,185\nET,2,154\nET,3,MATRIX27\nE,1,2,3,4,5,6,7,8\nTYPE,2\nE,1,2,3,4\nTYPE,3\nE,1,2\n");
  const auto read = [&](bool surfaceEffects)
  {
    return ReadWith<vtkMAPDLReader>(file.Path, 0, 1, 0,
      [=](vtkMAPDLReader* reader) { reader->SetSurfaceEffects(surfaceEffects); });
  };
  const Result standard = read(true);
  EXPECT_EQ(standard.Grid->GetNumberOfCells(), 2);
  ASSERT_EQ(standard.Warnings.size(), 1u);
  EXPECT_NE(standard.Warnings[0].find("1 element of type 27"), std::string::npos);
  const Result few = read(false);
  ASSERT_EQ(few.Grid->GetNumberOfCells(), 1);
  EXPECT_EQ(GetValue(few.Grid, "ElementType", 0), 185);
}

//------------------------------------------------------------------------------
// If this fails, named selections are lost or wrong.
TEST(MAPDLReader, Components)
{
  const Result result = ReadDeck(MakeNodes(1, 9) +
    "ET,1,181\nE,1,2,3,4\nE,5,6,7,8\n"
    "CMBLOCK,mixed,NODE,       5  ! a comment\n(8i10)\n         2         4        -6         9    "
    "   -2000000000\n"
    "CMBLOCK,a.b c ,ELEM,1\n(8i10)\n         2\n\n"
    "CMBLOCK,LINES,LINE,1\n(8i10)\n         2\nCM,NOTHING,NODE\n"
    "CMBLOCK,EMPTY,NODE,0\n(8i10)\nN,10,1,1,1\n"
    "CMBLOCK,MANY,NODE,9\n(8i2)\n 1 2 3 4 5 6 7 8\n10\nN,11\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_TRUE(result.Warnings.empty());
  EXPECT_EQ(result.Grid->GetNumberOfPoints(), 11);
  const auto expect = [&](const char* name, const std::string& flags)
  {
    vtkDataArray* const array = result.Grid->GetPointData()->GetArray(name);
    ASSERT_NE(vtkUnsignedCharArray::SafeDownCast(array), nullptr) << name;
    for (int i = 0; i < 11; ++i)
    {
      EXPECT_EQ(array->GetTuple1(i), flags[i] - '0') << name << i;
    }
  };
  expect("MIXED", "01011100111");
  expect("EMPTY", "00000000000");
  expect("MANY", "11111111010");
  EXPECT_EQ(GetValue(result.Grid, "A.B C", 0), 0);
  EXPECT_EQ(GetValue(result.Grid, "A.B C", 1), 1);
  auto* nodes =
    vtkStringArray::SafeDownCast(result.Grid->GetFieldData()->GetAbstractArray("NodeComponents"));
  auto* elements = vtkStringArray::SafeDownCast(
    result.Grid->GetFieldData()->GetAbstractArray("ElementComponents"));
  ASSERT_TRUE(nodes && elements);
  ASSERT_EQ(nodes->GetNumberOfValues(), 3);
  EXPECT_EQ(nodes->GetValue(2), "MANY");
  ASSERT_EQ(elements->GetNumberOfValues(), 1);
  EXPECT_EQ(elements->GetValue(0), "A.B C");
}

//------------------------------------------------------------------------------
TEST(MAPDLReader, WarnsOfMembersThatAreNotThere)
{
  const Result result = ReadDeck(MakeNodes(1, 9) + "CMBLOCK,BAD,NODE,1\n(8i10)\n        99\n");
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("1 component refers to nodes"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, text that only looks like commands is executed, or commands are skipped without a
// warning.
TEST(MAPDLReader, SkipsWhatIsNoMesh)
{
  const Result result = ReadDeck(MakeNodes(1, 4) +
    "/COM, costs $ N,9 $\n/TITLE,x $ N,9\nC*** N,9 $ N,9\n! N,9\nMP,EX,1,2e11 $ MP,NUXY,1,0.3\n"
    "RLBLOCK,1,1,7,7\n(2i8,6g16.9)\n(7g16.9)\n       1       7  0.0\n"
    "*IF,A,EQ,1,THEN\nN,9\n*IF,B,EQ,1,THEN\n*ELSE\n*ENDIF\n*ENDIF\n*IF,A,EQ,1,EXIT\n"
    "*DO,I,1,5\nN,I\n*ENDDO\n_a = 'N,9 $ N,9'\nNGEN,2,4,1,4\nET,1,181\nE,1,2,3,4\n/EOF\nN,9\n");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(result.Grid->GetNumberOfPoints(), 4);
  EXPECT_EQ(result.Grid->GetNumberOfCells(), 1);
  ASSERT_EQ(result.Warnings.size(), 2u);
  EXPECT_NE(
    result.Warnings[0].find("2 commands that define or change the mesh"), std::string::npos);
  EXPECT_NE(result.Warnings[1].find("NGEN"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, several models of a deck are merged, with the types of the last.
TEST(MAPDLReader, ADeckHasOneModel)
{
  EXPECT_TRUE(ReadDeck("/CLEAR\n" + MakeNodes(1, 3)).Warnings.empty());
  const Result second = ReadDeck(MakeNodes(1, 3) + "FINISH\n/clear,NOSTART\n" + MakeNodes(1, 3));
  ASSERT_TRUE(second.IsProperError());
  EXPECT_NE(second.Errors[0].find(
              "test.cdb:5: expected one model per deck, found /CLEAR after nodes or elements"),
    std::string::npos)
    << second.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, parts of the mesh that a branch or loop would change are read without a warning.
TEST(MAPDLReader, BranchesChangeNothingUnsaid)
{
  const std::string nodes = MakeNodes(1, 4) + "ET,1,181\nX=9\n";
  const auto read = [&](const std::string& text)
  {
    const Result result = ReadDeck(nodes + text + "E,1,2,3,4\n");
    EXPECT_TRUE(result.Errors.empty()) << text;
    EXPECT_EQ(result.Grid->GetNumberOfPoints(), 4) << text;
    EXPECT_EQ(result.Grid->GetNumberOfCells(), 1) << text;
    std::string warnings;
    for (const std::string& warning : result.Warnings)
    {
      warnings += warning + "\n";
    }
    return warnings;
  };
  const auto inBranch = [&](const std::string& text)
  { return read("*IF,A,EQ,1,THEN,\n" + text + "\n*ENDIF\n"); };
  const std::string block = "(3i9,6e21.13e3)\n        5        0        0\nN,UNBL,LOC,-1,";
  EXPECT_NE(
    inBranch("NBLOCK,6,SOLID\n" + block).find("(*IF, *DO, *CREATE): N,"), std::string::npos);
  for (const char* command : { "EBLOCK", "CMBLOCK", "ET", "ETBLOCK", "TYPE", "MAT", "REAL",
         "SECNUM", "/CLEAR", "NGEN", "/INPUT", "NUMMRG" })
  {
    const std::string warning = inBranch(std::string(command) + ",2,2\n");
    EXPECT_NE(warning.find("(*IF, *DO, *CREATE): " + std::string(command)), std::string::npos)
      << warning;
  }
  EXPECT_NE(read("*DO,I,1,9\nNGEN,2,4,1,4\n*ENDDO\n").find("NGEN"), std::string::npos);
  // The value of a parameter after a branch is unknown.
  for (const char* change : { "X=1", "*SET,X,1", "*GET,X,NODE,,NUM,MAX" })
  {
    const std::string warning = inBranch(change + std::string("\n*ENDIF\nN,X,7,7,7\n*IF,B,EQ,1"));
    EXPECT_NE(warning.find("1 command needs a parameter"), std::string::npos) << warning;
  }
  EXPECT_NE(read("*DO,X,1,9\n*ENDDO\nN,X,7\n").find("parameter"), std::string::npos);
  // Nor is the coordinate system.
  EXPECT_NE(
    inBranch("CSYS,1\n*ENDIF\nN,4,1,1,1\n*IF,B,EQ,1").find("coordinate system"), std::string::npos);
  for (const char* local : { "CSYS,5", "LOCAL,11,1", "local,11", "CLOCAL,12", "CS,13,0,1,2,3",
         "CSKP,13,0,1,2,3", "CSWPLA,14" })
  {
    EXPECT_NE(read(local + std::string("\nN,4,1,1,1\n")).find("1 node is given in a coordinate"),
      std::string::npos)
      << local;
    EXPECT_NE(
      inBranch(local + std::string("\n*ENDIF\nN,4,1,1,1\n*IF,B,EQ,1")).find("coordinate system"),
      std::string::npos)
      << local;
    EXPECT_EQ(
      read(local + std::string("\nCSYS,0\nN,4,1,1,1\n")).find("coordinate"), std::string::npos);
  }
  // Repeats the previous command with other numbers.
  EXPECT_NE(read("N,4,1,1,1\n*REPEAT,5,1,1\n").find("not executed: *REPEAT"), std::string::npos);
  // Commands that do not affect the mesh cause no warning.
  EXPECT_EQ(inBranch("NUMOFF,NODE,9\nMP,EX,1,2\nD,ALL,ALL\nCSYS,0\nY=1"), "");
  EXPECT_EQ(read("D,1,UX\n*REPEAT,3,1\n*IF,A,EQ,1,:LABEL\n"), "");
}

//------------------------------------------------------------------------------
// If this fails, the mesh depends on threads, or on where text is split for them.
TEST(MAPDLReader, ThreadsAndChunksChangeNothing)
{
  std::string wide = MakeBar(60, true); // rows that need more lines than are counted in advance
  const std::size_t at = wide.find("       -1\nCMBLOCK");
  Nodes many;
  for (int i = 1; i <= 120; ++i)
  {
    many.push_back(i);
  }
  for (int i = 0; i < 40; ++i)
  {
    wide.insert(at, MakeRow(1000 + i, 1, many));
  }
  for (const std::string& text :
    { MakeBar(300, false), MakeBar(300, true), MakeBar(100, true, "\r\n"), wide })
  {
    const File file(text);
    vtkNew<vtkUnstructuredGrid> expected;
    Warnings warnings;
    ScanError error;
    ASSERT_TRUE(ReadMAPDL(file.Path, {}, {}, expected, warnings, error)) << error.Message;
    EXPECT_GE(expected->GetNumberOfCells(), 150);
    for (const int threads : { 1, 3 })
    {
      for (const vtkIdType chunk : { 50, 333, 1000, 20000 })
      {
        vtkNew<vtkUnstructuredGrid> grid;
        vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
          [&]
          {
            ASSERT_TRUE(ReadMAPDL(file.Path, {}, {}, grid, warnings, error, Progress(), chunk))
              << error.Message;
          });
        ExpectSameGrid(expected, grid);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(MAPDLReader, PiecesMakeTheWhole)
{
  const File file(MakeBar(40, true) + "N,900\nN,1,7,7,7\nE,1,2,3,4\n");
  ExpectPiecesMakeTheWhole<vtkMAPDLReader>(file.Path, 3, 0);
  ExpectPiecesMakeTheWhole<vtkMAPDLReader>(file.Path, 3, 2);
  ExpectPiecesMakeTheWhole<vtkMAPDLReader>(file.Path, 200, 1);
}

//------------------------------------------------------------------------------
TEST(MAPDLReader, StopsWhenAsked)
{
  const File file(MakeBar(300, true));
  for (int reports = 0; reports < 40; reports += 3)
  {
    int left = reports;
    const Progress progress([&](double) { return left-- > 0; });
    vtkNew<vtkUnstructuredGrid> grid;
    Warnings warnings;
    ScanError error;
    if (!ReadMAPDL(file.Path, {}, {}, grid, warnings, error, progress, 1000))
    {
      EXPECT_FALSE(error) << error.Message;
      EXPECT_EQ(grid->GetNumberOfPoints(), 0);
    }
  }
}
