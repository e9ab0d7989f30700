// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LengthUnit.h
 * @brief Units for what is so large or small that squares of lengths leave the range of numbers.
 */
#ifndef camaron_LengthUnit_h
#define camaron_LengthUnit_h

#include "Base/Vector.h"

#include <algorithm> // for std::max
#include <cmath>     // for std::ldexp

namespace camaron
{
/// Length of the longest component.
inline double GetLargestComponent(const Vector& a)
{
  return std::max({ std::abs(a.X), std::abs(a.Y), std::abs(a.Z) });
}

/// The vector times 2^exponent, exactly.
inline Vector TimesPowerOfTwo(const Vector& a, int exponent)
{
  return { std::ldexp(a.X, exponent), std::ldexp(a.Y, exponent), std::ldexp(a.Z, exponent) };
}

/// Exponent of the power of two that is the unit of something of such a length; 0 if the length is usual.
inline int GetUnitExponent(double length)
{
  constexpr double Smallest = 1e-30, Largest = 1e30; // products of ten lengths are numbers
  const bool isUsual = length > Smallest && length < Largest;
  return isUsual || !(length > 0) || !std::isfinite(length) ? 0 : std::ilogb(length);
}
}

#endif
