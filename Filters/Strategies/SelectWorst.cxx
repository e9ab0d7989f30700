// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "AcceptableRanges.h"

#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
std::string SelectWorst(const SelectionTask& task, SelectionMarks& marks)
{
  const BlockValues values = FindValues(task);
  const auto end = FindWorstEnd(task.GetArrayName(), task.Parameters.WorstValues);
  if (!end)
  {
    throw std::invalid_argument("no end of '" + task.GetArrayName() +
      "' is known to be the worse one; choose Largest or Smallest for Worst Values");
  }
  const WorstLimit limit = FindWorstLimit(values.Get(), task.Parameters.NumberOfWorst, *end, task.Reducer);
  MarkValues(
    values, marks, [&](const ValueBlock& block, vtkIdType i) { return limit.Contains(block, i); });
  return limit.Count < task.Parameters.NumberOfWorst
    ? "there are only " + std::to_string(limit.Count) +
      (task.HasCells() ? " cells" : " points") + " with a value"
    : "";
}
}
