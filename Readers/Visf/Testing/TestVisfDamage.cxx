// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader reports about Visf files that are damaged, truncated or of another format.
#include "VisfSamples.h"

#include "vtkErrorCode.h"

#include <algorithm>

#if defined(__linux__)
#include <sys/resource.h>
#endif

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
VisfMesh MakeSmallMesh()
{
  VisfMesh mesh = MakeBar(2, 1);
  for (std::size_t i = 0; i < mesh.Polygons.size(); ++i)
  {
    mesh.Neighbors.push_back({ static_cast<std::int32_t>((i + 1) % mesh.Polygons.size()) });
  }
  return mesh;
}

//------------------------------------------------------------------------------
void ExpectError(const std::string& bytes, unsigned long code, const std::string& message)
{
  const Result result = ReadBytes(bytes);
  EXPECT_TRUE(result.IsProperError()) << message;
  EXPECT_TRUE(result.Warnings.empty());
  EXPECT_EQ(result.ErrorCode, code) << message;
  ASSERT_FALSE(result.Errors.empty());
  EXPECT_NE(result.Errors[0].find(message), std::string::npos) << result.Errors[0];
}

//------------------------------------------------------------------------------
// Bytes of a binary file with one of its words changed.
std::string SetWord(std::string bytes, std::size_t at, std::int32_t value)
{
  std::memcpy(&bytes[at], &value, 4);
  return bytes;
}
}

//------------------------------------------------------------------------------
// If this fails, half a mesh of a truncated file is shown as whole.
TEST(VisfDamage, CutOffAnywhere)
{
  const VisfMesh mesh = MakeSmallMesh();
  VisfMesh surface = mesh;
  surface.Polyhedra.clear();
  VisfMesh cloud = surface;
  cloud.Polygons.clear();
  for (const Encoding encoding : Encodings)
  {
    const std::string bytes = Encode(mesh, encoding);
    // Ends that the format allows: after the vertices (a cloud) and before the polyhedra (a
    // surface).
    VisfMesh plain = surface;
    plain.Type = 2;
    const std::size_t cloudEnd = Encode(cloud, encoding).size();
    const std::size_t surfaceEnd = encoding == Encoding::Web ? 0 : Encode(plain, encoding).size();
    for (std::size_t size = 0; size < bytes.size(); ++size)
    {
      const Result result = ReadBytes(bytes.substr(0, size));
      const std::size_t slack = IsText(encoding) ? 3 : 0; // blanks, line end, digits of last number
      const bool mayEnd = (size <= cloudEnd && size + slack >= cloudEnd) ||
        (size <= surfaceEnd && size + slack >= surfaceEnd) || size + slack >= bytes.size();
      // 32 or 36 bytes of this are a complete cloud of two vertices with a v0.1 header as well.
      const bool isCloud = encoding == Encoding::Big02 && (size == 32 || size == 36);
      if ((mayEnd || isCloud) && result.Errors.empty())
      {
        continue;
      }
      EXPECT_TRUE(result.IsProperError()) << int(encoding) << " cut at " << size;
    }
  }
}

