// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simplex.h
 * @brief Points, segments and triangles: how far they are from each other, and whether they cross.
 */
#ifndef camaron_Simplex_h
#define camaron_Simplex_h

#include "Base/Vector.h"
#include "Geometry/Bounds.h"

namespace camaron
{
/// A point, a segment or a triangle.
struct Simplex
{
  Vector Points[3];
  int Size = 0;

  Bounds GetBounds() const
  {
    Bounds bounds;
    for (int i = 0; i < this->Size; ++i)
    {
      bounds.Add(this->Points[i]);
    }
    return bounds;
  }
};

/// Squared distance of a point.
double GetSquaredDistance(const Vector& point, const Simplex& simplex);
/// Squared distance of two segments.
double GetSquaredDistance(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

/// Whether they have a point in common, or two that are no further apart than @a tolerance.
bool Touch(const Simplex& a, const Simplex& b, double tolerance);

/// Whether a segment or an edge of one goes through the inside of the other, a triangle, not just
/// to it.
bool Pierce(const Simplex& a, const Simplex& b);

/**
 * Whether the way from a point upwards (along Z) crosses a triangle. Of a closed surface an odd
 * number of triangles is crossed from inside, also where the way leads through their edges and
 * corners.
 */
bool IsAbove(const Simplex& triangle, const Vector& point);
}

#endif
