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

#include "Geometry/BoxTree.h"
#include "Geometry/OutsideSlits.h"

#include <array>  // for triangles
#include <vector> // for scratch

namespace camaron
{
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
