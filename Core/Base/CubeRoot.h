// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CubeRoot.h
 * @brief Cube roots, two at a time where two are asked for.
 */
#ifndef camaron_CubeRoot_h
#define camaron_CubeRoot_h

#include "Base/VectorPair.h"

#include <cstdint> // for the bits of numbers
#include <cstring> // to get at them

namespace camaron
{
/// Cube roots of positive normal numbers, to the last bit or the one before.
inline Pair CubeRoot(Pair a)
{
  // A third of the exponent and of the mantissa, which is right to 3.2 %. The offset is two thirds
  // of the bits of 1, less what makes the errors on both sides equal.
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
  // Halley's steps make two thirds of its cube of a relative error: 2e-5, 7e-15, none.
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
