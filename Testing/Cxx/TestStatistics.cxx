// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Histogram.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"
#include "StatisticsTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
double Bisect(const std::vector<double>& edges, double value)
{
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    if (edges[i] <= value && (value < edges[i + 1] || i + 2 == edges.size()))
    {
      return static_cast<double>(i);
    }
  }
  return -1;
}
}

//------------------------------------------------------------------------------
// Case 4 of the specification: undefined and infinite values must not enter any number.
TEST(Statistics, UndefinedAndInfiniteApart)
{
  std::vector<double> values = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, NaN, Infinity };
  Reducer serial;
  const Summary summary = Summarize(OneBlock(values), { 3, 7 }, serial);
  EXPECT_EQ(summary.Count, 12);
  EXPECT_EQ(summary.UndefinedCount, 1);
  EXPECT_EQ(summary.InfiniteCount, 1);
  EXPECT_EQ(summary.Min, 1);
  EXPECT_EQ(summary.Max, 10);
  EXPECT_EQ(summary.ArgMin, 0);
  EXPECT_EQ(summary.ArgMax, 9);
  EXPECT_EQ(summary.Mean, 5.5);
  EXPECT_EQ(summary.Sum, 55);
  EXPECT_NEAR(summary.Variance, 55.0 / 6, 1e-15);
  EXPECT_NEAR(summary.StandardDeviation, 3.0276503540974917, 1e-15);
  EXPECT_EQ(summary.BelowCount + summary.AboveCount, 6);
  EXPECT_EQ(summary.BelowCount, 2);
  EXPECT_EQ(GetQuantiles(OneBlock(values), summary, { 0.5, 0.25, 0.75, 0, 1 }, serial),
    (std::vector<double>{ 5.5, 3.25, 7.75, 1, 10 }));

  // The bins of the specification are those of a measured quantity.
  const Histogram histogram =
    CountBins(OneBlock(values), Bins(1, 10, 10, BinScale::Linear), serial);
  EXPECT_EQ(histogram.Counts, std::vector<std::int64_t>(10, 1));
  EXPECT_EQ(histogram.UndefinedCount, 1);
  EXPECT_EQ(histogram.InfiniteCount, 1);
  EXPECT_EQ(histogram.Underflow + histogram.Overflow, 0);

  values = { NaN, Null(NullReason::NotApplicable), Null(NullReason::Degenerate), -Infinity };
  const Summary undefined = Summarize(OneBlock(values), { 3, 7 }, serial);
  EXPECT_EQ(undefined.UndefinedCount, 3);
  EXPECT_EQ(undefined.GetApplicableCount(), 3);
  EXPECT_EQ(undefined.BelowCount, 1);
  EXPECT_TRUE(std::isnan(undefined.Min) && std::isnan(undefined.Mean));
  EXPECT_EQ(undefined.ArgMin, -1);
}

