// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "AcceptableRanges.h"
#include "PropertyValues.h"

#include <cmath>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// Marks the worst values and returns their number.
std::int64_t MarkWorst(
  const SelectionTask& task, const BlockValues& values, std::int64_t count, SelectionMarks& marks)
{
  const auto end = FindWorstEnd(task.GetArrayName(), task.Parameters.WorstValues);
  if (!end)
  {
    throw std::invalid_argument("cannot tell whether small or large values of '" +
      task.GetArrayName() + "' are worse; set Worst Values to Smallest or Largest");
  }
  const WorstLimit limit = FindWorstLimit(values.Get(), count, *end, task.Reducer);
  MarkValues(
    values, marks, [&](const ValueBlock& block, vtkIdType i) { return limit.Contains(block, i); });
  return limit.Count;
}
}

//------------------------------------------------------------------------------
std::string SelectWorst(const SelectionTask& task, SelectionMarks& marks)
{
  const int wanted = task.Parameters.NumberOfWorst;
  CheckNumber("Number Of Worst", wanted, 0);
  const std::int64_t count = MarkWorst(task, FindValues(task), wanted, marks);
  const std::string kind = task.HasCells() ? "cell" : "point";
  const std::string known = count == 1 ? "is only 1 " + kind
    : count == 0                       ? "is no " + kind
                                       : "are only " + std::to_string(count) + " " + kind + "s";
  return count < wanted ? "there " + known + " with a value" : "";
}

//------------------------------------------------------------------------------
std::string SelectWorstPercentage(const SelectionTask& task, SelectionMarks& marks)
{
  const double percent = task.Parameters.WorstPercentage;
  CheckNumber("Worst Percentage", percent, 0.0, 100.0);
  const BlockValues values = FindValues(task);
  std::int64_t count = 0;
  for (const ValueBlock& block : values.Get())
  {
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      count += block.Contains(i) && !std::isnan(block.Values[i]);
    }
  }
  task.Reducer.Sum(&count, 1);
  // Avoids rounding errors where the percentage is exactly a whole number of elements.
  const auto wanted =
    static_cast<std::int64_t>(std::floor(percent * static_cast<double>(count) / 100 * (1 + 1e-15)));
  MarkWorst(task, values, wanted, marks);
  return "";
}
}
