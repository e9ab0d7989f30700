// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ElementVertices
 * @brief Names the points of cells, told to all processes.
 *
 * A point has its global id if all points have one. Else it has VTK's id in its block, if that is
 * in one piece; the numbers of points in a piece of a block mean nothing to anybody else, so there
 * the points have no names.
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
  /// Collective. Borrows all.
  ElementVertices(const ElementBlocks& blocks, Reducer& reducer);

  /**
   * Collective. For each element, of @a values, the ids of its points separated by blanks, in the
   * order of the cell; those of polyhedra, which have none, ascending. Empty without names, and for
   * points.
   */
  std::vector<std::string> Find(
    const std::vector<WorstElement>& elements, const BlockValues& values) const;

private:
  std::string Describe(const ElementBlock& block, vtkIdType cell) const;

  const ElementBlocks& Blocks;
  camaron::Reducer& Reducer;
  bool HaveGlobalIds = false;
  std::set<int> BlocksInOnePiece; // their numbers
};
}

#endif