//------------------------------------------------------------------------------
// Quantiles, bins and worst elements against sorting and searching, for every list.
TEST(Statistics, AgreesWithBruteForce)
{
  Reducer serial;
  for (const std::vector<double>& values : DifficultLists(5000))
  {
    const Population population = OneBlock(values);
    const Summary summary = Summarize(population, {}, serial);
    std::vector<double> sorted;
    std::copy_if(values.begin(), values.end(), std::back_inserter(sorted),
      [](double value) { return std::isfinite(value); });
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(summary.GetFiniteCount(), static_cast<std::int64_t>(sorted.size()));
    if (sorted.empty())
    {
      continue;
    }
    EXPECT_EQ(summary.Min, sorted.front());
    EXPECT_EQ(summary.Max, sorted.back());
    EXPECT_EQ(values[summary.ArgMin], summary.Min);
    EXPECT_EQ(
      std::find(values.begin(), values.end(), summary.Max) - values.begin(), summary.ArgMax);

    // In halves, as long double may be no longer than double.
    const std::vector<double> quantiles =
      GetQuantiles(population, summary, DefaultFractions, serial);
    for (std::size_t q = 0; q < quantiles.size(); ++q)
    {
      const double place = DefaultFractions[q] * static_cast<double>(sorted.size() - 1);
      const auto index = static_cast<std::size_t>(place);
      const double weight = place - static_cast<double>(index);
      const double next = sorted[std::min(index + 1, sorted.size() - 1)];
      const double expected = 2 * (sorted[index] / 2 * (1 - weight) + next / 2 * weight);
      EXPECT_NEAR(
        quantiles[q], expected, 4e-16 * std::max(std::abs(sorted[index]), std::abs(next)) + 1e-323);
      EXPECT_LE(sorted[index], quantiles[q]);
      EXPECT_GE(next, quantiles[q]);
    }

    for (const BinScale scale : { BinScale::Linear, BinScale::Logarithmic })
    {
      for (const int numberOfBins : { 1, 7, 50 })
      {
        const Bins bins = MakeBins(summary, { numberOfBins, scale, {} });
        EXPECT_TRUE(std::is_sorted(bins.GetEdges().begin(), bins.GetEdges().end()));
        std::vector<std::int64_t> expected(bins.GetSize());
        for (const double value : sorted)
        {
          const double bin = Bisect(bins.GetEdges(), value);
          if (bin >= 0 && value <= bins.GetEdges().back())
          {
            ++expected[static_cast<std::size_t>(bin)];
          }
        }
        const Histogram histogram = CountBins(population, bins, serial);
        EXPECT_EQ(histogram.Counts, expected);
        EXPECT_EQ(histogram.GetTotal(), summary.Count);
      }
    }

    for (const WorstEnd end : { WorstEnd::Smallest, WorstEnd::Largest })
    {
      std::vector<vtkIdType> order;
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        if (!std::isnan(values[i]))
        {
          order.push_back(static_cast<vtkIdType>(i));
        }
      }
      std::stable_sort(order.begin(), order.end(), [&](vtkIdType a, vtkIdType b)
        { return end == WorstEnd::Largest ? values[a] > values[b] : values[a] < values[b]; });
      for (const std::size_t count : { 1, 12, 1000, 100000 })
      {
        const std::size_t size = std::min(count, order.size());
        const auto worst = FindWorst(
          population, static_cast<std::int64_t>(count), end, serial, [](WorstElement&) {});
        ASSERT_EQ(worst.size(), size);
        for (std::size_t i = 0; i < size; ++i)
        {
          EXPECT_EQ(worst[i].Id, order[i]);
        }
        const WorstLimit limit =
          FindWorstLimit(population, static_cast<std::int64_t>(count), end, serial);
        EXPECT_EQ(limit.Count, static_cast<std::int64_t>(size));
        std::vector<vtkIdType> selected, expected(order.begin(), order.begin() + size);
        for (vtkIdType i = 0; i < population.front().Size; ++i)
        {
          if (limit.Contains(population.front(), i))
          {
            selected.push_back(i);
          }
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(selected, expected);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Mean and deviation of values whose naive sums cancel or overflow; the moments are known.
TEST(Statistics, MomentsAreStable)
{
  Reducer serial;
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i)
  {
    values.push_back(1e9 + i % 2);
  }
  Summary summary = Summarize(OneBlock(values), {}, serial);
  EXPECT_EQ(summary.Mean, 1e9 + 0.5);
  EXPECT_DOUBLE_EQ(summary.Variance, 250.0 / 999);
  for (const double scale : { 1e308, 1e-300, 3e-320 })
  {
    values = { -scale, scale, -scale, scale };
    summary = Summarize(OneBlock(values), {}, serial);
    EXPECT_EQ(summary.Mean, 0.0);
    EXPECT_NEAR(summary.StandardDeviation / scale, std::sqrt(4.0 / 3), 1e-4);
  }
  values = { 1.7e308, 1.7e308, 1.7e308 };
  summary = Summarize(OneBlock(values), {}, serial);
  EXPECT_EQ(summary.Sum, Infinity);
  EXPECT_EQ(summary.Mean, 1.7e308);
  EXPECT_EQ(summary.StandardDeviation, 0);
}

//------------------------------------------------------------------------------
// Moments of known distributions, also far from 0, where powers of the values would lose all
// digits.
TEST(Statistics, HigherMoments)
{
  Reducer serial;
  Summary summary = Summarize(OneBlock({ 1, 10, 100, 1000, 10000, NaN, Infinity }), {}, serial);
  EXPECT_NEAR(summary.GeometricMean, 100, 1e-12);
  EXPECT_NEAR(summary.RootMeanSquare, std::sqrt(101010101 / 5.0), 1e-11);
  summary = Summarize(OneBlock({ -3, 4 }), {}, serial);
  EXPECT_DOUBLE_EQ(summary.RootMeanSquare, std::sqrt(12.5));
  EXPECT_TRUE(std::isnan(summary.GeometricMean));
  EXPECT_EQ(summary.Skewness, 0);
  EXPECT_EQ(summary.Kurtosis, -2);
  summary = Summarize(OneBlock({ 0.1, 0.1, 0.1 }), {}, serial);
  EXPECT_TRUE(std::isnan(summary.Skewness) && std::isnan(summary.Kurtosis));
  EXPECT_EQ(summary.GeometricMean, 0.1);
  EXPECT_NEAR(summary.RootMeanSquare, 0.1, 1e-17);

  // A coin that shows 1 in one of ten throws: skewness 0.8 / 0.3, kurtosis (1 - 6 * 0.09) / 0.09.
  for (const double shift : { 0.0, 1e6, 1e12, -3e15 })
  {
    std::vector<double> values(1000, shift);
    for (std::size_t i = 0; i < values.size(); i += 10)
    {
      values[i] += 1;
    }
    summary = Summarize(OneBlock(values), {}, serial);
    EXPECT_NEAR(summary.Skewness, 0.8 / 0.3, 1e-13) << shift;
    EXPECT_NEAR(summary.Kurtosis, 0.46 / 0.09, 1e-12) << shift;
    EXPECT_NEAR(summary.Variance, 0.09 * 1000 / 999, 1e-15) << shift;
  }
}

//------------------------------------------------------------------------------
// Skipped elements, blocks and identities: ghosts must not count, ties go to the smallest identity.
TEST(Statistics, BlocksAndIdentities)
{
  const std::vector<double> first = { 5, 1, 9, 9 }, second = { 1, 9, -7 };
  const std::vector<unsigned char> skip = { 0, 0, 1 };
  const std::vector<vtkIdType> firstIds = { 10, 11, 30, 12 }, secondIds = { 3, 4, 5 };
  ValueBlock a, b;
  a.Values = first.data();
  a.Size = 4;
  a.Ids = firstIds.data();
  b.Values = second.data();
  b.Size = 3;
  b.Ids = secondIds.data();
  b.Skip = skip.data();
  Reducer serial;
  const Summary summary = Summarize({ a, b }, {}, serial);
  EXPECT_EQ(summary.Count, 6);
  EXPECT_EQ(summary.Min, 1);
  EXPECT_EQ(summary.ArgMin, 3);
  EXPECT_EQ(summary.ArgMinPlace.Block, 1);
  EXPECT_EQ(summary.ArgMinPlace.Index, 0);
  EXPECT_EQ(summary.ArgMax, 4);
  EXPECT_EQ(summary.ArgMaxPlace.Block, 1);
  EXPECT_EQ(summary.ArgMaxPlace.Index, 1);
  const auto worst = FindWorst({ a, b }, 2, WorstEnd::Largest, serial, [](WorstElement&) {});
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0].Id, 4);
  EXPECT_EQ(worst[0].Block, 1);
  EXPECT_EQ(worst[0].Index, 1);
  EXPECT_EQ(worst[1].Id, 12);
}
