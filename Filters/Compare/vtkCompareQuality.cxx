// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompareQuality.h"

#include "AcceptableRanges.h"
#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "ComparisonTables.h"
#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "Grouping.h"
#include "Mesh/MeshView.h"
#include "MeshOutputs.h"
#include "PropertyValues.h"
#include "RequestFailure.h"
#include "Statistics/Quantiles.h"
#include "StatisticsArrays.h"
#include "StatisticsTables.h"
#include "TimeSteps.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <atomic>
#include <cmath>

vtkStandardNewMacro(vtkCompareQuality);

namespace
{
//------------------------------------------------------------------------------
bool AreEqual(const camaron::IndexRange& a, const camaron::IndexRange& b)
{
  bool equal = a.Size == b.Size;
  for (vtkIdType i = 0; i < a.Size && equal; ++i)
  {
    equal = a[i] == b[i];
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameFaces(const camaron::MeshView& a, const camaron::MeshView& b, vtkIdType cell)
{
  const camaron::IndexRange facesOfA = a.GetPolyhedronFaces(cell),
                            facesOfB = b.GetPolyhedronFaces(cell);
  bool equal = facesOfA.Size == facesOfB.Size;
  for (vtkIdType face = 0; face < facesOfA.Size && equal; ++face)
  {
    equal = AreEqual(
      a.GetPolyhedronFacePoints(facesOfA[face]), b.GetPolyhedronFacePoints(facesOfB[face]));
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameCells(const camaron::MeshView& a, const camaron::MeshView& b)
{
  std::atomic<bool> same(true);
  camaron::ParallelFor(a.GetNumberOfCells(), 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && same; ++cell)
      {
        // Polyhedra are compared by their faces: the order of their points is arbitrary.
        const bool hasFaces = a.GetPolyhedronFaces(cell).Size > 0;
        if (a.GetCellType(cell) != b.GetCellType(cell) || !HaveSameFaces(a, b, cell) ||
          !(hasFaces || AreEqual(a.GetCellPoints(cell), b.GetCellPoints(cell))))
        {
          same = false;
        }
      }
    });
  return same;
}

//------------------------------------------------------------------------------
// The same for images and other data sets that do not list their cells.
bool HaveSameImplicitCells(vtkDataSet* a, vtkDataSet* b)
{
  vtkNew<vtkIdList> pointsOfA, pointsOfB;
  bool equal = true;
  for (vtkIdType cell = 0; cell < a->GetNumberOfCells() && equal; ++cell)
  {
    a->GetCellPoints(cell, pointsOfA);
    b->GetCellPoints(cell, pointsOfB);
    equal = a->GetCellType(cell) == b->GetCellType(cell) &&
      std::equal(pointsOfA->begin(), pointsOfA->end(), pointsOfB->begin(), pointsOfB->end());
  }
  return equal;
}

//------------------------------------------------------------------------------
bool HaveSameCells(const camaron::ElementBlock& a, const camaron::ElementBlock& b)
{
  if (a.Data == b.Data)
  {
    return true;
  }
  if (a.Number != b.Number || a.GetSize() != b.GetSize() ||
    a.Data->GetNumberOfPoints() != b.Data->GetNumberOfPoints())
  {
    return false;
  }
  const camaron::MeshView meshOfA(a.Data), meshOfB(b.Data);
  const bool areListed =
    meshOfA.GetNumberOfCells() == a.GetSize() && meshOfB.GetNumberOfCells() == b.GetSize();
  return areListed ? HaveSameCells(meshOfA, meshOfB) : HaveSameImplicitCells(a.Data, b.Data);
}

//------------------------------------------------------------------------------
// Collective. Whether both meshes have, on every process, the same blocks with cells of the same
// types and points, polyhedra with the same faces, all in the same order. Then a cell of one mesh
// can be compared with the cell of the same index in the other, whatever the coordinates.
bool HaveSameCells(
  const camaron::ElementBlocks& a, const camaron::ElementBlocks& b, camaron::Reducer& reducer)
{
  std::int64_t same = a.Get().size() == b.Get().size();
  for (std::size_t block = 0; block < a.Get().size() && same; ++block)
  {
    same = HaveSameCells(a.Get()[block], b.Get()[block]);
  }
  reducer.Min(&same, 1);
  return same != 0;
}

//------------------------------------------------------------------------------
// The arrays that both meshes have with the same unit. Appends the names of arrays whose units
// differ to leftOut, and a sentence about each to reasons.
std::vector<camaron::StatisticsArray> FindCommonArrays(
  const std::vector<camaron::StatisticsArray>& ofA,
  const std::vector<camaron::StatisticsArray>& ofB, std::string& reasons,
  std::vector<std::string>& leftOut)
{
  std::vector<camaron::StatisticsArray> common;
  for (const camaron::StatisticsArray& array : ofA)
  {
    const auto other = std::find_if(ofB.begin(), ofB.end(),
      [&](const camaron::StatisticsArray& candidate) { return candidate.Name == array.Name; });
    if (other == ofB.end())
    {
      continue;
    }
    if (!array.Unit.empty() && !other->Unit.empty() && array.Unit != other->Unit)
    {
      leftOut.push_back(array.Name);
      reasons += " " + array.Name + " has the unit " + array.Unit + " in mesh A and " +
        other->Unit + " in mesh B.";
      continue;
    }
    common.push_back(array);
    common.back().Unit = std::max(array.Unit, other->Unit);
    common.back().OfIntegers = array.OfIntegers && other->OfIntegers;
  }
  return common;
}

//------------------------------------------------------------------------------
// Summary of the elements of both meshes together; only the members that bins need are valid.
camaron::Summary Join(const camaron::Summary& a, const camaron::Summary& b)
{
  if (a.GetFiniteCount() == 0 || b.GetFiniteCount() == 0)
  {
    return a.GetFiniteCount() == 0 ? b : a;
  }
  camaron::Summary both = a;
  both.Count += b.Count;
  both.UndefinedCount += b.UndefinedCount;
  both.InfiniteCount += b.InfiniteCount;
  both.NonIntegerCount += b.NonIntegerCount;
  both.Min = std::min(a.Min, b.Min);
  both.Max = std::max(a.Max, b.Max);
  both.MinPositive = std::fmin(a.MinPositive, b.MinPositive); // ignores NaN
  return both;
}

//------------------------------------------------------------------------------
// The blocks that have the array in both meshes. The meshes must have the same cells.
struct MatchedValues
{
  camaron::Population Before, After;
  std::vector<std::size_t> BlockNumbers;

  /// @a before and @a after are the populations of @a a and @a b to match.
  MatchedValues(const camaron::BlockValues& a, const camaron::Population& before,
    const camaron::BlockValues& b, const camaron::Population& after)
  {
    for (std::size_t i = 0; i < after.size(); ++i)
    {
      const auto& numbers = a.GetBlockNumbers();
      const auto found = std::find(numbers.begin(), numbers.end(), b.GetBlockNumbers()[i]);
      if (found != numbers.end())
      {
        this->Before.push_back(before[found - numbers.begin()]);
        this->After.push_back(after[i]);
        this->BlockNumbers.push_back(*found);
      }
    }
  }
};

//------------------------------------------------------------------------------
void AddDeltas(const std::string& name, const MatchedValues& values,
  const camaron::ElementBlocks& blocks, camaron::NewCellArrays& deltas)
{
  for (std::size_t i = 0; i < values.After.size(); ++i)
  {
    const auto delta = camaron::MakeLargeArray<vtkDoubleArray>(values.After[i].Size);
    delta->SetName((name + "_Delta").c_str());
    camaron::ParallelFor(values.After[i].Size, 1 << 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        camaron::FindDifferences(
          values.Before[i], values.After[i], begin, end, delta->GetPointer(0));
      });
    deltas[blocks.Get()[values.BlockNumbers[i]].FlatIndex].push_back(delta);
  }
}
}

//------------------------------------------------------------------------------
vtkCompareQuality::vtkCompareQuality()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkCompareQuality::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port < 2 ? "vtkTable" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCompareQuality::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::MakeTablesAndMesh(2, vtkDataObject::GetData(inputVector[1]), outputVector);
  return 1;
}

