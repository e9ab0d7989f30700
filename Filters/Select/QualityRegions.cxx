// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "QualityRegions.h"

#include "AcceptableRanges.h"
#include "Base/ExactSum.h"
#include "Base/Number.h"
#include "ElementPlaces.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/Weights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace camaron
{
namespace
{
constexpr std::int64_t LeastKey = std::numeric_limits<std::int64_t>::min();

//------------------------------------------------------------------------------
std::vector<const ValueBlock*> ListByBlock(const BlockValues& values, std::size_t numberOfBlocks)
{
  std::vector<const ValueBlock*> blocks(numberOfBlocks, nullptr);
  for (std::size_t v = 0; v < values.Get().size(); ++v)
  {
    blocks[values.GetBlockNumbers()[v]] = &values.Get()[v];
  }
  return blocks;
}

//------------------------------------------------------------------------------
/// The cells without a value to which the criterion and the range apply.
SelectionMarks MarkUndefined(const SelectionTask& task, const ExactRange& range)
{
  BlockValues values = FindValues(task);
  BlockShapes shapes(task.Blocks);
  AcceptableRange judged;
  judged.Shapes = range.Shapes;
  shapes.Judge(values, judged);
  SelectionMarks marks = MakeMarks(task.Blocks);
  MarkValues(values, marks,
    [](const ValueBlock& block, vtkIdType i)
    {
      return std::isnan(block.Values[i]) && block.IsJudged(i) &&
        block.GetNullReason(i) != NullReason::NotApplicable;
    });
  return marks;
}

//------------------------------------------------------------------------------
/// Calls merge(part) for the parts of every process, each of which knows its region.
template <typename Part, typename Merge>
void MergeParts(const std::vector<Part>& parts, Reducer& reducer, Merge&& merge)
{
  std::vector<Part> own;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(own),
    [](const Part& part) { return part.Region >= 0; });
  for (const Part& part : reducer.GatherItems(own))
  {
    merge(part);
  }
}
}

//------------------------------------------------------------------------------
// The extremes of the cells of a region, or of some of them.
struct RegionFinder::Part
{
  std::int64_t Region = -1; ///< -1: no cells
  ///@{
  /// The worst cell. The larger the key, then the rest, then the smaller the id, the worse.
  std::int64_t Key = LeastKey;
  int Rest = 0;
  vtkIdType Id = std::numeric_limits<vtkIdType>::max();
  double Value = 0;
  int BlockNumber = -1;
  ///@}
  double Low[3] = { Infinity, Infinity, Infinity };
  double High[3] = { -Infinity, -Infinity, -Infinity };
  double LargestVolume = 0;

  void Add(const Part& other)
  {
    this->Region = other.Region;
    const auto order = [](const Part& part) { return std::make_tuple(part.Key, part.Rest); };
    if (order(*this) < order(other) || (order(*this) == order(other) && other.Id < this->Id))
    {
      this->Key = other.Key;
      this->Rest = other.Rest;
      this->Id = other.Id;
      this->Value = other.Value;
      this->BlockNumber = other.BlockNumber;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
      this->High[axis] = std::max(this->High[axis], other.High[axis]);
    }
    this->LargestVolume = std::max(this->LargestVolume, other.LargestVolume);
  }

  double GetLength(int axis) const { return std::max(0.0, this->High[axis] - this->Low[axis]); }
};

//------------------------------------------------------------------------------
// Sums over the cells of a region: positions in its bounding box, and volumes in units of a power
// of two.
struct RegionFinder::Sums
{
  std::int64_t Region = -1; ///< -1: no cells
  FixedSum Place[3];
  FixedSum Volume;
};

//------------------------------------------------------------------------------
RegionFinder::RegionFinder(const SelectionTask& task, bool includesUndefined)
  : Task(task)
  , Values(FindValues(task))
  , Volumes(task.Blocks, "Volume")
  , Range(FindRange(task))
  , End(FindWorstEnd(task.GetArrayName()))
  , Marks(MakeMarks(task.Blocks))
{
  SelectByCriterion(task, this->Marks);
  if (includesUndefined)
  {
    const SelectionMarks undefined = MarkUndefined(task, this->Range);
    MarkElements(this->Marks,
      [&](std::size_t b, vtkIdType i) { return this->Marks[b][i] || undefined[b][i]; });
  }
  this->ValuesOfBlocks = ListByBlock(this->Values, this->Marks.size());
  this->VolumesOfBlocks = ListByBlock(this->Volumes, this->Marks.size());
}

//------------------------------------------------------------------------------
template <typename Visit>
void RegionFinder::ForEach(const CellsOfRegions& cells, Visit&& visit)
{
  for (std::size_t block = 0; block < cells.size(); ++block)
  {
    for (const LargestParts::PartCell& entry : cells[block])
    {
      visit(block, entry.Cell, entry.Part);
    }
  }
}

