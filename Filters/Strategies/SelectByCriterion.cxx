// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "AcceptableRanges.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
double ParseLimit(const std::string& text, const char* property, double open)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::string rest;
  if (!(stream >> std::ws) || stream.eof())
  {
    return open;
  }
  double limit;
  if (!(stream >> limit) || stream >> rest)
  {
    throw std::invalid_argument(
      std::string(property) + ": expected a number, found '" + text + "'");
  }
  return limit;
}

//------------------------------------------------------------------------------
// Unit of the array, the same on all processes.
std::string FindUnit(const std::string& arrayName, const ElementBlocks& blocks, Reducer& reducer)
{
  std::vector<std::string> units;
  for (const ElementBlock& block : blocks.Get())
  {
    vtkDataArray* array = GetCellArray(block, arrayName);
    if (array && array->HasInformation() &&
      array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
    {
      units.emplace_back(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()));
    }
  }
  units = reducer.GatherNames(units);
  return units.empty() ? std::string() : units.back();
}

//------------------------------------------------------------------------------
ValueRange FindRange(
  const SelectionParameters& parameters, const ElementBlocks& blocks, Reducer& reducer)
{
  if (parameters.Range == "Custom")
  {
    const ValueRange open;
    const ValueRange range{ ParseLimit(parameters.LowerLimit, "Lower Limit", open.Low),
      ParseLimit(parameters.UpperLimit, "Upper Limit", open.High) };
    if (range.Low > range.High)
    {
      throw std::invalid_argument("Lower Limit is above Upper Limit");
    }
    return range;
  }
  if (parameters.Range != "Acceptable")
  {
    throw std::invalid_argument("Range is Acceptable or Custom, not '" + parameters.Range + "'");
  }
  const AcceptableRanges ranges(parameters.Preset, parameters.RangesFile, reducer);
  const auto range = ranges.Find(parameters.Array, FindUnit(parameters.Array, blocks, reducer));
  if (!range)
  {
    throw std::invalid_argument("no acceptable range is known for '" + parameters.Array +
      "'; choose another Preset, or Custom for Range and give the limits");
  }
  return *range;
}
}

//------------------------------------------------------------------------------
std::string SelectByCriterion(const SelectionParameters& parameters, const ElementBlocks& blocks,
  Reducer& reducer, SelectionMarks& marks)
{
  const BlockValues values = FindValues(parameters.Array, blocks, reducer);
  const ValueRange range = FindRange(parameters, blocks, reducer);
  if (parameters.Side != "Inside" && parameters.Side != "Outside")
  {
    throw std::invalid_argument("Side is Inside or Outside, not '" + parameters.Side + "'");
  }
  const bool inside = parameters.Side == "Inside";
  // NaN is on neither side.
  MarkValues(values, marks,
    [&](const ValueBlock& block, vtkIdType i)
    {
      const double value = block.Values[i];
      return inside ? value >= range.Low && value <= range.High
                    : value < range.Low || value > range.High;
    });
  return "";
}
}
