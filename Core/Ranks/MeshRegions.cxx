// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/MeshRegions.h"

#include "Ranks/CellIds.h"
#include "Ranks/CompletedPieces.h"
#include "Ranks/KeyRanks.h"
#include "Ranks/LinkedComponents.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>

namespace camaron
{
namespace
{
using Ids = std::vector<std::int64_t>;

//------------------------------------------------------------------------------
// Connected components within the pieces of this rank, except those that only contain duplicates.
class PieceRegions
{
public:
  PieceRegions(const std::vector<LinkedPiece>& pieces, const CellIds& ids)
  {
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      const std::vector<Index>& regions = pieces[p].Topology->GetCellRegions();
      std::vector<Index> components(regions.size(), CopiesOnly); // of the regions of this piece
      for (std::size_t cell = 0; cell < regions.size(); ++cell)
      {
        if (regions[cell] >= 0 && !pieces[p].IsCopy(static_cast<vtkIdType>(cell)))
        {
          const std::int64_t id = ids.Get(p, cell);
          Index& component = components[regions[cell]];
          if (component < 0)
          {
            component = static_cast<Index>(this->FirstCells.size());
            this->FirstCells.push_back(id);
          }
          this->FirstCells[component] = std::min(this->FirstCells[component], id);
        }
      }
      this->OfCells.emplace_back();
      for (const Index region : regions)
      {
        this->OfCells[p].push_back(region < 0 ? NoRegion : components[region]);
      }
    }
  }

  static constexpr Index NoRegion = -1;
  static constexpr Index CopiesOnly = -2;
  std::vector<std::vector<Index>> OfCells; // components
  Ids FirstCells;                          // of the components
};
}

//------------------------------------------------------------------------------
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  const PieceRegions regions(pieces, CellIds(pieces, reducer));
  const LinkedComponents linked(
    pieces, regions.OfCells, static_cast<Index>(regions.FirstCells.size()), reducer);
  const Ids firstCells = linked.Combine(regions.FirstCells,
    [](std::int64_t& first, std::int64_t other) { first = std::min(first, other); });
  // The number of a region is the position of its first cell among those of all regions.
  std::map<std::int64_t, std::int64_t> numbers; // of first cells
  for (std::size_t i = 0; i < firstCells.size(); ++i)
  {
    numbers[firstCells[i]] += linked.IsFirst(i); // each region counts once
  }
  std::vector<KeyCounts> keys;
  for (const auto& [cell, count] : numbers)
  {
    keys.push_back({ cell, { { count, 0 } } });
  }
  const std::vector<KeyRank> ranks = RankKeys(keys, reducer);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    numbers[keys[i].Key] = ranks[i].Before[0];
  }
  Ids ofComponents;
  for (const std::int64_t cell : firstCells)
  {
    ofComponents.push_back(numbers[cell]);
  }
  std::vector<MeshRegions> result;
  for (const std::vector<Index>& components : regions.OfCells)
  {
    result.emplace_back();
    for (const Index component : components)
    {
      result.back().OfCells.push_back(component >= 0 ? ofComponents[component]
          : component == PieceRegions::CopiesOnly    ? MeshRegions::Unknown
                                                     : MeshRegions::None);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<PointRegions> FindPointRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  Completion completion;
  completion.BorderOnly = true;
  const auto borders = CompletePieces(pieces, completion, reducer);
  std::vector<PointRegions> regions;
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    regions.push_back({ pieces[p].Topology->GetPointRegionCounts() });
    std::vector<Index>& counts = regions.back().Counts;
    const MeshTopology border(borders[p]);
    const MeshView& mesh = border.GetMesh();
    vtkUnsignedCharArray* ghosts = borders[p]->GetCellGhostArray();
    for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
    {
      // All cells around the points of an added cell are present.
      const bool isAdded = (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
      for (const vtkIdType point : mesh.GetCellPoints(cell))
      {
        if (isAdded && point < static_cast<vtkIdType>(counts.size()))
        {
          counts[point] = border.GetPointRegionCounts()[point];
        }
      }
    }
  }
  return regions;
}
}
