// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// How writers put numbers into text and bytes.
#include "Intake/Rows/Bytes.h"
#include "Intake/Write/RealFormat.h"
#include "Intake/Write/WriteRows.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#if !defined(_WIN32)
#include <unistd.h>
#endif

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
std::string Format(const RealFormat& format, double value)
{
  std::string text;
  format.Append(text, value);
  return text;
}

//------------------------------------------------------------------------------
std::string Print(const char* format, double value)
{
  char text[100];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

constexpr double Values[] = { 0.0, -0.0, 1, -1, 0.1, 1. / 3, 123456789, 1e300, -1e-300, 5e-324,
  1.7976931348623157e308, 3.14159265358979, 1e10, 9.9999999999999999e22, 65536.5, 99999999.95 };
}

//------------------------------------------------------------------------------
// Other programs read the digits that C's printf writes; it is the reference here.
TEST(RealFormat, IsThatOfC)
{
  for (const double value : Values)
  {
    EXPECT_EQ(Format(RealFormat::Significant(9), value), Print("%.9g", value));
    EXPECT_EQ(Format(RealFormat::Significant(17), value), Print("%.17g", value));
    EXPECT_EQ(Format(RealFormat::Exponent(8), value), Print("%.8e", value));
    EXPECT_EQ(Format(RealFormat::Exponent(8, 'E', true), value), Print("%+.8E", value));
    EXPECT_EQ(Format(RealFormat::Exponent(0, 'E'), value), Print("%.0E", value));
  }
}

//------------------------------------------------------------------------------
// Readers of fixed columns cut at the width; the texts are those of gfortran's (1PE21.13E3).
TEST(RealFormat, FillsFortranFields)
{
  const RealFormat field = RealFormat::Field(21, 13, 3);
  EXPECT_EQ(Format(field, 0), " 0.0000000000000E+000");
  EXPECT_EQ(Format(field, -4.4672751426697), "-4.4672751426697E+000");
  EXPECT_EQ(Format(field, 1e-5), " 1.0000000000000E-005");
  EXPECT_EQ(Format(field, -1.5e300), "-1.5000000000000E+300");
  EXPECT_EQ(Format(RealFormat::Field(20, 13, 2), 1.25), " 1.2500000000000E+00");
  // Too long for the field: rather a longer line than wrong digits.
  EXPECT_EQ(Format(RealFormat::Field(20, 13, 2), -1e100), "-1.0000000000000E+100");
  EXPECT_EQ(Format(RealFormat::Field(8, 1, 1), 2e5), "  2.0E+5");
}

//------------------------------------------------------------------------------
TEST(RealFormat, WritesWhatIsNoNumber)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const RealFormat& format : { RealFormat::Shortest(), RealFormat::Shortest(true),
         RealFormat::Significant(9), RealFormat::Exponent(8, 'E') })
  {
    EXPECT_EQ(Format(format, inf), "inf");
    EXPECT_EQ(Format(format, -inf), "-inf");
    EXPECT_EQ(Format(format, std::numeric_limits<double>::quiet_NaN()), "nan");
  }
}

//------------------------------------------------------------------------------
// The fewest digits, and not one bit lost.
TEST(RealFormat, ShortestReadsBack)
{
  EXPECT_EQ(Format(RealFormat::Shortest(), 0.1), "0.1");
  EXPECT_EQ(Format(RealFormat::Shortest(true), 0.1f), "0.1");
  for (const double value : Values)
  {
    const std::string text = Format(RealFormat::Shortest(), value);
    double back = 0;
    EXPECT_EQ(ParseReal(text.data(), text.data() + text.size(), back), text.data() + text.size());
    EXPECT_EQ(std::memcmp(&back, &value, sizeof(back)), 0) << text;
  }
}

//------------------------------------------------------------------------------
TEST(Text, AlignsAndWritesHexadecimal)
{
  std::string text;
  AppendAligned(text, 42, 9);
  AppendAligned(text, -7, 3);
  AppendAligned(text, 123456, 3);
  AppendHex(text, 0);
  AppendHex(text, 0xe84);
  EXPECT_EQ(text, "       42 -71234560e84");
  text.clear();
  AppendAligned(text, std::numeric_limits<std::int64_t>::min(), 32);
  EXPECT_EQ(text, "            -9223372036854775808");
  text.clear();
  constexpr std::ptrdiff_t Count = 1000; // do not fit into a buffer of words
  std::string expected;
  AppendWords(text, Count,
    [](std::ptrdiff_t i, char* to) { return std::to_chars(to, to + 32, i * i * i).ptr; });
  for (std::ptrdiff_t i = 0; i < Count; ++i)
  {
    expected += std::to_string(i * i * i) + ' ';
  }
  EXPECT_EQ(text, expected);
  const double x[] = { 1, -0.5, 1e-7 };
  text.clear();
  RealFormat::Shortest().AppendRow(text, x, 3);
  EXPECT_EQ(text, "1 -0.5 1e-07\n");
}

