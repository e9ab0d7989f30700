// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCompareQuality.h"

#include "AcceptableRanges.h"
#include "ComparisonTables.h"
#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "MeshCopies.h"
#include "Parallel.h"
#include "SameCells.h"
#include "Statistics/Quantiles.h"
#include "StatisticsArrays.h"
#include "StatisticsTables.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkCompareQuality);

namespace
{
//------------------------------------------------------------------------------
// Those of both, with the same unit; says of others why they are left out.
std::vector<camaron::StatisticsArray> FindCommonArrays(const std::vector<camaron::StatisticsArray>& ofA,
  const std::vector<camaron::StatisticsArray>& ofB, std::string& leftOut)
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
      leftOut += " " + array.Name + " is in " + array.Unit + " in one mesh and in " + other->Unit + " in the other.";
      continue;
    }
    common.push_back(array);
    common.back().Unit = std::max(array.Unit, other->Unit);
    common.back().OfIntegers = array.OfIntegers && other->OfIntegers;
  }
  return common;
}

//------------------------------------------------------------------------------
// Of the elements of both meshes as one, as far as bins need it.
camaron::Summary Join(const camaron::Summary& a, const camaron::Summary& b)
{
  if (a.GetFiniteCount() == 0 || b.GetFiniteCount() == 0)
  {
    return a.GetFiniteCount() == 0 ? b : a;
  }
  camaron::Summary both = a;
  both.Count += b.Count;
  both.NullCount += b.NullCount;
  both.InfCount += b.InfCount;
  both.NonIntegerCount += b.NonIntegerCount;
  both.Min = std::min(a.Min, b.Min);
  both.Max = std::max(a.Max, b.Max);
  both.MinPositive = std::fmin(a.MinPositive, b.MinPositive); // the other one of NaN
  return both;
}

//------------------------------------------------------------------------------
// The blocks that have the array in both meshes, which have the same cells.
struct MatchedValues
{
  camaron::Population Before, After;
  std::vector<std::size_t> BlockNumbers;

  MatchedValues(const camaron::BlockValues& a, const camaron::BlockValues& b)
  {
    for (std::size_t i = 0; i < b.Get().size(); ++i)
    {
      const auto& numbers = a.GetBlockNumbers();
      const auto found = std::find(numbers.begin(), numbers.end(), b.GetBlockNumbers()[i]);
      if (found != numbers.end())
      {
        this->Before.push_back(a.Get()[found - numbers.begin()]);
        this->After.push_back(b.Get()[i]);
        this->BlockNumbers.push_back(*found);
      }
    }
  }
};

//------------------------------------------------------------------------------
void AddDeltas(const std::string& name, const MatchedValues& values, const camaron::ElementBlocks& blocks,
  camaron::NewCellArrays& deltas)
{
  for (std::size_t i = 0; i < values.After.size(); ++i)
  {
    auto delta = vtkSmartPointer<vtkDoubleArray>::New();
    delta->SetName((name + "_Delta").c_str());
    delta->SetNumberOfValues(values.After[i].Size);
    camaron::ParallelFor(values.After[i].Size, 1 << 16,
      [&](vtkIdType begin, vtkIdType end)
      {
        camaron::FindDifferences(
          values.Before[i].Values, values.After[i].Values, begin, end, delta->GetPointer(0));
      });
    deltas[blocks.Get()[values.BlockNumbers[i]].FlatIndex].push_back(delta);
  }
}
}

//------------------------------------------------------------------------------
vtkCompareQuality::vtkCompareQuality()
  : Preset(camaron::GetDefaultRangesName())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkCompareQuality::~vtkCompareQuality() = default;

//------------------------------------------------------------------------------
void vtkCompareQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << ' ' << name;
  }
  os << '\n' << indent << "Preset: " << this->Preset << '\n';
  os << indent << "RangesFile: " << this->RangesFile << '\n';
  os << indent << "NumberOfBins: " << this->NumberOfBins << '\n';
  os << indent << "HistogramScale: " << this->HistogramScale << '\n';
  os << indent << "Tolerance: " << this->Tolerance << '\n';
}

