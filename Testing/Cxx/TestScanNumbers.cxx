// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Conversion between text and numbers, compared with the C library.
#include "Base/Number.h"
#include "Intake/Rows/ShortNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <random>
#include <vector>

using namespace camaron;

namespace
{
//------------------------------------------------------------------------------
template <typename Real>
std::uint64_t GetBits(Real value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(value));
  return bits;
}

//------------------------------------------------------------------------------
void ExpectAsLibrary(const std::string& text)
{
  // Not null-terminated, like text in a mapped file.
  const std::string padded = text + "9";
  const char* const begin = padded.data();
  const char* const end = begin + text.size();
  double d = -7;
  float f = -7;
  EXPECT_EQ(ParseReal(begin, end, d), end) << text;
  EXPECT_EQ(ParseReal(begin, end, f), end) << text;
  EXPECT_EQ(GetBits(d), GetBits(std::strtod(text.c_str(), nullptr))) << text;
  EXPECT_EQ(GetBits(f), GetBits(std::strtof(text.c_str(), nullptr))) << text;
}
}

//------------------------------------------------------------------------------
// If this fails, coordinates are not the nearest to the number in the file.
TEST(ScanNumbers, RealsAsTheLibraryReadsThem)
{
  for (const char* text :
    { "0", "-0", "1", "+1", "1.", ".5", "-.5", "0.1", "1e0", "1e22", "1e23", "123456789012345678",
      "1234567890123456789", "12345678901234567890", "9007199254740993",
      "0.000000000000000000000000000001", "1e-400", "1e400", "-1e400", "5e-324", "2e-324", "1e-45",
      "1.17549435e-38", "3.4028235e38", "3.4028236e38", "1.7976931348623159e308", "16777217",
      "16777216.99999999999999999", "0.500000029802322387695312", "0.500000029802322387695313",
      "2.2250738585072011e-308", "1e00000000000000000000001", "0e999999999999",
      "1e-99999999999999999999", "1e99999999999999999999", "00000000000000000000000000000001.5" })
  {
    ExpectAsLibrary(text);
  }
  std::mt19937_64 random(1);
  char text[64];
  for (int i = 0; i < 200000; ++i)
  {
    std::uint64_t bits = random();
    double d;
    std::memcpy(&d, &bits, sizeof(d));
    if (!std::isfinite(d))
    {
      continue;
    }
    const int digits = 1 + static_cast<int>(random() % 20);
    std::snprintf(text, sizeof(text), "%.*e", digits, d);
    ExpectAsLibrary(text);
    std::snprintf(text, sizeof(text), "%.*g", digits, std::ldexp(d, -std::ilogb(d) + i % 40 - 20));
    ExpectAsLibrary(text);
    // Half way between two floats, and next to it.
    const auto fraction = static_cast<std::uint32_t>(bits);
    float f;
    const std::uint32_t pattern = (fraction & 0x807fffffu) | (100u + fraction % 50u) << 23;
    std::memcpy(&f, &pattern, sizeof(f));
    const double half = (static_cast<double>(f) + std::nextafter(f, 2 * f)) / 2;
    std::snprintf(text, sizeof(text), "%.*e", 15 + i % 10, half);
    ExpectAsLibrary(text);
    // Half way between two doubles, and next to it, in all the digits that fit 64 bits.
    constexpr std::uint64_t Hidden = std::uint64_t(1) << 53;
    const std::uint64_t odd = (bits & (Hidden - 1)) | Hidden | 1;
    const std::uint64_t halfWay = odd << random() % 10;
    std::snprintf(text, sizeof(text), "%llu", static_cast<unsigned long long>(halfWay));
    ExpectAsLibrary(text);
    std::snprintf(text, sizeof(text), "%llu", static_cast<unsigned long long>(halfWay + 1));
    ExpectAsLibrary(text);
    std::snprintf(text, sizeof(text), "%llue%d", static_cast<unsigned long long>(bits >> 1),
      static_cast<int>(random() % 60) - 30);
    ExpectAsLibrary(text);
  }
}

