// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeanSizes.h
 * @brief Mean sizes of the cells of a mesh, for criteria that compare a cell with the others.
 */
#ifndef camaron_MeanSizes_h
#define camaron_MeanSizes_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <vector> // for the pieces

namespace camaron
{
/// NaN if there is no such cell.
struct MeanSizes
{
  enum Kind
  {
    PolygonArea,
    PolyhedronVolume,
    TriangleArea, ///< this and the following sizes are those of Verdict
    QuadrilateralArea,
    TetrahedronVolume,
    HexahedronVolume,
    NumberOfKinds
  };
  double Of[NumberOfKinds];
};

/**
 * Collective. Means over all pieces of all ranks, computed exactly and rounded once, so they do
 * not depend on how the mesh is split. Ghost cells and cells without a finite size do not count;
 * inverted cells count as negative.
 */
MeanSizes GetMeanSizes(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/// Size of a triangle, quadrilateral, tetrahedron or hexahedron as Verdict computes it, and the
/// kind of this size; false for any other cell. Requires NeedsFaces and NeedsVolume.
bool GetVerdictSize(const CellGeometry& cell, MeanSizes::Kind& kind, double& size);
}

#endif
