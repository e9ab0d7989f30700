// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "PropertyValues.h"

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
}

//------------------------------------------------------------------------------
AcceptableRange FindRange(const SelectionTask& task)
{
  const SelectionParameters& parameters = task.Parameters;
  if (ParseChoice<bool>("Range", parameters.Range, { { "Acceptable", false }, { "Custom", true } }))
  {
    AcceptableRange range;
    range.Low = ParseLimit(parameters.LowerLimit, "Lower Limit", range.Low);
    range.High = ParseLimit(parameters.UpperLimit, "Upper Limit", range.High);
    if (range.High < range.Low)
    {
      throw std::invalid_argument("Lower Limit is above Upper Limit");
    }
    return range;
  }
  const AcceptableRanges ranges(parameters.Preset, parameters.RangesFile, task.Reducer);
  const auto range = ranges.Find(task.GetArrayName(), FindUnit(task, task.GetArrayName()));
  if (!range)
  {
    throw std::invalid_argument("no acceptable range is known for '" + task.GetArrayName() +
      "'; choose another Preset, or set Range to Custom and enter limits");
  }
  return *range;
}

//------------------------------------------------------------------------------
std::string SelectByCriterion(const SelectionTask& task, SelectionMarks& marks)
{
  const SelectionParameters& parameters = task.Parameters;
  BlockValues values = FindValues(task);
  const AcceptableRange range = FindRange(task);
  BlockShapes shapes(task.Blocks);
  shapes.Judge(values, range);
  enum class Side
  {
    Inside,
    Outside,
    Failing
  };
  const auto side = ParseChoice<Side>("Side", parameters.Side,
    { { "Inside", Side::Inside }, { "Outside", Side::Outside }, { "Failing", Side::Failing } });
  // Cells to whose shape the range does not apply are on no side. Undefined values fail where the
  // criterion applies.
  MarkValues(values, marks,
    [&](const ValueBlock& block, vtkIdType i)
    {
      const double value = block.Values[i];
      const bool isOutside = value < range.Low || range.High < value;
      const bool isOnSide = std::isnan(value)
        ? side == Side::Failing && block.GetNullReason(i) != NullReason::NotApplicable
        : isOutside == (side != Side::Inside);
      return block.IsJudged(i) && isOnSide;
    });
  return "";
}

//------------------------------------------------------------------------------
std::string SelectUndefined(const SelectionTask& task, SelectionMarks& marks)
{
  MarkValues(FindValues(task), marks,
    [](const ValueBlock& block, vtkIdType i) { return std::isnan(block.Values[i]); });
  return "";
}
}
