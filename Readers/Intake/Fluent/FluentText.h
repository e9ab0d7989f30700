// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FluentText.h
 * @brief Text in Fluent files: white space, hexadecimal numbers without a prefix, and lists as in
 * Scheme.
 */
#ifndef camaron_FluentText_h
#define camaron_FluentText_h

#include "Base/Number.h"

#include <array> // for the table of digits

namespace camaron
{
namespace detail
{
constexpr std::array<signed char, 256> MakeHexDigits()
{
  std::array<signed char, 256> digits{};
  for (int c = 0; c < 256; ++c)
  {
    digits[c] = static_cast<signed char>(c >= '0' && c <= '9' ? c - '0'
        : c >= 'a' && c <= 'f'                                ? c - 'a' + 10
        : c >= 'A' && c <= 'F'                                ? c - 'A' + 10
                                                              : -1);
  }
  return digits;
}
inline constexpr std::array<signed char, 256> HexDigits = MakeHexDigits();
}

/// The first character that is not white space, or the end.
inline const char* SkipSpaceFrom(const char* text, const char* end)
{
  while (text < end && IsSpace(*text))
  {
    ++text;
  }
  return text;
}

/**
 * Reads a number after white space; returns its end, or nullptr if there is none, if it is directly
 * followed by another character, or if it exceeds 63 bits.
 */
inline const char* ParseHex(const char* text, const char* end, std::int64_t& value)
{
  text = SkipSpaceFrom(text, end);
  const char* const first = text;
  std::uint64_t number = 0;
  for (; text < end; ++text)
  {
    const int digit = detail::HexDigits[static_cast<unsigned char>(*text)];
    if (digit < 0)
    {
      break;
    }
    if (number >> 59)
    {
      return nullptr;
    }
    number = number << 4 | static_cast<unsigned int>(digit);
  }
  if (text == first || (text < end && !IsSpace(*text)))
  {
    return nullptr;
  }
  value = static_cast<std::int64_t>(number);
  return text;
}

/// The same in a line of a section; the character at its end must be readable and not a digit.
inline const char* ParseHexInLine(const char* text, const char* end, std::int64_t& value)
{
  constexpr int MaxDigits = 7; // of 32 bits
  const char* place = text + (*text == ' ' ? 1 : 0);
  const char* const limit = end - place > MaxDigits ? place + MaxDigits : end;
  const char* const first = place;
  std::uint32_t number = 0;
  for (; place < limit; ++place)
  {
    const int digit = detail::HexDigits[static_cast<unsigned char>(*place)];
    if (digit < 0)
    {
      break;
    }
    number = number << 4 | static_cast<std::uint32_t>(digit);
  }
  if (place == first || (*place != ' ' && place != end))
  {
    return ParseHex(text, end, value);
  }
  value = number;
  return place;
}

/// Reads the number of nodes of a face at the beginning of its line, if @a size is 0; nullptr if
/// the line cannot contain that many.
inline const char* ParseFaceSize(const char* text, const char* end, std::int64_t& size)
{
  if (size == 0)
  {
    text = ParseHexInLine(text, end, size);
    return text && size <= (end - text) / 2 ? text : nullptr;
  }
  return text;
}

/// Reads numbers of a line and calls put(i, value) for each; returns the end, or nullptr if one is
/// missing or put returned false.
template <typename Put>
const char* ParseNumbers(const char* text, const char* end, std::int64_t count, Put&& put)
{
  for (std::int64_t i = 0; i < count && text; ++i)
  {
    std::int64_t value = 0;
    text = ParseHexInLine(text, end, value);
    text = text && put(i, value) ? text : nullptr;
  }
  return text;
}
}

#endif
