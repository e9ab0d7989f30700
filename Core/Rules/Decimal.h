// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Decimal
 * @brief A decimal number with all its digits, for exact arithmetic.
 */
#ifndef camaron_Decimal_h
#define camaron_Decimal_h

#include <cstdint>     // for counts
#include <optional>    // for failures
#include <string>      // for digits
#include <string_view> // for text

namespace camaron
{
class Decimal
{
public:
  /// The number of a text: digits with an optional sign, point and exponent (e, E, d or D).
  static std::optional<Decimal> Parse(std::string_view text);

  bool IsNegative() const { return this->Negative && !this->Digits.empty(); }
  bool IsInteger() const
  {
    return this->Exponent >= static_cast<std::int64_t>(this->Digits.size());
  }
  /// Whether the magnitude is at most a power of ten.
  bool IsAtMostPowerOfTen(int exponent) const;

  /// The number without point and exponent; for integers of at most 30 digits.
  std::string GetInteger() const;
  /// The integer part of this fraction of @a whole, in percent: floor(whole * number / 100), for 0
  /// to 100 percent of at most 10^18.
  std::int64_t GetPercentOf(std::int64_t whole) const;

private:
  // The number is 0.Digits * 10^Exponent; Digits starts and ends with another digit than 0.
  std::string Digits;
  std::int64_t Exponent = 0;
  bool Negative = false;
};
}

#endif
