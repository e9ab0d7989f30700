// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers in columns of fixed width, and lines with their blanks.
#include "Intake/Rows/FixedColumns.h"
#include "Intake/Rows/LineChunks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace camaron;

namespace
{
using Kind = ColumnFormat::Kind;

bool ParseFormat(ColumnFormat& format, const std::string& text)
{
  return format.Parse(text.data(), text.data() + text.size());
}

ColumnText GetColumn(const std::string& line, const ColumnFormat& format, int i)
{
  return ColumnText(line.data(), line.data() + line.size(), format[i]);
}

// The number in a column as wide as the text, in which nothing may follow it.
bool ReadReal(const std::string& text, double& value)
{
  const std::string line = text + "7"; // of the next column
  return ParseFixed(ColumnText(line.data(), line.data() + line.size(),
                      { 0, static_cast<std::int32_t>(text.size()), Kind::Real }),
    value);
}

double ToReal(const std::string& text)
{
  double value = -99;
  EXPECT_TRUE(ReadReal(text, value)) << text;
  return value;
}
}

//------------------------------------------------------------------------------
// If this fails, numbers of all formats but the most common one are cut in the wrong places.
TEST(FixedColumns, UnderstandsFormats)
{
  ColumnFormat format;
  ASSERT_TRUE(ParseFormat(format, "(3i9,6e21.13e3)"));
  ASSERT_EQ(format.GetNumberOfColumns(), 9);
  EXPECT_EQ(format.GetNumberOfLeadingIntegers(), 3);
  EXPECT_EQ(format[2].Begin, 18);
  EXPECT_EQ(format[2].Width, 9);
  EXPECT_EQ(format[8].Begin, 27 + 5 * 21);
  EXPECT_EQ(format[8].Type, Kind::Real);
  ASSERT_TRUE(ParseFormat(format, " ( 1I7 , 2i9, 6E21.13 ) ! comment"));
  EXPECT_EQ(format[1].Begin, 7);
  EXPECT_EQ(format[3].Begin, 25);
  ASSERT_TRUE(ParseFormat(format, "(2i9,19a9)"));
  EXPECT_EQ(format[20].Type, Kind::Text);
  ASSERT_TRUE(ParseFormat(format, "(i5,3x,f8.3,2G10.2E2,d25.16)"));
  EXPECT_EQ(format[1].Begin, 8);
  EXPECT_EQ(format[4].Begin, 36);
  for (const char* wrong : { "", "()", "(3i9", "3i9)", "(3i)", "(i0)", "(3z9)", "(0i9)", "(2i9,)",
         "(99999999999999999999i9)", "(i99999999)", "(2i9 6e21)", "(i9,a6,2(pg16.9))" })
  {
    EXPECT_FALSE(ParseFormat(format, wrong)) << wrong;
  }
  EXPECT_TRUE(ParseFormat(format, "(1000i1000)"));
  EXPECT_FALSE(ParseFormat(format, "(999i1,999i1)"));
}

//------------------------------------------------------------------------------
// If this fails, numbers that touch or are missing at the end of a line are misread.
TEST(FixedColumns, CutsByColumn)
{
  ColumnFormat format;
  ASSERT_TRUE(ParseFormat(format, "(2i5,2e12.5)"));
  const std::string line = "1234567890-1.23456E-01-2.5D+1";
  std::int64_t id;
  double x;
  ASSERT_TRUE(ParseFixed(GetColumn(line, format, 0), id));
  EXPECT_EQ(id, 12345);
  ASSERT_TRUE(ParseFixed(GetColumn(line, format, 1), id));
  EXPECT_EQ(id, 67890);
  ASSERT_TRUE(ParseFixed(GetColumn(line, format, 2), x));
  EXPECT_EQ(x, -1.23456e-1);
  ASSERT_TRUE(ParseFixed(GetColumn(line, format, 3), x)); // shorter than the column
  EXPECT_EQ(x, -25);
  const std::string shortLine = "  12 ";
  ASSERT_TRUE(ParseFixed(GetColumn(shortLine, format, 0), id));
  EXPECT_EQ(id, 12);
  for (const int i : { 1, 2, 3 })
  {
    ASSERT_TRUE(ParseFixed(GetColumn(shortLine, format, i), x));
    EXPECT_EQ(x, 0);
  }
  for (const char* wrong : { "1 2  ", "  x  ", " 1.5 ", " 1-2 ", "  -  " })
  {
    EXPECT_FALSE(ParseFixed(GetColumn(wrong, format, 0), id)) << wrong;
  }
}

//------------------------------------------------------------------------------
// If this fails, coordinates as Fortran writes them are refused or wrong.
TEST(FixedColumns, ReadsFortranNumbers)
{
  EXPECT_EQ(ToReal(" -6.01203 "), -6.01203);
  EXPECT_EQ(ToReal("1.0000000000000D+002"), 100);
  EXPECT_EQ(ToReal("1.234d-5"), 1.234e-5);
  EXPECT_EQ(ToReal("-4.4672751426697E+001"), -44.672751426697);
  EXPECT_EQ(ToReal("1.234-105"), 1.234e-105);
  EXPECT_EQ(ToReal("-1.5+102"), -1.5e102);
  EXPECT_EQ(ToReal("5.-3  "), 0.005);
  EXPECT_EQ(ToReal("0.12345678901234567890123-101"), 0.12345678901234567890123e-101);
  EXPECT_EQ(ToReal("   7"), 7); // no implied decimal point
  EXPECT_EQ(ToReal("    "), 0);
  EXPECT_TRUE(std::isnan(ToReal(" NaN")));
  double x;
  for (const char* wrong : { "x", "1 2", "1.5-1-2", "--1", "1.5e", "1.5e+", "-", "1.5-", "1,5" })
  {
    EXPECT_FALSE(ReadReal(wrong, x)) << wrong;
  }
  EXPECT_FALSE(ReadReal(std::string("8.0\0\0\0", 6), x));
}

//------------------------------------------------------------------------------
TEST(LineChunks, KeepLinesWhole)
{
  const std::string text = " one\r\n\ntwo \nthree";
  const char* const end = text.data() + text.size();
  std::string joined;
  for (const char* begin = text.data(); begin < end;)
  {
    const Line line(begin, end);
    joined += "<" + std::string(line.Begin, line.End) + ">";
    begin = line.Next;
  }
  EXPECT_EQ(joined, "< one><><two ><three>");
  EXPECT_EQ(CutAtLine(text.data(), end, 3), text.data() + 6);
  EXPECT_EQ(CutAtLine(text.data(), end, 6), text.data() + 7);
  EXPECT_EQ(CutAtLine(text.data(), end, 13), end);
  EXPECT_EQ(CutAtLine(text.data(), end, 100), end);
}
