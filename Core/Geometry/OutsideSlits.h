// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OutsideSlits
 * @brief Finds the vertices of a polygon in 2D on spikes and on bridges outside of it.
 *
 * If a polygon traverses edges in both directions, and nothing else, both sides of these edges are
 * alike: inside the polygon at a crack or at a bridge to a hole, outside at a spike or at a bridge
 * to another part. Only the ends of these edges decide which. Holds scratch memory.
 */
#ifndef camaron_OutsideSlits_h
#define camaron_OutsideSlits_h

#include "Base/Vector.h"

#include <vector> // for the polygon

namespace camaron
{
class OutsideSlits
{
public:
  /// Positions of such vertices in @a ring, if any; the polygon visits @a points with these indices
  /// counter-clockwise. Lengths up to @a tolerance are considered roundoff.
  const std::vector<int>& Find(
    const Vector* points, const std::vector<int>& ring, double tolerance);

private:
  struct Spoke
  {
    const Vector* End;
    int Edge;
    bool IsOutgoing;
  };
  const Vector& GetPoint(int place) const { return this->Points[(*this->Ring)[place]]; }
  int GetPrevious(int place) const;
  int GetNext(int place) const;
  bool IsSameDirection(const Vector& middle, const Vector& a, const Vector& b) const;
  bool IsTip(int place) const;
  bool FindSides(const Vector& middle);
  void FindOutside();

  const Vector* Points = nullptr;
  double Tolerance = 0;
  const std::vector<int>* Ring = nullptr;
  std::vector<int> Order, Found, Unclear;
  std::vector<Spoke> Spokes;
  std::vector<signed char> Sides; ///< left side of edges: 1 inside, 0 outside, -1 unknown
};
}

#endif
