// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnFacets.h
 * @brief Visits facets in the order of a piece's own cells.
 *
 * Cells of other pieces between them have no influence, so elements have the same numbers in a
 * piece without ghost cells, with them, and in the completed piece.
 */
#ifndef camaron_OwnFacets_h
#define camaron_OwnFacets_h

#include "Mesh/FacetTable.h"

#include <vector> // for marks

namespace camaron
{
/// Calls @a visit(facet, cell) once for each facet of the cells with @a isOwn(cell), with the first
/// of these cells.
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
