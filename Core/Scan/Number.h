// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Number.h
 * @brief Text to number and back: exact rounding, no locale, no allocation.
 *
 * A parser returns where the number ends, or nullptr if the text does not start with one; what may
 * follow a number is for the caller to judge. Accepted are a leading `+`, exponents written e, E, d or
 * D (as Fortran does), and nan, inf and infinity in any case. A real number too large for its type is
 * infinite, one too small is zero.
 */
#ifndef camaron_Number_h
#define camaron_Number_h

#include <charconv> // for std::to_chars
#include <cstdint>  // for integers of known size
#include <cstring>  // for std::memcpy
#include <limits>   // for the range of float
#include <string>   // for text to append to

namespace camaron
{
inline bool IsDigit(char c)
{
  return static_cast<unsigned char>(c - '0') < 10;
}
/// Blanks and line ends.
inline bool IsSpace(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Integers outside the 64 bit range are no numbers.
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
 * The common case: at most 19 digits that make an integer below 2^53, times a power of ten that is
 * exact in double; one division or multiplication then rounds correctly (W. D. Clinger, How to read
 * floating point numbers accurately, 1990). Returns nullptr for everything else.
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
    for (; p < end && IsDigit(*p); ++p)
    {
      mantissa = mantissa * 10 + static_cast<unsigned char>(*p - '0');
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
  constexpr std::uint64_t MaxMantissa = std::uint64_t(1) << 53;
  constexpr int MaxExponent = 22;
  if (mantissa > MaxMantissa || exponent < -MaxExponent || exponent > MaxExponent)
  {
    return nullptr;
  }
  double result = static_cast<double>(mantissa);
  result = exponent < 0 ? result / PowersOfTen[-exponent] : result * PowersOfTen[exponent];
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
  // Rounding the correctly rounded double again gives the correctly rounded float, except where the
  // double lies exactly half way between two floats, or where floats are denormal.
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

/// Appends the shortest text that reads back as the same number (at most 9 digits for float).
template <typename Number>
inline void AppendNumber(std::string& text, Number value)
{
  char digits[32]; // enough for any double or 64 bit integer
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}
}

#endif
