// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCorrelateQuality.h"

#include "AcceptableRanges.h"
#include "CellField.h"
#include "ControllerReducer.h"
#include "ElementBlocks.h"
#include "MeshCopies.h"
#include "Statistics/Correlation.h"
#include "StatisticsArrays.h"
#include "TableRows.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

vtkStandardNewMacro(vtkCorrelateQuality);

namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

//------------------------------------------------------------------------------
// The blocks with values of both, restricted to cells for which both are not null.
struct Pairs
{
  camaron::Population Quality, Field;

  Pairs(const camaron::BlockValues& values, const camaron::CellField& field)
  {
    this->Masks.resize(values.Get().size());
    for (std::size_t i = 0; i < values.Get().size(); ++i)
    {
      const std::vector<double>& fieldValues = field.Get()[values.GetBlockNumbers()[i]];
      camaron::ValueBlock quality = values.Get()[i];
      if (fieldValues.empty())
      {
        continue;
      }
      std::vector<unsigned char>& mask = this->Masks[i];
      mask.resize(fieldValues.size());
      for (vtkIdType cell = 0; cell < quality.Size; ++cell)
      {
        mask[cell] = !quality.Contains(cell) || std::isnan(quality.Values[cell]) || std::isnan(fieldValues[cell]);
      }
      quality.Skip = mask.data();
      this->Quality.push_back(quality);
      this->Field.push_back(quality);
      this->Field.back().Values = fieldValues.data();
    }
  }

private:
  std::vector<std::vector<unsigned char>> Masks;
};

//------------------------------------------------------------------------------
camaron::Population WithValues(camaron::Population population, const camaron::BlockRanks& values)
{
  for (std::size_t i = 0; i < population.size(); ++i)
  {
    population[i].Values = values[i].data();
  }
  return population;
}

//------------------------------------------------------------------------------
// Where the field is in the cells outside of a range.
struct OutsideCells
{
  std::int64_t Count = 0;
  double MeanInside = Unknown;
  double MeanOutside = Unknown;
  /// Probability that a cell outside has a larger value of the field than one inside; ties count half.
  double Above = Unknown;
};

//------------------------------------------------------------------------------
// Collective. @a ranks: of the field.
OutsideCells FindOutsideCells(const Pairs& pairs, const camaron::BlockRanks& ranks,
  const camaron::ValueRange& acceptable, camaron::Reducer& reducer)
{
  std::int64_t counts[3] = { 0, 0, 0 }; // inside, outside, sum of doubled ranks outside
  camaron::Population parts[2] = { pairs.Field, pairs.Field };
  std::vector<std::vector<unsigned char>> masks[2];
  for (std::size_t b = 0; b < pairs.Quality.size(); ++b)
  {
    const camaron::ValueBlock& block = pairs.Quality[b];
    for (auto& mask : masks)
    {
      mask.emplace_back(block.Size, 1);
    }
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      if (block.Contains(i))
      {
        const bool isOutside = block.Values[i] < acceptable.Low || block.Values[i] > acceptable.High;
        ++counts[isOutside];
        counts[2] += isOutside ? static_cast<std::int64_t>(ranks[b][i]) : 0;
        masks[isOutside][b][i] = 0;
      }
    }
  }
  reducer.Sum(counts, 3);
  OutsideCells result;
  result.Count = counts[1];
  double means[2];
  for (int part = 0; part < 2; ++part)
  {
    for (std::size_t b = 0; b < parts[part].size(); ++b)
    {
      parts[part][b].Skip = masks[part][b].data();
    }
    means[part] = camaron::Summarize(parts[part], camaron::ValueRange(), reducer).Mean;
  }
  result.MeanInside = means[0];
  result.MeanOutside = means[1];
  if (counts[0] > 0 && counts[1] > 0)
  {
    // The statistic of Mann and Whitney, doubled.
    const std::int64_t doubled = counts[2] - counts[1] * (counts[1] + 1);
    result.Above = static_cast<double>(doubled) / 2 / static_cast<double>(counts[0]) / static_cast<double>(counts[1]);
  }
  return result;
}

//------------------------------------------------------------------------------
void AddColumnsOfTable(vtkTable* table)
{
  camaron::AddColumns<vtkStringArray>(table, { "Criterion", "Unit", "Field" });
  camaron::AddColumns<vtkIdTypeArray>(table, { "Count" });
  camaron::AddColumns<vtkDoubleArray>(table, { "Pearson", "Spearman", "AcceptableLow", "AcceptableHigh" });
  camaron::AddColumns<vtkIdTypeArray>(table, { "OutsideCount" });
  camaron::AddColumns<vtkDoubleArray>(table, { "FieldMeanInside", "FieldMeanOutside", "OutsideAbove" });
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
}

