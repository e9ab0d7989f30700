// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexPolygon
 * @brief A convex polygon in the plane, from which half-planes cut parts off.
 *
 * Points have no Z and run counter-clockwise. Holds its memory for the next polygon.
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
   * Keeps what lies within the half-plane. Points no further than @a tolerance from its line count
   * as on it; a polygon of which no point is inside becomes empty.
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
