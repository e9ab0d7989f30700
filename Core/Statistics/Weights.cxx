// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Weights.h"

#include "Statistics/ExactSum.h"
#include "Statistics/WeightUnit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
constexpr int NumberOfSums = 4;

struct Sums
{
  ExactSum Weight, FiniteWeight, BadWeight, Product;
};
}

//------------------------------------------------------------------------------
WeightedSummary SummarizeWeighted(const Population& values, const Summary& summary,
  const Population& weights, const ValueRange& acceptable, Reducer& reducer)
{
  // In units in which no product overflows.
  const double weightUnit = GetUnit(FindLargestWeight(weights, reducer));
  const double valueUnit = summary.GetFiniteCount() > 0
    ? GetUnit(std::max(std::abs(summary.Min), std::abs(summary.Max)))
    : 1;
  std::vector<Sums> parts = ForEachChunk<Sums>(values,
    [&](Sums& sums, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      const ValueBlock& weightBlock = weights[&block - values.data()];
      for (ExactSum* sum : { &sums.Weight, &sums.FiniteWeight, &sums.BadWeight, &sums.Product })
      {
        sum->Reserve(end - begin);
      }
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double value = block.Values[i];
        if (!block.Contains(i) || std::isnan(value))
        {
          continue;
        }
        const double weight = weightUnit * GetWeight(weightBlock, i);
        sums.Weight.Add(weight);
        if (block.IsJudged(i) && (value < acceptable.Low || value > acceptable.High))
        {
          sums.BadWeight.Add(weight);
        }
        if (std::isfinite(value))
        {
          sums.FiniteWeight.Add(weight);
          sums.Product.Add(weight * (valueUnit * value));
        }
      }
    });

  constexpr std::size_t size = std::tuple_size<ExactSum::Limbs>::value;
  std::array<std::int64_t, NumberOfSums * size> all = {};
  for (Sums& part : parts)
  {
    auto* limb = all.data();
    for (ExactSum* sum : { &part.Weight, &part.FiniteWeight, &part.BadWeight, &part.Product })
    {
      for (const std::int64_t value : sum->GetLimbs())
      {
        *limb++ += value;
      }
    }
  }
  reducer.Sum(all.data(), all.size());
  double rounded[NumberOfSums];
  for (int s = 0; s < NumberOfSums; ++s)
  {
    ExactSum::Limbs limbs;
    std::copy_n(all.begin() + s * size, size, limbs.begin());
    rounded[s] = ExactSum::Round(limbs);
  }

  WeightedSummary result;
  result.Weight = rounded[0] / weightUnit;
  if (rounded[0] > 0)
  {
    result.BadFraction = rounded[2] / rounded[0];
  }
  if (rounded[1] > 0)
  {
    result.Mean = rounded[3] / rounded[1] / valueUnit;
  }
  return result;
}
}
