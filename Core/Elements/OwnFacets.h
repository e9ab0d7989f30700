// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnFacets.h
 * @brief Facets in the order of the cells that are a piece's own.
 *
 * Cells of other pieces, which may stand between them, change nothing: elements have the same
 * numbers in a piece, with ghost cells or without, and in that piece completed by those of its
 * neighbors.
 */
#ifndef camaron_OwnFacets_h
#define camaron_OwnFacets_h

#include "Mesh/FacetTable.h"

#include <vector> // for marks

namespace camaron
{
/// Calls @a visit(facet, cell) once for each facet that a cell has for which @a isOwn(cell), with
/// the first of these.
template <typename IsOwn, typename Visit>
void ForEachOwnFacet(const FacetTable& table, IsOwn&& isOwn, Visit&& visit)
{
  std::vector<bool> isVisited(static_cast<std::size_t>(table.GetNumberOfFacets()), false);
  for (Index cell = 0; cell < table.GetNumberOfCells(); ++cell)
  {
    if (!isOwn(cell))
    {
      continue;
    }
    for (const CellFacet use : table.GetCellFacets(cell))
    {
      if (!isVisited[use.Facet()])
      {
        isVisited[use.Facet()] = true;
        visit(use.Facet(), cell);
      }
    }
  }
}
}

#endif
