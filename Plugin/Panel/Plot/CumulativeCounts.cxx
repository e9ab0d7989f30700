// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CumulativeCounts.h"

#include "Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace camaron
{
namespace
{
constexpr double EntireWeight = 100; // percent

// Two pixels or more apart in a plot of usual width, and a short list for the server.
constexpr int NumberOfLimits = 100;

// The number up to a value.
template <typename T>
CumulativeCounts::Estimate Interpolate(
  const std::vector<double>& values, const std::vector<T>& numbers, double value)
{
  const auto above = std::lower_bound(values.begin(), values.end(), value);
  const auto index = above - values.begin();
  const double last = index == 0 ? 0 : static_cast<double>(numbers[index - 1]);
  if (above == values.end())
  {
    return { last, true };
  }
  const double next = static_cast<double>(numbers[index]);
  if (*above == value)
  {
    return { next, true };
  }
  if (index == 0 || last == next)
  {
    return { last, true }; // no element in between
  }
  const double fraction =
    (value / 2 - values[index - 1] / 2) / (*above / 2 - values[index - 1] / 2);
  return { std::isfinite(fraction) ? last + fraction * (next - last) : last, false };
}
}

//------------------------------------------------------------------------------
CumulativeCounts::Outside CumulativeCounts::GetOutside(
  double low, double high, qint64 numberOfValues) const
{
  const auto sumOutside = [&](const auto& numbers, double total)
  {
    Estimate sum;
    const auto add = [&sum](double number, bool isExact)
    {
      sum.Value += std::max(number, 0.0); // the total weight is rounded
      sum.Exact = sum.Exact && isExact;
    };
    if (low > -Infinity)
    {
      const Estimate below = Interpolate(this->Values, numbers, std::nextafter(low, -Infinity));
      add(below.Value, below.Exact);
    }
    if (high < Infinity)
    {
      const Estimate upTo = Interpolate(this->Values, numbers, high);
      add(total - upTo.Value, upTo.Exact);
    }
    return sum;
  };
  Estimate weight{ std::numeric_limits<double>::quiet_NaN() };
  if (!this->WeightPercents.empty())
  {
    weight = sumOutside(this->WeightPercents, EntireWeight);
  }
  return { sumOutside(this->Counts, static_cast<double>(numberOfValues)), weight };
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
  std::set<double> values;
  for (const double limit : limits)
  {
    values.insert({ std::nextafter(limit, -Infinity), limit });
  }
  return { values.begin(), values.end() };
}
}
