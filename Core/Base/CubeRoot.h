// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CubeRoot.h
 * @brief Cube roots, of single numbers or pairs.
 */
#ifndef camaron_CubeRoot_h
#define camaron_CubeRoot_h

#include "Base/VectorPair.h"

#include <cstdint> // for the bits of numbers
#include <cstring> // for std::memcpy

namespace camaron
{
/// Cube roots of positive normal numbers, correct to one unit in the last place.
inline Pair CubeRoot(Pair a)
{
  // Dividing exponent and mantissa by three gives a start value with a relative error of 3.2 %. The
  // offset is two thirds of the bits of 1, adjusted so that the errors on both sides are equal.
  const auto getFirst = [](double value)
  {
    constexpr std::uint64_t offset = 0x2a9f7893782da1ceull;
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    bits = bits / 3 + offset;
    std::memcpy(&value, &bits, sizeof(bits));
    return value;
  };
  Pair root = MakePair(getFirst(a[0]), getFirst(a[1]));
  // A step of Halley's method reduces a relative error to two thirds of its cube: 2e-5, 7e-15,
  // none.
  for (int step = 0; step < 3; ++step)
  {
    const Pair cube = root * root * root;
    root = root - root * ((cube - a) / (cube + cube + a));
  }
  return root;
}
inline double CubeRoot(double a)
{
  return CubeRoot(MakePair(a, a))[0];
}
}

#endif
