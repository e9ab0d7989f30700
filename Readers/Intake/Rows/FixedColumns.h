// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FixedColumns.h
 * @brief Parses numbers in columns of fixed width, as written by Fortran programs.
 *
 * Columns may touch, a blank column is zero, and lines may end before their last columns.
 */
#ifndef camaron_FixedColumns_h
#define camaron_FixedColumns_h

#include "Base/Number.h"

#include <cstdint> // for integers of known size
#include <vector>  // for columns

namespace camaron
{
/**
 * @class camaron::ColumnFormat
 * @brief The columns that a Fortran format such as (3i9,6e21.13e3) describes.
 */
class ColumnFormat
{
public:
  enum class Kind : unsigned char
  {
    Integer, ///< i
    Real,    ///< e, f, g or d
    Text     ///< a
  };
  struct Column
  {
    std::int32_t Begin; ///< characters from the start of the line
    std::int32_t Width;
    Kind Type;
  };

  /**
   * Parses a list of columns [repeat]letter width[.digits[eN]] and of blanks, nX, in upper or
   * lower case; returns whether [begin, end) is one, ignoring blanks.
   */
  bool Parse(const char* begin, const char* end);

  int GetNumberOfColumns() const { return static_cast<int>(this->Columns.size()); }
  const Column& operator[](int i) const { return this->Columns[i]; }
  /// Number of consecutive integer columns at the beginning.
  int GetNumberOfLeadingIntegers() const;

private:
  std::vector<Column> Columns;
};

/// The part of a line in a column; empty if the line ends before it.
struct ColumnText
{
  const char* Begin;
  const char* End;
  ColumnText(const char* line, const char* lineEnd, const ColumnFormat::Column& column)
    : Begin(lineEnd - line > column.Begin ? line + column.Begin : lineEnd)
    , End(lineEnd - this->Begin > column.Width ? this->Begin + column.Width : lineEnd)
  {
  }
};

inline const char* SkipBlanks(const char* text, const char* end)
{
  while (text < end && (*text == ' ' || *text == '\t'))
  {
    ++text;
  }
  return text;
}

/// Parses the integer in a column, 0 if it is blank; false if it contains anything else.
inline bool ParseFixed(const ColumnText& column, std::int64_t& value)
{
  const char* text = SkipBlanks(column.Begin, column.End);
  if (text == column.End)
  {
    value = 0;
    return true;
  }
  text = ParseInteger(text, column.End, value);
  return text && SkipBlanks(text, column.End) == column.End;
}

namespace detail
{
bool ParseFixedSlowly(const char* text, const char* end, double& value);
}

/**
 * Parses the real number in a column, 0 if it is blank; false if it contains anything else. In
 * addition to what ParseReal accepts, the letter of an exponent may be missing: 1.234-105.
 */
inline bool ParseFixed(const ColumnText& column, double& value)
{
  const char* const begin = SkipBlanks(column.Begin, column.End);
  if (begin == column.End)
  {
    value = 0;
    return true;
  }
  const char* const text = ParseReal(begin, column.End, value);
  return (text && SkipBlanks(text, column.End) == column.End) ||
    detail::ParseFixedSlowly(begin, column.End, value);
}
}

#endif
