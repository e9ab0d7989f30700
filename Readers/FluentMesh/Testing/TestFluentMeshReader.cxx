// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Fluent files in every encoding, and the grids that they become.
#include "FluentMeshSamples.h"
#include "Gzip.h"
#include "vtkFluentMeshReader.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::map<int, int> TypesOf3D = { { 2, VTK_TETRA }, { 4, VTK_HEXAHEDRON }, { 5, VTK_PYRAMID },
  { 6, VTK_WEDGE }, { 7, VTK_POLYHEDRON } };
}

//------------------------------------------------------------------------------
// If this fails, some encoding gives other points, types, nodes or faces than the file has.
TEST(FluentMeshReader, ReadsEveryEncoding)
{
  const FluentSample mesh = MakeMixed();
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    EXPECT_TRUE(result.Warnings.empty());
    vtkUnstructuredGrid* grid = result.Grid;
    ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.Points.size()));
    ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.Cells.size()));
    EXPECT_EQ(grid->GetPoints()->GetDataType(), how.RealSize == 4 ? VTK_FLOAT : VTK_DOUBLE);
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double x = mesh.Points[i][c];
        EXPECT_EQ(grid->GetPoint(static_cast<vtkIdType>(i))[c],
          how.RealSize == 4 ? static_cast<float>(x) : x);
      }
    }
    vtkDataArray* zones = grid->GetCellData()->GetArray("Zone");
    ASSERT_NE(zones, nullptr);
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      const FluentSample::Cell& expected = mesh.Cells[static_cast<std::size_t>(cell)];
      EXPECT_EQ(grid->GetCellType(cell), TypesOf3D.at(expected.Element)) << cell;
      EXPECT_EQ(GetFaceSet(grid, cell), GetFaceSet(mesh, static_cast<int>(cell))) << cell;
      EXPECT_GT(GetMeasure(grid, cell), 0.05) << cell;
      EXPECT_EQ(zones->GetTuple1(cell), expected.Zone);
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, an inverted element is silently corrected, or a valid one inverted.
TEST(FluentMeshReader, InvertedCellsStayInverted)
{
  FluentSample mesh = MakeMixed(1);
  for (auto& point : mesh.Points)
  {
    point[0] = -point[0];
  }
  for (const FluentEncoding& how : GetEncodings())
  {
    const Result result = ReadBytes(Encode(mesh, how));
    ASSERT_TRUE(result.Errors.empty());
    for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
    {
      EXPECT_LT(GetMeasure(result.Grid, cell), -0.05) << cell;
    }
  }
  FluentSample flat = MakeFlat();
  for (auto& point : flat.Points)
  {
    point[1] = -point[1];
  }
  const Result result = ReadBytes(Encode(flat));
  ASSERT_TRUE(result.Errors.empty());
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_LT(GetMeasure(result.Grid, cell), -0.1) << cell;
  }
}

//------------------------------------------------------------------------------
// If this fails, polyhedra become simpler cells, simple cells of unknown type are not recognized,
// or a wrong declared type is used.
TEST(FluentMeshReader, TheDeclaredTypeDecides)
{
  FluentSample mesh = MakeMixed(2);
  const FluentSample original = mesh;
  for (const int element : { 7, 0 })
  {
    for (FluentSample::Cell& cell : mesh.Cells)
    {
      cell.Element = element;
    }
    for (const FluentEncoding& how : GetEncodings())
    {
      const Result result = ReadBytes(Encode(mesh, how));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
      {
        EXPECT_EQ(result.Grid->GetCellType(cell),
          TypesOf3D.at(element == 7 ? 7 : original.Cells[static_cast<std::size_t>(cell)].Element));
        EXPECT_EQ(GetFaceSet(result.Grid, cell), GetFaceSet(mesh, static_cast<int>(cell)));
      }
    }
  }
  // A hexahedron declared as a tetrahedron, and a wedge declared as a pyramid.
  mesh = original;
  mesh.Cells[0].Element = 2;
  mesh.Cells[1].Element = 5;
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("2 cells whose faces do not match the declared type"),
    std::string::npos)
    << result.Warnings[0];
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(result.Grid->GetCellType(cell),
      cell < 2 ? VTK_POLYHEDRON
               : TypesOf3D.at(original.Cells[static_cast<std::size_t>(cell)].Element));
    EXPECT_EQ(GetFaceSet(result.Grid, cell), GetFaceSet(mesh, static_cast<int>(cell)));
  }
}

