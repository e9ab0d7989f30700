// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CompletedPieces.h
 * @brief Pieces of a mesh together with the cells that other pieces have at their points.
 *
 * With them a piece knows all that there is around each of its points, edges and faces, also where
 * pieces share no more than a point. Points are the same as PieceBorders says. Copies that a piece
 * has of cells of others (DUPLICATECELL) take no part; the cells that are added take their place.
 *
 * Memory, messages and time are proportional to the points within the box of another piece, see
 * SharedPoints, and to the cells at the border; a piece that gets cells is copied.
 */
#ifndef camaron_CompletedPieces_h
#define camaron_CompletedPieces_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include "vtkDataSet.h"      // for the meshes
#include "vtkSmartPointer.h" // for the meshes

#include <string> // for names of arrays
#include <vector> // for the pieces

namespace camaron
{
/// How pieces are completed.
struct Completion
{
  /// Whether there are other pieces that can be asked. If not, copies stay, and nothing is added.
  bool AsksOthers = true;
  /// Only the cells that share a point with another piece, and those of others.
  bool BorderOnly = false;
  /// Cell arrays to keep, as doubles; null for cells of a piece that lacks them. The same on all
  /// processes.
  std::vector<std::string> Arrays;
};

/**
 * Collective. Of every piece a vtkUnstructuredGrid, or the same as the piece if its cells are those
 * already: the points of the piece, then those that only added cells have; its cells in the order
 * of their ids.
 *
 * Cell arrays: global ids, those of CellIds::GetInBlock; "vtkGhostType", in which added cells are
 * DUPLICATECELL; and those that were asked for. Point arrays: none.
 */
std::vector<vtkSmartPointer<vtkDataSet>> CompletePieces(
  const std::vector<LinkedPiece>& pieces, const Completion& completion, Reducer& reducer);
}

#endif
