// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityRegions.h"

#include "AcceptableRanges.h"
#include "Base/ExactSum.h"
#include "Base/Number.h"
#include "ControllerReducer.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "MeshOutputs.h"
#include "PropertyValues.h"
#include "RequestFailure.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/Weights.h"
#include "Statistics/Worst.h"
#include "Strategies/Strategy.h"
#include "TableRows.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

vtkStandardNewMacro(vtkQualityRegions);

namespace camaron
{
namespace
{
struct QualityRegion
{
  std::int64_t Count = 0; ///< number of cells
  ///@{
  /// The worst cell: its value, its id, and the number of its block. Of equal values, the smallest
  /// id.
  double WorstValue = 0;
  vtkIdType WorstId = -1;
  int BlockNumber = -1;
  ///@}
  std::array<double, 3> Center = {}; ///< mean of the positions of the cells, see PlaceFinder
  double Size = 0;                   ///< diagonal of the bounding box of the points of the cells
  double Volume = 0; ///< sum of the magnitudes of the volumes; undefined and infinite ones are 0
};

struct QualityRegions
{
  std::int64_t Total = 0; ///< number of all regions
  /// The largest regions, largest first; of equally large ones, the one with the smallest id.
  std::vector<QualityRegion> Largest;
  bool HaveVolumes = false;
};

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

//------------------------------------------------------------------------------
/// The regions of a set of cells.
class RegionFinder
{
public:
  //----------------------------------------------------------------------------
  /// Collective. The bad cells are those of SelectByCriterion. Stores a reference to @a task.
  explicit RegionFinder(const SelectionTask& task)
    : Task(task)
    , Values(FindValues(task))
    , Volumes(task.Blocks, "Volume", task.Reducer)
    , Range(FindRange(task))
    , End(FindWorstEnd(task.GetArrayName()))
    , Marks(MakeMarks(task.Blocks))
  {
    SelectByCriterion(task, this->Marks);
    this->ValuesOfBlocks = ListByBlock(this->Values, this->Marks.size());
    this->VolumesOfBlocks = ListByBlock(this->Volumes, this->Marks.size());
  }

  //----------------------------------------------------------------------------
  /// Collective. Finds the @a count largest regions (0: all) that are connected according to the
  /// properties of the task. Results are the same on all processes, for any number of them.
  QualityRegions Find(std::int64_t count)
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

private:
  using CellsOfRegions = std::vector<std::vector<LargestParts::PartCell>>;

