// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// TetGen and Triangle files that are damaged, truncated, incomplete or of another format.
#include "TetGenSamples.h"

#include "Intake/Rows/TextLines.h"

#include "vtkErrorCode.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
const std::string Node = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
const std::string Ele = "1 4 0\n1 1 2 3 4\n";

const char* const Extensions[] = { "node", "ele", "face", "edge", "neigh", "poly", "smesh" };

// The file to read to get the error in another one.
std::string GetReader(const std::string& extension)
{
  return extension == "node" ? "ele" : extension;
}
}

//------------------------------------------------------------------------------
// If this fails, errors do not describe the problem or its position.
TEST(TetGenDamage, SaysWhatIsWrongAndWhere)
{
  using Code = vtkErrorCode;
  using Files = std::map<std::string, std::string>;
  const struct
  {
    Files Texts;
    const char* Extension;
    unsigned long Error;
    const char* Message;
  } cases[] = {
    { { { "ele", Ele } }, "ele", Code::FileNotFoundError,
      "mesh.ele: expected the file mesh.node with the nodes in the same folder" },
    { { { "face", "1 0\n1 1 2 3\n" } }, "face", Code::FileNotFoundError, "file mesh.node" },
    { { { "edge", "1 0\n1 1 2\n" } }, "edge", Code::FileNotFoundError, "file mesh.node" },
    { { { "poly", "0 3 0 0\n1\n1\n3 1 2 3\n" } }, "poly", Code::FileNotFoundError,
      "file mesh.node" },
    { { { "smesh", "0 3\n1\n3 1 2 3\n" } }, "smesh", Code::FileNotFoundError, "file mesh.node" },
    { { { "node", Node }, { "neigh", "1 4\n1 -1 -1 -1 -1\n" } }, "neigh", Code::FileNotFoundError,
      "mesh.neigh: expected the file mesh.ele with the elements in the same folder" },
    { { { "ele", Ele }, { "neigh", "1 4\n1 -1 -1 -1 -1\n" } }, "neigh", Code::FileNotFoundError,
      "file mesh.node" },
    { { { "node", "" } }, "node", Code::UnrecognizedFileTypeError, "mesh.node:1: expected nodes" },
    { { { "node", "# none\n\n" } }, "node", Code::UnrecognizedFileTypeError, "end of the file" },
    { { { "node",
        "\x7f"
        "ELF\n" } },
      "node", Code::UnrecognizedFileTypeError, "expected nodes of" },
    { { { "node", "1 4 0 0\n" } }, "node", Code::UnrecognizedFileTypeError,
      "mesh.node:1: expected nodes in 2 or 3 dimensions, as the second number of the first line, "
      "found "
      "4" },
    { { { "node", "-1 3 0 0\n" } }, "node", Code::FileFormatError, "number of nodes, found -1" },
    { { { "node", "1 3 -1 0\n1 0 0 0\n" } }, "node", Code::FileFormatError, "attributes" },
    { { { "node", "1 3 999999999 0\n1 0 0 0\n" } }, "node", Code::FileFormatError, "at most 1000" },
    { { { "node", "2000000000 3 0 0\n1 0 0 0\n" } }, "node", Code::PrematureEndOfFileError,
      "at least 16000000000 bytes" },
    { { { "node", "99999999999 3 0 0\n" } }, "node", Code::FileFormatError, "below 2147483648" },
    { { { "node", "2 3 0 0\n1 0 0 0\n2 0 x 0\n" } }, "node", Code::FileFormatError,
      "mesh.node:3: expected a coordinate of a node, found 'x'" },
    { { { "node", "2 3 0 0\n1 0 0\n2 0 0 0\n" } }, "node", Code::FileFormatError,
      "mesh.node:2: expected a coordinate of a node, found the end of the line" },
    { { { "node", "2 3 1 0\n1 0 0 0\n2 0 0 0 1\n" } }, "node", Code::FileFormatError,
      "mesh.node:2: expected an attribute, found the end of the line" },
    { { { "node", "2 3 0 0\n1 0.25 0.5 0.75\n# end" } }, "node", Code::PrematureEndOfFileError,
      "expected the id of a node, found the end of the file" },
    { { { "node", "2 3 0 0\n-1 0 0 0\n0 0 0 0\n" } }, "node", Code::FileFormatError,
      "expected the id of a node from 0 to 2147483647, found -1" },
    { { { "node", "2 3 0 1\n1 0 0 0 1\n2 0 0 0 99999999999\n" } }, "node", Code::FileFormatError,
      "expected a boundary marker of 32 bits, found '99999999999'" },
    { { { "node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n\n# c\n1 0 1 0\n4 0 0 1\n" } }, "node",
      Code::FileFormatError,
      "mesh.node:6: expected a node id that has not been used before, found '1'" },
    { { { "node", Node }, { "ele", "1 5 0\n1 1 2 3 4 1\n" } }, "ele", Code::FileFormatError,
      "mesh.ele:1: expected elements with 3, 4, 6 or 10 nodes, as the second number of the first "
      "line, "
      "found 5" },
    { { { "node", Node }, { "ele", "1 4 0\n1 1 2 3 5\n" } }, "ele", Code::FileFormatError,
      "mesh.ele:2: expected a node of an element, the id of a node from 1 to 4, found '5'" },
    { { { "node", Node }, { "ele", "1 4 0\n1 0 2 3 4\n" } }, "node", Code::FileFormatError,
      "mesh.ele:2: expected a node of an element, the id of a node from 1 to 4, found '0'" },
    { { { "node", "0 3\n" }, { "ele", Ele } }, "ele", Code::FileFormatError, "(there are none)" },
    { { { "node", Node }, { "ele", "2 4 0\n1 1 2 3\n2 1 2 3 4\n" } }, "ele", Code::FileFormatError,
      "found the end of the line" },
    { { { "node", Node }, { "ele", "2 4 0\n1 1 2 3 4\n" } }, "ele", Code::PrematureEndOfFileError,
      "mesh.ele:1: expected at least 20 bytes" },
    { { { "node", "1 2\n1 0 0\n" }, { "ele", Ele } }, "ele", Code::FileFormatError,
      "expected elements with 3 or 6 nodes, as nodes are in 2 dimensions" },
    { { { "node", Node }, { "face", "2 0\n1 1 2\n2 1 2 3\n" } }, "face", Code::FileFormatError,
      "mesh.face:2: expected a node of a face, found the end of the line" },
    { { { "node", Node }, { "face", "3 1\n1 1 2 3 9 1 -1\n2 1 2 4 9\n3 1 2 4 9 1 -1\n" } }, "face",
      Code::FileFormatError, "mesh.face:3: expected an adjacent tetrahedron" },
    { { { "node", Node }, { "edge", "1 0\n1 1 -1 0 0 1\n" } }, "edge", Code::FileFormatError,
      "mesh.edge:2: expected a node of an edge, the id of a node from 1 to 4, found '-1'" },
    { { { "node", Node }, { "ele", Ele }, { "neigh", "1 3\n1 -1 -1 -1\n" } }, "neigh",
      Code::FileFormatError, "expected 4 neighbors for each of 1 elements" },
    { { { "node", Node }, { "ele", Ele }, { "neigh", "1 4\n1 -1 2 -1 -1\n" } }, "neigh",
      Code::FileFormatError,
      "mesh.neigh:2: expected a neighbor, the id of an element of the mesh" },
    { { { "node", Node }, { "ele", Ele }, { "neigh", "1 4\n3 -1 -1 -1 -1\n" } }, "neigh",
      Code::FileFormatError, "mesh.neigh:2: expected the id of an element of the mesh, found '3'" },
    { { { "poly", Node } }, "poly", Code::PrematureEndOfFileError, "the number of facets" },
    { { { "poly", Node + "1\nx\n" } }, "poly", Code::FileFormatError,
      "mesh.poly:7: expected the number of polygons of a facet, found 'x'" },
    { { { "poly", Node + "1\n1\n3 1 2 9\n" } }, "poly", Code::FileFormatError,
      "mesh.poly:8: expected a node of a facet, the id of a node from 1 to 4, found '9'" },
    { { { "poly", Node + "1\n1\n0 1 2 9\n" } }, "poly", Code::FileFormatError,
      "mesh.poly:8: expected the number of nodes of a polygon, at least 1, found '0'" },
    { { { "poly", Node + "1\n1\n2000000000 1 2 3\n" } }, "poly", Code::PrematureEndOfFileError,
      "expected a node of a facet, found the end of the file" },
    { { { "poly", Node + "1\n1\n3 1 2 3\n1\n1 0 0\n1\n" } }, "poly", Code::FileFormatError,
      "mesh.poly:10: expected a coordinate of a point in a hole" },
    { { { "smesh", Node + "1 1\n3 1 2 3 x\n" } }, "smesh", Code::FileFormatError,
      "mesh.smesh:7: expected the marker of a facet, found 'x'" },
    { { { "mesh", Node } }, "mesh", Code::UnrecognizedFileTypeError, "whose name ends with .node" },
  };
  for (const auto& wrong : cases)
  {
    const Result result = Mesh(wrong.Texts).Read(wrong.Extension);
    ASSERT_TRUE(result.IsProperError()) << wrong.Message;
    EXPECT_TRUE(result.Warnings.empty());
    EXPECT_EQ(result.ErrorCode, wrong.Error) << result.Errors[0];
    EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
  }
}

