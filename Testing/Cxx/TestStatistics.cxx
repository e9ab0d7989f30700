// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Statistics of random and difficult values against brute force, and on simulated processes.
#include "Criteria/Criterion.h"
#include "Statistics/Cumulative.h"
#include "Statistics/DistributionDistance.h"
#include "Statistics/ExactSum.h"
#include "Statistics/Histogram.h"
#include "Statistics/KeyRanks.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/Quantiles.h"
#include "Statistics/Summary.h"
#include "Statistics/ValueChanges.h"
#include "Statistics/Worst.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>
#include <random>
#include <thread>

using namespace camaron;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
const std::vector<double> DefaultFractions = { 0, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1 };

// Processes of a parallel run as threads that wait for each other.
class Team
{
public:
  explicit Team(int size)
    : Size(size)
    , Slots(size)
  {
  }

  // Every process calls it with its bytes and gets those of all.
  std::vector<std::vector<char>> Exchange(int process, const std::vector<char>& bytes)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Slots[process] = bytes;
    this->Wait(lock);
    const std::vector<std::vector<char>> all = this->Slots;
    this->Wait(lock);
    return all;
  }

  const int Size;

private:
  void Wait(std::unique_lock<std::mutex>& lock)
  {
    const int generation = this->Generation;
    if (++this->Waiting == this->Size)
    {
      this->Waiting = 0;
      ++this->Generation;
      this->Condition.notify_all();
    }
    this->Condition.wait(lock, [&] { return generation != this->Generation; });
  }

  std::vector<std::vector<char>> Slots;
  std::mutex Mutex;
  std::condition_variable Condition;
  int Waiting = 0;
  int Generation = 0;
};

class TeamReducer : public Reducer
{
public:
  TeamReducer(Team& team, int process)
    : Processes(team)
    , Process(process)
  {
  }
  int GetNumberOfProcesses() const override { return this->Processes.Size; }
  int GetProcess() const override { return this->Process; }
  void Sum(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return a + b; });
  }
  void Min(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return std::min(a, b); });
  }
  void Max(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return std::max(a, b); });
  }
  std::vector<char> Gather(const std::vector<char>& bytes, std::vector<std::size_t>& sizes) override
  {
    std::vector<char> result;
    sizes.clear();
    for (const std::vector<char>& part : this->Processes.Exchange(this->Process, bytes))
    {
      sizes.push_back(part.size());
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  std::vector<std::vector<char>> Exchange(std::vector<std::vector<char>>&& lists) override
  {
    // All hear all lists, one receiver after the other, and keep what is theirs.
    std::vector<std::vector<char>> received;
    for (int receiver = 0; receiver < this->Processes.Size; ++receiver)
    {
      const auto all = this->Processes.Exchange(this->Process, lists[receiver]);
      received = receiver == this->Process ? all : received;
    }
    return received;
  }

private:
  template <typename Operation>
  void Combine(std::int64_t* values, std::size_t size, Operation&& operation)
  {
    const char* begin = reinterpret_cast<const char*>(values);
    const auto all =
      this->Processes.Exchange(this->Process, { begin, begin + size * sizeof(*values) });
    for (int process = 0; process < this->Processes.Size; ++process)
    {
      ASSERT_EQ(all[process].size(), size * sizeof(*values)) << "processes do not agree";
      for (std::size_t i = 0; i < size; ++i)
      {
        std::int64_t other;
        std::memcpy(&other, all[process].data() + i * sizeof(other), sizeof(other));
        values[i] = process == 0 ? other : operation(values[i], other);
      }
    }
  }

  Team& Processes;
  int Process;
};

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
    summary.StandardDeviation, summary.Variance, summary.Skewness, summary.Kurtosis, summary.RootMeanSquare,
    summary.GeometricMean, summary.Sum };
  results.Integers = { summary.Count, summary.NullCount, summary.NotApplicableCount,
    summary.InfCount, summary.BelowCount, summary.AboveCount, summary.NonIntegerCount != 0,
    summary.ArgMin, summary.ArgMax };
  const std::vector<double> quantiles =
    GetQuantiles(population, summary, DefaultFractions, reducer);
  results.Numbers.insert(results.Numbers.end(), quantiles.begin(), quantiles.end());
  const CumulativeCurve curve = MakeCumulativeCurve(population, summary, 30, &population, reducer);
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
      { histogram.Underflow, histogram.Overflow, histogram.NullCount, histogram.InfCount });
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