//------------------------------------------------------------------------------
// Worse is further to the bad end of the criterion, or, if it has none, farther from the range.
// Undefined values are less bad than all others.
RegionFinder::Part RegionFinder::GetPart(const ValueBlock& block, vtkIdType cell) const
{
  const ExactValue value = block.GetExact(cell);
  Part part;
  part.Id = block.GetId(cell);
  part.Value = value.Value;
  if (std::isnan(value.Value))
  {
    return part;
  }
  if (!this->End)
  {
    part.Key =
      ToKey(std::max(this->Range.Low.Value - value.Value, value.Value - this->Range.High.Value));
  }
  else if (*this->End == WorstEnd::Largest)
  {
    part.Key = ToKey(value.Value);
    part.Rest = value.Rest;
  }
  else
  {
    part.Key = ~ToKey(value.Value);
    part.Rest = -value.Rest;
  }
  return part;
}

//------------------------------------------------------------------------------
std::vector<RegionFinder::Part> RegionFinder::FindParts(
  const CellsOfRegions& cells, std::size_t numberOfRegions) const
{
  std::vector<Part> own(numberOfRegions), all(numberOfRegions);
  ForEach(cells,
    [&](std::size_t b, vtkIdType cell, std::size_t region)
    {
      const ElementBlock& block = this->Task.Blocks.Get()[b];
      Part part = this->GetPart(*this->ValuesOfBlocks[b], cell);
      part.Region = static_cast<std::int64_t>(region);
      part.BlockNumber = block.Number;
      double bounds[6];
      block.Data->GetCellBounds(cell, bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        part.Low[axis] = bounds[2 * axis];
        part.High[axis] = bounds[2 * axis + 1];
      }
      part.LargestVolume =
        this->VolumesOfBlocks[b] ? GetWeight(*this->VolumesOfBlocks[b], cell) : 0;
      own[region].Add(part);
    });
  MergeParts(own, this->Task.Reducer, [&](const Part& part) { all[part.Region].Add(part); });
  return all;
}

//------------------------------------------------------------------------------
void RegionFinder::AddSums(const CellsOfRegions& cells, const std::vector<Part>& parts,
  std::vector<QualityRegion>& regions) const
{
  std::vector<Sums> own(regions.size()), all(regions.size());
  PlaceFinder places;
  ForEach(cells,
    [&](std::size_t b, vtkIdType cell, std::size_t region)
    {
      Sums& sums = own[region];
      sums.Region = static_cast<std::int64_t>(region);
      double place[3];
      places.Find(this->Task.Blocks.Get()[b], cell, place);
      for (int axis = 0; axis < 3; ++axis)
      {
        const double length = parts[region].GetLength(axis);
        const double position = length > 0 ? (place[axis] - parts[region].Low[axis]) / length : 0;
        sums.Place[axis].Add(std::min(1.0, std::max(0.0, position)));
      }
      if (this->VolumesOfBlocks[b])
      {
        sums.Volume.Add(
          GetUnit(parts[region].LargestVolume) * GetWeight(*this->VolumesOfBlocks[b], cell));
      }
    });
  MergeParts(own, this->Task.Reducer,
    [&](const Sums& sums)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        all[sums.Region].Place[axis].Add(sums.Place[axis]);
      }
      all[sums.Region].Volume.Add(sums.Volume);
    });
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    const auto count = static_cast<double>(regions[r].Count);
    for (int axis = 0; axis < 3; ++axis)
    {
      regions[r].Center[axis] =
        parts[r].Low[axis] + parts[r].GetLength(axis) * (all[r].Place[axis].Get() / count);
    }
    regions[r].Volume = all[r].Volume.Get() / GetUnit(parts[r].LargestVolume);
  }
}

//------------------------------------------------------------------------------
QualityRegions RegionFinder::Find(std::int64_t count)
{
  const LargestParts largest =
    FindLargestParts(this->Task.GetPieces().Get(), FindNeighborhood(this->Task), count,
      ListIds(this->Task.Blocks), this->Task.Reducer, this->Marks);
  QualityRegions result;
  result.Total = largest.Total;
  auto haveVolumes = static_cast<std::int64_t>(this->Volumes.Get().size());
  this->Task.Reducer.Sum(&haveVolumes, 1);
  result.HaveVolumes = haveVolumes > 0;
  const std::vector<Part> parts = this->FindParts(largest.Cells, largest.Sizes.size());
  for (std::size_t r = 0; r < parts.size(); ++r)
  {
    QualityRegion region;
    region.Count = largest.Sizes[r];
    region.WorstValue = parts[r].Value;
    region.WorstId = parts[r].Id;
    region.BlockNumber = parts[r].BlockNumber;
    region.Size = std::hypot(parts[r].GetLength(0), parts[r].GetLength(1), parts[r].GetLength(2));
    result.Largest.push_back(region);
  }
  this->AddSums(largest.Cells, parts, result.Largest);
  return result;
}
}
