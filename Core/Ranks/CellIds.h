// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellIds
 * @brief Ids that identify the cells of a mesh across all pieces; duplicates of a cell share its
 * id.
 *
 * These are the global ids if all pieces have them. Otherwise cells are numbered block by block,
 * and within a block piece by piece, without duplicates, so a mesh split into ranges of cells
 * keeps the numbers of the undivided mesh.
 */
#ifndef camaron_CellIds_h
#define camaron_CellIds_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <cstdint> // for ids
#include <vector>  // for the pieces

namespace camaron
{
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
