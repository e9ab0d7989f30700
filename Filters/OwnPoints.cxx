// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OwnPoints.h"

#include "Criteria/SharedPoints.h"
#include "MeshPieces.h"

#include "vtkDataSet.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// 0 for points that copies of cells have and no other cell.
std::vector<unsigned char> FindPointsOfOwnCells(const LinkedPiece& piece, vtkIdType numberOfPoints)
{
  std::vector<unsigned char> marks(numberOfPoints, 1);
  const MeshView& mesh = piece.Topology->GetMesh();
  for (const bool isCopy : { true, false }) // own cells have the last word
  {
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && piece.Options.Ghosts; ++cell)
    {
      if (piece.IsCopy(cell) == isCopy)
      {
        const IndexRange points = mesh.GetCellPoints(cell);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          marks[points[i]] = !isCopy;
        }
      }
    }
  }
  return marks;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<unsigned char>> FindOwnPoints(
  const ElementBlocks& blocks, int numberOfRequestedPieces, Reducer& reducer)
{
  std::int64_t counts[2] = { static_cast<std::int64_t>(blocks.Get().size()), 0 };
  std::vector<DataSetLeaf> leaves;
  for (const ElementBlock& block : blocks.Get())
  {
    leaves.push_back(block);
    counts[1] += block.Data->GetPointGhostArray() != nullptr;
  }
  reducer.Sum(counts, 2);
  if (counts[0] < 2 || counts[1] > 0)
  {
    return {};
  }
  const MeshPieces pieces(leaves, EvaluationOptions(), numberOfRequestedPieces, reducer);
  const PieceBorders borders(pieces.Get(), reducer);
  const auto shared = FindSharedPoints(pieces.Get(), borders, reducer);
  std::vector<std::vector<unsigned char>> marks;
  for (std::size_t p = 0; p < shared.size(); ++p)
  {
    marks.push_back(FindPointsOfOwnCells(pieces.Get()[p], blocks.Get()[p].GetSize()));
    const PieceAt own = { reducer.GetProcess(), static_cast<std::int32_t>(p) };
    for (const SharedPoint& point : shared[p])
    {
      if (point.Other < own)
      {
        marks[p][point.Point] = 0;
      }
    }
  }
  return marks;
}
}
