// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::OutsideSlits
 * @brief Finds the corners of a polygon in the plane that lie on spikes and on bridges outside of
 * it.
 *
 * Where a polygon comes and goes along the same edges, and has nothing else there, both sides of
 * them are alike: inside of the polygon, as at a crack or at a bridge to a hole, or outside, as at
 * a spike or at a bridge to another part of it. That shows only at the ends of these edges. Holds
 * scratch memory.
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
  /// Where in @a ring such corners are, if any; the polygon runs counter-clockwise through @a
  /// points of these numbers. Lengths up to
  /// @a tolerance are taken for rounding.
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
  std::vector<signed char> Sides; ///< of edges, on the left: 1 inside, 0 outside, -1 not known
};
}

#endif