//------------------------------------------------------------------------------
vtkCorrelateQuality::vtkCorrelateQuality()
  : Preset(camaron::GetDefaultRangesName())
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkCorrelateQuality::~vtkCorrelateQuality() = default;

//------------------------------------------------------------------------------
void vtkCorrelateQuality::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arrays:";
  for (const std::string& name : this->Arrays)
  {
    os << ' ' << name;
  }
  os << '\n' << indent << "Gradient: " << this->Gradient << '\n';
  os << indent << "Preset: " << this->Preset << '\n';
  os << indent << "RangesFile: " << this->RangesFile << '\n';
}

//------------------------------------------------------------------------------
void vtkCorrelateQuality::SetText(std::string& member, const char* text)
{
  const std::string value = text ? text : "";
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCorrelateQuality::AddArray(const char* name)
{
  if (name && name[0])
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkCorrelateQuality::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkCorrelateQuality::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
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
int vtkCorrelateQuality::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  AddColumnsOfTable(vtkTable::GetData(outputVector, 0));
  try
  {
    this->Correlate(vtkDataObject::GetData(inputVector[0]), outputVector);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("There is no correlation: " << error.what() << '.');
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
// Collective.
void vtkCorrelateQuality::Correlate(vtkDataObject* input, vtkInformationVector* outputVector)
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  if (!info->Has(vtkDataObject::FIELD_NAME()) || !info->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    throw std::invalid_argument("no field is chosen");
  }
  const std::string name = info->Get(vtkDataObject::FIELD_NAME());
  const bool isOfPoints = info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const std::string fieldName = name + (this->Gradient ? "_Gradient" : "_Cells");

  camaron::ControllerReducer reducer;
  const camaron::AcceptableRanges ranges(this->Preset, this->RangesFile, reducer);
  const camaron::ElementBlocks blocks(input, reducer);
  const camaron::CellField field(blocks, name, isOfPoints, this->Gradient, reducer);
  std::string missing;
  const std::vector<camaron::StatisticsArray> arrays =
    camaron::ChooseArrays(camaron::FindArrays(blocks, reducer), this->Arrays, missing);
  const bool isRoot = reducer.GetProcess() == 0;
  if (!missing.empty() && isRoot)
  {
    vtkWarningMacro("There are no cell arrays with one component named: " << missing << '.');
  }

  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const camaron::BlockValues values(blocks, arrays[a].Name);
    const Pairs pairs(values, field);
    const std::int64_t count = CountElements(pairs.Quality, reducer);
    const double pearson = camaron::CorrelateLinearly(pairs.Quality, pairs.Field, reducer);
    const camaron::BlockRanks qualityRanks = camaron::FindDoubledRanks(pairs.Quality, reducer);
    const camaron::BlockRanks fieldRanks = camaron::FindDoubledRanks(pairs.Field, reducer);
    const double spearman = camaron::CorrelateLinearly(
      WithValues(pairs.Quality, qualityRanks), WithValues(pairs.Field, fieldRanks), reducer);
    const auto acceptable = ranges.Find(arrays[a].Name, arrays[a].Unit);
    const OutsideCells outside =
      acceptable ? FindOutsideCells(pairs, fieldRanks, *acceptable, reducer) : OutsideCells();
    if (isRoot)
    {
      camaron::TableRow row;
      row.Add(arrays[a].Name);
      row.Add(arrays[a].Unit);
      row.Add(fieldName);
      row.Add(count);
      row.Add(pearson);
      row.Add(spearman);
      row.Add(acceptable ? acceptable->Low : Unknown);
      row.Add(acceptable ? acceptable->High : Unknown);
      row.Add(outside.Count);
      row.Add(outside.MeanInside);
      row.Add(outside.MeanOutside);
      row.Add(outside.Above);
      row.AppendTo(vtkTable::GetData(outputVector, 0));
    }
    this->UpdateProgress(static_cast<double>(a + 1) / static_cast<double>(arrays.size()));
  }

  camaron::NewCellArrays fields;
  for (std::size_t b = 0; b < blocks.Get().size(); ++b)
  {
    const std::vector<double>& cells = field.Get()[b];
    if (!cells.empty())
    {
      auto array = vtkSmartPointer<vtkDoubleArray>::New();
      array->SetName(fieldName.c_str());
      array->SetNumberOfValues(static_cast<vtkIdType>(cells.size()));
      std::copy(cells.begin(), cells.end(), array->GetPointer(0));
      fields[blocks.Get()[b].FlatIndex].push_back(array);
    }
  }
  camaron::CopyWithCellArrays(input, fields, vtkDataObject::GetData(outputVector, 1));
}
