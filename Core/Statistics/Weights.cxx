// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Weights.h"

#include "Base/ExactSum.h"
#include "Statistics/WeightUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace camaron
{
namespace
{
constexpr int NumberOfSums = 4;

struct Sums
{
  ExactSum FiniteWeight, InfiniteWeight, BadWeight, Product;
};
}

//------------------------------------------------------------------------------
WeightedSummary SummarizeWeighted(const Population& values, const Summary& summary,
  const Weights& weights, const ValueRange& acceptable, Reducer& reducer)
{
  // In units that prevent overflow of products.
  const double weightUnit = weights.Unit;
  const double valueUnit = summary.GetFiniteCount() > 0
    ? GetUnit(std::max(std::abs(summary.Min), std::abs(summary.Max)))
    : 1;
  std::vector<Sums> parts = ForEachChunk<Sums>(values,
    [&](Sums& sums, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      const ValueBlock& weightBlock = weights.Values[&block - values.data()];
      for (ExactSum* sum :
        { &sums.FiniteWeight, &sums.InfiniteWeight, &sums.BadWeight, &sums.Product })
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
        if (block.IsJudged(i) && (value < acceptable.Low || value > acceptable.High))
        {
          sums.BadWeight.Add(weight);
        }
        if (std::isfinite(value))
        {
          sums.FiniteWeight.Add(weight);
          sums.Product.Add(weight * (valueUnit * value));
        }
        else
        {
          sums.InfiniteWeight.Add(weight);
        }
      }
    });

  constexpr std::size_t size = std::tuple_size<ExactSum::Limbs>::value;
  std::array<std::int64_t, NumberOfSums * size> all = {};
  for (Sums& part : parts)
  {
    auto* limb = all.data();
    for (ExactSum* sum :
      { &part.FiniteWeight, &part.InfiniteWeight, &part.BadWeight, &part.Product })
    {
      for (const std::int64_t value : sum->GetLimbs())
      {
        *limb++ += value;
      }
    }
  }
  reducer.Sum(all.data(), all.size());
  const auto get = [&](int sum)
  {
    ExactSum::Limbs limbs;
    std::copy_n(all.begin() + sum * size, size, limbs.begin());
    return limbs;
  };
  ExactSum::Limbs both = get(0);
  const ExactSum::Limbs infinite = get(1);
  std::transform(both.begin(), both.end(), infinite.begin(), both.begin(), std::plus<>());
  const double weight = ExactSum::Round(both), finiteWeight = ExactSum::Round(get(0));

  WeightedSummary result;
  result.Weight = weight / weightUnit;
  if (weight > 0)
  {
    result.BadFraction = ExactSum::Round(get(2)) / weight;
  }
  if (finiteWeight > 0)
  {
    result.Mean = ExactSum::Round(get(3)) / finiteWeight / valueUnit;
  }
  return result;
}
}