//------------------------------------------------------------------------------
TEST(FluentMeshReader, ReadsFlatMeshes)
{
  FluentSample mesh = MakeFlat(7);
  std::vector<int> circle; // a polygon with more edges than are tried one by one
  for (int i = 0; i < 40; ++i)
  {
    circle.push_back(mesh.AddPoint(20 + std::cos(i * 0.157), std::sin(i * 0.157)));
  }
  mesh.AddPolygon(7, circle);
  for (FluentEncoding how : GetEncodings())
  {
    for (const bool hasDimension : { true, false })
    {
      how.HasDimension = hasDimension;
      const Result result = ReadBytes(Encode(mesh, how));
      ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
      EXPECT_TRUE(result.Warnings.empty());
      for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
      {
        const int element = mesh.Cells[static_cast<std::size_t>(cell)].Element;
        EXPECT_EQ(result.Grid->GetCellType(cell),
          element == 1     ? VTK_TRIANGLE
            : element == 3 ? VTK_QUAD
                           : VTK_POLYGON);
        EXPECT_GT(GetMeasure(result.Grid, cell), 0.4) << cell;
        EXPECT_EQ(result.Grid->GetPoint(cell)[2], 0);
      }
      EXPECT_EQ(GetSortedPoints(result.Grid, 0), (std::vector<vtkIdType>{ 0, 1, 2, 3 }));
    }
  }
  // Edges that do not form a ring: the cell exists, but is empty.
  mesh = MakeFlat(1);
  mesh.Faces[1].Nodes = { 0, 3 };
  const Result result = ReadBytes(Encode(mesh));
  ASSERT_TRUE(result.Errors.empty());
  EXPECT_EQ(result.Grid->GetCellType(0), VTK_EMPTY_CELL);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_NE(result.Warnings[0].find("do not form a closed ring"), std::string::npos);
}

//------------------------------------------------------------------------------
// If this fails, an irrelevant section hides others.
TEST(FluentMeshReader, SkipsOtherSections)
{
  const FluentSample mesh = MakeMixed(1);
  const std::string text = Encode(mesh);
  const Result expected = ReadBytes(text);
  ASSERT_TRUE(expected.Errors.empty());
  const std::string others =
    "(0 \"quoted ))) \\\" (((\")(0 grid written by (someone)\n on two lines)\n"
    "(1 (header) \"x)\")\n(37 ((a 1) (b \"(\") (c ())))\n\n"
    "(64 ())(40 (1 2 3)(4 5 6))\n(18 (1 1 4 4)(\n1 1\n))\n";
  const std::string binary = "(2041 (1 8)\n(\x01((((\x02)))) End of Binary Section 3041) \"x\n"
                             "End of Binary Section   2041)\n";
  for (const std::string& bytes :
    { others + text, text + others, binary + text, text + binary, "\xef\xbb\xbf\n\n" + text })
  {
    const Result result = ReadBytes(bytes);
    ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
    ExpectSameGrid(expected.Grid, result.Grid);
  }
  // A lone quotation mark.
  const Result result = ReadBytes("(0 3\" pipe)\n" + text);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ExpectSameGrid(expected.Grid, result.Grid);
  // All on one line, headers in upper case, zones after a body.
  std::string flat = text;
  std::replace(flat.begin(), flat.end(), '\n', ' ');
  const Result onOneLine = ReadBytes(flat);
  ASSERT_TRUE(onOneLine.Errors.empty()) << onOneLine.Errors[0];
  ExpectSameGrid(expected.Grid, onOneLine.Grid);
}

