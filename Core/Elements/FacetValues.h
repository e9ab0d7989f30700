// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacetValues.h
 * @brief Finite volume measures as values of facets; NaN with a reason where they are not defined.
 */
#ifndef camaron_FacetValues_h
#define camaron_FacetValues_h

#include "Cell/FacetMeasures.h"

#include <cmath> // for std::isnan

namespace camaron
{
/// A value between two cells; NaN without another cell.
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
