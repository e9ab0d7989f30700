// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FixedSum
 * @brief Adds numbers from 0 to 1 in units of 2^-62, so the sum does not depend on their order.
 *
 * Sums of up to 2^31 numbers are merged by adding their parts as integers. Takes 16 bytes, for sums
 * that are as numerous as their addends; ExactSum adds numbers of any size.
 */
#ifndef camaron_FixedSum_h
#define camaron_FixedSum_h

#include <cmath>   // for the integers of a number
#include <cstdint> // for 64 bit integers

namespace camaron
{
struct FixedSum
{
  std::int64_t High = 0; ///< in units of 2^-31
  std::int64_t Low = 0;  ///< in units of 2^-62

  void Add(double number)
  {
    const double scaled = std::ldexp(number, Bits);
    const double high = std::floor(scaled);
    this->High += static_cast<std::int64_t>(high);
    this->Low += static_cast<std::int64_t>(std::ldexp(scaled - high, Bits));
  }
  void Add(const FixedSum& other)
  {
    this->High += other.High;
    this->Low += other.Low;
  }
  double Get() const
  {
    return std::ldexp(static_cast<double>(this->High), -Bits) +
      std::ldexp(static_cast<double>(this->Low), -2 * Bits);
  }

private:
  static constexpr int Bits = 31;
};
}

#endif
