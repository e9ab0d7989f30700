// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include "AcceptableRanges.h"
#include "PropertyValues.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The arrays on any process for which there is an acceptable range.
std::vector<std::string> FindNames(const SelectionTask& task, const AcceptableRanges& ranges)
{
  std::vector<std::string> names;
  for (const ElementBlock& block : task.Blocks.Get())
  {
    for (int i = 0; i < block.GetAttributes()->GetNumberOfArrays(); ++i)
    {
      const char* name = block.GetAttributes()->GetArrayName(i);
      if (name && block.GetArray(name) && ranges.HasRule(name) && ranges.Find(name, ""))
      {
        names.emplace_back(name);
      }
    }
  }
  return task.Reducer.GatherNames(names);
}
}

//------------------------------------------------------------------------------
std::string SelectFailed(const SelectionTask& task, SelectionMarks& marks)
{
  const SelectionParameters& parameters = task.Parameters;
  CheckNumber("Number Of Failures", parameters.NumberOfFailures, 1);
  const AcceptableRanges ranges(parameters.Preset, parameters.RangesFile, task.Reducer);
  const std::vector<std::string> names = FindNames(task, ranges);
  task.Blocks.RequireAny(names.size(),
    "no array is a criterion with an acceptable range in '" + parameters.Preset +
      "'; evaluate some with Element Quality",
    task.Reducer);
  std::vector<std::vector<int>>& counts = task.FailedCriteriaCounts;
  for (const std::vector<unsigned char>& block : marks)
  {
    counts.emplace_back(block.size());
  }
  BlockShapes shapes(task.Blocks);
  for (const std::string& name : names)
  {
    const AcceptableRange range = *ranges.Find(name, FindUnit(task, name));
    BlockValues values(task.Blocks, name, task.Reducer);
    shapes.Judge(values, range);
    for (std::size_t v = 0; v < values.Get().size(); ++v)
    {
      const ValueBlock& block = values.Get()[v];
      std::vector<int>& count = counts[values.GetBlockNumbers()[v]];
      ParallelForEach(block.Size, LightGrain,
        [&](vtkIdType i)
        {
          // NaN is on neither side.
          count[i] +=
            block.IsJudged(i) && (block.Values[i] < range.Low || block.Values[i] > range.High);
        });
    }
  }
  MarkElements(
    marks, [&](std::size_t b, vtkIdType i) { return counts[b][i] >= parameters.NumberOfFailures; });
  return "";
}
}