//------------------------------------------------------------------------------
// If this fails, notations of other programs are refused, or text that is not a number is accepted
// as one.
TEST(ScanNumbers, Notations)
{
  const auto parse = [](const std::string& text, double& value)
  {
    const char* end = ParseReal(text.data(), text.data() + text.size(), value);
    return end ? end - text.data() : -1;
  };
  double value = 0;
  EXPECT_EQ(parse("1.5D+01x", value), 7);
  EXPECT_EQ(value, 15);
  EXPECT_EQ(parse("1.234567890123456789012d-3", value), 26);
  EXPECT_EQ(value, 1.234567890123456789012e-3);
  EXPECT_EQ(parse("1e", value), 1); // the part that is a number
  EXPECT_EQ(parse("1e+", value), 1);
  EXPECT_EQ(parse("1.2.3", value), 3);
  EXPECT_EQ(parse("1,5", value), 1);
  EXPECT_EQ(parse("NaN", value), 3);
  EXPECT_TRUE(std::isnan(value));
  EXPECT_EQ(parse("-inf", value), 4);
  EXPECT_EQ(value, -INFINITY);
  EXPECT_EQ(parse("+Infinity", value), 9);
  EXPECT_EQ(value, INFINITY);
  for (const char* text : { "", "-", "+", ".", "-.", "e5", "--1", "+-1", "x", " 1", "x1" })
  {
    EXPECT_EQ(parse(text, value), -1) << text;
  }
}

//------------------------------------------------------------------------------
// If this fails, infinity and NaN as printed by old Microsoft run-time libraries are read as 1 with
// a comment.
TEST(ScanNumbers, SpellingsOfMicrosoft)
{
  const auto check = [](auto value, const std::string& text, double expected, std::size_t size)
  {
    for (const std::string rest : { "", " 2", "\t#", ",1" })
    {
      const std::string whole = text + rest;
      const char* const end = ParseReal(whole.data(), whole.data() + whole.size(), value);
      ASSERT_NE(end, nullptr) << whole;
      EXPECT_EQ(static_cast<std::size_t>(end - whole.data()), size) << whole;
      EXPECT_EQ(std::isnan(value), std::isnan(expected)) << whole;
      EXPECT_EQ(std::signbit(value), std::signbit(expected)) << whole;
      EXPECT_TRUE(std::isnan(expected) || value == expected) << whole;
    }
  };
  for (const char* name : { "INF", "QNAN", "SNAN", "IND" })
  {
    const double number = std::string(name) == "INF" ? INFINITY : NAN;
    for (const std::string end : { "", "0", "00", "000000000000000", "0e+000", "00E+000" })
    {
      const std::string text = std::string("1.#") + name + end;
      for (const auto& [sign, factor] :
        { std::pair<const char*, double>{ "", 1 }, { "-", -1 }, { "+", 1 } })
      {
        const std::string whole = sign + text;
        check(double(), whole, std::copysign(number, factor), whole.size());
        check(float(), whole, std::copysign(number, factor), whole.size());
      }
    }
  }
  check(double(), "1.#qnan", NAN, 7);
  // Truncated words are one of them, but which is unknown; similar words are not numbers.
  for (const char* text : { "1.#J", "1.#IO", "1.#R", "1.#QO", "1.#QNB", "1.#INFO", "1.#comment",
         "0.#INF", "2.#IND", "-11.#INF", "1.#INF#" })
  {
    double value = 5;
    const char* const end = ParseReal(text, text + std::strlen(text), value);
    EXPECT_EQ(end, nullptr) << text;
    EXPECT_EQ(value, 5) << text;
  }
  // None of them.
  const std::pair<const char*, int> others[] = { { "1.# a comment", 2 }, { "1.#", 2 },
    { "1.#5", 2 }, { "1.5#INF", 3 }, { "1#INF", 1 }, { "1.0#QNAN", 3 }, { "1.##INF", 2 } };
  for (const auto& [text, size] : others)
  {
    double value = 0;
    EXPECT_EQ(ParseReal(text, text + std::strlen(text), value), text + size) << text;
    EXPECT_EQ(std::floor(value), 1) << text;
  }
}

//------------------------------------------------------------------------------
// If this fails, ids or counts wrap around or are truncated.
TEST(ScanNumbers, Integers)
{
  const auto parse = [](const std::string& text, std::int64_t& value)
  {
    const char* end = ParseInteger(text.data(), text.data() + text.size(), value);
    return end ? end - text.data() : -1;
  };
  std::int64_t value = 0;
  EXPECT_EQ(parse("+42 ", value), 3);
  EXPECT_EQ(value, 42);
  EXPECT_EQ(parse("9223372036854775807", value), 19);
  EXPECT_EQ(value, INT64_MAX);
  EXPECT_EQ(parse("-9223372036854775808", value), 20);
  EXPECT_EQ(value, INT64_MIN);
  EXPECT_EQ(parse("0000000000000000000000000000000007", value), 34);
  EXPECT_EQ(value, 7);
  EXPECT_EQ(parse("9223372036854775808", value), -1);
  EXPECT_EQ(parse("99999999999999999999999", value), -1);
  EXPECT_EQ(parse("3.5", value), 1);
  EXPECT_EQ(parse("-", value), -1);
  EXPECT_EQ(parse("", value), -1);
}

