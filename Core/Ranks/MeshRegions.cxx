// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/MeshRegions.h"

#include "Ranks/CellIds.h"
#include "Ranks/CompletedPieces.h"
#include "Ranks/LinkedComponents.h"

#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace camaron
{
namespace
{
using Ids = std::vector<std::int64_t>;

//------------------------------------------------------------------------------
// The positions of numbers in the sorted list of all ranks. Each rank sorts a part of their range.
Ids FindRanks(const Ids& numbers, Reducer& reducer)
{
  const int processes = reducer.GetNumberOfProcesses();
  std::int64_t highest = 0, lowest = 0;
  for (const std::int64_t number : numbers)
  {
    highest = std::max(highest, number);
    lowest = std::min(lowest, number);
  }
  reducer.Max(&highest, 1);
  reducer.Min(&lowest, 1);
  const double width = (static_cast<double>(highest) - static_cast<double>(lowest)) / processes;
  const auto getSorter = [=](std::int64_t number)
  {
    const double place = static_cast<double>(number) - static_cast<double>(lowest);
    return width > 0 ? std::min(processes - 1, static_cast<int>(place / width)) : 0;
  };
  return reducer.Ask(numbers, getSorter,
    [&](std::vector<Ids> received)
    {
      Ids sorted;
      for (const Ids& list : received)
      {
        sorted.insert(sorted.end(), list.begin(), list.end());
      }
      std::sort(sorted.begin(), sorted.end());
      const Ids sizes = reducer.GatherItems(Ids{ static_cast<std::int64_t>(sorted.size()) });
      const std::int64_t first =
        std::accumulate(sizes.begin(), sizes.begin() + reducer.GetProcess(), std::int64_t(0));
      for (Ids& list : received)
      {
        for (std::int64_t& number : list)
        {
          number =
            first + (std::lower_bound(sorted.begin(), sorted.end(), number) - sorted.begin());
        }
      }
      return received;
    });
}

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
          this->Add(ids.Get(p, cell), components[regions[cell]]);
        }
      }
      this->OfCells.emplace_back(regions.size(), NoRegion);
      for (std::size_t cell = 0; cell < regions.size(); ++cell)
      {
        if (regions[cell] >= 0)
        {
          this->OfCells[p][cell] = components[regions[cell]];
        }
      }
    }
  }

  static constexpr Index NoRegion = -1;
  static constexpr Index CopiesOnly = -2;
  std::vector<std::vector<Index>> OfCells; // components
  Ids FirstCells;                          // of the components

private:
  void Add(std::int64_t id, Index& component)
  {
    if (component < 0)
    {
      component = static_cast<Index>(this->FirstCells.size());
      this->FirstCells.push_back(id);
    }
    this->FirstCells[component] = std::min(this->FirstCells[component], id);
  }
};

struct Report
{
  std::int64_t Label, FirstCell;
};
}

//------------------------------------------------------------------------------
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer)
{
  const PieceRegions regions(pieces, CellIds(pieces, reducer));
  const LinkedComponents linked(
    pieces, regions.OfCells, static_cast<Index>(regions.FirstCells.size()), reducer);

  // The rank of a region's label receives all its parts and numbers the region.
  std::vector<Report> reports;
  for (std::size_t i = 0; i < regions.FirstCells.size(); ++i)
  {
    reports.push_back({ linked.GetLabels()[i], regions.FirstCells[i] });
  }
  const Ids ofComponents = reducer.Ask(
    reports, [&](const Report& report) { return linked.GetProcess(report.Label); },
    [&](const std::vector<std::vector<Report>>& received)
    {
      std::map<std::int64_t, std::int64_t> numbers; // of labels
      for (const auto& list : received)
      {
        for (const Report& report : list)
        {
          std::int64_t& first = numbers.emplace(report.Label, report.FirstCell).first->second;
          first = std::min(first, report.FirstCell);
        }
      }
      Ids firstCells;
      for (const auto& entry : numbers)
      {
        firstCells.push_back(entry.second);
      }
      const Ids ranks = FindRanks(firstCells, reducer);
      std::size_t i = 0;
      for (auto& entry : numbers)
      {
        entry.second = ranks[i++];
      }
      std::vector<Ids> answers(received.size());
      for (std::size_t process = 0; process < received.size(); ++process)
      {
        for (const Report& report : received[process])
        {
          answers[process].push_back(numbers[report.Label]);
        }
      }
      return answers;
    });
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
      const IndexRange points = mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i < points.Size && isAdded; ++i)
      {
        if (points[i] < static_cast<vtkIdType>(counts.size()))
        {
          counts[points[i]] = border.GetPointRegionCounts()[points[i]];
        }
      }
    }
  }
  return regions;
}
}
