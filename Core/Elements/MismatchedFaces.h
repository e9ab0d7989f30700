// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MismatchedFaces.h
 * @brief Finds coincident but different boundary faces of a mesh.
 *
 * Two faces coincide if they have the same number of points, and each point coincides with one of
 * the other face, see PointGrid. Point ids do not matter.
 */
#ifndef camaron_MismatchedFaces_h
#define camaron_MismatchedFaces_h

#include "Mesh/FacetTable.h"
#include "Ranks/Reducer.h"

#include <functional> // for which cells count
#include <vector>     // for the faces

namespace camaron
{
class MeshTopology;

/// A piece of a mesh, with the neighboring cells of other pieces.
struct PieceOfFaces
{
  const MeshTopology* Topology;
  int Block;                        ///< only pieces of the same block are compared
  std::function<bool(Index)> IsOwn; ///< whether a cell belongs to the piece
};

/**
 * Collective. For every piece, the faces of its own cells that coincide with another face,
 * ascending.
 * @param tolerance see PointGrid
 *
 * Faces whose centers are near the bounding box of another piece are compared by cubes of space,
 * which are distributed over the ranks.
 */
std::vector<std::vector<Index>> FindMismatchedFaces(
  const std::vector<PieceOfFaces>& pieces, double tolerance, Reducer& reducer);
}

#endif
