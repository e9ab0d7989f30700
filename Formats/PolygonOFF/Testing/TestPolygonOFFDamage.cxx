// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// What the reader does with OFF files that are damaged, cut off or something else altogether.
#include "PolygonOFFSamples.h"

#include "Scan/TextLines.h"

#include "vtkErrorCode.h"

#include <chrono>

using namespace camaron;
using namespace camaron::testing;

namespace
{
//------------------------------------------------------------------------------
// Samples of every encoding, small enough to be cut everywhere.
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
// A mesh or one error, soon, with ids of points that there are.
bool ReadsOrRefuses(const std::string& bytes)
{
  const auto start = std::chrono::steady_clock::now();
  const Result result = ReadBytes(bytes);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  EXPECT_TRUE(result.Errors.empty() || result.IsProperError());
  for (vtkIdType cell = 0; cell < result.Grid->GetNumberOfCells(); ++cell)
  {
    const IndexRange ids = MeshView(result.Grid).GetCellPoints(cell);
    for (vtkIdType i = 0; i < ids.Size; ++i)
    {
      EXPECT_TRUE(ids[i] >= 0 && ids[i] < result.Grid->GetNumberOfPoints());
    }
  }
  return result.Errors.empty();
}

//------------------------------------------------------------------------------
// Reads the same in parallel too, small as the files are.
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
// If this fails, errors do not say where they are or what they are.
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
    { "COFF\n1 0 0\n0 0 0 1 x 1\n", format, "test.off:3: expected a component of the colour" },
    { "STCOFF\n1 0 0\n0 0 0 1\n", format,
      "test.off:3: expected a colour and 2 more numbers of vertex 0" },
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
// If this fails, wrong words of a binary file are followed, or reported at the wrong place.
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
  refuse(points() << -3 << 0, "byte 47: expected the number of vertices of a face, found -3");
  refuse(points() << 3 << 0 << 1, "byte 47: expected at least 12 bytes");
  refuse(points() << 2 << 0 << 1 << -1, "byte 59: expected the number of components of the colour");
  refuse(points() << 2 << 0 << 1 << 3 << 0.f, "byte 59: expected at least 12 bytes");
  refuse(points() << 2 << 0 << 2 << 0, "byte 55: expected a vertex of face 0 from 0 to 1, found 2");
  refuse(
    points() << 2 << -1 << 2 << 0, "byte 51: expected a vertex of face 0 from 0 to 1, found -1");
}

//------------------------------------------------------------------------------
// If this fails, a file that was cut off crashes or hangs the reader, or shows half a mesh as
// whole.
TEST(PolygonOFFDamage, CutOffAnywhere)
{
  WithBothChunks(
    []
    {
      for (const std::string& bytes : MakeSamples())
      {
        for (std::size_t size = 0; size < bytes.size(); ++size)
        {
          // The last id of a text may lose digits, and what follows it all.
          const bool mayBeGood =
            bytes.find("BINARY") == std::string::npos && size + 6 >= bytes.size();
          EXPECT_TRUE(!ReadsOrRefuses(bytes.substr(0, size)) || mayBeGood)
            << bytes.substr(0, 20) << size;
        }
      }
    });
}

//------------------------------------------------------------------------------
// If this fails, some damage crashes the reader. Damaged files may still be good meshes.
TEST(PolygonOFFDamage, RandomDamage)
{
  const char* rounds = std::getenv("CAMARON_FUZZ_ROUNDS"); // for longer runs by hand
  const int numberOfRounds = rounds ? std::atoi(rounds) : 400;
  std::mt19937 random(6);
  int errors = 0;
  WithBothChunks(
    [&]
    {
      for (const std::string& bytes : MakeSamples())
      {
        for (int i = 0; i < numberOfRounds; ++i)
        {
          std::string damaged = bytes;
          for (int flips = 1 + i % 4; flips > 0; --flips)
          {
            damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
          }
          if (i % 5 == 0)
          {
            damaged.erase(random() % damaged.size(), 1 + random() % 9);
          }
          errors += !ReadsOrRefuses(damaged);
        }
      }
    });
  EXPECT_GT(errors, numberOfRounds);
}

//------------------------------------------------------------------------------
// If this fails, damage to real files crashes the reader, or half of one is shown as whole.
TEST(PolygonOFFDamage, CollectedFiles)
{
  const char* folder = std::getenv("CAMARON_SHARED_DATA");
  if (!folder || !std::filesystem::exists(std::string(folder) + "/off"))
  {
    GTEST_SKIP() << "CAMARON_SHARED_DATA has no folder off";
  }
  std::vector<std::string> files;
  for (const char* kind : { "off", "malformed" })
  {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(folder) + "/" + kind))
    {
      if (entry.path().extension() == ".off")
      {
        std::ostringstream bytes;
        bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        files.push_back(bytes.str());
        EXPECT_EQ(ReadsOrRefuses(files.back()), kind[0] == 'o') << entry.path();
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::mt19937 random(7);
  for (const std::string& bytes : files)
  {
    for (int i = 0; i < 200 && !bytes.empty(); ++i)
    {
      ReadsOrRefuses(bytes.substr(0, random() % bytes.size()));
    }
  }
  for (int i = 0; i < 2000; ++i)
  {
    std::string damaged = files[i % files.size()];
    if (!damaged.empty())
    {
      damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
      ReadsOrRefuses(damaged);
    }
  }
}

//------------------------------------------------------------------------------
TEST(PolygonOFFDamage, NoFile)
{
  const File file("OFF 0 0 0\n", "test.off");
  for (const std::string& path : { file.Path + ".missing", file.GetFolder().string() })
  {
    const Result result = ReadWith<vtkPolygonOFFReader>(path);
    EXPECT_TRUE(result.IsProperError());
    EXPECT_EQ(result.ErrorCode, static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  }
}
