// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Cumulative.h"

#include "Statistics/ExactSum.h"
#include "Statistics/Quantiles.h"
#include "Statistics/WeightUnit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// What one thread finds between each point and the one before.
struct Steps
{
  std::vector<std::int64_t> Counts;
  std::vector<ExactSum> Weights;
};

//------------------------------------------------------------------------------
std::vector<double> ChooseValues(
  const Population& values, const Summary& summary, int numberOfPoints, Reducer& reducer)
{
  const std::int64_t last = summary.GetFiniteCount() - 1;
  std::vector<std::int64_t> positions;
  for (std::int64_t point = 0; point < numberOfPoints && last >= 0; ++point)
  {
    const double share = numberOfPoints > 1 ? static_cast<double>(point) / (numberOfPoints - 1) : 1;
    positions.push_back(static_cast<std::int64_t>(std::round(share * static_cast<double>(last))));
  }
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  if (positions.empty())
  {
    return {};
  }
  return GetOrderStatistics(values, summary, positions, reducer);
}

//------------------------------------------------------------------------------
// What std::lower_bound does, for many values: without branches, which no processor could foresee.
class PointFinder
{
public:
  PointFinder(const std::vector<double>& ascending)
    : Points(ascending)
  {
    while (this->Size <= ascending.size())
    {
      this->Size *= 2;
    }
    this->Points.resize(this->Size, std::numeric_limits<double>::infinity());
  }

  // Place of the first point that is not less than the value; of those there are, or one after the last.
  std::size_t Find(double value) const
  {
    std::size_t first = 0;
    for (std::size_t step = this->Size / 2; step > 0; step /= 2)
    {
      // A choice between two numbers would become a branch.
      first += step & (std::size_t(0) - static_cast<std::size_t>(this->Points[first + step - 1] < value));
    }
    return first;
  }

private:
  std::vector<double> Points; // as many as a power of two, with infinity at the end
  std::size_t Size = 1;
};

//------------------------------------------------------------------------------
std::vector<std::int64_t> CountUpTo(const std::vector<Steps>& parts, std::size_t size, Reducer& reducer)
{
  std::vector<std::int64_t> counts(size);
  for (const Steps& part : parts)
  {
    for (std::size_t point = 0; point < part.Counts.size(); ++point)
    {
      counts[point] += part.Counts[point];
    }
  }
  reducer.Sum(counts.data(), counts.size());
  for (std::size_t point = 1; point < size; ++point)
  {
    counts[point] += counts[point - 1];
  }
  return counts;
}

//------------------------------------------------------------------------------
std::vector<double> WeighUpTo(std::vector<Steps>& parts, std::size_t size, double unit, Reducer& reducer)
{
  constexpr std::size_t numberOfLimbs = std::tuple_size<ExactSum::Limbs>::value;
  std::vector<std::int64_t> limbs(size * numberOfLimbs);
  for (Steps& part : parts)
  {
    for (std::size_t point = 0; point < part.Weights.size(); ++point)
    {
      const ExactSum::Limbs sum = part.Weights[point].GetLimbs();
      for (std::size_t limb = 0; limb < numberOfLimbs; ++limb)
      {
        limbs[point * numberOfLimbs + limb] += sum[limb];
      }
    }
  }
  reducer.Sum(limbs.data(), limbs.size());
  std::vector<double> weights;
  ExactSum::Limbs upTo = {};
  for (std::size_t point = 0; point < size; ++point)
  {
    for (std::size_t limb = 0; limb < numberOfLimbs; ++limb)
    {
      upTo[limb] += limbs[point * numberOfLimbs + limb];
    }
    weights.push_back(ExactSum::Round(upTo) / unit);
  }
  return weights;
}
}

//------------------------------------------------------------------------------
CumulativeCurve MakeCumulativeCurve(const Population& values, const Summary& summary, int numberOfPoints,
  const Population* weights, Reducer& reducer, const std::vector<double>& alsoAt)
{
  CumulativeCurve curve;
  curve.Values = ChooseValues(values, summary, numberOfPoints, reducer);
  curve.Values.insert(curve.Values.end(), alsoAt.begin(), alsoAt.end());
  std::sort(curve.Values.begin(), curve.Values.end());
  curve.Values.erase(std::unique(curve.Values.begin(), curve.Values.end()), curve.Values.end());
  const std::size_t size = curve.Values.size();
  const PointFinder finder(curve.Values);
  const double unit = weights ? GetUnit(FindLargestWeight(*weights, reducer)) : 1;
  std::vector<Steps> parts = ForEachChunk<Steps>(values,
    [&](Steps& steps, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      steps.Counts.resize(size);
      steps.Weights.resize(weights ? size : 0);
      for (ExactSum& sum : steps.Weights)
      {
        sum.Reserve(end - begin);
      }
      const ValueBlock* weightBlock = weights ? &(*weights)[&block - values.data()] : nullptr;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double value = block.Values[i];
        if (!block.Contains(i) || std::isnan(value))
        {
          continue;
        }
        const std::size_t point = finder.Find(value);
        if (point < size)
        {
          ++steps.Counts[point];
          if (weightBlock)
          {
            steps.Weights[point].Add(unit * GetWeight(*weightBlock, i));
          }
        }
      }
    });
  curve.CountsUpTo = CountUpTo(parts, size, reducer);
  if (weights)
  {
    curve.WeightsUpTo = WeighUpTo(parts, size, unit, reducer);
  }
  return curve;
}
}