//------------------------------------------------------------------------------
// If this fails, written numbers do not read back, or are longer than necessary.
TEST(ScanNumbers, ThereAndBack)
{
  std::mt19937_64 random(9);
  for (int i = 0; i < 200000; ++i)
  {
    const auto pattern = static_cast<std::uint32_t>(random());
    float f, again = 0;
    std::memcpy(&f, &pattern, sizeof(f));
    if (!std::isfinite(f))
    {
      continue;
    }
    std::string text;
    AppendNumber(text, f);
    EXPECT_EQ(ParseReal(text.data(), text.data() + text.size(), again), text.data() + text.size());
    EXPECT_EQ(GetBits(f), GetBits(again)) << text;
    EXPECT_LE(text.size(), 15u); // sign, 9 digits, point, exponent
  }
}

//------------------------------------------------------------------------------
// If this fails, numbers depend on the user's language.
TEST(ScanNumbers, NoLocale)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool found = false;
  for (const char* name : { "de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "es_CL.UTF-8" })
  {
    found = found || std::setlocale(LC_ALL, name);
  }
  const std::string text = "1.5";
  double value = 0;
  EXPECT_EQ(ParseReal(text.data(), text.data() + 3, value), text.data() + 3);
  EXPECT_EQ(value, 1.5);
  std::string written;
  AppendNumber(written, 2.5f);
  EXPECT_EQ(written, "2.5");
  std::setlocale(LC_ALL, before.c_str());
  if (!found)
  {
    GTEST_SKIP() << "no locale with a decimal comma is installed";
  }
}

//------------------------------------------------------------------------------
// If this fails, ids in text are wrong or read beyond the end. Unusual input is left to another
// function, before its blank: numbers with nine digits, two blanks, signs, other characters.
TEST(ScanNumbers, ShortNumbersOfLists)
{
  std::mt19937 random(7);
  const std::string odd[] = { " 123456789", "  1", " -1", " +1", "\t1", " 1\t", " 1,", " 1x",
    " \xe9", " ", "\n", "\r\n", " #", " 1\r" };
  for (int trial = 0; trial < 20000; ++trial)
  {
    std::vector<std::int32_t> expected(random() % 20);
    std::string text;
    for (std::int32_t& value : expected)
    {
      // One to eight digits.
      value =
        static_cast<std::int32_t>(random() % static_cast<int>(std::pow(10, 1 + random() % 8)));
      text += " " + std::to_string(value);
    }
    const std::size_t good = text.size();
    const bool isOdd = trial % 2 == 0;
    text += isOdd ? odd[random() % std::size(odd)] : std::string(1, trial % 4 == 1 ? '\n' : ' ');
    text += std::string(random() % 80, trial % 3 == 0 ? '5' : ' ');
    const char* const end = text.data() + text.size();
    const auto count = static_cast<std::int32_t>(expected.size()) + (isOdd ? 1 : 0);
    std::vector<std::int32_t> numbers(expected.size() + 1, -1);
    const char* place = text.data();
    const std::int32_t read = ReadShortNumbers(place, end, count, 100000000, numbers.data());
    ASSERT_LE(place, end);
    const auto usual = static_cast<std::int32_t>(expected.size());
    if (read > usual)
    {
      ASSERT_EQ(read, usual + 1); // the following character made the odd one a usual one
      ASSERT_GT(place, text.data() + good);
    }
    for (std::int32_t i = 0; i < std::min(read, usual); ++i)
    {
      ASSERT_EQ(numbers[static_cast<std::size_t>(i)], expected[static_cast<std::size_t>(i)])
        << text;
    }
    // The position where the next number begins.
    std::string rest;
    for (std::int32_t i = read; i < usual; ++i)
    {
      rest += " " + std::to_string(expected[static_cast<std::size_t>(i)]);
    }
    if (read <= usual)
    {
      ASSERT_EQ(std::string(place, end), rest + text.substr(good)) << text;
    }
    if (usual > 0)
    {
      // A limit applies wherever it is exceeded.
      const std::int32_t limit = expected[0];
      const char* again = text.data();
      ASSERT_EQ(ReadShortNumbers(again, end, count, limit, numbers.data()), 0);
      ASSERT_EQ(again, text.data());
    }
  }
}
