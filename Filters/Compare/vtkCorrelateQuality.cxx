// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCorrelateQuality.h"

#include "AcceptableRanges.h"
#include "Base/Number.h"
#include "Base/Parallel.h"
#include "ControllerReducer.h"
#include "Criteria/Criterion.h"
#include "ElementBlocks.h"
#include "Grouping.h"
#include "Mesh/MeshView.h"
#include "MeshInput.h"
#include "MeshOutputs.h"
#include "Ranks/Collective.h"
#include "RequestFailure.h"
#include "Statistics/Correlation.h"
#include "StatisticsArrays.h"
#include "TableRows.h"
#include "TimeSteps.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

vtkStandardNewMacro(vtkCorrelateQuality);

namespace camaron
{
namespace
{
// Coordinates of a point, and the value there.
using Sample = std::array<double, 4>;

//------------------------------------------------------------------------------
double GetMagnitude(vtkDataArray* array, vtkIdType i)
{
  const int size = array->GetNumberOfComponents();
  double length = size == 1 ? array->GetComponent(i, 0) : 0;
  for (int c = 0; c < size && size > 1; ++c)
  {
    length = std::hypot(length, array->GetComponent(i, c));
  }
  return length;
}

//------------------------------------------------------------------------------
double FindMean(const std::vector<Sample>& samples)
{
  double sum = 0;
  for (const Sample& sample : samples)
  {
    sum += sample[3];
  }
  return samples.empty() ? NaN : sum / static_cast<double>(samples.size());
}

//------------------------------------------------------------------------------
std::vector<double> FromPoints(vtkDataSet* data, vtkDataArray* array)
{
  const vtkSmartPointer<vtkDataSet> mesh = AsMesh(data);
  const MeshView view(mesh);
  std::vector<double> values(view.GetNumberOfCells());
  ParallelFor(view.GetNumberOfCells(), 1 << 12,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Sample> samples;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const IndexRange points = view.GetCellPoints(cell);
        samples.resize(points.Size);
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          view.GetPoint(points[i], samples[i].data());
          samples[i][3] = GetMagnitude(array, points[i]);
        }
        // The order of points in the cell may depend on how the mesh was split.
        std::sort(samples.begin(), samples.end());
        values[cell] = FindMean(samples);
      }
    });
  return values;
}

//------------------------------------------------------------------------------
std::vector<double> FromCells(vtkDataArray* array)
{
  std::vector<double> values(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = GetMagnitude(array, static_cast<vtkIdType>(i));
  }
  return values;
}

//------------------------------------------------------------------------------
/// A field of a simulation as one value per cell. Fields with several components contribute their
/// magnitude. The value of a point field is the mean of the values at the points of the cell. It
/// depends neither on the partition of the mesh nor on the order of the points.
struct CellField
{
  std::vector<std::vector<double>> Values; ///< one list per block, empty without the array
};

//------------------------------------------------------------------------------
// Collective. Throws std::invalid_argument on all processes if no process has the array, or it has
// integers that are no exact doubles.
CellField FindCellField(
  const ElementBlocks& blocks, const std::string& name, bool isOfPoints, Reducer& reducer)
{
  blocks.RequireExactIntegers(isOfPoints ? ElementKind::Points : ElementKind::Cells, name, reducer);
  CellField field;
  std::size_t numberOfArrays = 0;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataArray* array =
      block.Data->GetAttributes(isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL)
        ->GetArray(name.c_str());
    numberOfArrays += array != nullptr;
    field.Values.push_back(!array ? std::vector<double>()
        : isOfPoints              ? FromPoints(block.Data, array)
                                  : FromCells(array));
  }
  blocks.RequireAny(numberOfArrays,
    "there is no " + std::string(isOfPoints ? "point" : "cell") + " array named '" + name + "'",
    reducer);
  return field;
}
}
}

namespace
{
//------------------------------------------------------------------------------
// The blocks that have both criterion and field, restricted to the cells in which both are defined.
struct Pairs
{
  camaron::Population Quality, Field;

