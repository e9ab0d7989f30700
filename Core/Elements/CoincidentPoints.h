// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentPoints.h
 * @brief Finds coincident points of a mesh, and coincident but different boundary faces.
 *
 * For every point, the lowest id of all points within a tolerance, including itself; -1 if there
 * is no other. The result is exact and does not depend on the number of threads. Points with
 * nonfinite coordinates do not coincide with any.
 */
#ifndef camaron_CoincidentPoints_h
#define camaron_CoincidentPoints_h

#include "Elements/PointGrid.h"
#include "Mesh/FacetTable.h"
#include "Mesh/MeshView.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <functional> // for which cells count
#include <vector>     // for the result

class vtkDataArray;

namespace camaron
{
/// Ids of the points of a mesh: from one of the lists, or their index in the mesh.
struct PointNumbers
{
  vtkDataArray* Array = nullptr;
  const vtkIdType* Ids = nullptr;
  vtkIdType First = 0; ///< id of the first point, without a list

  vtkIdType operator()(vtkIdType point) const;
};

/// Within one mesh; for the tolerance see PointGrid. @a isLeftOut: points to ignore; or empty.
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, double tolerance,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut = {});

/// The same with a given grid.
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, const PointGrid& grid,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut);

/**
 * Collective. For every piece, including the points of the other pieces of its block. Points of
 * several pieces with the same global id are one point; unless all pieces have global ids, so are
 * points at exactly the same position. Without global ids, the id is the index in the pieces of
 * the block, one after the other. Points that only belong to duplicates of cells, and points
 * without cells marked as duplicates, are ignored.
 *
 * Points near the bounding box of another piece are compared by cubes of space, which are
 * distributed over the ranks.
 */
std::vector<std::vector<vtkIdType>> FindCoincidentPoints(
  const std::vector<LinkedPiece>& pieces, double tolerance, Reducer& reducer);

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
 * ascending. Two faces coincide if they have the same number of points, and each point coincides
 * with one of the other face, see PointGrid. Point ids do not matter.
 * @param tolerance see PointGrid
 *
 * Faces whose centers are near the bounding box of another piece are compared by cubes of space,
 * which are distributed over the ranks.
 */
std::vector<std::vector<Index>> FindMismatchedFaces(
  const std::vector<PieceOfFaces>& pieces, double tolerance, Reducer& reducer);
}

#endif
