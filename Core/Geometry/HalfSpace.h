// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfSpace.h
 * @brief Half-spaces, the largest ball inside them, and the smallest ball around points.
 */
#ifndef camaron_HalfSpace_h
#define camaron_HalfSpace_h

#include "Base/Vector.h"

#include <vector> // for half-spaces and points

namespace camaron
{
/// The points p with Dot(Normal, p) <= Offset. In 2D, normals and points have no Z.
struct HalfSpace
{
  Vector Normal; ///< unit vector, outward
  double Offset = 0;

  /// Signed distance of a point; positive outside.
  double GetDistance(const Vector& point) const { return Dot(this->Normal, point) - this->Offset; }
};

struct Ball
{
  Vector Center;
  double Radius = 0;
};

/**
 * Largest ball inside all half-spaces, whose center is the Chebyshev center; if several balls are
 * equally large, one of them. A negative radius means that the half-spaces have no common point;
 * the ball then minimizes the maximum distance to them.
 *
 * Dual simplex method: tests a sequence of sets of @a dimension + 1 half-spaces, each with one
 * pass over the whole list.
 *
 * @param dimension 2 or 3
 * @param around a ball that contains the center of the result, such as the bounding sphere of the
 * cell
 */
Ball FindLargestBall(const std::vector<HalfSpace>& halfSpaces, int dimension, const Ball& around);

/**
 * Smallest ball around all points; radius 0 without points. Welzl's algorithm with a fixed shuffle
 * of the points; time is linear in their number except in rare cases.
 */
Ball FindSmallestBall(std::vector<Vector>& points);
}

#endif
