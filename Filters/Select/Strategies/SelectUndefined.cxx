// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
std::string SelectUndefined(const SelectionTask& task, SelectionMarks& marks)
{
  MarkValues(FindValues(task), marks,
    [](const ValueBlock& block, vtkIdType i) { return std::isnan(block.Values[i]); });
  return "";
}
}