//------------------------------------------------------------------------------
// If this fails, an error in the middle of a large file is not reported as in a small one.
TEST(TetGenDamage, LargeFilesToo)
{
  auto files = MakeStrip(3000);
  vtkIdType& chunk = TextLines::DefaultChunk;
  const vtkIdType before = chunk;
  chunk = 1000;
  const auto replace = [&](const char* extension, const std::string& from, const std::string& to,
                         const std::string& message)
  {
    auto damaged = files;
    std::string& text = damaged[extension];
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const Result result = Mesh(damaged).Read(GetReader(extension));
    ASSERT_TRUE(result.IsProperError()) << message;
    EXPECT_NE(result.Errors[0].find(message), std::string::npos) << result.Errors[0];
  };
  replace(
    "ele", "\n3001 3001 3004", "\n3001 3001 3005", "mesh.ele:1002: expected a node of an element");
  replace(
    "node", "\n3001 ", "\n2998 ", "mesh.node:1002: expected a node id that has not been used");
  replace(
    "face", "\n3001 3001", "\n3001 x", "mesh.face:1002: expected a node of a face, found 'x'");
  replace("poly", "\n3 4 7 10", "\n3 4 7 11", "mesh.poly:6: expected a node of a facet");
  chunk = before;
}

//------------------------------------------------------------------------------
// If this fails, faces of Voronoi cells are read as triangles.
TEST(TetGenDamage, VoronoiDiagramsAreRefused)
{
  const std::string node = "3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n";
  const std::string face = "1 0\n0 0 1 3 0 1 2\n", edge = "1\n0 0 1\n", cell = "1\n0 1 0\n";
  const Mesh mesh({ { "v.node", node }, { "v.face", face }, { "V.Face", face }, { "v.edge", edge },
    { "v.cell", cell }, { "v.face.node", node }, { "v.face.edge", "1 0\n0 0 1\n" } });
  for (const char* extension : { "v.face", "V.Face", "v.edge", "v.cell" })
  {
    const Result result = mesh.Read(extension);
    ASSERT_TRUE(result.IsProperError()) << extension;
    EXPECT_NE(result.Errors[0].find("part of a Voronoi diagram of TetGen"), std::string::npos)
      << result.Errors[0];
    EXPECT_EQ(vtkNew<vtkTetGenReader>()->CanReadFile(mesh.GetPath(extension).c_str()), 0);
  }
  EXPECT_EQ(Count(mesh.Read("v.node").Grid, VTK_VERTEX), 3);
  EXPECT_EQ(Count(mesh.Read("v.face.edge").Grid, VTK_LINE), 1);
}

