// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolygonOutline
 * @brief Distance of a position in 2D from the edges of a polygon, and whether it is inside.
 *
 * Uses a tree of bounding boxes of consecutive edges: the winding of the edges in a box beside a
 * position only depends on where they begin and end. Memory is reused for the next polygon.
 */
#ifndef camaron_PolygonOutline_h
#define camaron_PolygonOutline_h

#include "Geometry/BoxTree.h"

#include <cstddef> // for std::size_t
#include <limits>  // for infinity
#include <vector>  // for boxes

namespace camaron
{
class PolygonOutline
{
public:
  /// Vertices without Z; the caller must keep them.
  void Build(const std::vector<Vector>& corners);

  std::size_t GetSize() const { return this->Corners->size(); }
  const Vector& GetBegin(std::size_t edge) const { return (*this->Corners)[edge]; }
  const Vector& GetEnd(std::size_t edge) const
  {
    return (*this->Corners)[edge + 1 < this->GetSize() ? edge + 1 : 0];
  }

  /// Distance from the nearest edge, limited to @a limit and negative outside. A small limit speeds
  /// up the search.
  double GetSignedDistance(
    const Vector& point, double limit = std::numeric_limits<double>::infinity()) const;

  /// Calls @a visit(edge) for all edges within a distance, and for some others.
  template <typename Visit>
  void ForEachNear(const Vector& point, double distance, Visit&& visit) const
  {
    this->ForEach([&](const BoxTree::Node& node)
      { return node.Box.GetSquaredDistance(point) <= distance * distance; }, visit);
  }

private:
  double FindSquaredDistance(const Vector& point, double limit) const;
  bool IsInside(const Vector& point) const;

  template <typename Wants, typename Visit>
  void ForEach(Wants&& wants, Visit&& visit) const
  {
    this->Tree.FindAnyInNodes([&](std::size_t n) { return wants(this->Tree.GetNodes()[n]); },
      [&](std::size_t edge)
      {
        visit(edge);
        return false;
      });
  }

  const std::vector<Vector>* Corners = nullptr;
  std::vector<Bounds> Boxes;
  BoxTree Tree; ///< of consecutive edges
};
}

#endif