Population OneBlock(const std::vector<double>& values)
{
  ValueBlock block;
  block.Values = values.data();
  block.Size = static_cast<vtkIdType>(values.size());
  return { block };
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

// Lists of values that statistics tend to stumble over.
std::vector<std::vector<double>> DifficultLists(std::size_t size)
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
// Wrong carries or rounding would show up in sums that cancel; the expected values are exact by
// construction.
TEST(ExactSum, IsExact)
{
  const auto sum = [](const std::vector<double>& values)
  {
    ExactSum exact;
    exact.Reserve(static_cast<std::int64_t>(values.size()));
    for (const double value : values)
    {
      exact.Add(value);
    }
    return ExactSum::Round(exact.GetLimbs());
  };
  EXPECT_EQ(sum({}), 0.0);
  EXPECT_EQ(sum({ 1e308, 1.0, -1e308 }), 1.0);
  EXPECT_EQ(sum({ 1.0, 1e100, 1.0, -1e100 }), 2.0);
  EXPECT_EQ(sum({ 1e308, 1e308 }), Infinity);
  EXPECT_EQ(sum({ -1e308, -1e308 }), -Infinity);
  EXPECT_EQ(sum({ 5e-324, 5e-324 }), 1e-323);
  EXPECT_EQ(sum({ -5e-324, 2.2250738585072014e-308 }), 2.2250738585072009e-308);
  // Ties to even: 2^53 + 1 is not a double; a bit far below decides.
  EXPECT_EQ(sum({ 9007199254740992.0, 1.0 }), 9007199254740992.0);
  EXPECT_EQ(sum({ 9007199254740994.0, 1.0 }), 9007199254740996.0);
  EXPECT_EQ(sum({ 9007199254740992.0, 1.0, 1e-300 }), 9007199254740994.0);
  EXPECT_EQ(sum({ -9007199254740992.0, -1.0, -1e-300 }), -9007199254740994.0);
  EXPECT_EQ(sum({ 0.1, 0.2, -0.3 }), 2.7755575615628914e-17); // python: fsum

  std::vector<double> list;
  std::mt19937_64 random(7);
  while (list.size() < 20000)
  {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      list.push_back(value);
      list.push_back(-value);
    }
  }
  std::shuffle(list.begin(), list.end(), random);
  EXPECT_EQ(sum(list), 0.0);
}

//------------------------------------------------------------------------------
// A mean of equal values must be that value, else constant data would deviate from their mean.
TEST(ExactSum, DividesWithOneRounding)
{
  for (const double value : { 0.1, 1.0 / 3, 5e-324, 1.7e308, -2.2250738585072014e-308 })
  {
    for (const int count : { 1, 3, 7, 1000, 12345 })
    {
      ExactSum exact;
      exact.Reserve(count);
      for (int i = 0; i < count; ++i)
      {
        exact.Add(value);
      }
      EXPECT_EQ(ExactSum::Divide(exact.GetLimbs(), count), value) << count;
    }
  }
  ExactSum one;
  one.Reserve(1);
  one.Add(1.0);
  EXPECT_EQ(ExactSum::Divide(one.GetLimbs(), 3), 1.0 / 3);
  EXPECT_EQ(ExactSum::Divide(one.GetLimbs(), 9007199254740993), 1.1102230246251564e-16);
  ExactSum smallest;
  smallest.Reserve(1);
  smallest.Add(5e-324);
  EXPECT_EQ(ExactSum::Divide(smallest.GetLimbs(), 2), 0.0) << "a tie goes to even";
  smallest.Reserve(1);
  smallest.Add(1e-323);
  EXPECT_EQ(ExactSum::Divide(smallest.GetLimbs(), 2), 1e-323) << "1.5 units are a tie";
}

//------------------------------------------------------------------------------
// Keys out of order would give wrong extremes and quantiles.
TEST(OrderedKey, OrdersAsDoubles)
{
  const std::vector<double> ascending = { -Infinity, -1.7e308, -1.0, -2.3e-308, -5e-324, 0.0,
    5e-324, 2.3e-308, 1.0, 1.0000000000000002, 1.7e308, Infinity };
  for (std::size_t i = 0; i < ascending.size(); ++i)
  {
    EXPECT_EQ(FromKey(ToKey(ascending[i])), ascending[i]);
    if (i > 0)
    {
      EXPECT_LT(ToKey(ascending[i - 1]), ToKey(ascending[i]));
    }
  }
  EXPECT_EQ(ToKey(-0.0), ToKey(0.0));
}

