// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityStatistics.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "Criteria/Criterion.h"
#include "ElementBlocks.h"
#include "Grouping.h"
#include "Statistics/MissingValues.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Weights.h"
#include "StatisticsTables.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cassert>
#include <exception>
#include <limits>
#include <stdexcept>

vtkStandardNewMacro(vtkQualityStatistics);

namespace
{
// An array to evaluate, which some process may not have.
struct StatisticsArray
{
  std::string Name;
  std::string Unit;
  bool OfIntegers = true; // a count of the registry, or an array of an integer type
};

//------------------------------------------------------------------------------
bool IsIntegral(int dataType)
{
  return dataType != VTK_FLOAT && dataType != VTK_DOUBLE;
}

//------------------------------------------------------------------------------
// All numeric cell arrays with one component that any process has, with their units.
std::vector<StatisticsArray> FindArrays(
  const camaron::ElementBlocks& blocks, camaron::Reducer& reducer)
{
  constexpr char separator = '\1'; // sorts before all characters of a name
  std::vector<std::string> own;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    vtkCellData* data = block.Data->GetCellData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = data->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfComponents() == 1)
      {
        const bool hasUnit =
          array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL());
        const camaron::Criterion* criterion = camaron::FindCriterion(array->GetName());
        const bool ofIntegers = criterion ? criterion->IsInteger : IsIntegral(array->GetDataType());
        own.push_back(std::string(array->GetName()) + separator +
          (hasUnit ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : "") +
          (ofIntegers ? 'i' : 'r'));
      }
    }
  }
  std::vector<StatisticsArray> arrays;
  for (const std::string& entry : reducer.GatherNames(own))
  {
    const std::size_t end = entry.find(separator);
    const StatisticsArray array{ entry.substr(0, end),
      entry.substr(end + 1, entry.size() - end - 2), entry.back() == 'i' };
    if (arrays.empty() || arrays.back().Name != array.Name)
    {
      arrays.push_back(array);
    }
    else
    {
      arrays.back().Unit = std::max(arrays.back().Unit, array.Unit); // rather one than none
      arrays.back().OfIntegers = arrays.back().OfIntegers && array.OfIntegers;
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
// Those that the user wants, in his order, else criteria in the order of their table.
std::vector<StatisticsArray> ChooseArrays(const std::vector<StatisticsArray>& present,
  const std::vector<std::string>& wanted, std::string& missing)
{
  std::vector<StatisticsArray> chosen;
  const auto choose = [&](const std::string& name)
  {
    const auto found = std::find_if(present.begin(), present.end(),
      [&](const StatisticsArray& array) { return array.Name == name; });
    if (found != present.end())
    {
      chosen.push_back(*found);
      const camaron::Criterion* criterion = camaron::FindCriterion(name);
      if (criterion && found->Unit.empty())
      {
        chosen.back().Unit = criterion->UnitLabel();
      }
    }
    return found != present.end();
  };
  for (const std::string& name : wanted)
  {
    if (!choose(name))
    {
      missing += (missing.empty() ? "" : ", ") + name;
    }
  }
  if (wanted.empty())
  {
    for (const camaron::Criterion& criterion : camaron::GetCriteria())
    {
      choose(criterion.Name);
    }
  }
  return chosen;
}

//------------------------------------------------------------------------------
// Mean of the points, added in the order of their coordinates: the order in the cell may depend on
// how the mesh was split.
void GetPlace(vtkDataSet* data, vtkIdType cell, double place[3])
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  std::vector<double> coordinates[3];
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    double point[3];
    data->GetPoint(ids->GetId(i), point);
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates[axis].push_back(point[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    std::sort(coordinates[axis].begin(), coordinates[axis].end());
    place[axis] = 0;
    for (const double coordinate : coordinates[axis])
    {
      place[axis] += coordinate / static_cast<double>(coordinates[axis].size());
    }
  }
}

//------------------------------------------------------------------------------
camaron::BinScale ToBinScale(const std::string& name)
{
  if (name != "Linear" && name != "Logarithmic")
  {
    throw std::invalid_argument("Histogram Scale is Linear or Logarithmic, not '" + name + "'");
  }
  return name == "Linear" ? camaron::BinScale::Linear : camaron::BinScale::Logarithmic;
}

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
}

//------------------------------------------------------------------------------
vtkQualityStatistics::vtkQualityStatistics()
  : Preset(camaron::GetDefaultRangesName())
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkQualityStatistics::~vtkQualityStatistics() = default;

//------------------------------------------------------------------------------
void vtkQualityStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
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
int vtkQualityStatistics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* tables[3];
  for (int port = 0; port < 3; ++port)
  {
    tables[port] = vtkTable::GetData(outputVector, port);
  }
  camaron::AddStatisticsColumns(tables[0], this->Quantiles, this->WeightArray);
  camaron::AddHistogramColumns(tables[1]);
  camaron::AddWorstColumns(tables[2]);

  // Whatever may be wrong with the properties is found before the first collective call, by every
  // process.
  try
  {
    camaron::BinSettings settings;
    settings.NumberOfBins = this->NumberOfBins;
    settings.Scale = ToBinScale(this->HistogramScale);
    ToBinRange(this->HistogramRange, this->CustomRange, {});
    const bool listsNull = this->WorstValues == "Null";
    const std::string worstValues = listsNull ? "Smallest" : this->WorstValues;
    camaron::FindWorstEnd("", worstValues);
    std::vector<double> fractions;
    for (const double percent : this->Quantiles)
    {
      fractions.push_back(percent / 100);
    }

    camaron::ControllerReducer reducer;
    const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
    const bool isRoot = reducer.GetProcess() == 0;
    const camaron::ElementBlocks blocks(vtkDataObject::GetData(inputVector[0]), reducer);
    camaron::Grouping groups(this->GroupBy, this->GroupArray, blocks, reducer);
    const auto blockNames = camaron::GetBlockNames(blocks, reducer);
    std::string missing;
    const std::vector<StatisticsArray> arrays =
      ChooseArrays(FindArrays(blocks, reducer), this->Arrays, missing);
    if (!missing.empty() && isRoot)
    {
      vtkWarningMacro("There are no cell arrays with one component named: " << missing << '.');
    }

    const std::optional<camaron::BlockWeights> weights = this->WeightArray.empty()
      ? std::nullopt
      : std::make_optional<camaron::BlockWeights>(blocks, this->WeightArray, reducer);

    for (std::size_t a = 0; a < arrays.size(); ++a)
    {
      const StatisticsArray& array = arrays[a];
      const auto acceptable = ranges.Find(array.Name, array.Unit);
      const auto worstEnd = camaron::FindWorstEnd(array.Name, worstValues);
      settings.OfIntegers = array.OfIntegers;
      settings.Range = ToBinRange(this->HistogramRange, this->CustomRange, acceptable);
      const camaron::BlockValues values(blocks, array.Name);
      camaron::Bins bins;
      for (std::size_t g = 0; g < groups.GetLabels().size(); ++g)
      {
        const camaron::Population population = groups.GetPopulation(g, values);
        const camaron::Summary summary =
          camaron::Summarize(population, acceptable ? *acceptable : camaron::ValueRange(), reducer);
        std::optional<camaron::WeightedSummary> weighted;
        if (weights)
        {
          weighted = camaron::SummarizeWeighted(population, summary, weights->GetPopulation(values),
            acceptable ? *acceptable : camaron::ValueRange(), reducer);
        }
        const std::vector<double> quantiles =
          camaron::GetQuantiles(population, summary, fractions, reducer);
        if (g == 0)
        {
          bins = camaron::MakeBins(summary, settings); // all groups share those of all cells
        }
        const camaron::Histogram histogram = camaron::CountBins(population, bins, reducer);
        assert(histogram.GetTotal() == summary.Count);
        std::vector<camaron::WorstElement> worst;
        if (worstEnd)
        {
          const camaron::MissingValues missingValues(listsNull ? population : camaron::Population());
          worst = camaron::FindWorst(listsNull ? missingValues.Get() : population, this->NumberOfWorst,
            *worstEnd, reducer,
            [&](camaron::WorstElement& element)
            {
              const camaron::ElementBlock& block =
                blocks.Get()[values.GetBlockNumbers()[element.Block]];
              element.BlockNumber = block.Number;
              element.CellType = block.Data->GetCellType(element.Index);
              GetPlace(block.Data, element.Index, element.Place);
            });
          for (camaron::WorstElement& element : worst)
          {
            element.Value = listsNull ? std::numeric_limits<double>::quiet_NaN() : element.Value;
          }
        }
        if (isRoot)
        {
          const camaron::RowLabels labels{ array.Name, array.Unit, groups.GetLabels()[g],
            blocks.GetIdSpace() };
          camaron::AddStatisticsRow(tables[0], labels, summary, quantiles, acceptable, weighted);
          camaron::AddHistogramRows(tables[1], labels, bins, histogram);
          camaron::AddWorstRows(tables[2], labels, worst, blockNames);
        }
      }
      this->UpdateProgress(static_cast<double>(a + 1) / static_cast<double>(arrays.size()));
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The statistics cannot be made: " << error.what() << '.');
    return 0;
  }
  return 1;
}