  /// @a population is a population of @a values.
  Pairs(const camaron::Population& population, const camaron::BlockValues& values,
    const camaron::CellField& field)
  {
    this->Masks.resize(population.size());
    for (std::size_t i = 0; i < population.size(); ++i)
    {
      const std::vector<double>& fieldValues = field.Values[values.GetBlockNumbers()[i]];
      camaron::ValueBlock quality = population[i];
      if (fieldValues.empty())
      {
        continue;
      }
      std::vector<unsigned char>& mask = this->Masks[i];
      mask.resize(quality.Size);
      for (vtkIdType cell = 0; cell < quality.Size; ++cell)
      {
        mask[cell] = !quality.Contains(cell) || std::isnan(quality.Values[cell]) ||
          std::isnan(fieldValues[cell]);
      }
      quality.Skip = mask.data();
      this->Quality.push_back(quality);
      this->Field.push_back(quality.WithValues(fieldValues.data()));
    }
  }

  /// For each block the cells to skip; empty for a block without the field.
  const std::vector<std::vector<unsigned char>>& GetMasks() const { return this->Masks; }

private:
  std::vector<std::vector<unsigned char>> Masks;
};

//------------------------------------------------------------------------------
// Ranks of the field. Criteria that are defined in the same cells share them.
class FieldRanks
{
public:
  /// Collective. Valid until the next call.
  const camaron::BlockRanks& Get(const Pairs& pairs, camaron::Reducer& reducer)
  {
    std::int64_t isOther = this->Masks != pairs.GetMasks();
    reducer.Max(&isOther, 1);
    if (isOther)
    {
      this->Ranks = camaron::FindDoubledRanks(pairs.Field, reducer);
      this->Masks = pairs.GetMasks();
    }
    return this->Ranks;
  }

private:
  std::vector<std::vector<unsigned char>> Masks;
  camaron::BlockRanks Ranks;
};

//------------------------------------------------------------------------------
camaron::Population WithValues(camaron::Population population, const camaron::BlockRanks& values)
{
  for (std::size_t i = 0; i < population.size(); ++i)
  {
    population[i] = population[i].WithValues(values[i].data());
  }
  return population;
}

//------------------------------------------------------------------------------
// Values of the field in the cells outside a range, compared with those inside.
struct OutsideCells
{
  std::int64_t Count = 0;
  double MeanInside = camaron::NaN;
  double MeanOutside = camaron::NaN;
  /// Probability that the field is larger in a cell outside than in one inside; ties count half.
  double Above = camaron::NaN;
};

//------------------------------------------------------------------------------
// Collective. Sum of the doubled ranks of the cells that the mask does not skip.
std::int64_t SumRanks(const camaron::BlockRanks& ranks,
  const std::vector<std::vector<unsigned char>>& masks, camaron::Reducer& reducer)
{
  std::int64_t sum = 0;
  for (std::size_t b = 0; b < masks.size(); ++b)
  {
    for (std::size_t i = 0; i < masks[b].size(); ++i)
    {
      sum += masks[b][i] ? 0 : static_cast<std::int64_t>(ranks[b][i]);
    }
  }
  reducer.Sum(&sum, 1);
  return sum;
}

//------------------------------------------------------------------------------
// Collective. @a ranks: of the field. Only cells to which the range applies are inside or outside.
OutsideCells FindOutsideCells(const Pairs& pairs, const camaron::BlockRanks& ranks,
  const camaron::ValueRange& acceptable, camaron::Reducer& reducer)
{
  enum Part
  {
    Inside,
    Outside,
    Judged,
    NumberOfParts
  };
  std::int64_t counts[NumberOfParts] = {};
  std::int64_t hasOthers = 0;
  camaron::Population parts[NumberOfParts] = { pairs.Field, pairs.Field, pairs.Field };
  std::vector<std::vector<unsigned char>> masks[NumberOfParts];
  for (std::size_t b = 0; b < pairs.Quality.size(); ++b)
  {
    const camaron::ValueBlock& block = pairs.Quality[b];
    for (int part = 0; part < NumberOfParts; ++part)
    {
      masks[part].emplace_back(block.Size, 1);
      parts[part][b].Skip = masks[part][b].data();
    }
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      if (block.Contains(i) && block.IsJudged(i))
      {
        const bool isOutside =
          block.Values[i] < acceptable.Low || block.Values[i] > acceptable.High;
        for (const Part part : { isOutside ? Outside : Inside, Judged })
        {
          ++counts[part];
          masks[part][b][i] = 0;
        }
      }
      else if (block.Contains(i))
      {
        hasOthers = 1;
      }
    }
  }
  reducer.Sum(counts, NumberOfParts);
  reducer.Max(&hasOthers, 1);
  OutsideCells result;
  result.Count = counts[Outside];
  result.MeanInside = camaron::Summarize(parts[Inside], camaron::ValueRange(), reducer).Mean;
  result.MeanOutside = camaron::Summarize(parts[Outside], camaron::ValueRange(), reducer).Mean;
  if (counts[Inside] > 0 && counts[Outside] > 0)
  {
    // Twice the statistic of Mann and Whitney.
    const std::int64_t sum =
      SumRanks(hasOthers ? camaron::FindDoubledRanks(parts[Judged], reducer) : ranks,
        masks[Outside], reducer);
    const std::int64_t doubled = sum - counts[Outside] * (counts[Outside] + 1);
    result.Above = static_cast<double>(doubled) / 2 / static_cast<double>(counts[Inside]) /
      static_cast<double>(counts[Outside]);
  }
  return result;
}

