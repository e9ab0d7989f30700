// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LargestCircle
 * @brief Finds the largest circle inside a polygon, convex or not.
 *
 * Searches squares, the most promising first, and divides them into four. A circle centered in a
 * square is at most half a diagonal larger than the one at its center. It is also at most as large
 * as the largest circle between the edges and reflex vertices that bound the distance everywhere
 * in the square; this bound ends the search even if equally large circles have their centers along
 * a line, and this circle is tried, too.
 *
 * Memory is reused for the next polygon.
 */
#ifndef camaron_LargestCircle_h
#define camaron_LargestCircle_h

#include "Geometry/HalfSpace.h"
#include "Geometry/PolygonOutline.h"

#include <vector> // for squares

namespace camaron
{
class LargestCircle
{
public:
  /**
   * The largest circle inside the polygon with these vertices (without Z, in either direction),
   * accurate to 1e-10 of the polygon's size, or less for polygons that need more than 20000
   * squares. Radius 0 if the polygon has no interior.
   */
  Ball Find(const std::vector<Vector>& polygon);

private:
  struct Square
  {
    Vector Center;
    double Half;
    double Distance; ///< distance of the center from the outline
    double Bound;
    bool operator<(const Square& other) const { return this->Bound < other.Bound; }
  };
  double Try(const Vector& center, double limit);
  void AddSquare(const Vector& center, double half, double limit);
  void FindFeatures(const Vector& center, double half, double nearest);
  void AddFeatures(const Vector& center, double half, const Vector& a, const Vector& b);

  PolygonOutline Outline;
  Ball Around, Best;
  double Precision = 0;
  std::vector<Square> Squares; // a heap
  std::vector<HalfSpace> Features;
};
}

#endif
