// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rules/Decimal.h"

#include "Base/Number.h"
#include "Base/Text.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
std::optional<Decimal> Decimal::Parse(std::string_view text)
{
  Decimal number;
  const auto skip = [&](char character)
  {
    const bool found = !text.empty() && ToLower(text[0]) == character;
    text.remove_prefix(found ? 1 : 0);
    return found;
  };
  const auto takeDigits = [&]
  {
    const auto end = std::find_if_not(text.begin(), text.end(), IsDigit);
    const std::string digits(text.begin(), end);
    text.remove_prefix(digits.size());
    return digits;
  };
  number.Negative = skip('-');
  if (!number.Negative)
  {
    skip('+');
  }
  number.Digits = takeDigits();
  number.Exponent = static_cast<std::int64_t>(number.Digits.size());
  number.Digits += skip('.') ? takeDigits() : "";
  if (number.Digits.empty())
  {
    return std::nullopt;
  }
  if (skip('e') || skip('d'))
  {
    constexpr std::int64_t most = 1000000000; // far more than any double, or any line, has
    const bool isNegative = skip('-');
    if (!isNegative)
    {
      skip('+');
    }
    const std::string digits = takeDigits();
    std::int64_t exponent = most;
    if (digits.empty())
    {
      return std::nullopt;
    }
    ParseInteger(digits.data(), digits.data() + digits.size(), exponent);
    exponent = std::min(exponent, most);
    number.Exponent += isNegative ? -exponent : exponent;
  }
  if (!text.empty())
  {
    return std::nullopt;
  }
  const std::size_t first = number.Digits.find_first_not_of('0');
  if (first == std::string::npos)
  {
    number.Digits.clear();
    number.Exponent = 0;
    return number;
  }
  number.Digits.erase(number.Digits.find_last_not_of('0') + 1);
  number.Digits.erase(0, first);
  number.Exponent -= static_cast<std::int64_t>(first);
  return number;
}

//------------------------------------------------------------------------------
bool Decimal::IsAtMostPowerOfTen(int exponent) const
{
  return this->Exponent <= exponent || (this->Exponent == exponent + 1 && this->Digits == "1");
}

//------------------------------------------------------------------------------
std::string Decimal::GetInteger() const
{
  std::string text = this->Digits.empty() ? "0" : this->Digits;
  text.resize(std::max<std::size_t>(this->Exponent, 1), '0');
  return (this->IsNegative() ? "-" : "") + text;
}

//------------------------------------------------------------------------------
std::int64_t Decimal::GetPercentOf(std::int64_t whole) const
{
  if (this->Digits.empty())
  {
    return 0;
  }
  // The fraction is 0.0...0Digits, or exactly 1. From its last digit on, each step multiplies by a
  // digit and divides by ten; rounding down in between does not change the final integer part.
  constexpr int ofPercent = 2, allDigits = 18;
  const std::int64_t exponent = this->Exponent - ofPercent;
  if (exponent > 0)
  {
    return whole;
  }
  if (exponent < -allDigits)
  {
    return 0;
  }
  std::uint64_t result = 0;
  const auto multiply = [&](unsigned digit)
  { result = (static_cast<std::uint64_t>(whole) * digit + result) / 10; };
  std::for_each(this->Digits.rbegin(), this->Digits.rend(),
    [&](char digit) { multiply(static_cast<unsigned>(digit - '0')); });
  for (std::int64_t zero = exponent; zero < 0; ++zero)
  {
    multiply(0);
  }
  return static_cast<std::int64_t>(result);
}
}
