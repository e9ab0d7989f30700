// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::EarCutter
 * @brief Cuts a polygon in the plane into triangles, also one that touches itself.
 *
 * The polygon may come to a corner more than once, touch itself along edges, and have bridges to
 * holes, cracks and spikes, but not cross itself: no place lies within it more than once. Triangles
 * that all run the same way then cover it exactly once, however its corners lie. So an ear, the
 * triangle of a corner and the two beside it, may be cut off if nothing of the polygon lies in it.
 * The best of these is cut off first.
 *
 * Only corners that are not convex can lie in an ear (or on its sides with an edge that leads into
 * it). A tree of boxes finds them: O(n sqrt(n)) at worst in practice, O(n log n) mostly. Holds
 * scratch memory: use one per thread.
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
   * @a flat: @a size corners, three or more, that run counter-clockwise; Z is 0. Lengths up to @a
   * tolerance are taken for rounding. @a places: the same corners in space, where triangles are to
   * be good. There are size - 2 triangles, some without an area if the polygon makes them so. All
   * others run as the polygon does, but where it crosses itself.
   */
  void Cut(const Vector* flat, const Vector* places, int size, double tolerance,
    std::vector<Triangle>& triangles);

private:
  struct Corner
  {
    int Previous, Next;
    int Stamp = 0;          ///< of the entry in the queue that is up to date
    int PlaceInTree = -1;   ///< of those that are not strictly convex
    bool IsCut = false;     ///< off, and no corner any more
    bool IsFull = false;    ///< all around it is inside: the end of a crack
    bool IsOutside = false; ///< on a spike, or on a bridge outside of the polygon
  };
  /// Priority, then what tells two of the same priority apart, then the stamp.
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
  BoxTree Tree; ///< of the corners that are not convex
  std::vector<int> InTree;
  std::vector<Bounds> Boxes;
  std::vector<int> Ring;
  OutsideSlits Slits;
  std::vector<Entry> Waiting, Blocked; ///< heaps
  int TriedAgain = 0;
  bool HasCutSince = false; ///< blocked ears were tried again
};
}

#endif
