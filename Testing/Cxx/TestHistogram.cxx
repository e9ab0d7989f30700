// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Histogram.h"
#include "Statistics/Summary.h"
#include "StatisticsTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

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
// No bin has values on both sides of a limit, and the counts are those of the moved edges.
TEST(Statistics, BinsWithGivenEdges)
{
  Reducer serial;
  const std::vector<double> values = { 0, 1, 2.9, 3, 3.5, 7, 9.1, 10 };
  const Summary summary = Summarize(OneBlock(values), {}, serial);
  const auto edges = [&](std::vector<double> given, int numberOfBins = 5)
  {
    BinSettings settings;
    settings.NumberOfBins = numberOfBins;
    settings.Edges = std::move(given);
    const Bins bins = MakeBins(summary, settings);
    const Histogram histogram = CountBins(OneBlock(values), bins, serial);
    EXPECT_EQ(histogram.GetTotal(), 8);
    for (std::size_t bin = 0; bin < bins.GetSize(); ++bin)
    {
      const double low = bins.GetEdges()[bin], high = bins.GetEdges()[bin + 1];
      EXPECT_EQ(histogram.Counts[bin],
        std::count_if(values.begin(), values.end(), [&](double value)
          { return value >= low && (value < high || (value == high && high == 10)); }));
    }
    return bins.GetEdges();
  };
  EXPECT_EQ(edges({}), (std::vector<double>{ 0, 2, 4, 6, 8, 10 }));
  EXPECT_EQ(edges({ 3.1, 7.5 }), (std::vector<double>{ 0, 2, 3.1, 6, 7.5, 10 }));
  EXPECT_EQ(edges({ 4 }), (std::vector<double>{ 0, 2, 4, 6, 8, 10 }));
  EXPECT_EQ(edges({ 4.1, 4.2 }), (std::vector<double>{ 0, 2, 4.1, 4.2, 6, 8, 10 }));
  EXPECT_EQ(edges({ 0.5, 9.5 }), (std::vector<double>{ 0, 0.5, 2, 4, 6, 8, 9.5, 10 }));
  EXPECT_EQ(edges({ 0, 10, -1, 11 }), (std::vector<double>{ 0, 2, 4, 6, 8, 10 }));
  EXPECT_EQ(edges({ 3 }, 1), (std::vector<double>{ 0, 3, 10 }));
}

//------------------------------------------------------------------------------
// Integers get bins of their own, centered on them, and constant data a single point.
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
  bins =
    MakeBins(Summarize(OneBlock(counts), {}, serial), { 50, BinScale::Linear, { 4.5, 6 }, true });
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