  // The extremes of the cells of a region, or of some of them.
  struct Part
  {
    std::int64_t Region = -1; ///< -1: no cells
    ///@{
    /// The worst cell. The larger the key, then the smaller the id, the worse.
    std::int64_t Key = LeastKey;
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
      if (this->Key < other.Key || (this->Key == other.Key && other.Id < this->Id))
      {
        this->Key = other.Key;
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

  // Sums over the cells of a region: positions in its bounding box, and volumes in units of a power
  // of two.
  struct Sums
  {
    std::int64_t Region = -1; ///< -1: no cells
    FixedSum Place[3];
    FixedSum Volume;
  };

  //----------------------------------------------------------------------------
  /// Calls visit(block number, cell, region) for the cells of all regions.
  template <typename Visit>
  static void ForEach(const CellsOfRegions& cells, Visit&& visit)
  {
    for (std::size_t block = 0; block < cells.size(); ++block)
    {
      for (const LargestParts::PartCell& entry : cells[block])
      {
        visit(block, entry.Cell, entry.Part);
      }
    }
  }

  //----------------------------------------------------------------------------
  // Worse is further to the bad end of the criterion, or, if it has none, farther from the range.
  // Undefined values are less bad than all others.
  Part GetPart(const ValueBlock& block, vtkIdType cell) const
  {
    const double value = block.Values[cell];
    Part part;
    part.Id = block.GetId(cell);
    part.Value = value;
    if (std::isnan(value))
    {
      return part;
    }
    if (!this->End)
    {
      part.Key = ToKey(std::max(this->Range.Low - value, value - this->Range.High));
    }
    else
    {
      part.Key = *this->End == WorstEnd::Largest ? ToKey(value) : ~ToKey(value);
    }
    return part;
  }

  //----------------------------------------------------------------------------
  std::vector<Part> FindParts(const CellsOfRegions& cells, std::size_t numberOfRegions) const
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

  //----------------------------------------------------------------------------
  void AddSums(const CellsOfRegions& cells, const std::vector<Part>& parts,
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

  const SelectionTask& Task;
  BlockValues Values, Volumes;
  AcceptableRange Range;
  std::optional<WorstEnd> End;
  std::vector<const ValueBlock*> ValuesOfBlocks, VolumesOfBlocks; // nullptr without the array
  SelectionMarks Marks;
};

//------------------------------------------------------------------------------
void AddColumnsOfRegions(vtkTable* table, bool withVolumes)
{
  AddColumns<IntegerColumn>(table, { "Rank", "Count" });
  AddColumns<vtkDoubleArray>(table, { "WorstValue" });
  AddColumns<IntegerColumn>(table, { "WorstId" });
  AddColumns<vtkStringArray>(table, { "IdSpace" });
  AddColumns<vtkDoubleArray>(table, { "X", "Y", "Z", "Size" });
  if (withVolumes)
  {
    AddColumns<vtkDoubleArray>(table, { "Volume" });
  }
  AddColumns<vtkStringArray>(table, { "Block" });
}

//------------------------------------------------------------------------------
void AddRows(vtkTable* table, const QualityRegions& regions, const std::string& idSpace,
  const BlockNames& blockNames)
{
  std::int64_t rank = 0;
  for (const QualityRegion& region : regions.Largest)
  {
    TableRow row;
    row.Add(++rank, region.Count, region.WorstValue, static_cast<std::int64_t>(region.WorstId),
      idSpace, region.Center, region.Size);
    if (regions.HaveVolumes)
    {
      row.Add(region.Volume);
    }
    row.Add(FindBlockName(blockNames, region.BlockNumber));
    row.AppendTo(table);
  }
}
}
}

//------------------------------------------------------------------------------
vtkQualityRegions::vtkQualityRegions()
  : PresetNames(camaron::MakePresetNames(camaron::GetDefaultRangesName()))
{
  this->Adjacency = "Vertex";
}

//------------------------------------------------------------------------------
int vtkQualityRegions::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityRegions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector);
  camaron::SelectionInputs inputs;
  inputs.Mesh = vtkDataObject::GetData(inputVector[0]);
  try
  {
    camaron::CheckNumber("Number Of Regions", this->NumberOfRegions, 0);
    this->Side = this->IncludeUndefined ? "Failing" : "Outside";
    camaron::ControllerReducer reducer;
    const camaron::ElementBlocks blocks(inputs.Mesh, reducer);
    const camaron::SelectionTask task(
      *this, inputs, blocks, camaron::GetNumberOfPieces(outputVector), reducer);
    camaron::RegionFinder finder(task);
    camaron::CheckAbortOnAllRanks(this, 0.2, reducer);
    const camaron::QualityRegions regions = finder.Find(this->NumberOfRegions);
    camaron::CheckAbortOnAllRanks(this, 0.9, reducer);
    const auto blockNames = camaron::GetBlockNames(blocks, reducer);
    camaron::AddColumnsOfRegions(table, regions.HaveVolumes);
    if (reducer.GetProcess() == 0)
    {
      camaron::AddRows(table, regions, blocks.GetIdSpace(), blockNames);
      vtkNew<camaron::IntegerColumn> total;
      total->SetName("NumberOfRegions");
      total->InsertNextValue(regions.Total);
      table->GetFieldData()->AddArray(total);
    }
  }
  catch (...)
  {
    return camaron::FailRequest(this, "The regions cannot be found", outputVector);
  }
  return 1;
}
