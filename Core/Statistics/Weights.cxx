// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Weights.h"

#include "Ranks/ExactTotals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace camaron
{
namespace
{
enum
{
  FiniteWeight,
  InfiniteWeight,
  BadWeight,
  Product,
  NumberOfSums
};
using Sums = std::array<ExactSum, NumberOfSums>;
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
      for (ExactSum& sum : sums)
      {
        sum.Reserve(end - begin);
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
          sums[BadWeight].Add(weight);
        }
        if (std::isfinite(value))
        {
          sums[FiniteWeight].Add(weight);
          sums[Product].Add(weight * (valueUnit * value));
        }
        else
        {
          sums[InfiniteWeight].Add(weight);
        }
      }
    });

  constexpr std::size_t allWeight = NumberOfSums;
  ExactTotals totals(NumberOfSums + 1);
  for (Sums& part : parts)
  {
    totals.AddEach(part);
    totals.Add(allWeight, part[FiniteWeight]);
    totals.Add(allWeight, part[InfiniteWeight]);
  }
  totals.Reduce(reducer);
  const double weight = totals.Round(allWeight), finiteWeight = totals.Round(FiniteWeight);

  WeightedSummary result;
  result.Weight = weight / weightUnit;
  if (weight > 0)
  {
    result.BadFraction = totals.Round(BadWeight) / weight;
  }
  if (finiteWeight > 0)
  {
    result.Mean = totals.Round(Product) / finiteWeight / valueUnit;
  }
  return result;
}
}
