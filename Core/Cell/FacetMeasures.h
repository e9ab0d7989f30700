// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FacetMeasures.h
 * @brief Finite volume measures of a facet between two cells or at the boundary.
 *
 * Angles are in radians. Undefined values are NaN with a reason.
 */
#ifndef camaron_FacetMeasures_h
#define camaron_FacetMeasures_h

#include "Cell/CellNeighborhood.h"

namespace camaron
{
/// Angle between the line to the other centroid and the vector area.
double GetNonOrthogonality(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
///@{
/// GetLean returns minus the cotangent of that angle, which increases with the angle and is faster
/// to compute; GetAngleOfLean converts it to the angle.
double GetLean(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
double GetAngleOfLean(double lean);
///@}
/// Angle between the line to the center of the facet and the vector area.
double GetBoundaryNonOrthogonality(
  const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Distance of the center from the line between the centroids, relative to the size of the facet.
double GetFaceSkewness(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smaller of the distances of the facet from both centroids, along its normal, divided by their
/// sum.
double GetFaceWeight(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smaller divided by larger size of the two cells.
double GetVolumeRatio(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Smaller volume of the pyramids formed by the facet and the centroids; for an edge, the smaller
/// area of the triangles.
double GetFacePyramidVolume(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
/// Minimum cosine between the normals of the triangles about the center of a face and the line to
/// the other centroid, at the boundary to the center of the face.
double GetFaceTwist(const CellNeighborhood& cell, const CellNeighborhood::Facet& facet);
}

#endif
