// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/SharedElements.h"

#include "Ranks/EqualKeys.h"
#include "Ranks/PieceBorders.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Whether all points of an element are near another piece, and if so, the hash of its points in any
// order.
template <typename Points>
bool FindHash(const PieceBorders& borders, std::size_t piece,
  const std::vector<unsigned char>& isNear, const Points& points, vtkIdType size,
  std::uint64_t (&sums)[2])
{
  sums[0] = sums[1] = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (!isNear[points[i]])
    {
      return false;
    }
    const std::uint64_t hash = Hash(borders.GetKey(piece, points[i]));
    sums[0] += hash;
    sums[1] += Mix(hash);
  }
  return true;
}
}

//------------------------------------------------------------------------------
SharedElements::SharedElements(const std::vector<LinkedPiece>& pieces,
  const std::vector<CellElements>& elements, camaron::Reducer& reducer)
  : Reducer(reducer)
{
  std::vector<Candidate> candidates;
  this->FindCandidates(pieces, elements, candidates);
  this->FindGroups(candidates);
}

//------------------------------------------------------------------------------
SharedElements SharedElements::OfPoints(
  const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
{
  std::vector<CellElements> points;
  for (const LinkedPiece& piece : pieces)
  {
    points.emplace_back(*piece.Topology, Adjacency::Vertex);
  }
  return { pieces, points, reducer };
}

//------------------------------------------------------------------------------
SharedElements SharedElements::OfCells(
  const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
{
  const PieceBorders borders(pieces, reducer, true);
  std::vector<Candidate> candidates;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const std::vector<unsigned char> isNear = borders.FindNearPoints(p);
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && !isNear.empty(); ++cell)
    {
      const IndexRange points = mesh.GetCellPoints(cell);
      Candidate candidate = { { 0, 0 }, pieces[p].Block, static_cast<std::int32_t>(p), cell };
      if (FindHash(borders, p, isNear, points, points.Size, candidate.Hash))
      {
        candidates.push_back(candidate);
      }
    }
  }
  SharedElements cells(reducer);
  cells.FindGroups(candidates);
  return cells;
}

//------------------------------------------------------------------------------
// Elements whose points are all in the bounding box of another piece, once each.
void SharedElements::FindCandidates(const std::vector<LinkedPiece>& pieces,
  const std::vector<CellElements>& elements, std::vector<Candidate>& candidates)
{
  const PieceBorders borders(pieces, this->Reducer);
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const std::vector<unsigned char> isNear = borders.FindNearPoints(p);
    if (isNear.empty())
    {
      continue;
    }
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    CellFacets facets(mesh);
    std::vector<bool> isKnown(elements[p].GetSize());
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      if (pieces[p].IsCopy(cell))
      {
        continue;
      }
      elements[p].ForEach(cell, facets,
        [&](vtkIdType element, const vtkIdType* points, vtkIdType size)
        {
          Candidate candidate = { { 0, 0 }, pieces[p].Block, static_cast<std::int32_t>(p),
            element };
          if (!isKnown[element] && FindHash(borders, p, isNear, points, size, candidate.Hash))
          {
            isKnown[element] = true;
            candidates.push_back(candidate);
          }
        });
    }
  }
}

//------------------------------------------------------------------------------
void SharedElements::FindGroups(const std::vector<Candidate>& candidates)
{
  const auto numberOfProcesses = static_cast<std::size_t>(this->Reducer.GetNumberOfProcesses());
  std::vector<std::vector<Candidate>> sent(numberOfProcesses);
  for (const Candidate& candidate : candidates)
  {
    sent[candidate.Hash[0] % numberOfProcesses].push_back(candidate);
  }
  std::vector<std::vector<Candidate>> kept = sent;
  const auto received = this->Reducer.ExchangeItems(std::move(sent));

  // Groups of one are removed, here and at the sender.
  std::vector<std::vector<vtkIdType>> groups(numberOfProcesses);
  for (std::size_t process = 0; process < received.size(); ++process)
  {
    groups[process].assign(received[process].size(), -1);
  }
  ForEachKey(received,
    [&](const std::vector<ReceivedKey>& group)
    {
      for (std::size_t i = 0; i < group.size() && group.size() > 1; ++i)
      {
        groups[group[i].Process][group[i].Number] = this->NumberOfGroups;
      }
      this->NumberOfGroups += group.size() > 1;
    });
  auto answers = groups;
  const auto verdicts = this->Reducer.ExchangeItems(std::move(answers));
  this->SentTo.assign(numberOfProcesses, 0);
  for (std::size_t process = 0; process < numberOfProcesses; ++process)
  {
    for (std::size_t i = 0; i < kept[process].size(); ++i)
    {
      if (verdicts[process][i] >= 0)
      {
        this->Elements.push_back({ kept[process][i].Piece, kept[process][i].Number });
        ++this->SentTo[process];
      }
    }
    groups[process].erase(
      std::remove(groups[process].begin(), groups[process].end(), vtkIdType(-1)),
      groups[process].end());
  }
  this->Groups = std::move(groups);
}

//------------------------------------------------------------------------------
void SharedElements::Minimize(std::vector<std::int64_t>& values)
{
  std::vector<std::vector<std::int64_t>> sent;
  auto next = values.cbegin();
  for (const std::size_t size : this->SentTo)
  {
    sent.emplace_back(next, next + static_cast<std::ptrdiff_t>(size));
    next += static_cast<std::ptrdiff_t>(size);
  }
  auto lists = this->Reducer.ExchangeItems(std::move(sent));
  std::vector<std::int64_t> smallest(
    this->NumberOfGroups, std::numeric_limits<std::int64_t>::max());
  for (std::size_t process = 0; process < lists.size(); ++process)
  {
    for (std::size_t i = 0; i < lists[process].size(); ++i)
    {
      std::int64_t& value = smallest[this->Groups[process][i]];
      value = std::min(value, lists[process][i]);
    }
  }
  for (std::size_t process = 0; process < lists.size(); ++process)
  {
    for (std::size_t i = 0; i < lists[process].size(); ++i)
    {
      lists[process][i] = smallest[this->Groups[process][i]];
    }
  }
  lists = this->Reducer.ExchangeItems(std::move(lists));
  values.clear();
  for (const std::vector<std::int64_t>& list : lists)
  {
    values.insert(values.end(), list.begin(), list.end());
  }
}
}
