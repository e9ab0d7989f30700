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

#include <charconv> // for hexadecimal numbers

namespace camaron
{
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
 * followed by another character, or if it is too large.
 */
template <typename Integer>
const char* ParseHex(const char* text, const char* end, Integer& value)
{
  constexpr int Base = 16;
  text = SkipSpaceFrom(text, end);
  const auto [next, error] = std::from_chars(text, end, value, Base);
  return error == std::errc() && *text != '-' && (next == end || IsSpace(*next)) ? next : nullptr;
}
}

#endif