//------------------------------------------------------------------------------
// If this fails, errors do not describe the problem or its position.
TEST(VisfDamage, SaysWhatIsWrongAndWhere)
{
  using Code = vtkErrorCode;
  ExpectError("", Code::UnrecognizedFileTypeError, "test.visf:1: expected a Visf file");
  ExpectError(" \n", Code::UnrecognizedFileTypeError, "0, 1 or 2, found the end of the file");
  ExpectError("9 9\n", Code::UnrecognizedFileTypeError,
    "test.visf:1: expected a Visf file, which begins with 0, 1 or 2, found '9'");
  ExpectError("\n\x7f"
              "ELF\x01 2",
    Code::UnrecognizedFileTypeError,
    "test.visf:2: expected a Visf file, which begins with 0, 1 or 2, found '?ELF?'");
  ExpectError("2 7\n", Code::UnrecognizedFileTypeError, "test.visf:1: expected a Visf mesh type");
  ExpectError(
    "2 1\nx\n", Code::FileFormatError, "test.visf:2: expected the number of vertices, found 'x'");
  ExpectError("2 1\n-3\n", Code::FileFormatError,
    "test.visf:2: expected the number of vertices, "
    "found -3");
  ExpectError("2 1\n99999999999\n", Code::FileFormatError, "below 2147483648");
  ExpectError(
    "2 1\n2000000000\n0 0 0\n", Code::PrematureEndOfFileError, "at least 12000000000 bytes");
  ExpectError("2 1\n3.5\n", Code::FileFormatError, "found '3.5'");
  const std::string points = "# a comment\r\n2 1\r\n3\r\n0 0 0\r\n1 0 0\r\n";
  ExpectError(points + "0 1\r\n", Code::PrematureEndOfFileError,
    "test.visf:7: expected a coordinate of a vertex, found the end of the file");
  ExpectError(points + "0 y 0\r\n", Code::FileFormatError,
    "test.visf:6: expected a coordinate of a vertex, found 'y'");
  ExpectError(points + "0 1 0\r\n1\r\n3 0 1 3\r\n0\r\n", Code::FileFormatError,
    "test.visf:8: expected a vertex id from 0 to 2, found 3");
  ExpectError(points + "0 1 0\r\n1\r\n3 0 1 -1\r\n0\r\n", Code::FileFormatError, "found -1");
  ExpectError(points + "0 1 0\r\n1\r\n-1 0 1 2\r\n0\r\n", Code::FileFormatError, "found -1");
  ExpectError(points + "0 1 0\r\n1\r\n3 0 1 2\r\n0\r\n1\r\n1 1\r\n", Code::FileFormatError,
    "test.visf:11: expected a polygon id from 0 to 0, found 1");
  ExpectError(points + "0 1 0\r\n1\r\n3 0 1 2\r\n1\r\n1 1\r\n", Code::FileFormatError,
    "test.visf:10: expected a polygon id from 0 to 0, found 1");
  ExpectError(points + "0 1 0\r\n1\r\n3 0 1 2\r\n1\r\n", Code::PrematureEndOfFileError,
    "test.visf:10: expected the size of a list of neighbors");
  // A wrong flag may be the number of polyhedra of a file without a flag.
  const std::string surface = points + "0 1 0\r\n1\r\n3 0 1 2\r\n";
  ExpectError(surface + "2\r\n1\r\n1 1\r\n", Code::FileFormatError,
    "found 1 (the number 2 after the polygons is read as the number of polyhedra, as it is not");
  ExpectError(surface + "x\r\n", Code::FileFormatError,
    "test.visf:9: expected the flag for neighbors, found 'x'");
  const Result odd = ReadBytes(surface + "2\r\n1 0\r\n1 0\r\n7\r\n");
  EXPECT_TRUE(std::any_of(odd.Warnings.begin(), odd.Warnings.end(), [](const std::string& warning)
    { return warning.find("the number 2 after the polygons") != std::string::npos; }));
}

