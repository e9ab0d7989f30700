// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Strategies/Strategy.h"

#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
const std::vector<Strategy>& GetStrategies()
{
  static const std::vector<Strategy> strategies = {
    { "By criterion", &SelectByCriterion },
    { "Worst N", &SelectWorst },
    { "Null", &SelectNull },
    { "By id", &SelectById },
  };
  return strategies;
}

//------------------------------------------------------------------------------
const Strategy& FindStrategy(const std::string& name)
{
  for (const Strategy& strategy : GetStrategies())
  {
    if (name == strategy.Name)
    {
      return strategy;
    }
  }
  throw std::invalid_argument("there is no strategy named '" + name + "'");
}

//------------------------------------------------------------------------------
BlockValues FindValues(const std::string& arrayName, const ElementBlocks& blocks, Reducer& reducer)
{
  BlockValues values(blocks, arrayName);
  std::int64_t counts[2] = { static_cast<std::int64_t>(values.Get().size()),
    static_cast<std::int64_t>(blocks.Get().size()) };
  reducer.Sum(counts, 2);
  // An input without any cell has no arrays worth mentioning.
  if (counts[0] == 0 && counts[1] > 0)
  {
    throw std::invalid_argument(arrayName.empty()
        ? std::string("no Array is chosen")
        : "there is no cell array with one component named '" + arrayName + "'");
  }
  return values;
}
}