//------------------------------------------------------------------------------
void vtkCompareQuality::MakeColumns(vtkInformationVector* outputVector)
{
  for (int port = 0; port < 2; ++port)
  {
    vtkTable::GetData(outputVector, port)->Initialize();
  }
  camaron::AddComparisonColumns(vtkTable::GetData(outputVector, 0), this->AllTimeSteps);
  camaron::AddCommonHistogramColumns(vtkTable::GetData(outputVector, 1), this->AllTimeSteps);
}

//------------------------------------------------------------------------------
void vtkCompareQuality::AddRows(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::CheckNumber("Number Of Bins", this->NumberOfBins, 1, 100000);
  camaron::CheckNumber("Tolerance", this->Tolerance, 0.0, 1.0);
  camaron::BinSettings settings;
  settings.NumberOfBins = this->NumberOfBins;
  settings.Scale = camaron::ToBinScale(this->HistogramScale);
  std::vector<double> fractions;
  for (const double percent : camaron::GetComparedPercents())
  {
    fractions.push_back(percent / 100);
  }

  vtkDataObject *a = vtkDataObject::GetData(inputVector[0]),
                *b = vtkDataObject::GetData(inputVector[1]);
  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
  const camaron::ElementBlocks blocks[2] = { { a, reducer }, { b, reducer } };
  camaron::Grouping groupOfA(this->GroupBy, this->GroupArray, blocks[0], reducer);
  camaron::Grouping groupings[2] = { groupOfA,
    { this->GroupBy, groupOfA.GetArrayName(), blocks[1], reducer } };
  const std::vector<camaron::Group> groups =
    camaron::JoinGroups(groupings[0].GetGroups(), groupings[1].GetGroups());
  const bool sameCells = HaveSameCells(blocks[0], blocks[1], reducer);
  const std::vector<camaron::StatisticsArray> arrays = this->ChooseCommonArrays(blocks, reducer);
  const bool isRoot = reducer.GetProcess() == 0;
  this->WarnOfNoGroups(groupings[0].GetArrayName(), groups.size(), isRoot);

  camaron::NewCellArrays deltas;
  camaron::BlockShapes shapes[2] = { camaron::BlockShapes(blocks[0]),
    camaron::BlockShapes(blocks[1]) };
  std::size_t done = 0;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const camaron::Criterion* criterion = camaron::FindCriterion(arrays[i].Name);
    camaron::BlockValues values[2] = { { blocks[0], arrays[i].Name, reducer },
      { blocks[1], arrays[i].Name, reducer } };
    camaron::ArrayComparison comparison;
    comparison.Name = arrays[i].Name;
    comparison.Unit = arrays[i].Unit;
    comparison.Time = this->Steps->GetTime();
    comparison.Better = criterion ? criterion->Better : camaron::Better::Neither;
    const auto acceptable = ranges.Find(arrays[i].Name, arrays[i].Unit);
    const camaron::ValueRange limits = acceptable.value_or(camaron::AcceptableRange());
    comparison.Acceptable = acceptable;
    shapes[0].Judge(values[0], acceptable);
    shapes[1].Judge(values[1], acceptable);
    settings.OfIntegers = arrays[i].OfIntegers;
    for (const camaron::Group& group : groups)
    {
      camaron::CheckAbortOnAllRanks(this,
        this->Steps->GetProgress(
          static_cast<double>(done++) / static_cast<double>(arrays.size() * groups.size())),
        reducer);
      comparison.Group = group.Label;
      const camaron::Population populations[2] = { groupings[0].GetPopulation(group, values[0]),
        groupings[1].GetPopulation(group, values[1]) };
      for (int mesh = 0; mesh < 2; ++mesh)
      {
        comparison.Summaries[mesh] = camaron::Summarize(populations[mesh], limits, reducer);
        comparison.Quantiles[mesh] =
          camaron::GetQuantiles(populations[mesh], comparison.Summaries[mesh], fractions, reducer);
      }
      if (group.IsAll)
      {
        // All groups share the bins of all cells.
        comparison.Bins =
          camaron::MakeBins(Join(comparison.Summaries[0], comparison.Summaries[1]), settings);
      }
      for (int mesh = 0; mesh < 2; ++mesh)
      {
        comparison.Histograms[mesh] =
          camaron::CountBins(populations[mesh], comparison.Bins, reducer);
      }
      comparison.Distance =
        camaron::FindDistributionDistance(populations[0], populations[1], reducer);
      if (sameCells)
      {
        const MatchedValues matched(values[0], populations[0], values[1], populations[1]);
        comparison.Changes = camaron::CountChanges(
          matched.Before, matched.After, comparison.Better, this->Tolerance, reducer);
        if (group.IsAll && this->Steps->IsLast())
        {
          AddDeltas(arrays[i].Name, matched, blocks[1], deltas);
        }
      }
      if (isRoot)
      {
        camaron::AddComparisonRow(vtkTable::GetData(outputVector, 0), comparison);
        camaron::AddCommonHistogramRows(vtkTable::GetData(outputVector, 1), comparison);
      }
    }
  }
  if (this->Steps->IsLast())
  {
    camaron::CopyWithCellArrays(b, deltas, vtkDataObject::GetData(outputVector, 2));
  }
}

//------------------------------------------------------------------------------
// Collective.
std::vector<camaron::StatisticsArray> vtkCompareQuality::ChooseCommonArrays(
  const camaron::ElementBlocks blocks[2], camaron::Reducer& reducer)
{
  std::string reasons;
  std::vector<std::string> leftOut, missing;
  const std::vector<camaron::StatisticsArray> common =
    FindCommonArrays(camaron::FindArrays(blocks[0], reducer),
      camaron::FindArrays(blocks[1], reducer), reasons, leftOut);
  std::vector<camaron::StatisticsArray> arrays =
    camaron::ChooseArrays(common, this->Arrays, missing);
  const auto isLeftOut = [&](const std::string& name)
  { return std::find(leftOut.begin(), leftOut.end(), name) != leftOut.end(); };
  missing.erase(std::remove_if(missing.begin(), missing.end(), isLeftOut), missing.end());
  if (!reasons.empty() && this->Steps->IsFirst() && reducer.GetProcess() == 0)
  {
    vtkWarningMacro("Skipped arrays whose units differ." << reasons);
  }
  this->Found->Add(this->Steps->GetTime(), arrays, missing);
  return arrays;
}
