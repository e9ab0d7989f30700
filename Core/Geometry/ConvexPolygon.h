// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexPolygon
 * @brief A convex polygon in 2D that can be clipped by half-planes.
 *
 * Points have no Z and are counter-clockwise. Memory is reused for the next polygon.
 */
#ifndef camaron_ConvexPolygon_h
#define camaron_ConvexPolygon_h

#include "Geometry/HalfSpace.h"

#include <vector> // for points

namespace camaron
{
class ConvexPolygon
{
public:
  /// Starts with a rectangle.
  void SetBox(const Vector& low, const Vector& high);
  /**
   * Keeps the part inside the half-plane. Points within @a tolerance of its line count as on it; a
   * polygon without a point inside becomes empty.
   */
  void Clip(const HalfSpace& halfPlane, double tolerance);

  bool IsEmpty() const { return this->Points.empty(); }
  const std::vector<Vector>& GetPoints() const { return this->Points; }
  double GetArea() const;

private:
  std::vector<Vector> Points, Kept;
  std::vector<double> Distances;
};
}

#endif
