// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacetMeasures.h
 * @brief What finite volumes ask of a facet between two cells, or at the boundary.
 *
 * Angles are in radian. A null value says why there is none.
 */
#ifndef camaron_FacetMeasures_h
#define camaron_FacetMeasures_h

#include "Cell/CellNeighborhood.h"

namespace camaron
{
/// Angle between the line to the other centroid and the vector area.
double GetNonOrthogonality(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
///@{
/// Minus the cotangent of that angle, which grows with it and takes less time. And back again.
double GetLean(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
double GetAngleOfLean(double lean);
///@}
/// Angle between the line to the center of the facet and the vector area.
double GetBoundaryNonOrthogonality(
  const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Distance of the center from the line between the centroids, relative to the size of the facet.
double GetFaceSkewness(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smaller share of a cell in the distance of the centroids along the normal.
double GetFaceWeight(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smaller divided by larger size of the two cells.
double GetVolumeRatio(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Volume of the smaller one of the pyramids of the facet and the centroids; of an edge the area of
/// its triangle.
double GetFacePyramidVolume(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smallest cosine between the triangles about the center of a face and the line to the other
/// centroid, at the boundary to the center of the face.
double GetFaceTwist(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
}

#endif
