// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader reports about OFF files that are damaged, truncated or of another format.
#include "PolygonOFFSamples.h"

#include "Intake/Rows/TextLines.h"

#include "vtkErrorCode.h"

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Samples of every encoding, small enough to be truncated at every byte.
std::vector<std::string> MakeSamples()
{
  Sample colored;
  colored.Keyword = "STCN4nOFF";
  colored.HasTexture = colored.HasColors = colored.HasNormals = colored.IsHomogeneous = true;
  colored.Dimension = 2;
  Words faces;
  faces << 3 << 2 << 0 << 0.f << 0.f << 0.f << 1.f << 0.f << 0.f << 1.f << 1.f << 0.f;
  faces << 3 << 0 << 1 << 2 << 3 << 0.f << 1.f << 0.5f << 3 << 2 << 1 << 0 << 1 << 4.f;
  return { Sample().GetText(12), colored.GetText(12), MakeMixedText(3), Sample().GetBinary(12),
    colored.GetBinary(12), "OFF BINARY\n" + faces.Bytes };
}

//------------------------------------------------------------------------------
// Also reads in parallel, although the files are small.
template <typename Function>
void WithBothChunks(Function&& function)
{
  const vtkIdType usual = TextLines::DefaultChunk;
  for (const vtkIdType chunk : { usual, vtkIdType(32) })
  {
    TextLines::DefaultChunk = chunk;
    function();
  }
  TextLines::DefaultChunk = usual;
}
}

//------------------------------------------------------------------------------
// If this fails, errors do not describe the problem or its position.
TEST(PolygonOFFDamage, SaysWhatIsWrongAndWhere)
{
  const auto unknown = vtkErrorCode::UnrecognizedFileTypeError;
  const auto format = vtkErrorCode::FileFormatError;
  const auto premature = vtkErrorCode::PrematureEndOfFileError;
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const struct
  {
    std::string Text;
    unsigned long Code;
    const char* Message;
  } cases[] = {
    { "", unknown, "test.off:1: expected an OFF file" },
    { "ply\nformat ascii 1.0\n", unknown, "test.off:1: expected an OFF file" },
    { "# x\nSKEL\n", unknown,
      "test.off:2: expected an OFF file, which begins with [ST][C][N][4][n]OFF, found 'SKEL'" },
    { "OFF\n", premature,
      "test.off:2: expected the number of vertices, found the end of the file" },
    { "OFF binary\n", format, "expected the number of vertices, found 'binary'" },
    { "OFF\n3\n", premature, "the number of vertices" },
    { "OFF\n-3 1 0\n", format, "test.off:2: expected the number of vertices, found -3" },
    { "OFF\n0 -1 0\n", format, "test.off:2: expected the number of faces, found -1" },
    { "OFF\n353535235358 6 0\n0 0 0\n", format, "found 353535235358" },
    { "OFF\n1000 6 0\n0 0 0\n", premature,
      "at least 6000 bytes after the number of vertices (1000)" },
    { "OFF\n1 1000 0\n0 0 0\n", premature, "at least 2000 bytes after the number of faces (1000)" },
    { "nOFF 0\n1 1 0\n0\n", format,
      "expected the number of dimensions from 1 to 2147483647, found 0" },
    { "nOFF 2147483647\n2147483647 1 0\n0\n", premature, "the number of vertices" },
    { "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", format,
      "test.off:4: expected a coordinate of a vertex, found 'x'" },
    { "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", format,
      "test.off:4: expected the 3 numbers of vertex 1" },
    { "COFF\n1 0 0\n0 0 0 1 x 1\n", format, "test.off:3: expected a component of the color" },
    { "STCOFF\n1 0 0\n0 0 0 1\n", format,
      "test.off:3: expected a color and 2 more numbers of vertex 0" },
    { points, premature,
      "test.off:6: expected the number of vertices of a face, found the end of the file" },
    { points + "3 0 1\n", premature, "expected a vertex of a face, found the end of the file" },
    { points + "3 0 1 3\n", format,
      "test.off:6: expected a vertex of a face from 0 to 2, found 3" },
    { points + "3 0 1 -1\n", format,
      "test.off:6: expected a vertex of a face from 0 to 2, found -1" },
    { points + "3 0 1 1.5\n", format, "test.off:6: expected a vertex of a face, found '1.5'" },
    { points + "-3 0 1 2\n", format,
      "test.off:6: expected the number of vertices of a face, found -3" },
    { points + "1000 0 1 2\n", premature, "after the number of vertices of a face (1000)" },
    { "OFF\n0 1 0\n1 0\n", format, "found 0" },
    { "4OFF\n5 10 10 5\n0 0 0 1\n", format,
      "test.off:2: expected a surface, found a polytope of 4 dimensions in the dialect of "
      "Stella4D" },
    { "4OFF 5 10 10 5\n0 0 0 1\n", format,
      "test.off:1: expected a surface, found a polytope of 4" },
    { "4OFF\n5 10\n10 5\n0 0 0 1\n", format,
      "test.off:2: expected a surface, found a polytope of 4" },
    { "4OFF\n# Vertices, Faces, Edges, Cells\n5 10 10 5 # x\n", format,
      "test.off:3: expected a surface" },
    { "5OFF\n6 20 15 15 6\n", unknown,
      "test.off:1: expected an OFF file, which begins with [ST][C][N][4][n]OFF, found '5OFF'" },
    { "4nOFF 3\n1 0 0 0\n0 0 0\n", premature, "test.off:4: expected a coordinate of a vertex" },
  };
  WithBothChunks(
    [&]
    {
      for (const auto& wrong : cases)
      {
        const Result result = ReadBytes(wrong.Text);
        ASSERT_TRUE(result.IsProperError()) << wrong.Text;
        EXPECT_EQ(result.ErrorCode, wrong.Code) << result.Errors[0];
        EXPECT_NE(result.Errors[0].find(wrong.Message), std::string::npos) << result.Errors[0];
      }
    });
}

