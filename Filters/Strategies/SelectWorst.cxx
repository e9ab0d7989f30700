// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "AcceptableRanges.h"

#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
std::string SelectWorst(const SelectionParameters& parameters, const ElementBlocks& blocks,
  Reducer& reducer, SelectionMarks& marks)
{
  const BlockValues values = FindValues(parameters.Array, blocks, reducer);
  const auto end = FindWorstEnd(parameters.Array, parameters.WorstValues);
  if (!end)
  {
    throw std::invalid_argument("no end of '" + parameters.Array +
      "' is known to be the worse one; choose Largest or Smallest for Worst Values");
  }
  const WorstLimit limit = FindWorstLimit(values.Get(), parameters.NumberOfWorst, *end, reducer);
  MarkValues(
    values, marks, [&](const ValueBlock& block, vtkIdType i) { return limit.Contains(block, i); });
  return limit.Count < parameters.NumberOfWorst
    ? "there are only " + std::to_string(limit.Count) + " cells with a value"
    : "";
}
}
