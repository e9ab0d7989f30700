// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Strategy.h
 * @brief The ways in which vtkSelectElements selects: one function each, and the table of them.
 *
 * To add one: a file beside this one with the function, its declaration below, a row in
 * StrategyTable.cxx, and what it needs to know in SelectionParameters with a property of
 * vtkSelectElements.
 */
#ifndef camaron_Strategy_h
#define camaron_Strategy_h

#include "ElementBlocks.h"

#include <string> // for parameters
#include <vector> // for marks

namespace camaron
{
/// All properties of vtkSelectElements; a strategy reads its own. See there what they mean.
struct SelectionParameters
{
  std::string Strategy = "By criterion";
  std::string Ids;
  std::string IdSpace = "Index";
  std::string Array;
  std::string Side = "Outside";
  std::string Range = "Acceptable";
  std::string Preset = "Default ranges";
  std::string RangesFile;
  std::string LowerLimit;
  std::string UpperLimit;
  int NumberOfWorst = 10;
  std::string WorstValues = "By criterion";
};

/// For each block of the input 1 for selected cells, else 0. Comes filled with 0.
using SelectionMarks = std::vector<std::vector<unsigned char>>;

/**
 * Selects. Collective: throws on all processes or none, std::invalid_argument with a message for
 * people. Returns a remark for people, empty if there is none. Ghost cells are never selected.
 */
using SelectFunction = std::string (*)(const SelectionParameters& parameters,
  const ElementBlocks& blocks, Reducer& reducer, SelectionMarks& marks);

std::string SelectById(const SelectionParameters&, const ElementBlocks&, Reducer&, SelectionMarks&);
std::string SelectByCriterion(
  const SelectionParameters&, const ElementBlocks&, Reducer&, SelectionMarks&);
std::string SelectNull(const SelectionParameters&, const ElementBlocks&, Reducer&, SelectionMarks&);
std::string SelectWorst(
  const SelectionParameters&, const ElementBlocks&, Reducer&, SelectionMarks&);

struct Strategy
{
  const char* Name;
  SelectFunction Select;
};

const std::vector<Strategy>& GetStrategies();
/// Throws std::invalid_argument if there is none of that name.
const Strategy& FindStrategy(const std::string& name);

/**
 * Values of a cell array for the strategies that need one; throws if no process has it. Collective.
 */
BlockValues FindValues(const std::string& arrayName, const ElementBlocks& blocks, Reducer& reducer);

/// Marks the elements for which @a isSelected(block, i) is true; it is not asked about ghosts.
template <typename IsSelected>
void MarkValues(const BlockValues& values, SelectionMarks& marks, IsSelected&& isSelected)
{
  constexpr vtkIdType grain = 1 << 16;
  for (std::size_t b = 0; b < values.Get().size(); ++b)
  {
    const ValueBlock& block = values.Get()[b];
    unsigned char* mark = marks[values.GetBlockNumbers()[b]].data();
    ParallelFor(block.Size, grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          mark[i] = block.Contains(i) && isSelected(block, i);
        }
      });
  }
}
}

#endif
