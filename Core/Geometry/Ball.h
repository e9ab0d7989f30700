// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ball.h
 * @brief The largest ball within half-spaces and the smallest one around points.
 *
 * In the plane, with no Z, balls are circles.
 */
#ifndef camaron_Ball_h
#define camaron_Ball_h

#include "Geometry/HalfSpace.h"

#include <vector> // for half-spaces and points

namespace camaron
{
struct Ball
{
  Vector Center;
  double Radius = 0;
};

/**
 * Largest ball within all half-spaces (its center is that of Chebyshev; where several balls are
 * equally large, one of them). The radius is negative where the half-spaces have no point in
 * common: then the ball is the one that is least far outside of any.
 *
 * Dual simplex method: some sets of @a dimension + 1 half-spaces, each with the whole list looked
 * through once.
 *
 * @param dimension 2 or 3
 * @param around a ball in which the answer has its center, such as the bounding sphere of the cell
 */
Ball FindLargestBall(const std::vector<HalfSpace>& halfSpaces, int dimension, const Ball& around);

/**
 * Smallest ball around all points; radius 0 for none. Welzl's algorithm, for which the points are
 * shuffled, always in the same way: the time is linear in their number but for rare cases.
 */
Ball FindSmallestBall(std::vector<Vector>& points);
}

#endif