//------------------------------------------------------------------------------
// If this fails, wrong words of a binary file are used, or reported at the wrong position.
TEST(PolygonOFFDamage, WrongWordsInBinary)
{
  const std::string head = "OFF BINARY\n"; // 11 bytes
  const auto refuse =
    [&](const Words& body, const std::string& message, const std::string& keyword = "")
  {
    const Result result = ReadBytes((keyword.empty() ? head : keyword) + body.Bytes);
    ASSERT_TRUE(result.IsProperError()) << message;
    EXPECT_NE(result.Errors[0].find(message), std::string::npos) << result.Errors[0];
  };
  const auto points = []
  { return std::move(Words() << 2 << 1 << 0 << 0.f << 0.f << 0.f << 1.f << 1.f << 1.f); };
  refuse(Words(), "test.off: byte 11: expected the number of vertices, found the end of the file");
  refuse(Words() << -1 << 0 << 0, "byte 11: expected the number of vertices, found -1");
  refuse(Words() << 16909060 << 0 << 0, "at least 202908720 bytes");
  refuse(Words() << 0 << -1 << 0, "byte 15: expected the number of faces");
  refuse(Words() << 0 << 99 << 0,
    "byte 15: expected the number of faces, each of at least 8 bytes, found 99");
  refuse(Words() << 0 << 0, "the number of edges");
  refuse(Words() << 0 << 1 << 1 << 0, "the number of dimensions", "nOFF BINARY\n");
  refuse(points() << -3 << 0,
    "byte 47: expected vertices of face 0, found a length of -3 with 8 bytes left");
  refuse(points() << 3 << 0 << 1,
    "byte 47: expected vertices of face 0, found a length of 3 with 12 bytes left");
  refuse(points() << 2 << 0 << 1 << -1,
    "byte 59: expected color of face 0, found a length of -1 with 4 bytes left");
  refuse(points() << 2 << 0 << 1 << 3 << 0.f,
    "byte 59: expected color of face 0, found a length of 3 with 8 bytes left");
  refuse(points() << 2 << 0 << 2 << 0,
    "byte 55: expected a vertex of a face from 0 to 1 in face 0, found 2");
  refuse(points() << 2 << -1 << 2 << 0,
    "byte 51: expected a vertex of a face from 0 to 1 in face 0, found -1");
}

//------------------------------------------------------------------------------
// If this fails, half a mesh of a truncated file is shown as whole.
TEST(PolygonOFFDamage, CutOffAnywhere)
{
  for (const std::string& bytes : MakeSamples())
  {
    // Text may lose digits of the last id, and everything after it.
    constexpr std::size_t Slack = 6;
    const bool isText = bytes.find("BINARY") == std::string::npos;
    const std::size_t end = bytes.size() - (isText ? Slack : 0);
    for (std::size_t size = 0; size < end; ++size)
    {
      EXPECT_TRUE(ReadBytes(bytes.substr(0, size)).IsProperError()) << bytes.substr(0, 20) << size;
    }
  }
}
