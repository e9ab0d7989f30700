// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityStatistics.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "Criteria/Criterion.h"
#include "ElementBlocks.h"
#include "ElementPlaces.h"
#include "Grouping.h"
#include "Statistics/Cumulative.h"
#include "Statistics/MissingValues.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Weights.h"
#include "StatisticsArrays.h"
#include "StatisticsTables.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkQualityStatistics);

namespace
{
//------------------------------------------------------------------------------
camaron::ValueRange ToBinRange(const std::string& name, const double custom[2],
  const std::optional<camaron::ValueRange>& acceptable)
{
  if (name == "Custom")
  {
    return { custom[0], custom[1] };
  }
  if (name != "Automatic" && name != "Acceptable")
  {
    throw std::invalid_argument(
      "Histogram Range is Automatic, Acceptable or Custom, not '" + name + "'");
  }
  return name == "Acceptable" && acceptable ? *acceptable : camaron::ValueRange();
}

//------------------------------------------------------------------------------
camaron::ElementKind ToElementKind(const std::string& name)
{
  if (name != "Cells" && name != "Points")
  {
    throw std::invalid_argument("Element Type is Cells or Points, not '" + name + "'");
  }
  return name == "Cells" ? camaron::ElementKind::Cells : camaron::ElementKind::Points;
}

//------------------------------------------------------------------------------
// Collective. Of every element of every block whether it is selected.
std::vector<std::vector<unsigned char>> FindSelected(
  const camaron::ElementBlocks& blocks, const std::string& arrayName, camaron::Reducer& reducer)
{
  std::vector<std::vector<unsigned char>> marks;
  std::int64_t numberOfArrays = 0;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    marks.emplace_back(block.GetSize(), 0);
    if (vtkDataArray* array = block.GetArray(arrayName))
    {
      ++numberOfArrays;
      vtkNew<vtkDoubleArray> values;
      values->DeepCopy(array);
      std::transform(values->GetPointer(0), values->GetPointer(0) + block.GetSize(), marks.back().begin(),
        [](double value) { return value != 0 && !std::isnan(value); });
    }
  }
  std::int64_t counts[2] = { numberOfArrays, static_cast<std::int64_t>(marks.size()) };
  reducer.Sum(counts, 2);
  if (counts[0] == 0 && counts[1] > 0)
  {
    throw std::invalid_argument(
      "there is no array with one component named '" + arrayName + "' to tell what is selected");
  }
  return marks;
}

//------------------------------------------------------------------------------
// Collective. @a listsNull: those without a value instead.
std::vector<camaron::WorstElement> FindWorstElements(const camaron::Population& population, bool listsNull,
  int count, camaron::WorstEnd end, const camaron::ElementBlocks& blocks,
  const camaron::BlockValues& values, camaron::Reducer& reducer)
{
  const camaron::MissingValues missing(listsNull ? population : camaron::Population());
  std::vector<camaron::WorstElement> worst =
    camaron::FindWorst(listsNull ? missing.Get() : population, count, end, reducer,
      [&](camaron::WorstElement& element)
      {
        const camaron::ElementBlock& block = blocks.Get()[values.GetBlockNumbers()[element.Block]];
        element.BlockNumber = block.Number;
        element.CellType = blocks.GetKind() == camaron::ElementKind::Points
          ? camaron::PointCellType
          : block.Data->GetCellType(element.Index);
        camaron::GetPlace(block, element.Index, element.Place);
      });
  for (camaron::WorstElement& element : worst)
  {
    element.Value = listsNull ? std::numeric_limits<double>::quiet_NaN() : element.Value;
  }
  return worst;
}
}

