// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/FixedColumns.h"

#include <cctype>

namespace camaron
{
namespace
{
// More than any program writes; limits the sums of widths.
constexpr std::int64_t MaxColumns = 1000;
constexpr std::int64_t MaxWidth = 1000;

//------------------------------------------------------------------------------
// Reads a positive number if there is one; false if it is too large.
bool ReadCount(const char*& text, const char* end, std::int64_t limit, std::int64_t& count)
{
  std::int64_t number;
  if (text < end && IsDigit(*text))
  {
    text = ParseInteger(text, end, number);
    count = number;
    return text && number >= 1 && number <= limit;
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool ColumnFormat::Parse(const char* begin, const char* end)
{
  this->Columns.clear();
  const char* text = SkipBlanks(begin, end);
  if (text == end || *text != '(')
  {
    return false;
  }
  std::int64_t place = 0;
  do
  {
    text = SkipBlanks(text + 1, end);
    std::int64_t repeat = 1, width = 0;
    if (!ReadCount(text, end, MaxColumns, repeat) || text == end)
    {
      return false;
    }
    const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(*text++)));
    if (letter == 'x')
    {
      place += repeat;
    }
    else
    {
      const bool isReal = letter == 'e' || letter == 'f' || letter == 'g' || letter == 'd';
      if ((!isReal && letter != 'i' && letter != 'a') || !ReadCount(text, end, MaxWidth, width) ||
        width == 0 || repeat > MaxColumns - this->GetNumberOfColumns())
      {
        return false;
      }
      while (text < end && (IsDigit(*text) || *text == '.' || *text == 'e' || *text == 'E'))
      {
        ++text; // digits after the point and of the exponent, which the numbers show themselves
      }
      for (; repeat > 0; --repeat)
      {
        this->Columns.push_back(
          { static_cast<std::int32_t>(place), static_cast<std::int32_t>(width),
            isReal            ? Kind::Real
              : letter == 'i' ? Kind::Integer
                              : Kind::Text });
        place += width;
      }
    }
    text = SkipBlanks(text, end);
  } while (text < end && *text == ',');
  return text < end && *text == ')' && !this->Columns.empty();
}

//------------------------------------------------------------------------------
int ColumnFormat::GetNumberOfLeadingIntegers() const
{
  int number = 0;
  while (number < this->GetNumberOfColumns() && this->Columns[number].Type == Kind::Integer)
  {
    ++number;
  }
  return number;
}

namespace detail
{
//------------------------------------------------------------------------------
bool ParseFixedSlowly(const char* text, const char* end, double& value)
{
  // A sign after a digit or point begins an exponent without letter.
  std::string number;
  int letters = 0;
  for (; text < end && *text != ' ' && *text != '\t'; ++text)
  {
    if ((*text == '-' || *text == '+') && !number.empty() &&
      (IsDigit(number.back()) || number.back() == '.'))
    {
      number += 'e';
      ++letters;
    }
    number += *text;
  }
  const char* const numberEnd = number.data() + number.size();
  return letters == 1 && SkipBlanks(text, end) == end &&
    ParseReal(number.data(), numberEnd, value) == numberEnd;
}
}
}
