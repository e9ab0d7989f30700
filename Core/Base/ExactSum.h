// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ExactSum
 * @brief Adds doubles without rounding, so the sum does not depend on their order.
 *
 * A double is a 53-bit integer times one of 2046 powers of two. Add() adds that integer to the
 * bucket of its power, in about a nanosecond; GetLimbs() combines the buckets into one long
 * fixed-point number. Partial sums are merged by adding their limbs as integers, also across
 * ranks. Only finite values may be added.
 *
 * Based on R. M. Neal, Fast exact summation using small and large superaccumulators, 2015.
 */
#ifndef camaron_ExactSum_h
#define camaron_ExactSum_h

#include <array>   // for the limbs
#include <cmath>   // for the integers of a number
#include <cstdint> // for 64 bit integers
#include <cstring> // for the bits of a double
#include <vector>  // for the buckets

namespace camaron
{
class ExactSum
{
public:
  /**
   * Fixed-point number in units of 2^-1074: limb i counts 2^(32 i) units. 70 limbs store 2^63
   * values of the largest magnitude and a sign. Limbs may be added to those of other sums before
   * rounding, because each has 31 spare bits.
   */
  using Limbs = std::array<std::int64_t, 70>;

  /// Must be called before every @a count calls of Add (at most 2^30): propagates the carries.
  void Reserve(std::int64_t count)
  {
    this->NumberOfAddends += count;
    if (this->NumberOfAddends > MaximumOfAddends)
    {
      this->Flush();
      this->NumberOfAddends = count;
    }
  }

  void Add(double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    const std::uint64_t exponent = (bits >> 52) & 0x7ff;
    const std::uint64_t mantissa =
      (bits & 0x000fffffffffffffull) | (static_cast<std::uint64_t>(exponent != 0) << 52);
    // All ones for a negative value: (m ^ sign) - sign is then -m.
    const std::int64_t sign = -static_cast<std::int64_t>(bits >> 63);
    Bucket& bucket = this->Buckets[exponent];
    bucket.Low += (static_cast<std::int64_t>(mantissa & 0xffffffffull) ^ sign) - sign;
    bucket.High += (static_cast<std::int64_t>(mantissa >> 32) ^ sign) - sign;
  }

  /// The current sum; each limb but the last is in [0, 2^32), the last one has the sign.
  Limbs GetLimbs();

  /// The nearest double, ties to even; infinite if out of range.
  static double Round(const Limbs& limbs) { return Divide(limbs, 1); }
  /// The double nearest to the number divided by @a divisor, which must be positive.
  static double Divide(const Limbs& limbs, std::int64_t divisor);

private:
  // Halves of the integers of one power of two: sums of 2^30 of them fit into 64 bits.
  struct Bucket
  {
    std::int64_t Low = 0;
    std::int64_t High = 0;
  };
  static constexpr int NumberOfBuckets = 2048;
  static constexpr std::int64_t MaximumOfAddends = std::int64_t(1) << 30;

  void Flush();

  std::vector<Bucket> Buckets = std::vector<Bucket>(NumberOfBuckets);
  std::int64_t NumberOfAddends = 0;
  Limbs Total = {};
};

/**
 * Adds numbers from 0 to 1 in units of 2^-62, so the sum does not depend on their order.
 *
 * Sums of up to 2^31 numbers are merged by adding their parts as integers. Takes 16 bytes, for sums
 * that are as numerous as their addends; ExactSum adds numbers of any size.
 */
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
