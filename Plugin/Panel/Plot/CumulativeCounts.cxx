// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CumulativeCounts.h"

#include "Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr double EntireWeight = 100; // percent

// Two pixels or more apart in a plot of usual width, and a short list for the server.
constexpr int NumberOfLimits = 100;

template <typename T>
CumulativeCounts::Estimate Interpolate(
  const std::vector<double>& values, const std::vector<T>& numbers, double value)
{
  if (numbers.empty())
  {
    return {};
  }
  const auto above = std::lower_bound(values.begin(), values.end(), value);
  const auto index = above - values.begin();
  if (above == values.end())
  {
    return { static_cast<double>(numbers.back()), true };
  }
  const double next = static_cast<double>(numbers[index]);
  if (*above == value)
  {
    return { next, true };
  }
  if (index == 0)
  {
    return { 0, true };
  }
  const double last = static_cast<double>(numbers[index - 1]);
  if (last == next)
  {
    return { next, true }; // no element in between
  }
  const double fraction =
    (value / 2 - values[index - 1] / 2) / (*above / 2 - values[index - 1] / 2);
  return { std::isfinite(fraction) ? last + fraction * (next - last) : last, false };
}
}

//------------------------------------------------------------------------------
CumulativeCounts::Estimate CumulativeCounts::GetCountUpTo(double value) const
{
  return Interpolate(this->Values, this->Counts, value);
}

//------------------------------------------------------------------------------
CumulativeCounts::Estimate CumulativeCounts::GetWeightUpTo(double value) const
{
  return Interpolate(this->Values, this->WeightPercents, value);
}

//------------------------------------------------------------------------------
CumulativeCounts::Outside CumulativeCounts::GetOutside(
  double low, double high, qint64 numberOfValues) const
{
  Outside outside;
  outside.WeightPercent.Value = this->HasWeights() ? 0 : std::numeric_limits<double>::quiet_NaN();
  const auto add = [](Estimate& sum, double number, bool isExact)
  {
    sum.Value += std::max(number, 0.0); // the total weight is rounded
    sum.Exact = sum.Exact && isExact;
  };
  if (low > -Infinity)
  {
    const double below = std::nextafter(low, -Infinity);
    const Estimate count = this->GetCountUpTo(below);
    const Estimate weight = this->GetWeightUpTo(below);
    add(outside.Count, count.Value, count.Exact);
    add(outside.WeightPercent, weight.Value, weight.Exact);
  }
  if (high < Infinity)
  {
    const Estimate count = this->GetCountUpTo(high);
    const Estimate weight = this->GetWeightUpTo(high);
    add(outside.Count, static_cast<double>(numberOfValues) - count.Value, count.Exact);
    add(outside.WeightPercent, EntireWeight - weight.Value, weight.Exact);
  }
  return outside;
}

//------------------------------------------------------------------------------
bool CumulativeCounts::IsValid() const
{
  const auto isWrong = [](double low, double high) { return !(low < high); };
  return this->Counts.size() == this->Values.size() &&
    (this->WeightPercents.empty() || this->WeightPercents.size() == this->Values.size()) &&
    std::adjacent_find(this->Values.begin(), this->Values.end(), isWrong) == this->Values.end();
}

//------------------------------------------------------------------------------
std::vector<double> GetRoundLimits(const HistogramData& data)
{
  const auto [low, high] = data.GetAxisRange();
  if (data.HasIntegerBins())
  {
    return GetRoundNumbers(low, high, NumberOfLimits, 1);
  }
  return data.Logarithmic ? GetRoundNumbersOfDecades(low, high, NumberOfLimits)
                          : GetRoundNumbers(low, high, NumberOfLimits, 0);
}

//------------------------------------------------------------------------------
std::vector<double> GetCurveValues(const HistogramData& data, double low, double high)
{
  std::vector<double> limits = GetRoundLimits(data);
  limits.insert(limits.end(), data.Edges.begin(), data.Edges.end());
  for (const double limit : { low, high })
  {
    if (std::isfinite(limit))
    {
      limits.push_back(limit);
    }
  }
  std::vector<double> values;
  for (const double limit : limits)
  {
    values.push_back(std::nextafter(limit, -Infinity));
    values.push_back(limit);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}
}