//------------------------------------------------------------------------------
void AddColumnsOfTable(vtkTable* table, bool hasTime)
{
  camaron::AddLabelColumns(table, hasTime);
  camaron::AddColumns<vtkStringArray>(table, { "Field" });
  camaron::AddColumns<camaron::IntegerColumn>(table, { "Count" });
  camaron::AddColumns<vtkDoubleArray>(
    table, { "Pearson", "Spearman", "AcceptableLow", "AcceptableHigh" });
  camaron::AddColumns<camaron::IntegerColumn>(table, { "OutsideCount" });
  camaron::AddColumns<vtkDoubleArray>(
    table, { "FieldMeanInside", "FieldMeanOutside", "OutsideAbove" });
}

//------------------------------------------------------------------------------
std::int64_t CountElements(const camaron::Population& population, camaron::Reducer& reducer)
{
  std::int64_t count = 0;
  for (const camaron::ValueBlock& block : population)
  {
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      count += block.Contains(i);
    }
  }
  reducer.Sum(&count, 1);
  return count;
}

//------------------------------------------------------------------------------
struct Correlation
{
  std::int64_t Count;
  double Pearson, Spearman;
  OutsideCells Outside;
};

// Collective.
Correlation FindCorrelation(const Pairs& pairs, const camaron::BlockRanks& fieldRanks,
  const std::optional<camaron::ValueRange>& acceptable, camaron::Reducer& reducer)
{
  Correlation result;
  result.Count = CountElements(pairs.Quality, reducer);
  result.Pearson = camaron::CorrelateLinearly(pairs.Quality, pairs.Field, reducer);
  const camaron::BlockRanks qualityRanks = camaron::FindDoubledRanks(pairs.Quality, reducer);
  result.Spearman = camaron::CorrelateLinearly(
    WithValues(pairs.Quality, qualityRanks), WithValues(pairs.Field, fieldRanks), reducer);
  if (acceptable)
  {
    result.Outside = FindOutsideCells(pairs, fieldRanks, *acceptable, reducer);
  }
  return result;
}

//------------------------------------------------------------------------------
// Names of arrays are preceded by a letter for cells or points.
constexpr char OfCells = 'C', OfPoints = 'P';

std::string GetToldField(vtkInformation* info)
{
  if (!info->Has(vtkDataObject::FIELD_NAME()) || !info->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    return "";
  }
  const std::string name = info->Get(vtkDataObject::FIELD_NAME());
  const bool isOfPoints =
    info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return name.empty() ? "" : (isOfPoints ? OfPoints : OfCells) + name;
}

//------------------------------------------------------------------------------
struct ChosenField
{
  bool IsOfPoints;
  std::string Name;
};

// Collective. If the user has chosen no field: the active point scalars, else another point array,
// else a cell array that is not a criterion.
ChosenField ChooseField(
  vtkInformation* info, const camaron::ElementBlocks& blocks, camaron::Reducer& reducer)
{
  std::vector<std::string> active, ofPoints, ofCells;
  for (const camaron::ElementBlock& block : blocks.Get())
  {
    vtkPointData* points = block.Data->GetPointData();
    for (int i = 0; i < points->GetNumberOfArrays(); ++i)
    {
      if (points->GetArray(i) && points->GetArrayName(i))
      {
        const bool isActive = points->GetArray(i) == points->GetScalars();
        (isActive ? active : ofPoints).push_back(OfPoints + std::string(points->GetArrayName(i)));
      }
    }
    vtkCellData* cells = block.Data->GetCellData();
    for (int i = 0; i < cells->GetNumberOfArrays(); ++i)
    {
      if (cells->GetArray(i) && cells->GetArrayName(i) &&
        !camaron::FindCriterion(cells->GetArrayName(i)))
      {
        ofCells.push_back(OfCells + std::string(cells->GetArrayName(i)));
      }
    }
  }
  const std::string name =
    camaron::AgreeOnName(GetToldField(info), { active, ofPoints, ofCells }, reducer);
  blocks.RequireAny(name.size(), "the mesh has no array to use as the field", reducer);
  return { !name.empty() && name.front() == OfPoints, name.empty() ? name : name.substr(1) };
}

