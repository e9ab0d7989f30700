// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MismatchedFaces.h
 * @brief Boundary faces of a mesh that lie in one place although they are different.
 *
 * Two faces do that have as many points, each of which coincides with one of the other face, see
 * PointGrid. What ids points have makes no difference.
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

/// A piece of a mesh, with the cells that others have around it.
struct PieceOfFaces
{
  const MeshTopology* Topology;
  int Block;                        ///< pieces of one block are compared
  std::function<bool(Index)> IsOwn; ///< whether a cell is one of the piece
};

/**
 * Collective. Of every piece those faces of its own cells that lie in the place of another one,
 * ascending.
 * @param tolerance see PointGrid
 *
 * Faces whose centers lie near the box of another piece are compared by cubes of space, every
 * process its share.
 */
std::vector<std::vector<Index>> FindMismatchedFaces(
  const std::vector<PieceOfFaces>& pieces, double tolerance, Reducer& reducer);
}

#endif
