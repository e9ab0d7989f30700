// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/ValueChanges.h"
#include "StatisticsTesting.h"
#include "TeamReducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Distances of Kolmogorov and Smirnov by their definition, on any number of processes, one of them
// without values.
TEST(Statistics, DistributionDistance)
{
  const auto lists = DifficultLists(300);
  const auto share = [](const std::vector<double>& list, double x)
  {
    const auto isNull = [](double value) { return std::isnan(value); };
    const auto upTo =
      std::count_if(list.begin(), list.end(), [x](double value) { return value <= x; });
    const auto size = list.size() - std::count_if(list.begin(), list.end(), isNull);
    return static_cast<double>(upTo) / static_cast<double>(size);
  };
  for (std::size_t first = 0; first < lists.size(); ++first)
  {
    for (const std::size_t second : { first, std::size_t(6), std::size_t(8), lists.size() - 1 })
    {
      const std::vector<double>&a = lists[first], &b = lists[second];
      double expected = NaN, where = NaN;
      std::vector<double> places = a;
      places.insert(places.end(), b.begin(), b.end());
      for (const double x : places)
      {
        const double difference = std::abs(share(a, x) - share(b, x));
        if (!std::isnan(x) && !std::isnan(difference) &&
          (!(difference <= expected) || (difference == expected && x < where)))
        {
          expected = difference;
          where = x;
        }
      }
      for (const int size : { 1, 2, 5 })
      {
        Team team(size);
        std::vector<DistributionDistance> found(size);
        std::vector<std::thread> threads;
        for (int process = 0; process < size; ++process)
        {
          threads.emplace_back(
            [&, process]
            {
              // The last of several processes has nothing.
              const std::size_t owners = size > 1 ? size - 1 : 1;
              const std::size_t number = static_cast<std::size_t>(process);
              const auto part = [&](const std::vector<double>& list)
              {
                ValueBlock block;
                const std::size_t begin = list.size() * number / owners;
                block.Values = list.data() + begin;
                block.Size = number < owners ? list.size() * (number + 1) / owners - begin : 0;
                return Population{ block };
              };
              TeamReducer reducer(team, process);
              found[process] = FindDistributionDistance(part(a), part(b), reducer);
            });
        }
        for (std::thread& thread : threads)
        {
          thread.join();
        }
        for (const DistributionDistance& distance : found)
        {
          if (std::isnan(expected))
          {
            EXPECT_TRUE(std::isnan(distance.Distance) && std::isnan(distance.Value));
            continue;
          }
          EXPECT_EQ(distance.Distance, expected) << first << ' ' << second << ' ' << size;
          EXPECT_EQ(distance.Value, where) << first << ' ' << second << ' ' << size;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// What counts as better, worse and the same, at the ends of what numbers can be.
TEST(Statistics, ValueChanges)
{
  Reducer serial;
  const std::vector<double> before = { 1, 1, 1, 1, NaN, NaN, 1, Infinity, Infinity, 0, -1.7e308,
    7 };
  const std::vector<double> after = { 2, 0, 1, 1 + 1e-12, NaN, 1, NaN, Infinity, 1, 1e-300, 1.7e308,
    8 };
  Population a = OneBlock(before), b = OneBlock(after);
  const std::vector<unsigned char> skip = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  b.front().Skip = skip.data();
  ValueChanges changes = CountChanges(a, b, Better::Bigger, 1e-9, serial);
  EXPECT_EQ(changes.Compared, 10);
  EXPECT_EQ(changes.Unchanged, 3);
  EXPECT_EQ(changes.Improved, 4); // 1 to 2, from undefined, 0 to 1e-300, and the huge ones
  EXPECT_EQ(changes.Worsened, 3);
  changes = CountChanges(a, b, Better::Smaller, 0, serial);
  EXPECT_EQ(changes.Unchanged, 2);
  EXPECT_EQ(changes.Improved, 3); // 1 to 0, from undefined, from infinity
  EXPECT_EQ(changes.Worsened, 5);
  changes = CountChanges(a, b, Better::Neither, 0, serial);
  EXPECT_EQ(changes.Improved, 1);
  EXPECT_EQ(changes.Worsened, 1);
}

//------------------------------------------------------------------------------
// A curve that skips values, counts ties twice or loses infinite ones would not be the distribution
// function.
TEST(Statistics, CumulativeCurve)
{
  Reducer serial;
  const std::vector<double> values = { 4, 1, NaN, 3, Infinity, 3, -Infinity, 2, 3 };
  const std::vector<double> weights = { -1, 10, 5, 100, 7, NaN, 1000, 1e4, 1e5 };
  const Population population = OneBlock(values), weighing = OneBlock(weights);
  const Summary summary = Summarize(population, {}, serial);
  CumulativeCurve curve = MakeCurve(population, summary, 100, &weighing, serial);
  EXPECT_EQ(curve.Values, (std::vector<double>{ 1, 2, 3, 4 }));
  EXPECT_EQ(curve.CountsUpTo, (std::vector<std::int64_t>{ 2, 3, 6, 7 }));
  EXPECT_EQ(curve.WeightsUpTo, (std::vector<double>{ 1010, 11010, 111110, 111111 }));
  curve = MakeCurve(population, summary, 3, nullptr, serial);
  EXPECT_EQ(curve.Values, (std::vector<double>{ 1, 3, 4 }));
  EXPECT_EQ(curve.CountsUpTo, (std::vector<std::int64_t>{ 2, 6, 7 }));
  EXPECT_TRUE(curve.WeightsUpTo.empty());
  EXPECT_TRUE(MakeCurve(population, summary, 0, nullptr, serial).Values.empty());
  curve = MakeCurve(population, summary, 3, nullptr, serial, { Infinity, 3, 2.5, -Infinity, 0 });
  EXPECT_EQ(curve.Values, (std::vector<double>{ -Infinity, 0, 1, 2.5, 3, 4, Infinity }));
  EXPECT_EQ(curve.CountsUpTo, (std::vector<std::int64_t>{ 1, 1, 2, 3, 6, 7, 8 }));

  for (const std::vector<double>& list : DifficultLists(3000))
  {
    const Summary all = Summarize(OneBlock(list), {}, serial);
    const CumulativeCurve points = MakeCurve(OneBlock(list), all, 50, nullptr, serial);
    EXPECT_EQ(points.Values.empty(), all.GetFiniteCount() == 0);
    for (std::size_t p = 0; p < points.Values.size(); ++p)
    {
      const double value = points.Values[p];
      EXPECT_EQ(points.CountsUpTo[p],
        std::count_if(list.begin(), list.end(), [&](double other) { return other <= value; }));
    }
  }
}
