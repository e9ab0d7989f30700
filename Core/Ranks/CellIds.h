// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellIds
 * @brief What cells are known by in all pieces of a mesh: different for all cells but copies.
 *
 * It is the global id if all pieces have them. Else cells are counted, block after block and in a
 * block piece after piece, without copies: in a mesh that is split into ranges of cells it is the
 * number in the undivided mesh.
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
  /// Collective. Borrows the pieces.
  CellIds(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

  bool AreGlobal() const { return this->HasIds; }
  /// Of a cell that is no copy.
  std::int64_t Get(std::size_t piece, vtkIdType cell) const;
  /// The same, but cells without global ids are counted from the first one of their block.
  std::int64_t GetInBlock(std::size_t piece, vtkIdType cell) const
  {
    return this->Get(piece, cell) - (this->HasIds ? 0 : this->FirstOfBlock[piece]);
  }

private:
  const std::vector<LinkedPiece>& Pieces;
  bool HasIds = false;
  // Without ids, by piece:
  std::vector<std::int64_t> First, FirstOfBlock; // number of the first cell
  std::vector<std::vector<Index>> Places; // of the cells of a piece with copies among the others
};
}

#endif
