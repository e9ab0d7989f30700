// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/CellIds.h"

#include <tuple>

namespace camaron
{
//------------------------------------------------------------------------------
CellIds::CellIds(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
  : Pieces(pieces)
  , Places(pieces.size())
{
  struct Part
  {
    std::int64_t Block, NumberOfCells;
    int Order, Process, Piece;
    auto GetOrder() const { return std::tie(this->Order, this->Process, this->Piece); }
  };
  std::int64_t lacksIds = 0;
  std::vector<Part> own;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const vtkIdType size = pieces[p].Topology->GetMesh().GetNumberOfCells();
    lacksIds = lacksIds || (size > 0 && !pieces[p].CellIds);
    Index count = 0;
    for (vtkIdType cell = 0; cell < size && pieces[p].Options.Ghosts; ++cell)
    {
      this->Places[p].push_back(count);
      count += !pieces[p].IsCopy(cell);
    }
    own.push_back({ pieces[p].Block, pieces[p].Options.Ghosts ? count : size, pieces[p].Order,
      reducer.GetProcess(), static_cast<int>(p) });
  }
  reducer.Max(&lacksIds, 1);
  this->HasIds = !lacksIds;
  const std::vector<Part> all = reducer.GatherItems(own);
  for (std::size_t p = 0; p < own.size(); ++p)
  {
    std::int64_t first = 0, firstOfBlock = 0;
    for (const Part& part : all)
    {
      const bool isBefore = part.GetOrder() < own[p].GetOrder();
      firstOfBlock += part.Block < own[p].Block ? part.NumberOfCells : 0;
      first += part.Block == own[p].Block && isBefore ? part.NumberOfCells : 0;
    }
    this->First.push_back(firstOfBlock + first);
    this->FirstOfBlock.push_back(firstOfBlock);
  }
}

//------------------------------------------------------------------------------
std::int64_t CellIds::Get(std::size_t piece, vtkIdType cell) const
{
  return this->HasIds ? this->Pieces[piece].CellIds[cell]
                      : this->First[piece] +
      (this->Places[piece].empty() ? cell : vtkIdType(this->Places[piece][cell]));
}
}
