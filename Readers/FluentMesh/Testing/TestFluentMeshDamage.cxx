// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader reports about Fluent files that are damaged, truncated or of another format.
#include "FluentMeshSamples.h"

#include "vtkErrorCode.h"

#include <ctime>

#if defined(__linux__)
#include <sys/resource.h>
#endif

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// By the time of the processor, whatever else runs.
void ExpectToReadSoon(const std::string& bytes)
{
  const std::clock_t start = std::clock();
  EXPECT_TRUE(ReadBytes(bytes).Errors.empty());
  EXPECT_LT((std::clock() - start) / CLOCKS_PER_SEC, 10);
}

//------------------------------------------------------------------------------
std::vector<std::string> MakeSamples()
{
  FluentSample polyhedra = MakeMixed(2);
  for (FluentSample::Cell& cell : polyhedra.Cells)
  {
    cell.Element = 7;
  }
  std::vector<std::string> samples;
  for (const FluentSample& mesh : { MakeMixed(1), polyhedra, MakeFlat(6) })
  {
    for (const FluentEncoding& how : GetEncodings())
    {
      samples.push_back(Encode(mesh, how));
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
void ExpectError(const std::string& bytes, unsigned long code, const std::string& message)
{
  const Result result = ReadBytes(bytes);
  ASSERT_TRUE(result.IsProperError()) << message;
  EXPECT_EQ(result.ErrorCode, code) << result.Errors[0];
  EXPECT_NE(result.Errors[0].find(message), std::string::npos) << result.Errors[0];
}

//------------------------------------------------------------------------------
std::string Replace(std::string text, const std::string& old, const std::string& other)
{
  EXPECT_NE(text.find(old), std::string::npos) << old;
  return text.replace(text.find(old), old.size(), other);
}

// Prevents a faulty reader from using all memory of the machine.
const struct MemoryLimit
{
  MemoryLimit()
  {
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
    constexpr rlim_t Limit = rlim_t(8) << 30;
    const rlimit limit = { Limit, Limit };
    setrlimit(RLIMIT_AS, &limit);
#endif
  }
} limit;

const std::string Tetrahedron = "(2 3)\n(10 (0 1 4 0 3))\n(12 (0 1 1 0))\n(13 (0 1 4 0))\n"
                                "(10 (1 1 4 1 3)(\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n))\n"
                                "(12 (2 1 1 1 2))\n(13 (3 1 4 3 3)(\n1 2 3 1 0\n1 4 2 1 0\n"
                                "2 4 3 1 0\n3 4 1 1 0\n))\n";
}

//------------------------------------------------------------------------------
// If this fails, errors do not describe the problem or its position.
TEST(FluentMeshDamage, SaysWhatIsWrongAndWhere)
{
  const auto unknown = vtkErrorCode::UnrecognizedFileTypeError;
  const auto format = vtkErrorCode::FileFormatError;
  const auto premature = vtkErrorCode::PrematureEndOfFileError;
  ASSERT_TRUE(ReadBytes(Tetrahedron).Errors.empty());
  const auto change = [](const std::string& old, const std::string& other)
  { return Replace(Tetrahedron, old, other); };

  ExpectError("", unknown, "test.msh: expected a Fluent mesh, found an empty file");
  ExpectError("solid x\n", unknown, "test.msh:1: expected a section of a Fluent mesh");
  ExpectError("\x89HDF\r\n\x1a\n0123", format, "ParaView's FLUENT CFF reader");
  ExpectError("$MeshFormat\n2.2 0 8\n", unknown, "Gmsh");
  ExpectError("8\n1 0 0 0\n", unknown, "begins with a number, as those of Netgen and ADVENTURE do");
  ExpectError("(0 \"only a comment\")\n", unknown, "no nodes or faces");
  ExpectError("(2 4)\n", format, "test.msh:1: expected the dimension of the mesh, 2 or 3");
  ExpectError("(2 3)\n(10 (0 1 4 0))\n", premature, ":2: expected 4 nodes, as declared, found 0");
  ExpectError("(2 3)\n(10 (1 1 1 1)(1 2 3))\n", vtkErrorCode::FileFormatError, "found no faces");
  ExpectError(Tetrahedron + "(45 (1 x", premature,
    "test.msh:18: expected a closing parenthesis for the section that begins here");
  ExpectError(change("(12 (2 1 1 1 2))", "(12 (2 1 1 1 2)"), premature,
    "expected a closing parenthesis for the section that begins here, found another opening one");
  ExpectError(Tetrahedron + "x", format, "test.msh:18: expected a section");
  ExpectError(change("(10 (1 1 4 1 3)", "(10 (1 1 z 1 3)"), format,
    "test.msh:5: expected a hexadecimal number or the end of the header, found 'z'");
  ExpectError(change("(10 (1 1 4 1 3)", "(10 (1 2 4 1 3)"), format,
    "test.msh:5: expected the nodes from 1 on, found 2");
  ExpectError(
    change("(10 (1 1 4 1 3)", "(10 (1 1 5 1 3)"), premature, "test.msh:5: expected 15 coordinates");
  ExpectError(
    change("(10 (1 1 4 1 3)", "(10 (1 1 3 1 3)"), premature, ":2: expected 4 nodes, as declared");
  ExpectError(change("(10 (1 1 4 1 3)", "(10 (1 1 ffffffffff 1 3)"), format, "below 80000000");
  ExpectError(change("(10 (1 1 4 1 3)", "(10 (1 1 7fffffff 1 3)"), premature,
    "test.msh:5: expected 6442450941 coordinates");
  ExpectError(change("0 1 0\n0 0 1", "0 y 0\n0 0 1"), format,
    "test.msh:8: expected a coordinate of node 3, found 'y'");
  ExpectError(
    change("0 0 1\n))", "0 0\n))"), premature, "test.msh:10: expected a coordinate of node 4");
  ExpectError(change("0 0 1\n))", "0 0 1 7\n))"), format,
    "test.msh:9: expected the end of the section after 4 nodes, found '7'");
  ExpectError(
    change("(13 (3 1 4 3 3)", "(13 (3 1 4 3 7)"), format, "a face type of 0, 2, 3, 4 or 5");
  ExpectError(change("(13 (3 1 4 3 3)", "(13 (3 1 5 3 3)"), format, "faces from 1 to 4, found 5");
  ExpectError(change("(13 (3 1 4 3 3)", "(13 (3 1 3 3 3)"), format,
    "test.msh:16: expected the end of the section after 3 faces, found '3'");
  ExpectError(change("(13 (0 1 4 0))", "(13 (0 1 7fffffff 0))"), premature,
    ": expected 2147483647 faces, as declared, found 4");
  ExpectError(Replace(change("(13 (0 1 4 0))", ""), "(13 (3 1 4 3 3)", "(13 (3 1 7fffffff 3 3)"),
    premature, "expected 2147483647 faces in the section that begins here");
  ExpectError(change("2 4 3 1 0", "2 4 5 1 0"), format,
    "test.msh:15: expected a node of face 3 from 1 to 4, found 5");
  ExpectError(change("2 4 3 1 0", "2 4 0 1 0"), format, "a node of face 3 from 1 to 4, found 0");
  ExpectError(change("2 4 3 1 0", "2 4 3 1 2"), format,
    "test.msh:15: expected a cell of face 3 from 0 to 1, found 2");
  ExpectError(change("2 4 3 1 0", "2 4 3 -1 0"), format, "test.msh:15: expected a cell of face 3");
  ExpectError(change("2 4 3 1 0", "2 4 3 1 g"), format, "found 'g'");
  ExpectError(change("2 4 3 1 0", "2 4 ffffffff 1 0"), format, "up to 2147483647");
  ExpectError(change("(12 (0 1 1 0))", "(12 (0 1 7fffffff 0))"), format, "at most 16 cells");
  ExpectError(change("(12 (2 1 1 1 2)", "(12 (2 1 1 1 8)"), format, "a cell type from 0 to 7");
  ExpectError(change("(12 (2 1 1 1 2)", "(12 (2 1 1 1 0)(9)"), format,
    "expected the type of cell 1 from 0 to 7");
  for (const char* more : { "7", "zz" })
  {
    ExpectError(change("(12 (2 1 1 1 2)", std::string("(12 (2 1 1 1 0)(2 ") + more + ")"), format,
      "expected the end of the section after the types of 1 cells");
  }
  ExpectError(change("(12 (2 1 1 1 2)", "(12 (2 1 2 1 2)"), format, "cells from 1 to 1, found 2");
  ExpectError(
    change("(12 (2 1 1 1 2)", "(12 (2 1 1 0 2)"), vtkErrorCode::FileFormatError, "no active cell");
  ExpectError(Tetrahedron + "(59 (1 1 3 3)(1 9))", format, "an existing face, found 9");
  ExpectError(Tetrahedron + "(59 (9 9 3 3)(1 1))", format, "parts of an existing face, found 9");
  ExpectError(Tetrahedron + "(59 (1 1 3 3)(3 1 1))", format, "a part of a face");
}

//------------------------------------------------------------------------------
// If this fails, wrong words of a binary file are used, or reported at the wrong position.
TEST(FluentMeshDamage, WrongWordsInBinary)
{
  FluentSample mesh;
  for (int i = 0; i < 4; ++i)
  {
    mesh.AddPoint(i == 1, i == 2, i == 3);
  }
  mesh.AddVTKCell(2, VTK_TETRA, { 0, 1, 2, 3 });
  FluentEncoding how;
  how.RealSize = 8;
  for (const bool uniform : { false, true })
  {
    how.Uniform = uniform;
    const std::string bytes = Encode(mesh, how);
    ASSERT_TRUE(ReadBytes(bytes).Errors.empty());
    const std::size_t faces = bytes.find("(3013 (4");
    const std::size_t words = bytes.find("(", bytes.find("\n", faces)) + 1;
    const auto set = [&](std::size_t word, std::int32_t value)
    {
      std::string changed = bytes;
      Store(&changed[words + 4 * word], value, false);
      return changed;
    };
    const std::size_t node = uniform ? 0 : 1;
    ExpectError(set(node, 5), vtkErrorCode::FileFormatError,
      "test.msh: byte " + std::to_string(words + 4 * node) +
        ": expected a node of face 1 from 1 to 4, found 5");
    ExpectError(
      set(node + 4, 2), vtkErrorCode::FileFormatError, "a cell of face 1 from 0 to 1, found 2");
    ExpectError(set(node + 3, -1), vtkErrorCode::FileFormatError, "found -1");
    for (const std::size_t word : { node, node + 3, node + 4 })
    {
      ExpectError(set(word, INT32_MIN), vtkErrorCode::FileFormatError, "found -2147483648");
    }
    if (!uniform)
    {
      ExpectError(set(0, -3), vtkErrorCode::FileFormatError, "the number of nodes of face 1");
      ExpectError(set(0, INT32_MAX), vtkErrorCode::PrematureEndOfFileError, "found 2147483647");
    }
    ExpectError(Replace(bytes, "End of Binary Section   3013", "End of Something Else"),
      vtkErrorCode::FileFormatError, "'End of Binary Section 3013'");
    ExpectError(Replace(bytes, "(3010 (1 1 4 1 3)", "(3010 (1 1 fffff 1 3)"),
      vtkErrorCode::PrematureEndOfFileError, "25165800 bytes of the section that begins at byte");
  }
}

//------------------------------------------------------------------------------
// If this fails, half a mesh of a truncated file is shown as whole.
TEST(FluentMeshDamage, CutOffAnywhere)
{
  const std::string names = "(45 (2 fluid";
  for (const std::string& bytes : MakeSamples())
  {
    const Result whole = ReadBytes(bytes);
    ASSERT_TRUE(whole.Errors.empty()) << whole.Errors[0];
    const std::size_t zones = bytes.find(names);
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 40)
    {
      const Result result = ReadBytes(bytes.substr(0, size));
      if (result.Errors.empty())
      {
        // The file may end between two zone names after the mesh, but not within the mesh.
        EXPECT_GE(size + 1, zones) << bytes.substr(0, 60);
        ExpectSameGrid(whole.Grid, result.Grid);
      }
      else
      {
        EXPECT_TRUE(result.IsProperError()) << size;
      }
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, time or memory grow faster than the size of a file with very many small sections.
TEST(FluentMeshDamage, ManySections)
{
  constexpr int Count = 30000;
  std::string text = "(2 3)\n(10 (1 1 4 1 3)(0 0 0 1 0 0 0 1 0 0 0 1))\n";
  std::string quotes = Tetrahedron;
  for (int i = 1; i <= Count; ++i)
  {
    std::string id;
    AppendHex(id, static_cast<std::uint64_t>(i));
    text += "(13 (" + id + " " + id + " " + id + " 3 3)(1 2 3 1 0))(61 (1 ffff)())(12 (" + id +
      " " + id + " " + id + " 1 7))";
    quotes += "(37 (a \" b))(0 3\" x)";
  }
  ExpectToReadSoon(text);
  ExpectToReadSoon(quotes + "(37 (\"))");
  // A cell with very many faces, all of them parts of others.
  std::string cell = "(2 3)\n(10 (1 1 4 1 3)(0 0 0 1 0 0 0 1 0 0 0 1))\n(12 (2 1 1 1 4))", faces,
              tree;
  for (int i = 1; i <= Count; ++i)
  {
    faces += "1 2 3 1 0\n";
    tree += "1 ";
    AppendHex(tree, static_cast<std::uint64_t>(i));
    tree += "\n";
  }
  ExpectToReadSoon(cell + "(13 (3 1 7530 3 3)(" + faces + "))(13 (4 7531 ea60 1f 3)(" + faces +
    "))(59 (7531 ea60 4 3)(" + tree + "))");
}
