// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityStatistics.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "Criteria/Criterion.h"
#include "ElementBlocks.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "PropertyValues.h"
#include "RequestFailure.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Weights.h"
#include "Statistics/Worst.h"
#include "StatisticsArrays.h"
#include "StatisticsTables.h"
#include "TimeSteps.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkQualityStatistics);

namespace
{
constexpr char AllElements[] = "All elements"; // a range of bins

//------------------------------------------------------------------------------
camaron::ValueRange ToBinRange(const std::string& name, const double custom[2],
  const std::optional<camaron::ValueRange>& acceptable)
{
  if (name == "Custom")
  {
    if (!(custom[0] <= custom[1]))
    {
      std::ostringstream text;
      text << "Custom Range must go from a smaller to a larger number, not from " << custom[0]
           << " to " << custom[1];
      throw std::invalid_argument(text.str());
    }
    return { custom[0], custom[1] };
  }
  if (name != "Automatic" && name != AllElements && name != "Acceptable")
  {
    throw std::invalid_argument(
      "Histogram Range must be Automatic, All elements, Acceptable or Custom, not '" + name + "'");
  }
  return name == "Acceptable" && acceptable ? *acceptable : camaron::ValueRange();
}

//------------------------------------------------------------------------------
// The results of one array for one group of elements.
struct GroupNumbers
{
  camaron::Summary Totals;
  std::optional<camaron::WeightedSummary> Weighted;
  std::vector<double> Quantiles;
  camaron::Histogram Counts;
  std::vector<std::int64_t> Judged; // of these
  camaron::CumulativeCurve Curve;
  std::vector<std::array<double, 3>> Places; // of the smallest and the largest value
  std::vector<camaron::WorstElement> Worst;
  std::vector<std::string> VerticesOfWorst;
};

//------------------------------------------------------------------------------
// Collective. For every element of every block whether it is selected.
std::vector<std::vector<unsigned char>> FindSelected(
  const camaron::ElementBlocks& blocks, const std::string& arrayName, camaron::Reducer& reducer)
{
  std::vector<std::vector<unsigned char>> marks;
  std::size_t numberOfArrays = 0;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    marks.emplace_back(block.GetSize(), 0);
    if (vtkDataArray* array = block.GetArray(arrayName))
    {
      ++numberOfArrays;
      vtkNew<vtkDoubleArray> values;
      values->DeepCopy(array);
      std::transform(values->GetPointer(0), values->GetPointer(0) + block.GetSize(),
        marks.back().begin(), [](double value) { return value != 0 && !std::isnan(value); });
    }
  }
  blocks.RequireAny(numberOfArrays,
    "Only Selected needs a one-component array named '" + arrayName + "', which does not exist",
    reducer);
  return marks;
}

//------------------------------------------------------------------------------
// Collective. @a listsUndefined: lists undefined values instead.
std::vector<camaron::WorstElement> FindWorstElements(const camaron::Population& population,
  bool listsUndefined, int count, camaron::WorstEnd end, const camaron::ElementBlocks& blocks,
  const camaron::BlockValues& values, camaron::Reducer& reducer)
{
  const camaron::MissingValues missing(listsUndefined ? population : camaron::Population());
  std::vector<camaron::WorstElement> worst =
    camaron::FindWorst(listsUndefined ? missing.Get() : population, count, end, reducer,
      [&](camaron::WorstElement& element)
      { camaron::DescribeElement(blocks, values, reducer.GetProcess(), element); });
  for (camaron::WorstElement& element : worst)
  {
    element.Value = listsUndefined ? std::numeric_limits<double>::quiet_NaN() : element.Value;
  }
  return worst;
}
}