//------------------------------------------------------------------------------
// Case 4 of the specification: null and infinite values must not enter any number.
TEST(Statistics, NullAndInfiniteApart)
{
  std::vector<double> values = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, NaN, Infinity };
  Reducer serial;
  const Summary summary = Summarize(OneBlock(values), { 3, 7 }, serial);
  EXPECT_EQ(summary.Count, 12);
  EXPECT_EQ(summary.NullCount, 1);
  EXPECT_EQ(summary.InfCount, 1);
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
  EXPECT_EQ(histogram.NullCount, 1);
  EXPECT_EQ(histogram.InfCount, 1);
  EXPECT_EQ(histogram.Underflow + histogram.Overflow, 0);

  values = { NaN, Null(NullReason::NotApplicable), Null(NullReason::Degenerate), -Infinity };
  const Summary nulls = Summarize(OneBlock(values), { 3, 7 }, serial);
  EXPECT_EQ(nulls.NullCount, 3);
  EXPECT_EQ(nulls.GetApplicableCount(), 3);
  EXPECT_EQ(nulls.BelowCount, 1);
  EXPECT_TRUE(std::isnan(nulls.Min) && std::isnan(nulls.Mean));
  EXPECT_EQ(nulls.ArgMin, -1);
}

//------------------------------------------------------------------------------
// Case 5 of the specification.
TEST(Statistics, LogarithmicBins)
{
  const std::vector<double> values = { 0.01, 0.1, 1, 10, 100, 0, -1 };
  Reducer serial;
  const Summary summary = Summarize(OneBlock(values), {}, serial);
  BinSettings settings;
  settings.NumberOfBins = 4;
  settings.Scale = BinScale::Logarithmic;
  for (const bool automatic : { true, false })
  {
    settings.Range = automatic ? ValueRange() : ValueRange{ 0.01, 100 };
    const Bins bins = MakeBins(summary, settings);
    EXPECT_EQ(bins.GetEdges(), (std::vector<double>{ 0.01, 0.1, 1, 10, 100 }));
    EXPECT_DOUBLE_EQ(bins.GetCenter(0), std::sqrt(0.001));
    const Histogram histogram = CountBins(OneBlock(values), bins, serial);
    EXPECT_EQ(histogram.Counts, (std::vector<std::int64_t>{ 1, 1, 1, 2 }));
    EXPECT_EQ(histogram.Underflow, 2);
    EXPECT_EQ(histogram.Overflow, 0);
  }
}

