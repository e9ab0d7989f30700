// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Histogram.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/Worst.h"
#include "StatisticsTesting.h"
#include "TeamReducer.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

namespace
{
// Everything there is to know, as bits, so that NaN equals NaN and 0 differs from -0.
struct Results
{
  std::vector<double> Numbers;
  std::vector<std::int64_t> Integers;

  bool operator==(const Results& other) const
  {
    return this->Integers == other.Integers && this->Numbers.size() == other.Numbers.size() &&
      std::memcmp(
        this->Numbers.data(), other.Numbers.data(), this->Numbers.size() * sizeof(double)) == 0;
  }
};

Results ComputeAll(const Population& population, Reducer& reducer)
{
  Results results;
  const Summary summary = Summarize(population, { 0.25, 0.75 }, reducer);
  results.Numbers = { summary.Min, summary.Max, summary.MinPositive, summary.Mean,
    summary.StandardDeviation, summary.Variance, summary.Skewness, summary.Kurtosis,
    summary.RootMeanSquare, summary.GeometricMean, summary.Sum };
  results.Integers = { summary.Count, summary.UndefinedCount, summary.NotApplicableCount,
    summary.InfiniteCount, summary.BelowCount, summary.AboveCount, summary.NonIntegerCount != 0,
    summary.ArgMin, summary.ArgMax };
  const std::vector<double> quantiles =
    GetQuantiles(population, summary, DefaultFractions, reducer);
  results.Numbers.insert(results.Numbers.end(), quantiles.begin(), quantiles.end());
  const CumulativeCurve curve = MakeCurve(population, summary, 30, &population, reducer);
  results.Numbers.insert(results.Numbers.end(), curve.Values.begin(), curve.Values.end());
  results.Numbers.insert(results.Numbers.end(), curve.WeightsUpTo.begin(), curve.WeightsUpTo.end());
  results.Integers.insert(results.Integers.end(), curve.CountsUpTo.begin(), curve.CountsUpTo.end());
  for (const BinScale scale : { BinScale::Linear, BinScale::Logarithmic })
  {
    const Bins bins = MakeBins(summary, { 20, scale, {} });
    const Histogram histogram = CountBins(population, bins, reducer);
    results.Numbers.insert(results.Numbers.end(), bins.GetEdges().begin(), bins.GetEdges().end());
    results.Integers.insert(
      results.Integers.end(), histogram.Counts.begin(), histogram.Counts.end());
    results.Integers.insert(results.Integers.end(),
      { histogram.Underflow, histogram.Overflow, histogram.UndefinedCount,
        histogram.InfiniteCount });
    EXPECT_EQ(histogram.GetTotal(), summary.Count);
  }
  for (const WorstEnd end : { WorstEnd::Smallest, WorstEnd::Largest })
  {
    for (const WorstElement& element :
      FindWorst(population, 12, end, reducer, [](WorstElement& e) { e.CellType = 10; }))
    {
      results.Numbers.push_back(element.Value);
      results.Integers.insert(results.Integers.end(), { element.Id, element.CellType });
    }
    const WorstLimit limit = FindWorstLimit(population, 12, end, reducer);
    results.Integers.insert(results.Integers.end(), { limit.Count, limit.Key, limit.LastId });
  }
  return results;
}

Results ComputeSerial(const std::vector<double>& values)
{
  Reducer serial;
  return ComputeAll(OneBlock(values), serial);
}

// The same values dealt out in pieces of random sizes, one of them empty.
Results ComputeOnProcesses(const std::vector<double>& values, int size, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> cuts = { 0, values.size() };
  for (int i = 0; i + 2 < size; ++i)
  {
    cuts.push_back(random() % (values.size() + 1));
  }
  cuts.push_back(cuts.back());
  std::sort(cuts.begin(), cuts.end());

  Team team(size);
  std::vector<Results> results(size);
  std::vector<std::thread> threads;
  for (int process = 0; process < size; ++process)
  {
    threads.emplace_back(
      [&, process]
      {
        ValueBlock block;
        block.Values = values.data() + cuts[process];
        block.Size = static_cast<vtkIdType>(cuts[process + 1] - cuts[process]);
        block.FirstId = static_cast<vtkIdType>(cuts[process]);
        TeamReducer reducer(team, process);
        results[process] = ComputeAll({ block }, reducer);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const Results& other : results)
  {
    EXPECT_TRUE(other == results.front()) << "processes know different results";
  }
  return results.front();
}
}

//------------------------------------------------------------------------------
// The promise of the module: not a bit depends on threads.
TEST(Statistics, SameOnAnyNumberOfThreads)
{
  for (const std::vector<double>& values : DifficultLists(200000))
  {
    Results one, four;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 1, "Sequential", false }, [&] { one = ComputeSerial(values); });
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ 4, "STDThread", false }, [&] { four = ComputeSerial(values); });
    EXPECT_TRUE(one == four) << values.size() << " values, first "
                             << (values.empty() ? 0 : values.front());
  }
}

//------------------------------------------------------------------------------
// ... nor on processes, some of them without any element.
TEST(Statistics, SameOnAnyNumberOfProcesses)
{
  for (const std::vector<double>& values : DifficultLists(3000))
  {
    const Results serial = ComputeSerial(values);
    for (const int size : { 2, 3, 5 })
    {
      EXPECT_TRUE(ComputeOnProcesses(values, size, 17u * size) == serial)
        << values.size() << " values on " << size << " processes";
    }
  }
}

//------------------------------------------------------------------------------
// Nor on the order of the elements.
TEST(Statistics, SameInAnyOrder)
{
  for (std::vector<double> values : DifficultLists(3000))
  {
    Reducer serial;
    const Summary before = Summarize(OneBlock(values), {}, serial);
    std::shuffle(values.begin(), values.end(), std::mt19937(3));
    const Summary after = Summarize(OneBlock(values), {}, serial);
    EXPECT_EQ(std::memcmp(&before.Min, &after.Min, 7 * sizeof(double)), 0);
  }
}
