// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/MissingValues.h"

#include "Base/Parallel.h"

#include <cmath>
#include <limits>

namespace camaron
{
//------------------------------------------------------------------------------
MissingValues::MissingValues(const Population& population)
  : Blocks(population)
  , Values(population.size())
{
  constexpr int grain = 1 << 16;
  for (std::size_t b = 0; b < population.size(); ++b)
  {
    const ValueBlock& block = population[b];
    std::vector<double>& values = this->Values[b];
    values.assign(block.Size, std::numeric_limits<double>::quiet_NaN());
    ParallelForEach(block.Size, grain,
      [&](vtkIdType i)
      {
        if (std::isnan(block.Values[i]) && block.GetNullReason(i) != NullReason::NotApplicable)
        {
          values[i] = 0;
        }
      });
    this->Blocks[b] = block.WithValues(values.data());
  }
}
}
