// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/SharedPoints.h"

#include "Ranks/EqualKeys.h"

#include <algorithm>

namespace camaron
{
namespace
{
// A point of a piece that another piece may have, too.
struct CandidatePoint
{
  PointKey Key;
  std::int32_t Block;
  PieceAt Piece;
  vtkIdType Point;

  auto GetKey() const { return std::make_tuple(this->Block, this->Key); }
  std::uint64_t GetHash() const { return Hash(this->Key); }
};

//------------------------------------------------------------------------------
// The points of own cells that are near other pieces.
std::vector<CandidatePoint> FindCandidates(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, int process)
{
  constexpr unsigned char isUsed = 2;
  std::vector<CandidatePoint> candidates;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    std::vector<unsigned char> marks = borders.FindNearPoints(p);
    if (marks.empty())
    {
      continue;
    }
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      for (const vtkIdType point : mesh.GetCellPoints(cell))
      {
        marks[point] |= pieces[p].IsCopy(cell) ? 0 : isUsed;
      }
    }
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      if (marks[point] == (isUsed | 1))
      {
        candidates.push_back({ borders.GetKey(p, point), pieces[p].Block,
          { process, static_cast<std::int32_t>(p) }, point });
      }
    }
  }
  return candidates;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<SharedPoint>> FindSharedPoints(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, Reducer& reducer)
{
  std::vector<std::vector<SharedPoint>> shared(pieces.size());
  ForEachEqual(FindCandidates(pieces, borders, reducer.GetProcess()), reducer,
    [&](const std::vector<CandidatePoint>& group)
    {
      for (const CandidatePoint& own : group)
      {
        for (const CandidatePoint& other : group)
        {
          if (own.Piece.Process == reducer.GetProcess() && !(other.Piece == own.Piece))
          {
            shared[own.Piece.Piece].push_back({ own.Point, other.Piece });
          }
        }
      }
    });
  for (std::vector<SharedPoint>& points : shared)
  {
    const auto order = [](const SharedPoint& s) { return std::tie(s.Point, s.Other); };
    std::sort(points.begin(), points.end(),
      [&](const SharedPoint& a, const SharedPoint& b) { return order(a) < order(b); });
    points.erase(
      std::unique(points.begin(), points.end(),
        [&](const SharedPoint& a, const SharedPoint& b) { return order(a) == order(b); }),
      points.end());
  }
  return shared;
}
}
