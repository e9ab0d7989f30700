// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RealFormat.h
 * @brief Converts numbers to the text that a file format requires: exact rounding, no locale.
 */
#ifndef camaron_RealFormat_h
#define camaron_RealFormat_h

#include "Base/Number.h"

#include <algorithm> // for std::min
#include <cstring>   // for std::memset

namespace camaron
{
/**
 * The format of real numbers, the same for all numbers of a file; cheap to copy.
 */
class RealFormat
{
public:
  /// The fewest digits that convert back to the same double, or float.
  static RealFormat Shortest(bool isFloat = false)
  {
    return RealFormat(isFloat ? Style::ShortestFloat : Style::Shortest);
  }

  /// Like printf's %.<digits>g: 9 digits preserve every float, 17 every double.
  static RealFormat Significant(int digits)
  {
    RealFormat format(Style::Significant);
    format.Digits = digits;
    return format;
  }

  /**
   * With an exponent of at least two digits, like printf's %.<decimals>e; %E if @a mark is 'E'.
   * @param withPlus whether positive numbers begin with a `+`
   */
  static RealFormat Exponent(int decimals, char mark = 'e', bool withPlus = false)
  {
    RealFormat format(Style::Exponent);
    format.Digits = decimals;
    format.Mark = mark;
    format.Plus = withPlus;
    return format;
  }

  /**
   * Like Fortran's fields 1PE<width>.<decimals>E<exponentDigits>, for example 6e21.13e3 in ANSYS
   * archives: right-aligned, `E`, a sign and exactly this many exponent digits (more if
   * necessary). A number that does not fit makes the field longer.
   */
  static RealFormat Field(int width, int decimals, int exponentDigits)
  {
    RealFormat format(Style::Exponent);
    format.Digits = decimals;
    format.Mark = 'E';
    format.Width = width;
    format.ExponentDigits = exponentDigits;
    return format;
  }

  void Append(std::string& text, double value) const
  {
    switch (this->Kind)
    {
      case Style::Shortest:
        AppendNumber(text, value);
        return;
      case Style::ShortestFloat:
        AppendNumber(text, static_cast<float>(value));
        return;
      default:
        this->AppendFormatted(text, value);
    }
  }
  /// Appends numbers separated by blanks, and an end.
  void AppendRow(std::string& text, const double* values, int count, char end = '\n') const
  {
    for (int i = 0; i < count; ++i)
    {
      this->Append(text, values[i]);
      text += i + 1 < count ? ' ' : end;
    }
  }

private:
  enum class Style
  {
    Shortest,
    ShortestFloat,
    Significant,
    Exponent
  };
  explicit RealFormat(Style kind)
    : Kind(kind)
  {
  }
  void AppendFormatted(std::string& text, double value) const;

  Style Kind;
  int Digits = 0;
  int Width = 0;
  int ExponentDigits = 2;
  char Mark = 'e';
  bool Plus = false;
};

/// Like printf's %<width>d for a width of at most 32: right-aligned, longer if necessary.
template <typename Integer>
inline void AppendAligned(std::string& text, Integer value, int width)
{
  constexpr int MaxWidth = 32;
  char field[2 * MaxWidth]; // blanks, then the number, which ends the field
  char* const number = field + MaxWidth;
  std::memset(field, ' ', MaxWidth);
  char* const end = std::to_chars(number, field + sizeof(field), value).ptr;
  text.append(std::min(number, end - width), end);
}

/// Appends words with a blank after each: faster than one by one. @a write(i, char* to) writes word
/// i of at most 32 characters and returns its end.
template <typename Write>
void AppendWords(std::string& text, std::ptrdiff_t count, Write&& write)
{
  constexpr std::ptrdiff_t Longest = 32 + 1;
  char words[1024];
  char* to = words;
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    to = write(i, to);
    *to++ = ' ';
    if (words + sizeof(words) - to < Longest)
    {
      text.append(words, to);
      to = words;
    }
  }
  text.append(words, to);
}

/// Hexadecimal, lower case, without a prefix.
inline void AppendHex(std::string& text, std::uint64_t value)
{
  char digits[16]; // for 64 bits
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value, 16).ptr);
}
}

#endif