//------------------------------------------------------------------------------
// Files of either byte order must be the same on any machine.
TEST(Bytes, StoresAndLoadsAnySize)
{
  const bool swap = GetByteOrder() != ByteOrder::Big;
  std::string bytes;
  AppendBytes(bytes, std::uint8_t(0xab), swap);
  AppendBytes(bytes, std::int16_t(-2), swap);
  AppendBytes(bytes, std::int32_t(0x01020304), swap);
  AppendBytes(bytes, std::int64_t(0x0102030405060708), swap);
  AppendBytes(bytes, 1.0f, swap);
  AppendBytes(bytes, -2.0, swap);
  const unsigned char expected[] = { 0xab, 0xff, 0xfe, 1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 7, 8, 0x3f,
    0x80, 0, 0, 0xc0, 0, 0, 0, 0, 0, 0, 0 };
  EXPECT_EQ(bytes, std::string(reinterpret_cast<const char*>(expected), sizeof(expected)));
  EXPECT_EQ(Load<std::int16_t>(bytes.data() + 1, swap), -2);
  EXPECT_EQ(Load<std::int64_t>(bytes.data() + 7, swap), 0x0102030405060708);
  EXPECT_EQ(Load<double>(bytes.data() + 19, swap), -2.0);

  bytes = "x";
  AppendBytes<std::int16_t>(bytes, 3, [](std::ptrdiff_t i) { return 0x0102 * (i + 1); }, swap);
  EXPECT_EQ(bytes, "x\1\2\2\4\3\6");
}

//------------------------------------------------------------------------------
// If this fails, files cannot be saved under names that the system allows, or end up elsewhere.
TEST(OutputFile, LongNamesAndLinks)
{
  namespace fs = std::filesystem;
  const TemporaryFolder temporary;
  const fs::path folder = temporary.Path;
  const auto write = [](const fs::path& path)
  {
    OutputFile file(path.string());
    file.Write("new");
    return file.Commit();
  };
  const fs::path longest = folder / (std::string(251, 'n') + ".off"); // 255 bytes
  EXPECT_TRUE(write(longest));
  EXPECT_EQ(fs::file_size(longest), 3u);

  fs::create_symlink("later.off", folder / "link.off");
  EXPECT_TRUE(write(folder / "link.off"));
  EXPECT_TRUE(fs::is_symlink(folder / "link.off"));
  EXPECT_EQ(fs::file_size(folder / "later.off"), 3u);

  const fs::path kept = folder / "protected.off";
  EXPECT_TRUE(write(kept));
  fs::permissions(kept, fs::perms::owner_read);
  if (!std::ofstream(kept, std::ios::app)) // may be written by some users all the same
  {
    EXPECT_FALSE(write(kept));
  }
  const auto count = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  EXPECT_EQ(count, 4) << "something temporary was left";
}

#if !defined(_WIN32)
//------------------------------------------------------------------------------
// Writers follow no links of others in folders such as /tmp, whether the system does or not:
// another user could choose which file they replace.
TEST(OutputFile, LinksOfOthers)
{
  namespace fs = std::filesystem;
  const TemporaryFolder temporary;
  const fs::path shared = temporary.Path / "shared", link = shared / "mesh.off";
  fs::create_directory(shared);
  fs::permissions(shared, fs::perms::all | fs::perms::sticky_bit);
  for (const char* target : { "mine.off", "new.off" })
  {
    std::ofstream(temporary.Path / "mine.off") << "old";
    fs::create_symlink(temporary.Path / target, link);
    constexpr unsigned int Nobody = 65534;
    if (lchown(link.c_str(), Nobody, Nobody) != 0)
    {
      GTEST_SKIP() << "only root makes links of others";
    }
    OutputFile file(link.string());
    file.Write("newer");
    EXPECT_FALSE(file.Commit());
    EXPECT_NE(file.GetError().Message.find("Permission denied"), std::string::npos);
    fs::remove(link);
    EXPECT_EQ(fs::file_size(temporary.Path / "mine.off"), 3u);
    EXPECT_FALSE(fs::exists(temporary.Path / "new.off"));
  }
}
#endif

//------------------------------------------------------------------------------
// Rows are formatted in any order, but must be written in theirs.
TEST(WriteRows, KeepsTheOrder)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path / "rows.txt").string();
  constexpr vtkIdType Count = 1000000; // several batches of chunks
  {
    OutputFile file(path);
    ASSERT_TRUE(WriteRows(file, Count, Progress(),
      [](vtkIdType row, std::string& bytes)
      {
        AppendNumber(bytes, row);
        bytes += '\n';
      }));
    ASSERT_TRUE(file.Commit());
  }
  std::ifstream stream(path);
  vtkIdType expected = 0, row = -1;
  while (stream >> row)
  {
    ASSERT_EQ(row, expected++);
  }
  EXPECT_EQ(expected, Count);
  std::filesystem::remove(path);

  OutputFile file(path);
  EXPECT_FALSE(WriteRows(file, Count, Progress([](double) { return false; }),
    [](vtkIdType, std::string& bytes) { bytes += 'x'; }));
}
