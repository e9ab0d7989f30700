// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::BoxTree
 * @brief Bounding volume hierarchy: finds boxes that satisfy a spatial condition.
 *
 * Built in O(n log n). Boxes can be removed later, but not added.
 */
#ifndef camaron_BoxTree_h
#define camaron_BoxTree_h

#include "Geometry/Bounds.h"

#include <cstddef> // for std::size_t
#include <vector>  // for boxes

namespace camaron
{
class BoxTree
{
public:
  /// @param sorts if false, boxes keep their order: neighbors in the list are neighbors in space
  void Build(const std::vector<Bounds>& boxes, bool sorts = true);
  /// Of a box around each point.
  void Build(const Vector* points, std::size_t size);

  bool IsEmpty() const { return this->Nodes.empty(); }
  /// Bounding box of all boxes, of which there must be at least one.
  const Bounds& GetBounds() const { return this->Nodes.front().Box; }
  /// The box at each position of the tree. Neighboring boxes have neighboring positions.
  const std::vector<std::size_t>& GetOrder() const { return this->Order; }

  /// Removes the box at a position; subtrees without remaining boxes are skipped.
  void LeaveOut(std::size_t place);

  /**
   * Calls @a visit(place) for the boxes in leaves that satisfy @a wants, until it returns true;
   * returns whether it did. @a wants(const Bounds&) must be true for every box that contains a box
   * with this property. Removed boxes, and others in the same leaf, may be visited.
   */
  template <typename Wants, typename Visit>
  bool FindAny(Wants&& wants, Visit&& visit) const
  {
    return this->FindAnyInNodes([&](std::size_t n) { return wants(this->Nodes[n].Box); }, visit);
  }
  /// The same with @a wants(std::size_t) for an index of GetNodes.
  template <typename Wants, typename Visit>
  bool FindAnyInNodes(Wants&& wants, Visit&& visit) const
  {
    for (std::size_t n = 0; n < this->Nodes.size();)
    {
      const Node& node = this->Nodes[n];
      if (node.Count == 0 || !wants(n))
      {
        n = node.Next;
        continue;
      }
      if (node.Next == n + 1)
      {
        for (std::size_t place = node.First; place < node.Last; ++place)
        {
          if (visit(place))
          {
            return true;
          }
        }
      }
      ++n;
    }
    return false;
  }

  /// A box around some boxes.
  struct Node
  {
    Bounds Box;
    std::size_t
      Next; ///< where to continue if nothing in it is needed; the index of a leaf plus one
    std::size_t First, Last; ///< positions
    std::size_t Count;       ///< number of boxes among them that are not removed
  };
  /// Parents before children, in the order of traversal.
  const std::vector<Node>& GetNodes() const { return this->Nodes; }

private:
  void AddNodes(const std::vector<Bounds>& boxes, std::size_t first, std::size_t last, bool sorts);

  std::vector<Node> Nodes;
  std::vector<std::size_t> Order;
};
}

#endif
