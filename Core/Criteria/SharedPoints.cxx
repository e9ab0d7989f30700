// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/SharedPoints.h"

#include <algorithm>

namespace camaron
{
namespace
{
// A point of a piece that some other piece may have, too.
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
};

// "The piece has your candidate, too."
struct Verdict
{
  std::int64_t Candidate;
  PieceAt Other;
};

//------------------------------------------------------------------------------
// The points of own cells that lie near other pieces.
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
        candidates.push_back({ borders.GetKey(p, point), pieces[p].Block,
          static_cast<std::int32_t>(p), point });
      }
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
// Tells every process which other pieces have its candidates.
std::vector<std::vector<Verdict>> Judge(
  const std::vector<std::vector<CandidateKey>>& candidates)
{
  struct Item
  {
    PointKey Key;
    std::int32_t Block;
    PieceAt From;
    std::int64_t Number;
    auto GetPlace() const { return std::tie(this->Block, this->Key); }
    bool operator<(const Item& other) const
    {
      return std::tie(this->Block, this->Key, this->From, this->Number) <
        std::tie(other.Block, other.Key, other.From, other.Number);
    }
  };
  std::vector<Item> items;
  for (std::size_t process = 0; process < candidates.size(); ++process)
  {
    for (std::size_t i = 0; i < candidates[process].size(); ++i)
    {
      const CandidateKey& candidate = candidates[process][i];
      items.push_back({ candidate.Key, candidate.Block,
        { static_cast<std::int32_t>(process), candidate.Piece }, static_cast<std::int64_t>(i) });
    }
  }
  std::sort(items.begin(), items.end());
  std::vector<std::vector<Verdict>> verdicts(candidates.size());
  std::vector<PieceAt> having;
  for (auto first = items.begin(); first != items.end();)
  {
    auto last = first;
    having.clear();
    for (; last != items.end() && last->GetPlace() == first->GetPlace(); ++last)
    {
      if (having.empty() || !(having.back() == last->From))
      {
        having.push_back(last->From);
      }
    }
    for (; first != last; ++first)
    {
      for (const PieceAt& other : having)
      {
        if (!(other == first->From))
        {
          verdicts[first->From.Process].push_back({ first->Number, other });
        }
      }
    }
  }
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
  const auto verdicts =
    reducer.ExchangeItems(Judge(reducer.ExchangeItems(std::move(sent))));
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
    std::sort(points.begin(), points.end(),
      [](const SharedPoint& a, const SharedPoint& b)
      { return std::tie(a.Point, a.Other) < std::tie(b.Point, b.Other); });
  }
  return shared;
}
}
