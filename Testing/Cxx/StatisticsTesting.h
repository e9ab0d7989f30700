// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StatisticsTesting.h
 * @brief What the tests of statistics share: values that statistics tend to stumble over.
 */
#ifndef camaron_StatisticsTesting_h
#define camaron_StatisticsTesting_h

#include "Base/Number.h"
#include "Criteria/Criterion.h"
#include "Statistics/Population.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Weights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace camaron
{
namespace testing
{
const std::vector<double> DefaultFractions = { 0, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1 };

inline Population OneBlock(const std::vector<double>& values)
{
  ValueBlock block;
  block.Values = values.data();
  block.Size = static_cast<vtkIdType>(values.size());
  return { block };
}

// The cumulative curve of one population by itself.
inline CumulativeCurve MakeCurve(const Population& values, const Summary& summary,
  int numberOfPoints, const Population* weights, Reducer& reducer,
  const std::vector<double>& alsoAt = {})
{
  const OrderStatistics sorted(
    values, summary, GetPositionsOfCurve(summary, numberOfPoints), reducer);
  const Weights weighing = { weights ? *weights : Population(),
    weights ? FindWeightUnit(*weights, reducer) : 1 };
  return MakeCumulativeCurve(
    values, summary, sorted, numberOfPoints, weights ? &weighing : nullptr, reducer, alsoAt);
}

// Lists of values that statistics tend to stumble over.
inline std::vector<std::vector<double>> DifficultLists(std::size_t size)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 1);
  const auto fill = [&](const std::function<double()>& next)
  {
    std::vector<double> list(size);
    std::generate(list.begin(), list.end(), next);
    return list;
  };
  return {
    {},
    { 3.5 },
    { -0.0, 0.0 },
    std::vector<double>(size, 0.1),
    std::vector<double>(size, NaN),
    std::vector<double>(size, Infinity),
    fill([&] { return uniform(random); }),
    fill([&] { return normal(random) * 1e-3 + 1e6; }),
    fill([&] { return std::floor(uniform(random) * 30) - 10; }),
    fill([&] { return std::exp(normal(random) * 100); }),
    fill([&] { return 5e-324 * std::floor(uniform(random) * 1000); }),
    fill([&] { return (2 * uniform(random) - 1) * 1.75e308; }),
    fill([&] { return uniform(random) < 0.5 ? -1.7e308 : 1.7e308; }),
    // Any bits: infinities, denormals, NaNs and all magnitudes.
    fill(
      [&]
      {
        const std::uint64_t bits = random();
        double value;
        std::memcpy(&value, &bits, sizeof(value));
        return value;
      }),
    fill(
      [&]
      {
        const double choice = uniform(random);
        return choice < 0.1 ? NaN
          : choice < 0.15   ? Infinity
          : choice < 0.2    ? -Infinity
          : choice < 0.25   ? Null(NullReason::NotApplicable)
          : choice < 0.3    ? -0.0
                            : std::floor(normal(random) * 100) / 100;
      }),
  };
}
}
}

#endif
