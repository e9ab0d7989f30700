// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacetValues.h
 * @brief What finite volumes ask of a facet, as values of that facet: null, with a reason, where
 * they ask nothing.
 */
#ifndef camaron_FacetValues_h
#define camaron_FacetValues_h

#include "Cell/FacetMeasures.h"

#include <cmath> // for std::isnan

namespace camaron
{
/// A value between two cells; null where there is no other.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double Inside(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  using Side = CellNeighborhood::Side;
  return facet.Other == Side::Cell
    ? Measure(cell, facet)
    : Null(facet.Other == Side::Missing   ? NullReason::MissingGhosts
          : facet.Other == Side::Boundary ? NullReason::NoNeighbor
                                          : NullReason::InvalidTopology);
}

/// A value that takes the boundary into account.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double InsideOrBoundary(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return facet.Other == CellNeighborhood::Side::Boundary ? Measure(cell, facet)
                                                         : Inside<Measure>(cell, facet);
}

/// A value of the boundary only.
template <double (*Measure)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
double Boundary(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return facet.Other == CellNeighborhood::Side::Boundary ? Measure(cell, facet)
                                                         : Null(NullReason::NotApplicable);
}

/// The smaller pyramid, or triangle, of the facet and the centroids, in units of the mesh.
template <int Dimension>
double PyramidSize(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet)
{
  return std::isnan(cell.GetSize())
    ? cell.GetSize()
    : cell.GetGeometry().ToMesh(GetFacePyramidVolume(cell, facet), Dimension);
}
}

#endif
