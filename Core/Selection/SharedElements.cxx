// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/SharedElements.h"

#include "Base/Hash.h"
#include "Geometry/FacetRing.h"
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
// order and with any repetitions. @a distinct is scratch memory.
template <typename Points>
bool FindHash(const PieceBorders& borders, std::size_t piece,
  const std::vector<unsigned char>& isNear, const Points& points, vtkIdType size,
  std::vector<vtkIdType>& distinct, SetHash& sum)
{
  sum = {};
  distinct.clear();
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (!isNear[points[i]])
    {
      return false;
    }
    distinct.push_back(points[i]);
  }
  SortDistinct(distinct);
  for (const vtkIdType point : distinct)
  {
    sum.Add(Hash(borders.GetKey(piece, point)));
  }
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<CellElements> MakeElements(const std::vector<LinkedPiece>& pieces, Adjacency adjacency)
{
  std::vector<CellElements> elements;
  elements.reserve(pieces.size());
  for (const LinkedPiece& piece : pieces)
  {
    elements.emplace_back(*piece.Topology, adjacency);
  }
  return elements;
}

//------------------------------------------------------------------------------
struct SharedElements::Candidate
{
  SetHash Hash; // of its points
  std::int32_t Block, Piece;
  vtkIdType Number;
  auto GetKey() const { return std::make_tuple(this->Hash.Low, this->Hash.High, this->Block); }
  std::uint64_t GetHash() const { return this->Hash.Low; }
};

//------------------------------------------------------------------------------
SharedElements::SharedElements(const std::vector<LinkedPiece>& pieces,
  const std::vector<CellElements>& elements, camaron::Reducer& reducer)
  : SharedElements(FindCandidates(pieces, elements, reducer), reducer)
{
}

//------------------------------------------------------------------------------
SharedElements SharedElements::OfPoints(
  const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
{
  return { pieces, MakeElements(pieces, Adjacency::Vertex), reducer };
}

//------------------------------------------------------------------------------
SharedElements SharedElements::OfCells(
  const std::vector<LinkedPiece>& pieces, camaron::Reducer& reducer)
{
  const PieceBorders borders(pieces, reducer, true);
  std::vector<Candidate> candidates;
  std::vector<vtkIdType> distinct;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const std::vector<unsigned char> isNear = borders.FindNearPoints(p);
    const MeshView& mesh = pieces[p].Topology->GetMesh();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells() && !isNear.empty(); ++cell)
    {
      const IndexRange points = mesh.GetCellPoints(cell);
      Candidate candidate = { {}, pieces[p].Block, static_cast<std::int32_t>(p), cell };
      if (FindHash(borders, p, isNear, points, points.Size, distinct, candidate.Hash))
      {
        candidates.push_back(candidate);
      }
    }
  }
  return { candidates, reducer };
}

//------------------------------------------------------------------------------
// Elements whose points are all in the bounding box of another piece, once each.
std::vector<SharedElements::Candidate> SharedElements::FindCandidates(
  const std::vector<LinkedPiece>& pieces, const std::vector<CellElements>& elements,
  camaron::Reducer& reducer)
{
  const PieceBorders borders(pieces, reducer);
  std::vector<Candidate> candidates;
  std::vector<vtkIdType> distinct;
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
          Candidate candidate = { {}, pieces[p].Block, static_cast<std::int32_t>(p), element };
          if (!isKnown[element] && !elements[p].IsCollapsed(element) &&
            FindHash(borders, p, isNear, points, size, distinct, candidate.Hash))
          {
            isKnown[element] = true;
            candidates.push_back(candidate);
          }
        });
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
SharedElements::SharedElements(const std::vector<Candidate>& candidates, camaron::Reducer& reducer)
  : Reducer(reducer)
{
  const auto numberOfProcesses = static_cast<vtkIdType>(this->Reducer.GetNumberOfProcesses());
  const std::vector<vtkIdType> groups = AskAboutEqual(candidates, this->Reducer,
    [&](const std::vector<Received<Candidate>>& group) -> vtkIdType
    {
      return group.size() < 2
        ? -1
        : this->NumberOfGroups++ * numberOfProcesses + this->Reducer.GetProcess();
    });
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (groups[i] >= 0)
    {
      this->Elements.push_back({ candidates[i].Piece, candidates[i].Number });
      this->Groups.push_back(groups[i]);
    }
  }
}

//------------------------------------------------------------------------------
void SharedElements::Minimize(std::vector<std::int64_t>& values)
{
  struct GroupValue
  {
    vtkIdType Group;
    std::int64_t Value;
  };
  const auto numberOfProcesses = static_cast<vtkIdType>(this->Reducer.GetNumberOfProcesses());
  std::vector<GroupValue> own;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    own.push_back({ this->Groups[i], values[i] });
  }
  values = this->Reducer.Ask(
    own, [=](const GroupValue& item) { return item.Group % numberOfProcesses; },
    [&](const std::vector<std::vector<GroupValue>>& lists)
    {
      std::vector<std::int64_t> smallest(
        this->NumberOfGroups, std::numeric_limits<std::int64_t>::max());
      for (const std::vector<GroupValue>& list : lists)
      {
        for (const GroupValue& item : list)
        {
          std::int64_t& value = smallest[item.Group / numberOfProcesses];
          value = std::min(value, item.Value);
        }
      }
      std::vector<std::vector<std::int64_t>> answers;
      for (const std::vector<GroupValue>& list : lists)
      {
        answers.emplace_back();
        for (const GroupValue& item : list)
        {
          answers.back().push_back(smallest[item.Group / numberOfProcesses]);
        }
      }
      return answers;
    });
}
}
