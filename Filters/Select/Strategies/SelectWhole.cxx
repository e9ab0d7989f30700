// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
std::string SelectAll(const SelectionTask&, SelectionMarks& marks)
{
  MarkElements(marks, [](std::size_t, vtkIdType) { return true; });
  return "";
}

//------------------------------------------------------------------------------
std::string SelectCurrent(const SelectionTask& task, SelectionMarks& marks)
{
  marks = task.Current;
  return "";
}

//------------------------------------------------------------------------------
std::string SelectInverse(const SelectionTask& task, SelectionMarks& marks)
{
  MarkElements(marks, [&](std::size_t b, vtkIdType i) { return !task.Current[b][i]; });
  if (!task.Parameters.ExcludeUndefined)
  {
    return "";
  }
  const BlockValues values = FindValues(task);
  for (std::size_t v = 0; v < values.Get().size(); ++v)
  {
    const ValueBlock& block = values.Get()[v];
    std::vector<unsigned char>& mark = marks[values.GetBlockNumbers()[v]];
    for (vtkIdType i = 0; i < block.Size; ++i)
    {
      mark[i] = mark[i] && !std::isnan(block.Values[i]);
    }
  }
  return "";
}
}