//------------------------------------------------------------------------------
void vtkCompareQuality::SetText(std::string& member, const char* text)
{
  const std::string value = text ? text : "";
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCompareQuality::AddArray(const char* name)
{
  if (name && name[0])
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCompareQuality::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkCompareQuality::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
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
int vtkCompareQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::AddComparisonColumns(vtkTable::GetData(outputVector, 0));
  camaron::AddCommonHistogramColumns(vtkTable::GetData(outputVector, 1));
  try
  {
    this->Compare(vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(inputVector[1]), outputVector);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The meshes cannot be compared: " << error.what() << '.');
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
// Collective.
void vtkCompareQuality::Compare(vtkDataObject* a, vtkDataObject* b, vtkInformationVector* outputVector)
{
  camaron::BinSettings settings;
  settings.NumberOfBins = this->NumberOfBins;
  settings.Scale = camaron::ToBinScale(this->HistogramScale);
  std::vector<double> fractions;
  for (const double percent : camaron::GetComparedPercents())
  {
    fractions.push_back(percent / 100);
  }

  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
  const camaron::ElementBlocks blocks[2] = { { a, reducer }, { b, reducer } };
  const bool sameCells = camaron::HaveSameCells(blocks[0], blocks[1], reducer);
  std::string leftOut, missing;
  const std::vector<camaron::StatisticsArray> common = FindCommonArrays(
    camaron::FindArrays(blocks[0], reducer), camaron::FindArrays(blocks[1], reducer), leftOut);
  const std::vector<camaron::StatisticsArray> arrays = camaron::ChooseArrays(common, this->Arrays, missing);
  if (!missing.empty() && leftOut.empty())
  {
    leftOut = " There are no cell arrays with one component in both meshes named: " + missing + '.';
  }
  const bool isRoot = reducer.GetProcess() == 0;
  if (!leftOut.empty() && isRoot)
  {
    vtkWarningMacro("Not compared." << leftOut);
  }

  camaron::NewCellArrays deltas;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const camaron::Criterion* criterion = camaron::FindCriterion(arrays[i].Name);
    const camaron::BlockValues values[2] = { { blocks[0], arrays[i].Name }, { blocks[1], arrays[i].Name } };
    camaron::ArrayComparison comparison;
    comparison.Name = arrays[i].Name;
    comparison.Unit = arrays[i].Unit;
    comparison.Better = criterion ? criterion->Better : camaron::Better::Neither;
    comparison.Acceptable = ranges.Find(arrays[i].Name, arrays[i].Unit);
    for (int mesh = 0; mesh < 2; ++mesh)
    {
      comparison.Summaries[mesh] = camaron::Summarize(values[mesh].Get(),
        comparison.Acceptable ? *comparison.Acceptable : camaron::ValueRange(), reducer);
      comparison.Quantiles[mesh] =
        camaron::GetQuantiles(values[mesh].Get(), comparison.Summaries[mesh], fractions, reducer);
    }
    settings.OfIntegers = arrays[i].OfIntegers;
    comparison.Bins = camaron::MakeBins(Join(comparison.Summaries[0], comparison.Summaries[1]), settings);
    for (int mesh = 0; mesh < 2; ++mesh)
    {
      comparison.Histograms[mesh] = camaron::CountBins(values[mesh].Get(), comparison.Bins, reducer);
    }
    comparison.Distance = camaron::FindDistributionDistance(values[0].Get(), values[1].Get(), reducer);
    if (sameCells)
    {
      const MatchedValues matched(values[0], values[1]);
      comparison.Changes =
        camaron::CountChanges(matched.Before, matched.After, comparison.Better, this->Tolerance, reducer);
      AddDeltas(arrays[i].Name, matched, blocks[1], deltas);
    }
    if (isRoot)
    {
      camaron::AddComparisonRow(vtkTable::GetData(outputVector, 0), comparison);
      camaron::AddCommonHistogramRows(vtkTable::GetData(outputVector, 1), comparison);
    }
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(arrays.size()));
  }
  camaron::CopyWithCellArrays(b, deltas, vtkDataObject::GetData(outputVector, 2));
}