//------------------------------------------------------------------------------
vtkQualityStatistics::vtkQualityStatistics()
{
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::AddQuantile(double percent)
{
  if (!(percent >= 0 && percent <= 100))
  {
    vtkErrorMacro("A quantile must be 0 to 100 percent, not " << percent << '.');
    return;
  }
  // Every quantile has its own column.
  if (std::find(this->Quantiles.begin(), this->Quantiles.end(), percent) == this->Quantiles.end())
  {
    this->Quantiles.push_back(percent);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::ClearQuantiles()
{
  this->Quantiles.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::AddCurveValue(double value)
{
  if (std::isnan(value))
  {
    vtkErrorMacro("A curve value must be a number, not NaN.");
    return;
  }
  this->CurveValues.push_back(value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::ClearCurveValues()
{
  this->CurveValues.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::AddBinEdge(double value)
{
  if (std::isnan(value))
  {
    vtkErrorMacro("An edge of bins must be a number, not NaN.");
    return;
  }
  this->BinEdges.push_back(value);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::ClearBinEdges()
{
  this->BinEdges.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkQualityStatistics::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
// The properties, checked and converted.
struct vtkQualityStatistics::Settings
{
  camaron::ElementKind Kind;
  camaron::BinSettings Bins;
  bool ListsUndefined;
  std::string WorstValues;
  std::vector<double> Fractions;
};

//------------------------------------------------------------------------------
vtkQualityStatistics::Settings vtkQualityStatistics::CheckSettings() const
{
  constexpr int most = 100000;
  camaron::CheckNumber("Number Of Bins", this->NumberOfBins, 1, most);
  camaron::CheckNumber("Curve Points", this->CurvePoints, 0, most);
  camaron::CheckNumber("Number Of Worst", this->NumberOfWorst, 0);
  Settings settings;
  settings.Kind = camaron::ParseElementKind(this->ElementType);
  settings.Bins.NumberOfBins = this->NumberOfBins;
  settings.Bins.Scale = camaron::ToBinScale(this->HistogramScale);
  settings.Bins.Edges = this->BinEdges;
  ToBinRange(this->HistogramRange, this->CustomRange, {});
  settings.ListsUndefined = this->WorstValues == "Undefined";
  settings.WorstValues = settings.ListsUndefined ? "Smallest" : this->WorstValues;
  camaron::FindWorstEnd("", settings.WorstValues);
  for (const double percent : this->Quantiles)
  {
    settings.Fractions.push_back(percent / 100);
  }
  return settings;
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::MakeColumns(vtkInformationVector* outputVector)
{
  const camaron::TableLayout layout = { this->AllTimeSteps, this->WeightArray };
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkTable::GetData(outputVector, port)->Initialize();
  }
  camaron::AddStatisticsColumns(vtkTable::GetData(outputVector, 0), layout, this->Quantiles);
  camaron::AddHistogramColumns(vtkTable::GetData(outputVector, 1), layout);
  camaron::AddWorstColumns(vtkTable::GetData(outputVector, 2), layout);
  camaron::AddCurveColumns(vtkTable::GetData(outputVector, 3), layout);
}

//------------------------------------------------------------------------------
// Collective.
void vtkQualityStatistics::AddRows(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const Settings settings = this->CheckSettings();
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer, this->Ranges);
  const bool isRoot = reducer.GetProcess() == 0;
  camaron::ElementBlocks blocks(input, reducer, settings.Kind);
  camaron::Grouping groups(this->GroupBy, this->GroupArray, blocks, reducer);
  std::optional<camaron::ElementBlocks> whole; // where bins do not depend on what is selected
  if (this->OnlySelected)
  {
    if (this->HistogramRange == AllElements || this->HistogramRange == "Custom")
    {
      whole = blocks;
    }
    blocks.Restrict(FindSelected(blocks, this->SelectionArray, reducer));
  }
  const auto blockNames = camaron::GetBlockNames(blocks, reducer);
  std::vector<std::string> missing;
  const std::vector<camaron::StatisticsArray> arrays =
    camaron::ChooseArrays(camaron::FindArrays(blocks, reducer), this->Arrays, missing);
  this->Found->Add(this->Steps->GetTime(), arrays, missing, !blocks.AreEmpty(reducer));
  this->WarnOfNoGroups(groups.GetArrayName(), groups.GetGroups().size(), isRoot);
  const std::optional<camaron::BlockWeights> weights = this->WeightArray.empty()
    ? std::nullopt
    : std::make_optional<camaron::BlockWeights>(blocks, this->WeightArray, reducer);
  const camaron::ElementVertices vertices(blocks, reducer);
  camaron::BinSettings binSettings = settings.Bins;
  camaron::BlockShapes shapes(blocks);
  std::size_t done = 0;

  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const camaron::StatisticsArray& array = arrays[a];
    const auto acceptable = ranges.Find(array.Name, array.Unit);
    const camaron::ValueRange limits = acceptable.value_or(camaron::AcceptableRange());
    const auto worstEnd = camaron::FindWorstEnd(array.Name, settings.WorstValues);
    binSettings.OfIntegers = array.OfIntegers;
    binSettings.Range = ToBinRange(this->HistogramRange, this->CustomRange, acceptable);
    camaron::BlockValues values(blocks, array.Name, reducer);
    const bool judgesSome = shapes.Judge(values, acceptable);
    camaron::Bins bins;
    GroupNumbers numbers;
    for (const camaron::Group& group : groups.GetGroups())
    {
      camaron::CheckAbortOnAllRanks(this,
        this->Steps->GetProgress(static_cast<double>(done++) /
          static_cast<double>(arrays.size() * groups.GetGroups().size())),
        reducer);
      if (group.IsAll || !groups.IsOneGroup())
      {
        const camaron::Population population = groups.GetPopulation(group, values);
        numbers.Totals = camaron::Summarize(population, limits, reducer, this->Moments);
        const camaron::Summary& summary = numbers.Totals;
        numbers.Places = camaron::FindPlaces(
          { summary.ArgMinPlace, summary.ArgMaxPlace }, blocks, values, reducer);
        std::optional<camaron::Weights> weightsOfValues;
        if (weights)
        {
          weightsOfValues = weights->GetWeights(values);
          numbers.Weighted =
            camaron::SummarizeWeighted(population, summary, *weightsOfValues, limits, reducer);
        }
        std::vector<std::int64_t> positions =
          camaron::GetPositionsOfQuantiles(summary, settings.Fractions);
        const auto ofCurve = camaron::GetPositionsOfCurve(summary, this->CurvePoints);
        positions.insert(positions.end(), ofCurve.begin(), ofCurve.end());
        const camaron::OrderStatistics sorted(population, summary, std::move(positions), reducer);
        numbers.Quantiles = camaron::GetQuantiles(sorted, summary, settings.Fractions);
        if (group.IsAll)
        {
          // All groups share the bins of all cells.
          bins = camaron::MakeBins(whole
              ? camaron::Summarize(
                  camaron::BlockValues(*whole, array.Name, reducer).Get(), limits, reducer, false)
              : summary,
            binSettings);
        }
        numbers.Counts = camaron::CountBins(population, bins, reducer);
        assert(numbers.Counts.GetTotal() == summary.Count);
        numbers.Judged = judgesSome ? camaron::CountJudged(population, bins, reducer)
          : acceptable              ? numbers.Counts.Counts
                                    : std::vector<std::int64_t>(bins.GetSize());
        numbers.Curve = camaron::MakeCumulativeCurve(population, summary, sorted, this->CurvePoints,
          weights ? &*weightsOfValues : nullptr, reducer, this->CurveValues);
        if (worstEnd)
        {
          numbers.Worst = FindWorstElements(population, settings.ListsUndefined,
            this->NumberOfWorst, *worstEnd, blocks, values, reducer);
        }
        numbers.VerticesOfWorst = vertices.Find(numbers.Worst, values);
      }
      if (isRoot)
      {
        const camaron::RowLabels labels{ array.Name, array.Unit, group.Label, blocks.GetIdSpace(),
          this->Steps->GetTime() };
        camaron::AddStatisticsRow(vtkTable::GetData(outputVector, 0), labels, numbers.Totals,
          { numbers.Places[0], numbers.Places[1] }, numbers.Quantiles, acceptable,
          numbers.Weighted);
        camaron::AddHistogramRows(
          vtkTable::GetData(outputVector, 1), labels, bins, numbers.Counts, numbers.Judged);
        camaron::AddWorstRows(vtkTable::GetData(outputVector, 2), labels, acceptable.has_value(),
          numbers.Worst, numbers.VerticesOfWorst, blockNames);
        camaron::AddCurveRows(vtkTable::GetData(outputVector, 3), labels, numbers.Curve,
          numbers.Totals, numbers.Weighted);
      }
    }
  }
}
