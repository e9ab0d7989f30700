// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/IdRanges.h"
#include "Strategies/Strategy.h"

#include "PropertyValues.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The ids of every block; nullptr if the ids are indices. Throws if a process has no such ids.
std::vector<vtkSmartPointer<vtkIdTypeArray>> FindIds(const SelectionTask& task)
{
  constexpr int index = -1;
  const int idSpace = ParseChoice<int>("Id Space", task.Parameters.IdSpace,
    { { "Index", index }, { "Global id", vtkDataSetAttributes::GLOBALIDS },
      { "Pedigree id", vtkDataSetAttributes::PEDIGREEIDS } });
  std::vector<vtkSmartPointer<vtkIdTypeArray>> ids(task.Blocks.Get().size());
  if (idSpace == index)
  {
    return ids;
  }
  std::int64_t missing = 0;
  for (std::size_t b = 0; b < ids.size(); ++b)
  {
    auto* array = vtkDataArray::SafeDownCast(
      task.Blocks.Get()[b].GetAttributes()->GetAbstractAttribute(idSpace));
    if (array && array->GetNumberOfComponents() == 1)
    {
      ids[b] = ToIds(array);
    }
    missing += !ids[b];
  }
  task.Reducer.Sum(&missing, 1);
  if (missing > 0)
  {
    throw std::invalid_argument(std::string(task.HasCells() ? "the cells" : "the points") +
      " have no " + (idSpace == vtkDataSetAttributes::GLOBALIDS ? "global" : "numeric pedigree") +
      " ids");
  }
  return ids;
}
}

//------------------------------------------------------------------------------
std::string SelectById(const SelectionTask& task, SelectionMarks& marks)
{
  const std::vector<IdRange> ranges = ParseIdRanges("Ids", task.Parameters.Ids);
  const auto ids = FindIds(task);
  std::int64_t found = 0;
  for (std::size_t b = 0; b < marks.size(); ++b)
  {
    const ElementBlock& block = task.Blocks.Get()[b];
    ParallelForEach(static_cast<vtkIdType>(marks[b].size()), LightGrain,
      [&](vtkIdType cell)
      {
        const vtkIdType id = ids[b] ? ids[b]->GetValue(cell) : block.GetIndex(cell);
        marks[b][cell] = !block.IsGhost(cell) && Contains(ranges, id);
      });
    found += std::count(marks[b].begin(), marks[b].end(), 1);
  }
  task.Reducer.Sum(&found, 1);

  // Ranges of more ids than 64 bits can count have at least this number of them.
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t wanted = 0;
  for (const IdRange& range : ranges)
  {
    const std::uint64_t others =
      static_cast<std::uint64_t>(range.Last) - static_cast<std::uint64_t>(range.First);
    wanted = others < most - wanted ? wanted + others + 1 : most;
  }
  if (static_cast<std::uint64_t>(found) >= wanted)
  {
    return "";
  }
  if (wanted == 1)
  {
    return "The id does not exist";
  }
  const std::uint64_t missing = wanted - static_cast<std::uint64_t>(found);
  if (wanted == most)
  {
    return "At least " + std::to_string(missing) + " ids do not exist";
  }
  return std::to_string(missing) + " of " + std::to_string(wanted) +
    (missing == 1 ? " ids does" : " ids do") + " not exist";
}
}
