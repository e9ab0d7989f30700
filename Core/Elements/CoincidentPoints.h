// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoincidentPoints.h
 * @brief Points of a mesh that lie in one place.
 *
 * Of every point the lowest id of all points within a tolerance of it, itself included; -1 if there
 * is no other. Exact, whatever the number of threads. Points with coordinates that are not finite
 * coincide with none.
 */
#ifndef camaron_CoincidentPoints_h
#define camaron_CoincidentPoints_h

#include "Elements/PointGrid.h"
#include "Mesh/MeshView.h"
#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <vector> // for the result

class vtkDataArray;

namespace camaron
{
/// Ids by which the points of a mesh are known: those of one of the lists, or places in the mesh.
struct PointNumbers
{
  vtkDataArray* Array = nullptr;
  const vtkIdType* Ids = nullptr;
  vtkIdType First = 0; ///< number of the first point if there is no list

  vtkIdType operator()(vtkIdType point) const;
};

/**
 * Of one mesh.
 * @param tolerance see PointGrid
 * @param isLeftOut of points that count for nothing; or empty
 */
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, double tolerance,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut = {});

/// The same with a given grid.
std::vector<vtkIdType> FindCoincidentPoints(const MeshView& mesh, const PointGrid& grid,
  const PointNumbers& numbers, const std::vector<unsigned char>& isLeftOut);

/**
 * Collective. Of every piece, with the points of the other pieces of its block. What several pieces
 * have is one point: points of the same global id, or, unless all pieces have such ids, in exactly
 * the same place. Without them points are known by their places in the pieces of the block one
 * after the other. Points that only copies of cells have, and points
 * marked as copies that no cell has, count for nothing.
 *
 * Points within reach of the box of another piece are compared by cubes of space, every process its
 * share.
 */
std::vector<std::vector<vtkIdType>> FindCoincidentPoints(
  const std::vector<LinkedPiece>& pieces, double tolerance, Reducer& reducer);
}

#endif
