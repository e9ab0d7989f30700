// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/FoamLabels.h"
#include "Strategies/Strategy.h"

#include "Base/Parallel.h"
#include "Ranks/Collective.h"
#include "Scan/MappedFile.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Collective. Process 0 reads the file.
FoamLabels ReadLabels(const SelectionTask& task)
{
  FoamLabels labels;
  RunCollectively(task.Reducer,
    [&]
    {
      if (task.Reducer.GetProcess() == 0)
      {
        labels = ReadFoamLabels(task.Parameters.SetFile, task.Parameters.SetName);
      }
    });
  std::int64_t facts[] = { labels.ArePoints, labels.NumberOfCells };
  task.Reducer.Max(facts, 2);
  return { facts[0] != 0, facts[1], task.Reducer.GatherItems(labels.Labels) };
}

//------------------------------------------------------------------------------
// Whether a block has elements with labels: the cells of a case, not its patches.
bool HasLabels(const ElementBlock& block, bool hasOthers)
{
  return !hasOthers || !vtkPolyData::SafeDownCast(block.Data);
}
}

//------------------------------------------------------------------------------
// Labels are indices in the whole mesh, or global ids where it has some.
std::string SelectSet(const SelectionTask& task, SelectionMarks& marks)
{
  if (task.Parameters.SetFile.empty())
  {
    throw std::invalid_argument("no Set File is chosen");
  }
  const FoamLabels set = ReadLabels(task);
  if (set.ArePoints == task.HasCells())
  {
    throw std::invalid_argument(set.ArePoints ? "the set has points, but Element Type is Cells"
                                              : "the set has cells, but Element Type is Points");
  }
  const std::vector<ElementBlock>& blocks = task.Blocks.Get();
  std::int64_t hasOthers = std::any_of(blocks.begin(), blocks.end(),
    [](const ElementBlock& block) { return !vtkPolyData::SafeDownCast(block.Data); });
  task.Reducer.Max(&hasOthers, 1);
  std::int64_t found = 0, pieces = 0, elements = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const ElementBlock& block = blocks[b];
    if (!HasLabels(block, hasOthers != 0))
    {
      continue;
    }
    pieces += !marks[b].empty();
    for (std::size_t i = 0; i < marks[b].size(); ++i)
    {
      elements += !block.IsGhost(static_cast<vtkIdType>(i));
    }
    const ValueBlock ids = task.Blocks.GetValueBlock(block);
    ParallelForEach(static_cast<vtkIdType>(marks[b].size()), LightGrain,
      [&](vtkIdType i)
      {
        const std::int64_t label = task.Blocks.HasGlobalIds() ? ids.GetId(i) : block.GetIndex(i);
        marks[b][i] =
          !block.IsGhost(i) && std::binary_search(set.Labels.begin(), set.Labels.end(), label);
      });
    found += std::count(marks[b].begin(), marks[b].end(), 1);
  }
  std::int64_t sums[] = { found, pieces, elements };
  task.Reducer.Sum(sums, 3);
  if (set.NumberOfCells >= 0 && set.NumberOfCells != sums[2])
  {
    throw std::invalid_argument("the faces of the set are those of a mesh with " +
      std::to_string(set.NumberOfCells) + " cells, and this one has " + std::to_string(sums[2]));
  }
  if (sums[1] > 1 && !task.Blocks.HasGlobalIds())
  {
    throw std::invalid_argument("labels are those of a whole mesh, and this one is in " +
      std::to_string(sums[1]) + " pieces");
  }
  const auto size = static_cast<std::int64_t>(set.Labels.size());
  return sums[0] == size ? ""
                         : std::to_string(size - sums[0]) + " of " + std::to_string(size) +
      " labels of " + GetFileName(task.Parameters.SetFile) + " do not exist";
}
}
