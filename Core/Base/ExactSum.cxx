// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ExactSum.h"

#include <cmath>

namespace camaron
{
namespace
{
constexpr std::int64_t LimbMask = 0xffffffffll;
constexpr int LimbBits = 32;
constexpr int MantissaBits = 53;
constexpr int SmallestExponent = -1074; // of the last bit of a denormal double

// Moves every limb but the last to [0, 2^32); shifts of negative numbers are arithmetic.
void Normalize(ExactSum::Limbs& limbs)
{
  for (std::size_t i = 0; i + 1 < limbs.size(); ++i)
  {
    limbs[i + 1] += limbs[i] >> LimbBits;
    limbs[i] &= LimbMask;
  }
}

// Adds value * 2^bit.
void AddShifted(ExactSum::Limbs& limbs, std::int64_t value, int bit)
{
  const int limb = bit / LimbBits;
  const int shift = bit % LimbBits;
  const std::int64_t low = (value & LimbMask) << shift; // below 2^63
  const std::int64_t high = (value >> LimbBits) * (std::int64_t(1) << shift);
  limbs[limb] += low & LimbMask;
  limbs[limb + 1] += (low >> LimbBits) + (high & LimbMask);
  limbs[limb + 2] += high >> LimbBits;
}

bool GetBit(const ExactSum::Limbs& limbs, int bit)
{
  return (limbs[bit / LimbBits] >> (bit % LimbBits)) & 1;
}
}

//------------------------------------------------------------------------------
void ExactSum::Flush()
{
  for (int exponent = 0; exponent < NumberOfBuckets; ++exponent)
  {
    Bucket& bucket = this->Buckets[exponent];
    if (bucket.Low != 0 || bucket.High != 0)
    {
      // Denormal numbers (exponent 0) have the same unit as those of exponent 1.
      const int bit = exponent == 0 ? 0 : exponent - 1;
      AddShifted(this->Total, bucket.Low, bit);
      AddShifted(this->Total, bucket.High, bit + LimbBits);
      bucket = Bucket();
    }
  }
  Normalize(this->Total);
  this->NumberOfAddends = 0;
}

//------------------------------------------------------------------------------
ExactSum::Limbs ExactSum::GetLimbs()
{
  this->Flush();
  return this->Total;
}

//------------------------------------------------------------------------------
double ExactSum::Divide(const Limbs& sum, std::int64_t divisor)
{
  Limbs limbs = sum;
  Normalize(limbs);
  const bool negative = limbs.back() < 0;
  if (negative)
  {
    for (std::int64_t& limb : limbs)
    {
      limb = -limb;
    }
    Normalize(limbs);
  }

  // Long division bit by bit: the mantissa receives the first bits of the quotient, the rest
  // decides on rounding. The remainder is less than the divisor, so twice the remainder fits.
  std::uint64_t remainder = 0, mantissa = 0;
  int exponent = SmallestExponent;
  int numberOfBits = 0;
  bool half = false, beyondHalf = false;
  for (int bit = static_cast<int>(limbs.size()) * LimbBits - 1; bit >= 0; --bit)
  {
    remainder = 2 * remainder + GetBit(limbs, bit);
    const bool quotientBit = remainder >= static_cast<std::uint64_t>(divisor);
    remainder -= quotientBit ? static_cast<std::uint64_t>(divisor) : 0;
    if (numberOfBits < MantissaBits)
    {
      mantissa = 2 * mantissa + quotientBit;
      numberOfBits += mantissa != 0;
      exponent = bit + SmallestExponent;
    }
    else if (bit == exponent - SmallestExponent - 1)
    {
      half = quotientBit;
    }
    else
    {
      beyondHalf = beyondHalf || quotientBit;
    }
  }
  const std::uint64_t twice = 2 * remainder;
  if (exponent == SmallestExponent)
  {
    // The mantissa extends to the last bit of the smallest double: only the remainder is left.
    half = twice >= static_cast<std::uint64_t>(divisor);
    beyondHalf = twice > static_cast<std::uint64_t>(divisor);
  }
  else
  {
    beyondHalf = beyondHalf || remainder != 0;
  }
  mantissa += half && (beyondHalf || (mantissa & 1)); // ties to even
  return std::ldexp(static_cast<double>(negative ? -static_cast<std::int64_t>(mantissa)
                                                 : static_cast<std::int64_t>(mantissa)),
    exponent);
}
}