//------------------------------------------------------------------------------
camaron::NewCellArrays MakeFieldArrays(
  const camaron::ElementBlocks& blocks, const camaron::CellField& field, const std::string& name)
{
  camaron::NewCellArrays fields;
  for (std::size_t b = 0; b < blocks.Get().size(); ++b)
  {
    const std::vector<double>& cells = field.Values[b];
    if (!cells.empty())
    {
      auto array = vtkSmartPointer<vtkDoubleArray>::New();
      array->SetName(name.c_str());
      array->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
      std::copy(cells.begin(), cells.end(), array->GetPointer(0));
      fields[blocks.Get()[b].FlatIndex].push_back(array);
    }
  }
  return fields;
}
}

//------------------------------------------------------------------------------
vtkCorrelateQuality::vtkCorrelateQuality()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkCorrelateQuality::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkCorrelateQuality::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  camaron::MakeTablesAndMesh(1, vtkDataObject::GetData(inputVector[0]), outputVector);
  return 1;
}

//------------------------------------------------------------------------------
void vtkCorrelateQuality::MakeColumns(vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  table->Initialize();
  AddColumnsOfTable(table, this->AllTimeSteps);
}

//------------------------------------------------------------------------------
void vtkCorrelateQuality::AddRows(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
  const camaron::ElementBlocks blocks(input, reducer);
  camaron::Grouping groups(this->GroupBy, this->GroupArray, blocks, reducer);
  const auto [isOfPoints, name] = ChooseField(this->GetInputArrayInformation(0), blocks, reducer);
  const std::string fieldName = name + "_Cells";
  const camaron::CellField field = camaron::FindCellField(blocks, name, isOfPoints, reducer);
  std::vector<std::string> missing;
  const std::vector<camaron::StatisticsArray> arrays =
    camaron::ChooseArrays(camaron::FindArrays(blocks, reducer), this->Arrays, missing);
  this->Found->Add(this->Steps->GetTime(), arrays, missing);
  this->WarnOfNoGroups(groups.GetArrayName(), groups.GetGroups().size(), reducer.GetProcess() == 0);

  // The loop over groups is the outer one, so that ranks of the field are computed once per group
  // for all arrays.
  std::vector<std::vector<camaron::TableRow>> rows(arrays.size());
  double done = 0;
  camaron::BlockShapes shapes(blocks);
  for (const camaron::Group& group : groups.GetGroups())
  {
    FieldRanks fieldRanks;
    for (std::size_t a = 0; a < arrays.size(); ++a)
    {
      camaron::BlockValues values(blocks, arrays[a].Name, reducer);
      const auto acceptable = ranges.Find(arrays[a].Name, arrays[a].Unit);
      shapes.Judge(values, acceptable);
      const Pairs pairs(groups.GetPopulation(group, values), values, field);
      const Correlation correlation =
        FindCorrelation(pairs, fieldRanks.Get(pairs, reducer), acceptable, reducer);
      const OutsideCells& outside = correlation.Outside;
      camaron::TableRow row(this->Steps->GetTime(), arrays[a].Name, arrays[a].Unit, group.Label);
      row.Add(fieldName, correlation.Count, correlation.Pearson, correlation.Spearman,
        acceptable ? acceptable->Low : camaron::NaN, acceptable ? acceptable->High : camaron::NaN,
        outside.Count, outside.MeanInside, outside.MeanOutside, outside.Above);
      rows[a].push_back(std::move(row));
      const std::size_t total = groups.GetGroups().size() * arrays.size();
      camaron::CheckAbortOnAllRanks(
        this, this->Steps->GetProgress(++done / static_cast<double>(total)), reducer);
    }
  }
  for (const auto& rowsOfArray : rows)
  {
    for (const camaron::TableRow& row : rowsOfArray)
    {
      if (reducer.GetProcess() == 0)
      {
        row.AppendTo(vtkTable::GetData(outputVector, 0));
      }
    }
  }
  if (this->Steps->IsLast())
  {
    camaron::CopyWithCellArrays(
      input, MakeFieldArrays(blocks, field, fieldName), vtkDataObject::GetData(outputVector, 1));
  }
}
