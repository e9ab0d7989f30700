// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NeighborhoodPass.h
 * @brief A parallel pass over the cells with facets, with their geometry and neighbors.
 */
#ifndef camaron_NeighborhoodPass_h
#define camaron_NeighborhoodPass_h

#include "Cell/CellNeighborhood.h"
#include "Elements/ElementContext.h"

namespace camaron
{
/**
 * Calls @a visit(id, uses, cell, neighborhood) for the cells with facets in @a table, except those
 * with nonfinite coordinates, while ElementContext::GoesOn. Called by several threads for
 * different cells.
 * @param uses FacetTable::Range of the cell
 * @param cell CellGeometry, normalized, with CellNeighborhood::BaseNeeds and @a needs
 * @param neighborhood CellNeighborhood
 */
template <typename Visit>
void ForEachNeighborhood(
  const ElementContext& context, const FacetTable& table, unsigned needs, Visit&& visit)
{
  const MeshView& mesh = context.GetMesh();
  EvaluationOptions options = context.GetOptions();
  options.Ghosts = context.IsComplete() ? nullptr : options.Ghosts;
  constexpr double centerTime = 0.4; // approximate fraction of the time
  CellCenters centers(mesh.GetNumberOfCells());
  {
    const ElementContext::Step step(context, 0, centerTime);
    context.ForCells(
      [&](vtkIdType begin, vtkIdType end)
      {
        CellGeometry cell;
        for (vtkIdType id = begin; id < end; ++id)
        {
          GetCellCenter(mesh, id, options, cell, centers.Centroids[id], centers.Sizes[id]);
        }
      });
  }
  const ElementContext::Step step(context, centerTime, 1);
  const CellNeighborhood prototype(context.GetTopology(), centers, options);
  context.ForCells(
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      CellNeighborhood neighborhood = prototype;
      for (vtkIdType id = begin; id < end; ++id)
      {
        const FacetTable::Range uses = table.GetCellFacets(id);
        cell.Load(mesh, id, options);
        cell.Normalize();
        if (uses.size() == 0 || !cell.IsFinite())
        {
          continue;
        }
        cell.Compute(CellNeighborhood::BaseNeeds | needs);
        neighborhood.Load(id, cell);
        visit(id, uses, cell, neighborhood);
      }
    });
}
}

#endif
