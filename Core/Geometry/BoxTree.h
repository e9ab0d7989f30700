// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::BoxTree
 * @brief Finds those of many boxes that are where something is wanted.
 *
 * Built in O(n log n). Boxes can be left out later on, not added.
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
  void Build(const std::vector<Bounds>& boxes);

  bool IsEmpty() const { return this->Nodes.empty(); }
  /// Around all boxes; there is one.
  const Bounds& GetBounds() const { return this->Nodes.front().Box; }
  /// The box at each place of the tree. Boxes that lie close together have places close together.
  const std::vector<std::size_t>& GetOrder() const { return this->Order; }

  /// Leaves out the box at a place: where all boxes around it are left out, nothing is looked for.
  void LeaveOut(std::size_t place);

  /**
   * Calls @a visit(place) for the boxes in leaves that are wanted until it returns true, and tells
   * whether it did.
   * @a wants(const Bounds&) has to be true for a box around one that is wanted. Boxes that are left
   * out, and others in the same leaf, may be visited.
   */
  template <typename Wants, typename Visit>
  bool FindAny(Wants&& wants, Visit&& visit) const
  {
    return this->FindAnyInNodes([&](std::size_t n) { return wants(this->Nodes[n].Box); }, visit);
  }
  /// The same where @a wants(std::size_t) is about one of GetNodes.
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
    std::size_t Next; ///< where to go on in the list if nothing in it is wanted; one more than its
                      ///< own place for a leaf
    std::size_t First, Last; ///< places
    std::size_t Count;       ///< of those, the ones that are not left out
  };
  /// Parents before children, in the order in which they are looked at.
  const std::vector<Node>& GetNodes() const { return this->Nodes; }

private:
  void AddNodes(const std::vector<Bounds>& boxes, std::size_t first, std::size_t last);

  std::vector<Node> Nodes;
  std::vector<std::size_t> Order;
};
}

#endif
