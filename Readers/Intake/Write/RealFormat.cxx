// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Write/RealFormat.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr int MaxDigits = 64; // no format has more; a double needs 17
}

//------------------------------------------------------------------------------
void RealFormat::AppendFormatted(std::string& text, double value) const
{
  char digits[MaxDigits + 16]; // sign, point and exponent besides
  const bool isExponent = this->Kind == Style::Exponent;
  const int precision = std::clamp(this->Digits, 0, MaxDigits);
  char* end = std::to_chars(digits, digits + sizeof(digits), value,
    isExponent ? std::chars_format::scientific : std::chars_format::general, precision)
                .ptr;
  if (!isExponent)
  {
    text.append(digits, static_cast<std::size_t>(end - digits));
    return;
  }
  // The exponent with its own mark and number of digits.
  char* mark = std::find(digits, end, 'e');
  std::size_t zeros = 0;
  if (mark != end)
  {
    const int written = static_cast<int>(end - mark) - 2;
    char* first = mark + 2; // behind the sign
    const int surplus = std::max(0, written - this->ExponentDigits);
    // to_chars writes two digits at least; a field of one digit drops the zero.
    if (surplus > 0 && *first == '0')
    {
      std::copy(first + 1, end, first);
      --end;
    }
    zeros = static_cast<std::size_t>(std::max(0, this->ExponentDigits - written));
    *mark = this->Mark;
  }
  const bool plus = this->Plus && !std::signbit(value);
  const auto size = static_cast<std::size_t>(end - digits) + zeros + (plus ? 1 : 0);
  const auto width = static_cast<std::size_t>(this->Width);
  text.append(size < width ? width - size : 0, ' ');
  if (plus)
  {
    text += '+';
  }
  if (mark == end)
  {
    text.append(digits, static_cast<std::size_t>(end - digits)); // nan and inf have no exponent
    return;
  }
  text.append(digits, static_cast<std::size_t>(mark + 2 - digits));
  text.append(zeros, '0');
  text.append(mark + 2, static_cast<std::size_t>(end - mark - 2));
}
}
