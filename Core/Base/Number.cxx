// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Number.h"

#include <algorithm>
#include <string_view>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// End of the number that starts with a digit or point, and whether it has a D exponent.
const char* FindEnd(const char* p, const char* end, const char*& fortranExponent)
{
  while (p < end && (IsDigit(*p) || *p == '.'))
  {
    ++p;
  }
  if (p < end && ((*p | 0x20) == 'e' || (*p | 0x20) == 'd'))
  {
    const char* q = p + 1;
    q += q < end && (*q == '-' || *q == '+');
    if (q < end && IsDigit(*q))
    {
      fortranExponent = (*p | 0x20) == 'd' ? p : nullptr;
      p = q;
      while (p < end && IsDigit(*p))
      {
        ++p;
      }
    }
  }
  return p;
}

//------------------------------------------------------------------------------
bool IsLetter(char c)
{
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}

//------------------------------------------------------------------------------
// Reads 1.#INF and similar; returns the end, or nullptr.
template <typename Real>
const char* ParseMicrosoft(const char* text, const char* hash, const char* end, Real& value)
{
  static constexpr struct
  {
    std::string_view Name;
    Real Value;
  } spellings[] = { { "inf", std::numeric_limits<Real>::infinity() },
    { "qnan", std::numeric_limits<Real>::quiet_NaN() },
    { "snan", std::numeric_limits<Real>::quiet_NaN() },
    { "ind", std::numeric_limits<Real>::quiet_NaN() } };
  if (hash - text != 2 || *text != '1')
  {
    return nullptr;
  }
  const char* const name = hash + 1;
  const char* last = name;
  while (last < end && IsLetter(*last) && last - name < 4)
  {
    ++last;
  }
  const auto isSame = [](char a, char b) { return (a | 0x20) == b; };
  for (const auto& spelling : spellings)
  {
    if (std::equal(name, last, spelling.Name.begin(), spelling.Name.end(), isSame))
    {
      value = spelling.Value;
      const char* unused = nullptr;
      last = FindEnd(last, end, unused); // digits and an exponent
      return last < end && (IsLetter(*last) || *last == '#') ? nullptr : last;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
// Whether a number is out of range because it is too small.
bool IsTiny(const char* p, const char* end)
{
  long long exponent = 0; // of the first nonzero digit
  bool point = false;
  bool started = false;
  for (; p < end && (IsDigit(*p) || *p == '.'); ++p)
  {
    point = point || *p == '.';
    started = started || (*p >= '1' && *p <= '9');
    exponent += started && !point ? 1 : !started && point && *p == '0' ? -1 : 0;
  }
  if (p < end)
  {
    ++p;
    const bool negative = *p == '-';
    p += *p == '-' || *p == '+';
    long long written = 0;
    constexpr long long Enough = 1000000000; // more digits than any text has
    for (; p < end; ++p)
    {
      written = written < Enough ? written * 10 + (*p - '0') : written;
    }
    exponent += negative ? -written : written;
  }
  return exponent < 0;
}

//------------------------------------------------------------------------------
template <typename Real>
const char* Parse(const char* text, const char* end, Real& value)
{
  const bool negative = text < end && *text == '-';
  const char* p = text + (text < end && (*text == '-' || *text == '+'));
  if (p < end && (*p == '-' || *p == '+'))
  {
    return nullptr;
  }
  Real magnitude = 0;
  if (p < end && (IsDigit(*p) || *p == '.'))
  {
    const char* fortranExponent = nullptr;
    const char* last = FindEnd(p, end, fortranExponent);
    if (IsPartOfNumber(p, last, end))
    {
      last = ParseMicrosoft(p, last, end, magnitude);
      value = last ? negative ? -magnitude : magnitude : value;
      return last;
    }
    std::from_chars_result result;
    const char* parsed = p;
    std::string copy;
    if (fortranExponent)
    {
      copy.assign(p, last);
      copy[fortranExponent - p] = 'e';
      parsed = copy.data();
    }
    result = std::from_chars(parsed, parsed + (last - p), magnitude);
    if (result.ec == std::errc::result_out_of_range)
    {
      magnitude = IsTiny(p, last) ? Real(0) : std::numeric_limits<Real>::infinity();
    }
    else if (result.ec != std::errc())
    {
      return nullptr;
    }
    p += result.ptr - parsed;
  }
  else
  {
    const auto result = std::from_chars(p, end, magnitude); // nan, inf or infinity
    if (result.ec != std::errc())
    {
      return nullptr;
    }
    p = result.ptr;
  }
  value = negative ? -magnitude : magnitude;
  return p;
}
}

//------------------------------------------------------------------------------
bool IsPartOfNumber(const char* word, const char* hash, const char* end)
{
  if (end - hash < 2 || hash[0] != '#' || !IsLetter(hash[1]) || hash - word < 2 || hash[-1] != '.')
  {
    return false;
  }
  word += *word == '-' || *word == '+';
  return word < hash - 1 && std::all_of(word, hash - 1, IsDigit);
}

namespace detail
{
//------------------------------------------------------------------------------
const char* ParseRealSlowly(const char* text, const char* end, double& value)
{
  return Parse(text, end, value);
}

//------------------------------------------------------------------------------
const char* ParseRealSlowly(const char* text, const char* end, float& value)
{
  return Parse(text, end, value);
}
}
}
