// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfSpaceTesting.h
 * @brief What the tests of kernels and balls share: the point of three planes.
 */
#ifndef camaron_HalfSpaceTesting_h
#define camaron_HalfSpaceTesting_h

#include "Base/Vector.h"
#include "Geometry/HalfSpace.h"

#include <cmath>

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
// Cramer's rule.
inline bool Intersect(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, Vector& point)
{
  const double volume = Dot(a.Normal, Cross(b.Normal, c.Normal));
  if (std::abs(volume) < 1e-9)
  {
    return false;
  }
  point = (1 / volume) *
    (a.Offset * Cross(b.Normal, c.Normal) + b.Offset * Cross(c.Normal, a.Normal) +
      c.Offset * Cross(a.Normal, b.Normal));
  return true;
}
}
}

#endif
