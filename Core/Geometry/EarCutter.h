// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::EarCutter
 * @brief Triangulates a polygon in 2D, even if it touches itself.
 *
 * The polygon may visit a vertex more than once, touch itself along edges, and have bridges to
 * holes, cracks and spikes, but must not intersect itself: no position is inside it more than
 * once. Triangles with the same orientation then cover it exactly once. An ear, the triangle of a
 * vertex and its two neighbors, may be cut off if no other part of the polygon is inside it. The
 * best ear is cut off first.
 *
 * Only non-convex vertices can be inside an ear (or on its sides with an edge leading into it). A
 * tree of boxes finds them: O(n sqrt(n)) in the worst case in practice, usually O(n log n). Holds
 * scratch memory: use one object per thread.
 */
#ifndef camaron_EarCutter_h
#define camaron_EarCutter_h

#include "Base/Vector.h"
#include "Geometry/BoxTree.h"

#include <array>  // for triangles
#include <cmath>  // for std::abs
#include <vector> // for scratch

namespace camaron
{
/**
 * Finds the vertices of a polygon in 2D on spikes and on bridges outside of it.
 *
 * If a polygon traverses edges in both directions, and nothing else, both sides of these edges are
 * alike: inside the polygon at a crack or at a bridge to a hole, outside at a spike or at a bridge
 * to another part. Only the ends of these edges decide which. Holds scratch memory.
 */
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

/// Orient if the rounded product is too small to be reliable.
double OrientExactly(const Vector& a, const Vector& b, const Vector& c);

/**
 * Twice the area of a triangle in 2D: positive if counter-clockwise, 0 if and only if the points
 * are collinear. The sign is exact, the value is rounded. Z is ignored.
 */
inline double Orient(const Vector& a, const Vector& b, const Vector& c)
{
  // Shewchuk (1997), Adaptive Precision Floating-Point Arithmetic: (3 + 16 u) u, with u = 2^-53.
  constexpr double errorBound = 3.3306690738754716e-16;
  const double left = (b.X - a.X) * (c.Y - a.Y), right = (b.Y - a.Y) * (c.X - a.X);
  const double area = left - right, error = errorBound * (std::abs(left) + std::abs(right));
  return std::abs(area) > error ? area : OrientExactly(a, b, c);
}

class EarCutter
{
public:
  using Triangle = std::array<int, 3>;

  /**
   * @param flat @a size vertices, at least three, counter-clockwise; Z is 0
   * @param places the same vertices in 3D, where triangles should be well shaped
   * @param tolerance lengths up to this are considered roundoff
   * Creates size - 2 triangles; some have no area if the polygon requires it. All others have the
   * orientation of the polygon, unless it intersects itself.
   */
  void Cut(const Vector* flat, const Vector* places, int size, double tolerance,
    std::vector<Triangle>& triangles);

private:
  struct Corner
  {
    int Previous, Next;
    int Stamp = 0;          ///< stamp of the current entry in the queue
    int PlaceInTree = -1;   ///< of vertices that are not strictly convex
    bool IsCut = false;     ///< cut off, no longer a vertex
    bool IsFull = false;    ///< completely surrounded by the polygon: the end of a crack
    bool IsOutside = false; ///< on a spike, or on a bridge outside of the polygon
  };
  /// Priority, then the tie-breaker, then the stamp.
  struct Entry
  {
    double Quality;
    int Corner, Stamp;
    bool operator<(const Entry& other) const
    {
      return this->Quality != other.Quality ? this->Quality < other.Quality
                                            : this->Corner > other.Corner;
    }
  };

  double GetHeight(int corner) const;
  double GetQuality(int corner) const;
  bool TurnsBack(int corner) const;
  void LinkCorners(int size);
  void CutRepeated();
  void MarkSpikes();
  void BuildTree();
  void Queue(int corner);
  bool IsFree(int corner) const;
  void CutOff(int corner);
  void CutBest();
  int TakeUpToDate(std::vector<Entry>& heap, double& quality);

  const Vector* Flat = nullptr;
  const Vector* Places = nullptr;
  double Tolerance = 0;
  std::vector<Triangle>* Triangles = nullptr;
  std::vector<Corner> Corners;
  int NumberLeft = 0, AnyLeft = 0;
  BoxTree Tree; ///< of non-convex vertices
  std::vector<int> InTree;
  std::vector<Bounds> Boxes;
  std::vector<int> Ring;
  OutsideSlits Slits;
  std::vector<Entry> Waiting, Blocked; ///< heaps
  int TriedAgain = 0;
  bool HasCutSince = false; ///< blocked ears have been tried again
};
}

#endif
