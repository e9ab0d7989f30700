// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Cumulative.h"

#include "Ranks/ExactTotals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace camaron
{
namespace
{
// Counts of one thread between consecutive points.
struct Steps
{
  std::vector<std::int64_t> Counts;
  std::vector<ExactSum> Weights;
};

//------------------------------------------------------------------------------
// Like std::lower_bound, but for many values: a table of slots of equal width provides the start,
// and the bisection from there, nearly always one or two steps, has no branches, which would be
// mispredicted.
class PointFinder
{
public:
  explicit PointFinder(const std::vector<double>& ascending)
    : Points(ascending)
    , Firsts(NumberOfSlots + 1, 0)
  {
    const auto isFinite = [](double point) { return std::isfinite(point); };
    const auto low = std::find_if(ascending.begin(), ascending.end(), isFinite);
    const auto high = std::find_if(ascending.rbegin(), ascending.rend(), isFinite);
    if (low != ascending.end())
    {
      const double scale = (NumberOfSlots - 1) / (*high - *low);
      this->Low = *low;
      this->High = *high;
      this->Scale = std::isnormal(scale) ? scale : 0; // all in one slot
    }
    for (const double point : ascending)
    {
      ++this->Firsts[this->GetSlot(point) + 1];
    }
    const auto most =
      static_cast<std::size_t>(*std::max_element(this->Firsts.begin(), this->Firsts.end()));
    std::partial_sum(this->Firsts.begin(), this->Firsts.end(), this->Firsts.begin());
    while (this->Size <= most)
    {
      this->Size *= 2;
    }
    this->Points.resize(ascending.size() + this->Size, std::numeric_limits<double>::infinity());
  }

  // Index of the first point not less than the value, or the number of points.
  std::size_t Find(double value) const
  {
    auto first = static_cast<std::size_t>(this->Firsts[this->GetSlot(value)]);
    for (std::size_t step = this->Size / 2; step > 0; step /= 2)
    {
      // A choice between two numbers would be compiled to a branch.
      first +=
        step & (std::size_t(0) - static_cast<std::size_t>(this->Points[first + step - 1] < value));
    }
    return first;
  }

private:
  static constexpr int NumberOfSlots = 4096;

  // Monotone: a larger value never has a smaller slot.
  int GetSlot(double value) const
  {
    value = value < this->High ? value : this->High;
    value = value > this->Low ? value : this->Low;
    return static_cast<int>(
      std::min(value - this->Low, std::numeric_limits<double>::max()) * this->Scale);
  }

  std::vector<double> Points; // and infinity after the last one
  std::vector<int> Firsts;    // for each slot, the number of points in previous slots
  double Low = 0, High = 0, Scale = 0;
  std::size_t Size = 1; // a power of two above the number of points in any slot
};

//------------------------------------------------------------------------------
std::vector<std::int64_t> CountUpTo(
  const std::vector<Steps>& parts, std::size_t size, Reducer& reducer)
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
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  return counts;
}

//------------------------------------------------------------------------------
std::vector<double> WeighUpTo(
  std::vector<Steps>& parts, std::size_t size, double unit, Reducer& reducer)
{
  ExactTotals totals(size);
  for (Steps& part : parts)
  {
    totals.AddEach(part.Weights);
  }
  totals.Reduce(reducer);
  totals.Accumulate();
  std::vector<double> weights;
  for (std::size_t point = 0; point < size; ++point)
  {
    weights.push_back(totals.Round(point) / unit);
  }
  return weights;
}
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> GetPositionsOfCurve(const Summary& summary, int numberOfPoints)
{
  const std::int64_t last = summary.GetFiniteCount() - 1;
  std::vector<std::int64_t> positions;
  for (std::int64_t point = 0; point < numberOfPoints && last >= 0; ++point)
  {
    const double share = numberOfPoints > 1 ? static_cast<double>(point) / (numberOfPoints - 1) : 1;
    positions.push_back(static_cast<std::int64_t>(std::round(share * static_cast<double>(last))));
  }
  return positions;
}

//------------------------------------------------------------------------------
CumulativeCurve MakeCumulativeCurve(const Population& values, const Summary& summary,
  const OrderStatistics& sorted, int numberOfPoints, const Weights* weights, Reducer& reducer,
  const std::vector<double>& alsoAt)
{
  CumulativeCurve curve;
  for (const std::int64_t position : GetPositionsOfCurve(summary, numberOfPoints))
  {
    curve.Values.push_back(sorted.Get(position));
  }
  curve.Values.insert(curve.Values.end(), alsoAt.begin(), alsoAt.end());
  std::sort(curve.Values.begin(), curve.Values.end());
  curve.Values.erase(std::unique(curve.Values.begin(), curve.Values.end()), curve.Values.end());
  if (curve.Values.empty())
  {
    return curve;
  }
  const std::size_t size = curve.Values.size();
  const PointFinder finder(curve.Values);
  const double unit = weights ? weights->Unit : 1;
  std::vector<Steps> parts = ForEachChunk<Steps>(values,
    [&](Steps& steps, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      steps.Counts.resize(size);
      steps.Weights.resize(weights ? size : 0);
      for (ExactSum& sum : steps.Weights)
      {
        sum.Reserve(end - begin);
      }
      const ValueBlock* weightBlock = weights ? &weights->Values[&block - values.data()] : nullptr;
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
