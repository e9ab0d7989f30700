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
struct Candidate
{
  PointKey Key;
  std::int32_t Block, Piece;
  vtkIdType Point;
};

struct CandidateKey
{
  PointKey Key;
  std::int32_t Block, Piece;
  auto GetKey() const { return std::tie(this->Block, this->Key); }
};

// "The piece has your candidate, too."
struct Verdict
{
  std::int64_t Candidate;
  PieceAt Other;
};

//------------------------------------------------------------------------------
// The points of own cells that are near other pieces.
std::vector<Candidate> FindCandidates(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders)
{
  constexpr unsigned char isUsed = 2;
  std::vector<Candidate> candidates;
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
      const IndexRange points = mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i < points.Size && !pieces[p].IsCopy(cell); ++i)
      {
        marks[points[i]] |= isUsed;
      }
    }
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      if (marks[point] == (isUsed | 1))
      {
        candidates.push_back(
          { borders.GetKey(p, point), pieces[p].Block, static_cast<std::int32_t>(p), point });
      }
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
// Reports to every rank which other pieces have its candidates.
std::vector<std::vector<Verdict>> Judge(const std::vector<std::vector<CandidateKey>>& candidates)
{
  std::vector<std::vector<Verdict>> verdicts(candidates.size());
  std::vector<PieceAt> having;
  ForEachKey(candidates,
    [&](const std::vector<ReceivedKey>& group)
    {
      const auto getPiece = [&](const ReceivedKey& at)
      {
        return PieceAt{ static_cast<std::int32_t>(at.Process),
          candidates[at.Process][at.Number].Piece };
      };
      having.clear(); // sorted, because ranks send their pieces in order
      for (const ReceivedKey& at : group)
      {
        if (having.empty() || !(having.back() == getPiece(at)))
        {
          having.push_back(getPiece(at));
        }
      }
      for (const ReceivedKey& at : group)
      {
        for (const PieceAt& other : having)
        {
          if (!(other == getPiece(at)))
          {
            verdicts[at.Process].push_back({ static_cast<std::int64_t>(at.Number), other });
          }
        }
      }
    });
  return verdicts;
}
}

//------------------------------------------------------------------------------
std::vector<std::vector<SharedPoint>> FindSharedPoints(
  const std::vector<LinkedPiece>& pieces, const PieceBorders& borders, Reducer& reducer)
{
  const auto numberOfProcesses = static_cast<std::size_t>(reducer.GetNumberOfProcesses());
  const std::vector<Candidate> candidates = FindCandidates(pieces, borders);
  std::vector<std::vector<CandidateKey>> sent(numberOfProcesses);
  std::vector<std::vector<std::size_t>> numbers(numberOfProcesses);
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const Candidate& candidate = candidates[i];
    const std::size_t judge = Hash(candidate.Key) % numberOfProcesses;
    sent[judge].push_back({ candidate.Key, candidate.Block, candidate.Piece });
    numbers[judge].push_back(i);
  }
  const auto verdicts = reducer.ExchangeItems(Judge(reducer.ExchangeItems(std::move(sent))));
  std::vector<std::vector<SharedPoint>> shared(pieces.size());
  for (std::size_t judge = 0; judge < verdicts.size(); ++judge)
  {
    for (const Verdict& verdict : verdicts[judge])
    {
      const Candidate& candidate = candidates[numbers[judge][verdict.Candidate]];
      shared[candidate.Piece].push_back({ candidate.Point, verdict.Other });
    }
  }
  for (std::vector<SharedPoint>& points : shared)
  {
    std::sort(points.begin(), points.end(), [](const SharedPoint& a, const SharedPoint& b)
      { return std::tie(a.Point, a.Other) < std::tie(b.Point, b.Other); });
  }
  return shared;
}
}
