// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementVertices
 * @brief Ids of the points of cells, gathered on all processes.
 *
 * A point is identified by its global id if all points have one, else by VTK's id in its block. If
 * a block is split into several pieces, ids inside a piece are meaningless elsewhere, so its points
 * have no ids.
 */
#ifndef camaron_ElementVertices_h
#define camaron_ElementVertices_h

#include "ElementBlocks.h"
#include "Statistics/Worst.h"

#include <set>    // for blocks
#include <string> // for names
#include <vector> // for lists

namespace camaron
{
class ElementVertices
{
public:
  /// Collective. Stores references to both arguments.
  ElementVertices(const ElementBlocks& blocks, Reducer& reducer);

  /**
   * Collective. For each element of @a values the ids of its points, separated by blanks, in the
   * order of the cell; ascending for polyhedra, whose points have no order. Empty if the points
   * have no ids, and for elements that are points.
   */
  std::vector<std::string> Find(
    const std::vector<WorstElement>& elements, const BlockValues& values) const;

private:
  std::string Describe(const ElementBlock& block, vtkIdType cell) const;

  const ElementBlocks& Blocks;
  camaron::Reducer& Reducer;
  bool HaveGlobalIds = false;
  std::set<int> BlocksInOnePiece; // numbers of the blocks that are not split
};
}

#endif
