// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Quantiles.h"

#include "Statistics/OrderedKey.h"
#include "Statistics/RadixSelect.h"

#include <algorithm>
#include <cmath>
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
}
