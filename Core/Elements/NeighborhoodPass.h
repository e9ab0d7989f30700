// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file NeighborhoodPass.h
 * @brief A parallel pass over the cells with facets, with their geometry and neighbors, and values
 * of facets for it.
 */
#ifndef camaron_NeighborhoodPass_h
#define camaron_NeighborhoodPass_h

#include "Cell/CellNeighborhood.h"
#include "Cell/FacetMeasures.h"
#include "Elements/ElementContext.h"

#include <cmath> // for std::isnan

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

// Finite volume measures as values of facets; NaN with a reason where they are not defined.

/// A value between two cells, which a facet at the boundary does not have.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double Inside(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  using Side = CellNeighborhood::Side;
  return facet.Other == Side::Cell
    ? Measure(cell, facet)
    : Null(facet.Other == Side::Missing   ? NullReason::MissingGhosts
          : facet.Other == Side::Boundary ? NullReason::NotApplicable
                                          : NullReason::InvalidTopology);
}

/// A value that is also defined at the boundary.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double InsideOrBoundary(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return facet.Other == CellNeighborhood::Side::Boundary ? Measure(cell, facet)
                                                         : Inside<Measure>(cell, facet);
}

/// A value that is only defined at the boundary.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double Boundary(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return facet.Other == CellNeighborhood::Side::Boundary ? Measure(cell, facet)
                                                         : Null(NullReason::NotApplicable);
}

/// The smaller pyramid (triangle) between the facet and a centroid, in units of the mesh.
template <int Dimension>
double PyramidSize(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return std::isnan(cell.GetSize())
    ? cell.GetSize()
    : cell.GetGeometry().ToMesh(GetFacePyramidVolume(cell, facet), Dimension);
}
}

#endif