//------------------------------------------------------------------------------
// If this fails, wrong words of a binary file are used, or reported at the wrong position.
TEST(VisfDamage, WrongWordsInBinary)
{
  VisfMesh mesh;
  mesh.Points.resize(3);
  mesh.Polygons = { { 0, 1, 2 }, { 2, 1, 0, 1 } };
  mesh.Polyhedra = { { 0, 1 } };
  const std::string bytes = Encode(mesh, Encoding::Little03);
  const std::size_t points = 5, polygons = points + 4 + 36, first = polygons + 4;
  const std::size_t second = first + 16, flag = second + 20, cells = flag + 4;
  using Code = vtkErrorCode;
  ExpectError(SetWord(bytes, 1, 3), Code::UnrecognizedFileTypeError,
    "test.visf: byte 1: expected a Visf mesh type of 0, 1 or 2, found 3");
  ExpectError(SetWord(bytes, points, -1), Code::FileFormatError, "byte 5: expected the number of");
  ExpectError(SetWord(bytes, points, 1000), Code::PrematureEndOfFileError, "at least 12000 bytes");
  ExpectError(
    SetWord(bytes, points, INT32_MAX), Code::PrematureEndOfFileError, "25769803764 bytes");
  ExpectError(
    SetWord(bytes, polygons, INT32_MAX), Code::PrematureEndOfFileError, "number of polyg");
  ExpectError(SetWord(bytes, first, INT32_MAX), Code::PrematureEndOfFileError, "polygon 0 of 2");
  ExpectError(SetWord(bytes, first, -2), Code::FileFormatError, "a size of -2");
  ExpectError(SetWord(bytes, second + 8, 3), Code::FileFormatError,
    "test.visf: byte 73: expected a vertex id from 0 to 2 in polygon 1, found 3");
  ExpectError(SetWord(bytes, flag, 2), Code::FileFormatError, "byte 85: expected the flag");
  ExpectError(
    SetWord(bytes, cells, -1), Code::FileFormatError, "byte 89: expected the number of p");
  ExpectError(SetWord(bytes, cells + 8, 2), Code::FileFormatError,
    "byte 97: expected a polygon id from 0 to 1 in polyhedron 0, found 2");
}

//------------------------------------------------------------------------------
// If this fails, a small file that declares or implies large sizes exhausts the memory.
TEST(VisfDamage, SmallFilesNeedLittleMemory)
{
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
  // A polygon with 20000 vertices, used 20000 times in a cell, would need 400 million points.
  constexpr int Many = 20000;
  VisfMesh mesh;
  mesh.Points.resize(3);
  mesh.Polygons.emplace_back(Many);
  for (int i = 0; i < Many; ++i)
  {
    mesh.Polygons[0][i] = i % 3;
  }
  mesh.Polyhedra.emplace_back(Many, 0);
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  rlimit limit = before;
  limit.rlim_cur = rlim_t(2) << 30; // the libraries alone map about one
  setrlimit(RLIMIT_AS, &limit);
  for (const Encoding encoding : Encodings)
  {
    // One cell without flag reads as the flag and one list of neighbors, which is acceptable.
    EXPECT_TRUE(encoding == Encoding::Web || ReadMesh(mesh, encoding).IsProperError());
  }
  EXPECT_TRUE(ReadBytes("2 1\n2147483647\n0 0 0\n").IsProperError());
  EXPECT_TRUE(ReadBytes("2 1\n1\n0 0 0\n2147483647\n1 0\n").IsProperError());
  setrlimit(RLIMIT_AS, &before);
#else
  GTEST_SKIP() << "needs to limit memory";
#endif
}

//------------------------------------------------------------------------------
// If this fails, files of other formats are accepted, or Visf files are not recognized.
TEST(VisfDamage, CanReadFile)
{
  vtkNew<vtkVisfReader> reader;
  std::vector<std::string> messages;
  Observe(reader, vtkCommand::ErrorEvent, messages);
  Observe(reader, vtkCommand::WarningEvent, messages);
  for (const Encoding encoding : Encodings)
  {
    EXPECT_EQ(reader->CanReadFile(File(Encode(MakeSmallMesh(), encoding)).Path.c_str()), 1);
  }
  EXPECT_EQ(reader->CanReadFile(File("# by hand\n\n2 0 x\n1\n# v\n1 2 3").Path.c_str()), 1);
  for (const char* other : { "", " ", "OFF\n8 6 0\n", "ply\nformat ascii 1.0\n", "2",
         "2 3\n1\n0 0 0\n", "2 2\nx", "2 2\n5\n1 x 3", "20 2\n1\n0 0 0\n", "#!/bin/sh\n",
         "1 2 3 4 5 6 7 8 9", "0\n", "<?xml version=\"1.0\"?>",
         "\x7f"
         "ELF" })
  {
    EXPECT_EQ(reader->CanReadFile(File(other).Path.c_str()), 0) << other;
  }
  EXPECT_EQ(
    reader->CanReadFile(File(std::string(64, '\0') + "text").Path.c_str()), 1); // a cloud of 0
  EXPECT_TRUE(messages.empty());
}
