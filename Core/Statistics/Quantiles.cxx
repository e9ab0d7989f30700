// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Quantiles.h"

#include "Ranks/ExactTotals.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/RadixSelect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
// Location of a quantile in the sorted values: Weight is the fraction of the way from Position to
// the next one.
struct Place
{
  std::int64_t Position;
  double Weight;

  Place(double fraction, std::int64_t count)
  {
    const double last = static_cast<double>(count - 1);
    const double place = std::min(std::max(fraction * last, 0.0), last);
    this->Position = static_cast<std::int64_t>(place);
    this->Weight = place - static_cast<double>(this->Position);
  }
};

// Exact at both ends and monotone, as in numpy.
double Interpolate(double a, double b, double weight)
{
  const double difference = b - a;
  if (std::isinf(difference))
  {
    return a * (1 - weight) + b * weight;
  }
  return weight < 0.5 ? a + difference * weight : b - difference * (1 - weight);
}
}

//------------------------------------------------------------------------------
OrderStatistics::OrderStatistics(const Population& population, const Summary& summary,
  std::vector<std::int64_t> positions, Reducer& reducer)
  : Positions(std::move(positions))
{
  std::sort(this->Positions.begin(), this->Positions.end());
  this->Positions.erase(
    std::unique(this->Positions.begin(), this->Positions.end()), this->Positions.end());
  const std::int64_t count = summary.GetFiniteCount();
  // The ends are known; leaving them out reduces the number of windows.
  const std::int64_t low = ToKey(summary.Min), high = ToKey(summary.Max);
  std::vector<std::int64_t> inner;
  for (const std::int64_t position : this->Positions)
  {
    if (position > 0 && position < count - 1)
    {
      inner.push_back(position);
    }
  }
  const auto getKey = [](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  {
    const double value = block.Values[i];
    key = ToKey(value);
    return !IsNotFinite(value) && block.Contains(i);
  };
  // Bins of equal width suit values that fill their range; bins of the leading bits, which are
  // nearly logarithmic, suit values with long tails.
  constexpr double last = RadixSelector::NumberOfBins - 1;
  const double min = summary.Min;
  const double scale = last / (summary.Max - summary.Min);
  const auto getBin = [=](std::int64_t key)
  { return static_cast<int>(std::min((FromKey(key) - min) * scale, last)); };
  const bool fillsRange = summary.StandardDeviation * 100 > summary.Max - summary.Min;
  const std::vector<std::int64_t> keys = fillsRange && std::isnormal(scale)
    ? SelectKeys(population, getKey, getBin, low, high, inner, reducer)
    : SelectKeys(population, getKey, low, high, inner, reducer);

  auto key = keys.begin();
  for (const std::int64_t position : this->Positions)
  {
    const bool isEnd = position == 0 || position == count - 1;
    this->Values.push_back(!isEnd ? FromKey(*key++) : position == 0 ? summary.Min : summary.Max);
  }
}

//------------------------------------------------------------------------------
double OrderStatistics::Get(std::int64_t position) const
{
  const auto place = std::lower_bound(this->Positions.begin(), this->Positions.end(), position);
  return this->Values[place - this->Positions.begin()];
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> GetPositionsOfQuantiles(
  const Summary& summary, const std::vector<double>& fractions)
{
  std::vector<std::int64_t> positions;
  const std::int64_t count = summary.GetFiniteCount();
  for (const double fraction : fractions)
  {
    if (count > 0)
    {
      const Place place(fraction, count);
      positions.push_back(place.Position);
      if (place.Weight > 0)
      {
        positions.push_back(place.Position + 1);
      }
    }
  }
  return positions;
}

//------------------------------------------------------------------------------
std::vector<double> GetQuantiles(
  const OrderStatistics& sorted, const Summary& summary, const std::vector<double>& fractions)
{
  const std::int64_t count = summary.GetFiniteCount();
  std::vector<double> quantiles;
  for (const double fraction : fractions)
  {
    if (count == 0)
    {
      quantiles.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const Place place(fraction, count);
    const double value = sorted.Get(place.Position);
    quantiles.push_back(
      place.Weight > 0 ? Interpolate(value, sorted.Get(place.Position + 1), place.Weight) : value);
  }
  return quantiles;
}

//------------------------------------------------------------------------------
std::vector<double> GetQuantiles(const Population& population, const Summary& summary,
  const std::vector<double>& fractions, Reducer& reducer)
{
  const OrderStatistics sorted(
    population, summary, GetPositionsOfQuantiles(summary, fractions), reducer);
  return GetQuantiles(sorted, summary, fractions);
}

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
