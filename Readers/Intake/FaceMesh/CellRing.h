// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellRing
 * @brief The points of a polygon in order, from its edges in any order.
 *
 * Contains scratch memory: use one per thread.
 */
#ifndef camaron_CellRing_h
#define camaron_CellRing_h

#include "Intake/FaceMesh/PrimitiveMatcher.h"

#include <vector> // for points

namespace camaron
{
class CellRing
{
public:
  /// Finds a ring of the edges, which have the polygon on the left if they point inward: it starts
  /// with the first edge, and is counterclockwise then. False if they do not form a closed ring.
  bool Make(const IdList* edges, const FaceDirection* directions, std::int32_t count);

  /// As many as there are edges; edges with the same point at both ends repeat it.
  const std::vector<std::int32_t>& GetPoints() const { return this->Points; }

private:
  struct Edge
  {
    std::int32_t From, To;
  };
  bool FollowEdges();
  bool InsertLoops();

  std::vector<Edge> Edges;
  std::vector<std::int32_t> Used;  ///< by the first edge or loop of a point, how many are passed
  std::vector<std::int32_t> Loops; ///< points with an edge to themselves
  std::vector<std::int32_t> Points, Scratch;
};
}

#endif
