// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Number.h
 * @brief Converts text to numbers and back: exact rounding, no locale, no allocation.
 *
 * A parser returns where the number ends, or nullptr if the text does not start with one; the
 * caller decides what may follow. It accepts a leading `+`, exponents with e, E, d or D (Fortran),
 * and nan, inf and infinity in any case. Real numbers too large for the type are infinite, too
 * small ones zero.
 *
 * The output of old Microsoft run-time libraries is accepted as well, in any case, with a sign and
 * with trailing digits or an exponent: 1.#INF is infinity; 1.#QNAN, 1.#SNAN and 1.#IND are NaN.
 * Any other number whose point is followed by # and a letter is rejected, even if # starts
 * comments: it may be a truncated one (1.#J), and never means the number before the #.
 */
#ifndef camaron_Number_h
#define camaron_Number_h

#include <cfloat>   // for the extended format
#include <charconv> // for std::to_chars
#include <cstddef>  // for std::ptrdiff_t
#include <cstdint>  // for integers of known size
#include <cstring>  // for std::memcpy
#include <limits>   // for infinity and the range of float
#include <string>   // for text to append to

namespace camaron
{
constexpr double Pi = 3.141592653589793238462643383279502884;
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

inline bool IsDigit(char c)
{
  return static_cast<unsigned char>(c - '0') < 10;
}
/// Blanks and line ends.
inline bool IsSpace(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Whether the # in a word does not start a comment, because it is part of a number such as 1.#INF
/// or may be.
bool IsPartOfNumber(const char* word, const char* hash, const char* end);

/// Rejects integers outside the 64-bit range.
inline const char* ParseInteger(const char* text, const char* end, std::int64_t& value)
{
  const char* p = text;
  const bool negative = p < end && *p == '-';
  p += p < end && (*p == '-' || *p == '+');
  const char* digits = p;
  std::uint64_t magnitude = 0;
  for (; p < end && IsDigit(*p); ++p)
  {
    magnitude = magnitude * 10 + static_cast<unsigned char>(*p - '0');
  }
  if (p == digits)
  {
    return nullptr;
  }
  constexpr int SafeDigits = 18; // any 18 digits fit
  if (p - digits > SafeDigits)
  {
    const auto result = std::from_chars(negative ? digits - 1 : digits, p, value);
    return result.ec == std::errc() ? p : nullptr;
  }
  value = negative ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
  return p;
}

namespace detail
{
const char* ParseRealSlowly(const char* text, const char* end, double& value);
const char* ParseRealSlowly(const char* text, const char* end, float& value);

constexpr double PowersOfTen[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };

/**
 * Appends eight digits to a number at once. False if there are fewer, or if the byte order of the
 * machine does not allow it. In a word of characters minus '0', digits are bytes below ten, and
 * adjacent bytes combine to numbers of two, four and eight digits.
 */
inline bool ReadEightDigits(const char* p, const char* end, std::uint64_t& number)
{
#if defined(__GNUC__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  constexpr std::uint64_t EveryByte = 0x0101010101010101u;
  std::uint64_t word;
  if (end - p < static_cast<std::ptrdiff_t>(sizeof(word)))
  {
    return false;
  }
  std::memcpy(&word, p, sizeof(word));
  word ^= EveryByte * '0';
  if (((word + EveryByte * (0x80 - 10)) | word) & (EveryByte * 0x80))
  {
    return false;
  }
  constexpr std::uint64_t EveryFourth = 0x000000ff000000ffu;
  word = word * 10 + (word >> 8);
  word = (word & EveryFourth) * ((std::uint64_t(1000000) << 32) + 100) +
    (word >> 16 & EveryFourth) * ((std::uint64_t(10000) << 32) + 1);
  number = number * 100000000 + (word >> 32);
  return true;
#else
  (void)p;
  (void)end;
  (void)number;
  return false;
#endif
}

/**
 * Multiplies an integer by a power of ten that is exact in double. If the integer is exact, too,
 * one division or multiplication rounds correctly (W. D. Clinger, How to read floating point
 * numbers accurately, 1990). Otherwise the x86 extended format represents both exactly; rounding
 * its result to double is correct unless it is half way between two doubles. Returns false in that
 * case, and without that format.
 */
inline bool ScaleByPowerOfTen(std::uint64_t integer, int exponent, double& value)
{
  constexpr std::uint64_t MaxExact = std::uint64_t(1) << 53;
  if (integer <= MaxExact)
  {
    value = static_cast<double>(integer);
    value = exponent < 0 ? value / PowersOfTen[-exponent] : value * PowersOfTen[exponent];
    return true;
  }
#if defined(__GNUC__) && LDBL_MANT_DIG == 64
  auto wide = static_cast<long double>(integer);
  wide = exponent < 0 ? wide / PowersOfTen[-exponent] : wide * PowersOfTen[exponent];
  value = static_cast<double>(wide);
  std::uint64_t fraction; // the first part of the format
  std::memcpy(&fraction, &wide, sizeof(fraction));
  constexpr std::uint64_t Dropped = (std::uint64_t(1) << 11) - 1; // 64 - 53 bits
  constexpr std::uint64_t HalfWay = std::uint64_t(1) << 10;
  return (fraction & Dropped) != HalfWay;
#else
  return false;
#endif
}

/**
 * The common case: at most 19 digits, which fit into a 64-bit integer, and a power of ten that is
 * exact in double. Returns nullptr for everything else.
 */
inline const char* ParseRealFast(const char* text, const char* end, double& value)
{
  const char* p = text;
  const bool negative = p < end && *p == '-';
  p += p < end && (*p == '-' || *p == '+');
  std::uint64_t mantissa = 0;
  const char* first = p;
  for (; p < end && IsDigit(*p); ++p)
  {
    mantissa = mantissa * 10 + static_cast<unsigned char>(*p - '0');
  }
  auto digits = p - first;
  int exponent = 0;
  if (p < end && *p == '.')
  {
    first = ++p;
    while (ReadEightDigits(p, end, mantissa))
    {
      p += 8;
    }
    for (; p < end && IsDigit(*p); ++p)
    {
      mantissa = mantissa * 10 + static_cast<unsigned char>(*p - '0');
    }
    if (p == first && p < end && *p == '#')
    {
      return nullptr; // 1.#INF
    }
    digits += p - first;
    exponent = -static_cast<int>(p - first);
  }
  constexpr int MaxDigits = 19; // fit 64 bits
  if (digits == 0 || digits > MaxDigits)
  {
    return nullptr;
  }
  if (p < end && ((*p | 0x20) == 'e' || (*p | 0x20) == 'd'))
  {
    const char* q = p + 1;
    const bool down = q < end && *q == '-';
    q += q < end && (*q == '-' || *q == '+');
    if (q < end && IsDigit(*q))
    {
      int written = 0;
      for (; q < end && IsDigit(*q); ++q)
      {
        written = written < 1000 ? written * 10 + (*q - '0') : written;
      }
      exponent += down ? -written : written;
      p = q;
    }
  }
  constexpr int MaxExponent = 22;
  double result;
  if (exponent < -MaxExponent || exponent > MaxExponent ||
    !ScaleByPowerOfTen(mantissa, exponent, result))
  {
    return nullptr;
  }
  value = negative ? -result : result;
  return p;
}
}

inline const char* ParseReal(const char* text, const char* end, double& value)
{
  const char* p = detail::ParseRealFast(text, end, value);
  return p ? p : detail::ParseRealSlowly(text, end, value);
}

inline const char* ParseReal(const char* text, const char* end, float& value)
{
  // Rounding the correctly rounded double gives the correctly rounded float, except if the double
  // is exactly half way between two floats, or the float is denormal.
  double exact;
  if (const char* p = detail::ParseRealFast(text, end, exact))
  {
    std::uint64_t bits;
    std::memcpy(&bits, &exact, sizeof(bits));
    constexpr std::uint64_t Dropped = (std::uint64_t(1) << 29) - 1; // 52 - 23 bits of the fraction
    constexpr std::uint64_t HalfWay = std::uint64_t(1) << 28;
    const double magnitude = exact < 0 ? -exact : exact;
    if ((bits & Dropped) != HalfWay && magnitude <= std::numeric_limits<float>::max() &&
      (magnitude >= std::numeric_limits<float>::min() || magnitude == 0))
    {
      value = static_cast<float>(exact);
      return p;
    }
  }
  return detail::ParseRealSlowly(text, end, value);
}

///@{
/// The parser for a type.
inline const char* ParseNumber(const char* text, const char* end, std::int64_t& value)
{
  return ParseInteger(text, end, value);
}
template <typename Real>
const char* ParseNumber(const char* text, const char* end, Real& value)
{
  return ParseReal(text, end, value);
}
///@}

/// Appends the shortest text that converts back to the same number (at most 9 digits for float).
template <typename Number>
inline void AppendNumber(std::string& text, Number value)
{
  char digits[32]; // enough for any double or 64-bit integer
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}
}

#endif
