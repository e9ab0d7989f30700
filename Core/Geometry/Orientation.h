// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Orientation.h
 * @brief Exact test on which side of a line in 2D a point is.
 */
#ifndef camaron_Orientation_h
#define camaron_Orientation_h

#include "Base/Vector.h"

#include <cmath> // for std::abs

namespace camaron
{
/// Orient if the rounded product is too small to be reliable.
double OrientExactly(const Vector& a, const Vector& b, const Vector& c);

/**
 * Twice the area of a triangle in 2D: positive if counter-clockwise, 0 if and only if the points
 * are collinear. The sign is exact, the value is rounded. Z is ignored.
 */
inline double Orient(const Vector& a, const Vector& b, const Vector& c)
{
  // Shewchuk (1997), Adaptive Precision Floating-Point Arithmetic: (3 + 16 u) u, with u = 2^-53.
  constexpr double errorBound = 3.3306690738754716e-16;
  const double left = (b.X - a.X) * (c.Y - a.Y), right = (b.Y - a.Y) * (c.X - a.X);
  const double area = left - right, error = errorBound * (std::abs(left) + std::abs(right));
  return std::abs(area) > error ? area : OrientExactly(a, b, c);
}
}

#endif
