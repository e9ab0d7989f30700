// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LargestCircle
 * @brief Finds the largest circle within a polygon, convex or not.
 *
 * Squares are searched, the most promising first, and cut into four. No circle about a point of a
 * square is larger than the one about its middle by more than half a diagonal; nor larger than the
 * largest circle between those edges and reflex corners that bound the distance over the whole
 * square, which ends the search also where equally large circles have their centers along a line.
 * Such a circle is also tried.
 *
 * Holds its memory for the next polygon.
 */
#ifndef camaron_LargestCircle_h
#define camaron_LargestCircle_h

#include "Geometry/Ball.h"
#include "Geometry/PolygonOutline.h"

#include <vector> // for squares

namespace camaron
{
class LargestCircle
{
public:
  /**
   * The circle within the polygon with these corners (no Z, in order, either way round), up to
   * 1e-10 of the polygon's size; less exact only for polygons that need more than 20000 squares.
   * Radius 0 if nothing lies inside.
   */
  Ball Find(const std::vector<Vector>& polygon);

private:
  struct Square
  {
    Vector Center;
    double Half;
    double Distance; ///< of the center from the outline
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
