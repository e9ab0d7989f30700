// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinkedPieces.h
 * @brief Finds the cells of other pieces at the facets of each piece of a mesh.
 *
 * Facets of two pieces are the same if they have the same points, see PieceBorders. Each rank
 * computes what others need to know about its own cells, so the values are bitwise identical to
 * those of an undivided mesh. Ghost duplicates of cells (DUPLICATECELL) are ignored.
 *
 * Facets whose points are within the bounding box of another piece are compared by a 128-bit hash;
 * every rank compares a part of the hashes. Memory, messages and time are proportional to the
 * number of these facets.
 */
#ifndef camaron_LinkedPieces_h
#define camaron_LinkedPieces_h

#include "Cell/CellGeometry.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshTopology.h"
#include "Ranks/Reducer.h"

#include "vtkDataSetAttributes.h" // for kinds of ghosts

#include <cstdint> // for ids
#include <vector>  // for the pieces

class vtkDataSet;

namespace camaron
{
struct LinkedPiece
{
  const MeshTopology* Topology = nullptr;
  EvaluationOptions Options;
  int Block = 0;                       ///< pieces of the same block are linked, across all ranks
  int Order = 0;                       ///< cells of a block are numbered by this, then by rank
  const vtkIdType* PointIds = nullptr; ///< global ids, or nullptr
  const vtkIdType* CellIds = nullptr;  ///< global ids, or nullptr
  vtkDataSet* Data = nullptr;          ///< the data set of Topology, or nullptr if not needed

  /// Whether a cell duplicates a cell that belongs to another piece.
  bool IsCopy(vtkIdType cell) const { return this->Options.IsCopy(cell); }
};

/// Collective. For every piece, the cells of other pieces at its facets.
std::vector<PieceLinks> LinkPieces(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/**
 * Ids that identify the cells of a mesh across all pieces; duplicates of a cell share its id.
 *
 * These are the global ids if all pieces have them. Otherwise cells are numbered block by block,
 * and within a block piece by piece, without duplicates, so a mesh split into ranges of cells
 * keeps the numbers of the undivided mesh.
 */
class CellIds
{
public:
  /// Collective. Keeps references to the pieces.
  CellIds(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  bool AreGlobal() const { return this->HasIds; }
  /// Id of a cell that is not a duplicate.
  std::int64_t Get(std::size_t piece, vtkIdType cell) const;
  /// As Get, but without global ids, numbers start at the first cell of the block.
  std::int64_t GetInBlock(std::size_t piece, vtkIdType cell) const
  {
    return this->Get(piece, cell) - (this->HasIds ? 0 : this->FirstOfBlock[piece]);
  }

private:
  const std::vector<LinkedPiece>& Pieces;
  bool HasIds = false;
  // Without global ids, by piece:
  std::vector<std::int64_t> First, FirstOfBlock; // number of the first cell
  std::vector<std::vector<Index>> Places; // for pieces with duplicates, the index of each cell
                                          // among the others
};
}

#endif
