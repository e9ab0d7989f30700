// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Orientation.h
 * @brief On which side of a line in the plane a point lies, without rounding.
 */
#ifndef camaron_Orientation_h
#define camaron_Orientation_h

#include "Base/Vector.h"

#include <cmath> // for std::abs

namespace camaron
{
/// Orient where the rounded product is too small to trust.
double OrientExactly(const Vector& a, const Vector& b, const Vector& c);

/**
 * Twice the area of a triangle in the plane: positive if it runs counter-clockwise, 0 if and only
 * if the points lie on a line. The sign is exact, the value rounded. Z does not count.
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
