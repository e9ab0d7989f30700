// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HalfSpace.h
 * @brief One side of a plane.
 */
#ifndef camaron_HalfSpace_h
#define camaron_HalfSpace_h

#include "Base/Vector.h"

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
}

#endif
