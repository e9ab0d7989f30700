// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Simplex.h
 * @brief Distances and intersections of points, segments and triangles.
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

/// Squared distance of a point from a simplex.
double GetSquaredDistance(const Vector& point, const Simplex& simplex);
/// Squared distance of two segments.
double GetSquaredDistance(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

/// Whether two simplices intersect or are no further apart than @a tolerance.
bool Touch(const Simplex& a, const Simplex& b, double tolerance);

/// Whether a segment, or an edge of one, passes through the interior of the other, a triangle;
/// touching does not count.
bool Pierce(const Simplex& a, const Simplex& b);

/**
 * Whether the ray from a point upwards (along Z) crosses a triangle. From inside a closed surface,
 * it crosses an odd number of triangles, even if it passes through edges and vertices.
 */
bool IsAbove(const Simplex& triangle, const Vector& point);
}

#endif