//------------------------------------------------------------------------------
// If this fails, the mesh is hidden by a list of settings with a name, as Fluent Meshing writes
// them.
TEST(FluentMeshReader, SkipsOtherLists)
{
  vtkNew<vtkFluentMeshReader> reader;
  const FluentSample mesh = MakeMixed(1);
  for (const int realSize : { 0, 4, 8 })
  {
    FluentEncoding how;
    how.RealSize = realSize;
    const std::string text = Encode(mesh, how);
    const Result expected = ReadBytes(text);
    ASSERT_TRUE(expected.Errors.empty());
    for (const char* list : { "(cad/options (merge #t))", "(x)", "( %version \"23.1\")",
           "(*settings*)\n(a (b (c \"d\")) ())", "(name \"strings with ) and \\\\\")",
           "(name \"(((\" \"\\\")((\\\"\")", "(a\n\t\"two\nlines ) \")", "(p \"C:\\\\mesh\\\\\")",
           "(rp/10 (10 (0 1 5 1)) (13 (0 1 3 0)))", "((a . 1) (b . 2))", "(\"string first (\" 1 2)",
           "()", "(#t)", "((10 (0 1 5 1)))" })
    {
      const std::string named = list;
      std::vector<std::string> files = { named + text, text + "\n" + named,
        named + "\n" + text + named };
      for (const char* before : { "(10 (", "(13 (3", "(12 (2" })
      {
        const std::size_t at = realSize == 0 ? text.find(before) : std::string::npos;
        if (at != std::string::npos)
        {
          files.push_back(text.substr(0, at) + named + "\n" + text.substr(at));
        }
      }
      for (const std::string& bytes : files)
      {
        const Result result = ReadBytes(bytes);
        ASSERT_TRUE(result.Errors.empty()) << named << ": " << result.Errors[0];
        ExpectSameGrid(expected.Grid, result.Grid);
        EXPECT_TRUE(reader->CanReadFile(File(bytes, "test.msh").Path.c_str())) << named;
      }
    }
    // A list without end hides everything after it.
    const Result open = ReadBytes(text + "\n(cad/options (merge");
    ASSERT_TRUE(open.IsProperError());
    EXPECT_NE(open.Errors[0].find("a closing parenthesis for the section that begins here"),
      std::string::npos);
    // A section whose index is damaged is not skipped.
    for (const char* other : { "(-1 2)", "(13x (1 2))", "(1.3 (1 2))", "name", "\"a\"" })
    {
      const Result refused = ReadBytes(text + "\n" + other);
      ASSERT_TRUE(refused.IsProperError()) << other;
      EXPECT_NE(refused.Errors[0].find("begins with '(' and an index"), std::string::npos)
        << refused.Errors[0];
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, errors in irrelevant parts of binary files without faces prevent reading.
TEST(FluentMeshReader, FilesWithoutFaces)
{
  const std::string start = "(2 3)\n(10 (0 1 4 0 3))\n(12 (0 1 1 0))\n";
  const std::string words(16, '\1'), doubles(4 * 3 * 8, '\0');
  const std::string nodes = "(3010 (1 1 4 1 3)(" + doubles + ")\nEnd of Binary Section   3010)\n";
  const std::string files[] = {
    start + "(10 (1 1 4 1 3)(0 0 0 1 0 0 0 1 0 0 0 1))\n(12 (1 1 1 1 2)(1 2 3 4))\n",
    start + nodes + "(2012 (1 1 1 1 2)(" + words + ")\nEnd of Binary Section   2012)\n",
    start + nodes + "(2012 (1 1 1 1 2)(\n" + words + "\n)\nEnd of Binary Section 2012)\n",
    start + nodes + "(3012 (1 1 1 1 2)\nEnd of Binary Section   3012)\n",
    start + nodes + "(3012 (1 1 1 1 2)()\nEnd of Binary Section   3012)\n",
    start + nodes + "(12 (1 1 1 1 2))\n",
    start + nodes + "(12 (1 1 1 1 2))\n(13 (0 1 4 0))\n",
  };
  for (const std::string& bytes : files)
  {
    const Result result = ReadBytes(bytes);
    ASSERT_TRUE(result.IsProperError()) << bytes;
    EXPECT_NE(result.Errors[0].find("expected a mesh with nodes and faces, found no faces"),
      std::string::npos)
      << result.Errors[0];
  }
  // Irrelevant parts may not be truncated either.
  const Result open = ReadBytes(start + nodes + "(2012 (1 1 1 1 2)(" + words);
  ASSERT_TRUE(open.IsProperError());
  EXPECT_NE(open.Errors[0].find("'End of Binary Section 2012'"), std::string::npos)
    << open.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, meshes of old programs, which do not declare types of cells, are refused.
TEST(FluentMeshReader, CellsNeedNotBeDeclared)
{
  const std::string text = Encode(MakeMixed(1));
  std::string bytes = text;
  const auto begin = bytes.find("(12 (0 1 ") + 1;
  const auto first = bytes.find("(12 (", begin), last = bytes.find("(13 (3", first);
  ASSERT_NE(last, std::string::npos);
  bytes.erase(first, last - first);
  const Result result = ReadBytes(bytes);
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  EXPECT_EQ(Count(result.Grid, VTK_WEDGE), 2);
  EXPECT_EQ(Count(result.Grid, VTK_TETRA), 1);
  EXPECT_EQ(result.Warnings.size(), 1u);
}

//------------------------------------------------------------------------------
// If this fails, words in a byte order other than the declared one are used.
TEST(FluentMeshReader, RefusesTheWrongByteOrder)
{
  FluentEncoding how;
  how.RealSize = 8;
  std::string bytes = Encode(MakeMixed(1), how);
  const std::string little = "(4 (60 ", big = "(4 (22 ";
  bytes.replace(bytes.find(little), little.size(), big);
  const Result result = ReadBytes(bytes);
  ASSERT_TRUE(result.IsProperError());
  EXPECT_NE(result.Errors[0].find("the number of nodes of face 1 of at most"), std::string::npos)
    << result.Errors[0];
}

//------------------------------------------------------------------------------
// If this fails, compressed files cannot be read, or a small one can exhaust the memory.
TEST(FluentMeshReader, ReadsCompressedFiles)
{
  const std::string text = Encode(MakeMixed(40));
  const Result expected = ReadBytes(text);
  const std::string packed = Gzip(text);
  const Result result = ReadBytes(packed, "test.msh.gz");
  ASSERT_TRUE(result.Errors.empty()) << result.Errors[0];
  ExpectSameGrid(expected.Grid, result.Grid);
  const std::size_t half = text.size() / 2;
  const Result parts =
    ReadBytes(Gzip(text.substr(0, half)) + Gzip(text.substr(half)) + std::string(100, '\0'));
  ASSERT_TRUE(parts.Errors.empty()) << parts.Errors[0];
  EXPECT_EQ(parts.Warnings.size(), expected.Warnings.size()); // zeros are padding
  ExpectSameGrid(expected.Grid, parts.Grid);
  const Result garbage = ReadBytes(packed + std::string("\0garbage", 8));
  ASSERT_TRUE(garbage.Errors.empty()) << garbage.Errors[0];
  ASSERT_EQ(garbage.Warnings.size(), expected.Warnings.size() + 1);
  EXPECT_NE(
    garbage.Warnings.back().find("data after the compressed data is ignored"), std::string::npos);
  ExpectSameGrid(expected.Grid, garbage.Grid);
  for (std::size_t size = 3; size < packed.size(); size += 13)
  {
    EXPECT_TRUE(ReadBytes(packed.substr(0, size)).IsProperError()) << size;
  }
  const Result bomb = ReadBytes(Gzip(text + "(0 " + std::string(200 << 20, ' ') + ")"));
  ASSERT_TRUE(bomb.IsProperError());
  EXPECT_NE(bomb.Errors[0].find("expands more than 100 times"), std::string::npos);
  vtkNew<vtkFluentMeshReader> reader;
  EXPECT_TRUE(reader->CanReadFile(File(packed, "test.cas.gz").Path.c_str()));
  EXPECT_FALSE(reader->CanReadFile(File(Gzip("solid"), "test.cas.gz").Path.c_str()));
}

//------------------------------------------------------------------------------
// If this fails, files of other formats with the same extensions are accepted, or ours are not.
TEST(FluentMeshReader, KnowsItsFiles)
{
  vtkNew<vtkFluentMeshReader> reader;
  const auto canRead = [&](const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "test.msh").Path.c_str()) == 1; };
  for (const char* bytes :
    { "(0 \"a comment\")", "\n (2 3)", "(10(0 1 18cf 1))", "(1 \"x\")", "(3010 (1 1 2 1 3)",
      "(37 ((a b)))", "\xef\xbb\xbf(2 3)", "((a . 1))", "(\"a (\")", "(define a 1)", "(" })
  {
    EXPECT_TRUE(canRead(bytes)) << bytes;
  }
  for (const char* bytes : { "", "$MeshFormat\n2.2 0 8\n", "\x89HDF\r\n\x1a\n", "5\n1 2 3\n",
         "; comment\n", "\xef\xbb\xbf" })
  {
    EXPECT_FALSE(canRead(bytes)) << bytes;
  }
  EXPECT_FALSE(reader->CanReadFile(nullptr));
  EXPECT_FALSE(reader->CanReadFile("/no/such/file.msh"));
}