//------------------------------------------------------------------------------
vtkQualityStatistics::vtkQualityStatistics()
  : Preset(camaron::GetDefaultRangesName())
{
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
vtkQualityStatistics::~vtkQualityStatistics() = default;

//------------------------------------------------------------------------------
void vtkQualityStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ElementType: " << this->ElementType << '\n';
  os << indent << "OnlySelected: " << this->OnlySelected << '\n';
  os << indent << "SelectionArray: " << this->SelectionArray << '\n';
  os << indent << "AllTimeSteps: " << this->AllTimeSteps << '\n';
  os << indent << "CurvePoints: " << this->CurvePoints << '\n';
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << ' ' << name;
  }
  os << '\n' << indent << "Preset: " << this->Preset << '\n';
  os << indent << "RangesFile: " << this->RangesFile << '\n';
  os << indent << "GroupBy: " << this->GroupBy << '\n';
  os << indent << "GroupArray: " << this->GroupArray << '\n';
  os << indent << "WeightArray: " << this->WeightArray << '\n';
  os << indent << "Quantiles (%):";
  for (const double percent : this->Quantiles)
  {
    os << ' ' << percent;
  }
  os << '\n' << indent << "NumberOfBins: " << this->NumberOfBins << '\n';
  os << indent << "HistogramRange: " << this->HistogramRange << '\n';
  os << indent << "CustomRange: " << this->CustomRange[0] << ' ' << this->CustomRange[1] << '\n';
  os << indent << "HistogramScale: " << this->HistogramScale << '\n';
  os << indent << "NumberOfWorst: " << this->NumberOfWorst << '\n';
  os << indent << "WorstValues: " << this->WorstValues << '\n';
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::SetText(std::string& member, const char* text)
{
  const std::string value = text ? text : "";
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::AddArray(const char* name)
{
  if (name && name[0])
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkQualityStatistics::AddQuantile(double percent)
{
  if (!(percent >= 0 && percent <= 100))
  {
    vtkErrorMacro("A quantile is between 0 and 100 percent, not " << percent << '.');
    return;
  }
  // Each has a column of its own.
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
int vtkQualityStatistics::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
// What the properties mean.
struct vtkQualityStatistics::Settings
{
  camaron::ElementKind Kind;
  camaron::BinSettings Bins;
  bool ListsNull;
  std::string WorstValues;
  std::vector<double> Fractions;
};

//------------------------------------------------------------------------------
struct vtkQualityStatistics::Tables
{
  vtkTable *Statistics, *Histogram, *Worst, *Curve;
  std::optional<double> Time; // of the rows to add
};

//------------------------------------------------------------------------------
vtkQualityStatistics::Settings vtkQualityStatistics::CheckSettings() const
{
  Settings settings;
  settings.Kind = ToElementKind(this->ElementType);
  settings.Bins.NumberOfBins = this->NumberOfBins;
  settings.Bins.Scale = camaron::ToBinScale(this->HistogramScale);
  ToBinRange(this->HistogramRange, this->CustomRange, {});
  settings.ListsNull = this->WorstValues == "Null";
  settings.WorstValues = settings.ListsNull ? "Smallest" : this->WorstValues;
  camaron::FindWorstEnd("", settings.WorstValues);
  for (const double percent : this->Quantiles)
  {
    settings.Fractions.push_back(percent / 100);
  }
  return settings;
}

//------------------------------------------------------------------------------
int vtkQualityStatistics::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  this->TimeSteps.clear();
  if (const int size = info->Length(Pipeline::TIME_STEPS()))
  {
    this->TimeSteps.resize(size);
    info->Get(Pipeline::TIME_STEPS(), this->TimeSteps.data());
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts() && this->AllTimeSteps; ++port)
  {
    // The tables are those of all times.
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_STEPS());
    outputVector->GetInformationObject(port)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityStatistics::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  if (this->TimeStep < this->GetNumberOfSteps())
  {
    inputVector[0]->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), this->TimeSteps[this->TimeStep]);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityStatistics::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  Tables tables = { vtkTable::GetData(outputVector, 0), vtkTable::GetData(outputVector, 1),
    vtkTable::GetData(outputVector, 2), vtkTable::GetData(outputVector, 3), {} };
  if (this->TimeStep == 0)
  {
    const camaron::TableLayout layout = { this->AllTimeSteps, this->WeightArray };
    for (vtkTable* table : { tables.Statistics, tables.Histogram, tables.Worst, tables.Curve })
    {
      table->Initialize();
    }
    camaron::AddStatisticsColumns(tables.Statistics, layout, this->Quantiles);
    camaron::AddHistogramColumns(tables.Histogram, layout);
    camaron::AddWorstColumns(tables.Worst, layout);
    camaron::AddCurveColumns(tables.Curve, layout);
  }
  if (this->AllTimeSteps)
  {
    tables.Time = this->TimeStep < this->GetNumberOfSteps() ? this->TimeSteps[this->TimeStep]
                                                            : std::numeric_limits<double>::quiet_NaN();
  }
  try
  {
    // Whatever may be wrong with the properties is found before the first collective call, by every
    // process.
    const Settings settings = this->CheckSettings();
    this->AddRows(vtkDataObject::GetData(inputVector[0]), settings, tables);
  }
  catch (const std::exception& error)
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    this->TimeStep = 0;
    vtkErrorMacro("The statistics cannot be made: " << error.what() << '.');
    return 0;
  }
  if (++this->TimeStep < this->GetNumberOfSteps())
  {
    request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
  }
  else
  {
    request->Remove(Pipeline::CONTINUE_EXECUTING());
    this->TimeStep = 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
// Collective.
void vtkQualityStatistics::AddRows(
  vtkDataObject* input, const Settings& settings, const Tables& tables)
{
  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
  const bool isRoot = reducer.GetProcess() == 0;
  camaron::ElementBlocks blocks(input, reducer, settings.Kind);
  camaron::Grouping groups(this->GroupBy, this->GroupArray, blocks, reducer);
  if (this->OnlySelected)
  {
    blocks.Restrict(FindSelected(blocks, this->SelectionArray, reducer));
  }
  const auto blockNames = camaron::GetBlockNames(blocks, reducer);
  std::string missing;
  const std::vector<camaron::StatisticsArray> arrays =
    camaron::ChooseArrays(camaron::FindArrays(blocks, reducer), this->Arrays, missing);
  if (!missing.empty() && isRoot && this->TimeStep == 0)
  {
    const bool areCells = settings.Kind == camaron::ElementKind::Cells;
    vtkWarningMacro(
      "There are no " << (areCells ? "cell" : "point") << " arrays with one component named: " << missing << '.');
  }
  if (this->GroupBy == "Cell array" && groups.GetLabels().size() == 1 && isRoot && this->TimeStep == 0)
  {
    vtkWarningMacro(
      "There is nothing to group: no cell array with one component is named '" << this->GroupArray << "'.");
  }
  const std::optional<camaron::BlockWeights> weights = this->WeightArray.empty()
    ? std::nullopt
    : std::make_optional<camaron::BlockWeights>(blocks, this->WeightArray, reducer);
  camaron::BinSettings binSettings = settings.Bins;

  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const camaron::StatisticsArray& array = arrays[a];
    const auto acceptable = ranges.Find(array.Name, array.Unit);
    const camaron::ValueRange limits = acceptable ? *acceptable : camaron::ValueRange();
    const auto worstEnd = camaron::FindWorstEnd(array.Name, settings.WorstValues);
    binSettings.OfIntegers = array.OfIntegers;
    binSettings.Range = ToBinRange(this->HistogramRange, this->CustomRange, acceptable);
    const camaron::BlockValues values(blocks, array.Name);
    camaron::Bins bins;
    for (std::size_t g = 0; g < groups.GetLabels().size(); ++g)
    {
      const camaron::Population population = groups.GetPopulation(g, values);
      const camaron::Summary summary = camaron::Summarize(population, limits, reducer);
      const auto places =
        camaron::FindPlaces({ summary.ArgMinPlace, summary.ArgMaxPlace }, blocks, values, reducer);
      std::optional<camaron::WeightedSummary> weighted;
      camaron::Population weightsOfValues;
      if (weights)
      {
        weightsOfValues = weights->GetPopulation(values);
        weighted =
          camaron::SummarizeWeighted(population, summary, weightsOfValues, limits, reducer);
      }
      const std::vector<double> quantiles =
        camaron::GetQuantiles(population, summary, settings.Fractions, reducer);
      if (g == 0)
      {
        bins = camaron::MakeBins(summary, binSettings); // all groups share those of all cells
      }
      const camaron::Histogram histogram = camaron::CountBins(population, bins, reducer);
      assert(histogram.GetTotal() == summary.Count);
      const camaron::CumulativeCurve curve = camaron::MakeCumulativeCurve(
        population, summary, this->CurvePoints, weights ? &weightsOfValues : nullptr, reducer);
      std::vector<camaron::WorstElement> worst;
      if (worstEnd)
      {
        worst = FindWorstElements(
          population, settings.ListsNull, this->NumberOfWorst, *worstEnd, blocks, values, reducer);
      }
      if (isRoot)
      {
        const camaron::RowLabels labels{ array.Name, array.Unit, groups.GetLabels()[g],
          blocks.GetIdSpace(), tables.Time };
        camaron::AddStatisticsRow(tables.Statistics, labels, summary, { places[0], places[1] },
          quantiles, acceptable, weighted);
        camaron::AddHistogramRows(tables.Histogram, labels, bins, histogram);
        camaron::AddWorstRows(tables.Worst, labels, worst, blockNames);
        camaron::AddCurveRows(tables.Curve, labels, curve, summary, weighted);
      }
    }
    const int numberOfSteps = std::max(this->GetNumberOfSteps(), 1);
    const double share = static_cast<double>(a + 1) / static_cast<double>(arrays.size());
    this->UpdateProgress((this->TimeStep + share) / numberOfSteps);
  }
}
