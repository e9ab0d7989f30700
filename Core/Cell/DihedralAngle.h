// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DihedralAngle.h
 * @brief The angle between two polygons at their common edge.
 */
#ifndef camaron_DihedralAngle_h
#define camaron_DihedralAngle_h

#include "Base/Vector.h"

#include <cmath> // for atan2

namespace camaron
{
constexpr double DihedralRounding = 1e-14; // of sines

/**
 * In radian, from 0 to 2 pi, on the side that the unit normals point away from.
 * @param along unit vector of the edge, in the direction in which the first polygon runs
 */
inline double GetDihedralAngle(const Vector& along, const Vector& normal0, const Vector& normal1)
{
  constexpr double halfTurn = 3.141592653589793238462643383279502884;
  const double sine = Dot(along, Cross(normal0, normal1));
  // Rounding must not turn an angle of 0 into one of 2 pi.
  return halfTurn - std::atan2(std::abs(sine) <= DihedralRounding ? 0 : sine, Dot(normal0, normal1));
}
}

#endif