//------------------------------------------------------------------------------
// Integers get bins of their own, centred on them, and constant data a single point.
TEST(Statistics, BinsOfIntegersAndConstants)
{
  Reducer serial;
  const std::vector<double> counts = { 4, 6, 6, 5, 12, NaN, 6 };
  BinSettings ofIntegers;
  ofIntegers.OfIntegers = true;
  Bins bins = MakeBins(Summarize(OneBlock(counts), {}, serial), ofIntegers);
  ASSERT_EQ(bins.GetSize(), 9u);
  EXPECT_EQ(bins.GetCenter(0), 4);
  EXPECT_EQ(CountBins(OneBlock(counts), bins, serial).Counts,
    (std::vector<std::int64_t>{ 1, 1, 3, 0, 0, 0, 0, 0, 1 }));
  bins = MakeBins(Summarize(OneBlock(counts), {}, serial), { 50, BinScale::Linear, { 4.5, 6 }, true });
  const Histogram custom = CountBins(OneBlock(counts), bins, serial);
  EXPECT_EQ(custom.Counts, (std::vector<std::int64_t>{ 1, 3 }));
  EXPECT_EQ(custom.Underflow, 1);
  EXPECT_EQ(custom.Overflow, 1);

  // Other values that happen to be whole numbers have as many bins as the user wants.
  bins = MakeBins(Summarize(OneBlock(counts), {}, serial), { 4, BinScale::Linear, { 4, 12 } });
  EXPECT_EQ(bins.GetEdges(), (std::vector<double>{ 4, 6, 8, 10, 12 }));

  const std::vector<double> constant = { 0.1, 0.1, 0.1 };
  for (const BinScale scale : { BinScale::Linear, BinScale::Logarithmic })
  {
    bins = MakeBins(Summarize(OneBlock(constant), {}, serial), { 50, scale, {} });
    EXPECT_EQ(bins.GetEdges(), (std::vector<double>{ 0.1, 0.1 }));
    EXPECT_EQ(CountBins(OneBlock(constant), bins, serial).Counts, (std::vector<std::int64_t>{ 3 }));
  }
  const Summary summary = Summarize(OneBlock(constant), {}, serial);
  EXPECT_EQ(summary.Mean, 0.1);
  EXPECT_EQ(summary.Variance, 0.0);

  const std::vector<double> negative = { -1, -2.5 };
  bins = MakeBins(Summarize(OneBlock(negative), {}, serial), { 50, BinScale::Logarithmic, {} });
  EXPECT_EQ(bins.GetSize(), 0u);
  EXPECT_EQ(CountBins(OneBlock(negative), bins, serial).Underflow, 2);
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
      std::stable_sort(order.begin(), order.end(),
        [&](vtkIdType a, vtkIdType b)
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
// Moments of known distributions, also far from 0, where powers of the values would lose all digits.
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
// Distances of Kolmogorov and Smirnov by their definition, on any number of processes, one of them without values.
TEST(Statistics, DistributionDistance)
{
  const auto lists = DifficultLists(700);
  const auto share = [](const std::vector<double>& list, double x)
  {
    const auto isNull = [](double value) { return std::isnan(value); };
    const auto upTo = std::count_if(list.begin(), list.end(), [x](double value) { return value <= x; });
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
  const std::vector<double> before = { 1, 1, 1, 1, NaN, NaN, 1, Infinity, Infinity, 0, -1.7e308, 7 };
  const std::vector<double> after = { 2, 0, 1, 1 + 1e-12, NaN, 1, NaN, Infinity, 1, 1e-300, 1.7e308, 8 };
  Population a = OneBlock(before), b = OneBlock(after);
  const std::vector<unsigned char> skip = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  b.front().Skip = skip.data();
  ValueChanges changes = CountChanges(a, b, Better::Bigger, 1e-9, serial);
  EXPECT_EQ(changes.Compared, 10);
  EXPECT_EQ(changes.Unchanged, 3);
  EXPECT_EQ(changes.Improved, 4); // 1 to 2, from null, 0 to 1e-300, and the huge ones
  EXPECT_EQ(changes.Worsened, 3);
  changes = CountChanges(a, b, Better::Smaller, 0, serial);
  EXPECT_EQ(changes.Unchanged, 2);
  EXPECT_EQ(changes.Improved, 3); // 1 to 0, from null, from infinity
  EXPECT_EQ(changes.Worsened, 5);
  changes = CountChanges(a, b, Better::Neither, 0, serial);
  EXPECT_EQ(changes.Improved, 1);
  EXPECT_EQ(changes.Worsened, 1);
}

//------------------------------------------------------------------------------
// A curve that skips values, counts ties twice or loses infinite ones would not be the distribution function.
TEST(Statistics, CumulativeCurve)
{
  Reducer serial;
  const std::vector<double> values = { 4, 1, NaN, 3, Infinity, 3, -Infinity, 2, 3 };
  const std::vector<double> weights = { -1, 10, 5, 100, 7, NaN, 1000, 1e4, 1e5 };
  const Population population = OneBlock(values), weighing = OneBlock(weights);
  const Summary summary = Summarize(population, {}, serial);
  CumulativeCurve curve = MakeCumulativeCurve(population, summary, 100, &weighing, serial);
  EXPECT_EQ(curve.Values, (std::vector<double>{ 1, 2, 3, 4 }));
  EXPECT_EQ(curve.CountsUpTo, (std::vector<std::int64_t>{ 2, 3, 6, 7 }));
  EXPECT_EQ(curve.WeightsUpTo, (std::vector<double>{ 1010, 11010, 111110, 111111 }));
  curve = MakeCumulativeCurve(population, summary, 3, nullptr, serial);
  EXPECT_EQ(curve.Values, (std::vector<double>{ 1, 3, 4 }));
  EXPECT_EQ(curve.CountsUpTo, (std::vector<std::int64_t>{ 2, 6, 7 }));
  EXPECT_TRUE(curve.WeightsUpTo.empty());
  EXPECT_TRUE(MakeCumulativeCurve(population, summary, 0, nullptr, serial).Values.empty());

  for (const std::vector<double>& list : DifficultLists(3000))
  {
    const Summary all = Summarize(OneBlock(list), {}, serial);
    const CumulativeCurve points = MakeCumulativeCurve(OneBlock(list), all, 50, nullptr, serial);
    EXPECT_EQ(points.Values.empty(), all.GetFiniteCount() == 0);
    for (std::size_t p = 0; p < points.Values.size(); ++p)
    {
      const double value = points.Values[p];
      EXPECT_EQ(points.CountsUpTo[p],
        std::count_if(list.begin(), list.end(), [&](double other) { return other <= value; }));
    }
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
