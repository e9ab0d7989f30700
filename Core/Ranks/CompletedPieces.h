// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CompletedPieces.h
 * @brief Extends pieces of a mesh by the cells of other pieces that share a point with them.
 *
 * A completed piece knows all cells around each of its points, edges and faces, even where pieces
 * share only a point. PieceBorders defines which points are the same. Ghost duplicates of cells of
 * other pieces (DUPLICATECELL) are ignored and replaced by the added cells.
 *
 * Memory, messages and time are proportional to the points within the bounding box of another
 * piece, see SharedPoints, and to the cells at the border. A piece that receives cells is copied.
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
/// Options of CompletePieces.
struct Completion
{
  /// Whether other pieces can be asked. If not, duplicates are kept and nothing is added.
  bool AsksOthers = true;
  /// Only keep cells that share a point with another piece, and the cells of other pieces.
  bool BorderOnly = false;
  /// Cell arrays to keep, converted to double; NaN for cells of a piece that lacks them. Must be
  /// the same on all ranks.
  std::vector<std::string> Arrays;
};

/**
 * Collective. For every piece, a vtkUnstructuredGrid with the points of the piece followed by the
 * additional points of added cells, and with its cells in the order of their ids; or the data set
 * of the piece if that already has these cells.
 *
 * Cell arrays: global ids, which are those of CellIds::GetInBlock; "vtkGhostType", which marks
 * added cells as DUPLICATECELL; and the requested arrays. Point arrays: none.
 */
std::vector<vtkSmartPointer<vtkDataSet>> CompletePieces(
  const std::vector<LinkedPiece>& pieces, const Completion& completion, Reducer& reducer);
}

#endif
