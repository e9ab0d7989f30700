// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of acceptable ranges: their contents, and the errors for invalid ones.
#include "Base/Number.h"
#include "Rules/ParsedRules.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace camaron;

namespace
{
std::string GetMessage(const std::string& text)
{
  try
  {
    ParseRanges({ "my.txt", text });
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}
}

//------------------------------------------------------------------------------
TEST(RangesFile, LimitsCommentsAndLineEnds)
{
  const auto rules = ParseRanges({ "my.txt",
    "\xef\xbb\xbf# ours\r\n\r\n  Volume 1e-3 * # open\r\nArea - "
    "+2.5\nMinDihedralAngle\t-inf INF\nMaxWarpage 0.1 0.1" });
  const std::vector<Preset::Rule> expected = { { "Volume", { 1e-3, Infinity } },
    { "Area", { -Infinity, 2.5 } }, { "MinDihedralAngle", { -Infinity, Infinity } },
    { "MaxWarpage", { 0.1, 0.1 } } };
  ASSERT_EQ(rules.size(), expected.size());
  for (std::size_t i = 0; i < rules.size(); ++i)
  {
    EXPECT_STREQ(rules[i].Criterion, expected[i].Criterion);
    EXPECT_EQ(rules[i].Acceptable[0], expected[i].Acceptable[0]);
    EXPECT_EQ(rules[i].Acceptable[1], expected[i].Acceptable[1]);
  }
  EXPECT_TRUE(ParseRanges({ "my.txt", "" }).empty());
}

//------------------------------------------------------------------------------
// If this fails, people search for a mistake that the message should have shown.
TEST(RangesFile, ErrorsSayWhereAndWhat)
{
  const std::pair<const char*, const char*> cases[] = {
    { "Volume 1 2\n\nMinDihedralAngel 1 2\n",
      "my.txt:3: expected the name of a criterion, found 'MinDihedralAngel'; did you mean "
      "MinDihedralAngle?" },
    { "volume 1 2",
      "my.txt:1: expected the name of a criterion, found 'volume'; did you mean Volume?" },
    { "Nonsense 1 2", "my.txt:1: expected the name of a criterion, found 'Nonsense'" },
    { "Volume 1",
      "my.txt:1: expected the upper limit: a number, or * for none, found end of line" },
    { "Volume\n1 2",
      "my.txt:1: expected the lower limit: a number, or * for none, found end of line" },
    { "Volume # 1 2\nArea 1 2",
      "my.txt:1: expected the lower limit: a number, or * for none, found end of line" },
    { "Volume 1 two", "my.txt:1: expected the upper limit: a number, or * for none, found 'two'" },
    { "Volume nan 2", "my.txt:1: expected the lower limit: a number, or * for none, found 'nan'" },
    { "Volume 1 2 3", "my.txt:1: expected end of line, found '3'" },
    { "Volume 2 1",
      "my.txt:1: expected a lower limit that is not above the upper one, found a range of Volume "
      "without values" },
    { "Volume inf inf",
      "my.txt:1: expected a lower limit that is not above the upper one, found a range of Volume "
      "without values" },
    { "Volume 1 2\nVolume 1 3",
      "my.txt:2: expected one range per criterion, found another range of Volume" },
  };
  for (const auto& [text, message] : cases)
  {
    EXPECT_EQ(GetMessage(text), message) << text;
  }
  // Anything at all is an error with a place, and not a crash.
  EXPECT_EQ(GetMessage(std::string(100000, 'x')).substr(0, 9), "my.txt:1:");
  EXPECT_EQ(GetMessage(std::string("\0\xff\x01", 3)).substr(0, 9), "my.txt:1:");
}