//------------------------------------------------------------------------------
// If this fails, files of other programs with these extensions are accepted, or ours are not.
TEST(TetGenDamage, CanReadFile)
{
  vtkNew<vtkTetGenReader> reader;
  std::vector<std::string> messages;
  Observe(reader, vtkCommand::ErrorEvent, messages);
  Observe(reader, vtkCommand::WarningEvent, messages);
  const auto canRead = [&](const std::string& extension, const std::string& bytes)
  { return reader->CanReadFile(File(bytes, "mesh." + extension).Path.c_str()) == 1; };
  for (const auto& file : MakeStrip(3))
  {
    EXPECT_TRUE(canRead(file.first, file.second)) << file.first;
    EXPECT_TRUE(canRead(file.first, "# comment\r\n\r\n" + file.second)) << file.first;
    EXPECT_FALSE(canRead(file.first + "x", file.second)) << file.first;
  }
  EXPECT_TRUE(canRead("NODE", Node));
  for (const char* extension : Extensions)
  {
    for (const char* other : { "", " ", "OFF\n8 6 0\n", "ply\nformat ascii 1.0\n",
           "none\n1\n 1.0 2.0\n", "<?xml version=\"1.0\"?>",
           "\x7f"
           "ELF",
           "1 7 7 7\n" })
    {
      EXPECT_FALSE(canRead(extension, other)) << extension << " " << other;
    }
  }
  EXPECT_FALSE(canRead("node", "5 3 0 0\n1 a b c\n.......................................\n"));
  EXPECT_FALSE(canRead("node", "100 3 0 0\n1 0 0 0\n"));
  EXPECT_FALSE(canRead("ele", "1 4 0\n1 2 3\n4 5 6 7\n"));
  EXPECT_EQ(reader->CanReadFile(nullptr), 0);
  EXPECT_TRUE(messages.empty());
}
