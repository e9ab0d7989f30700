// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Summary.h"

#include "Base/Number.h"
#include "Criteria/Criterion.h"
#include "Ranks/ExactTotals.h"
#include "Statistics/OrderedKey.h"

#include <array>
#include <cmath>

namespace camaron
{
namespace
{
// The first pass over a part of the values.
struct Totals
{
  Summary Counts;
  double Min = Infinity;
  double Max = -Infinity;
  double MinPositive = Infinity;
  ExactSum Sum;

  void AddNotFinite(const ValueBlock& block, vtkIdType i, const ValueRange& acceptable)
  {
    const double value = block.Values[i];
    const bool isApplicable =
      !std::isnan(value) || block.GetNullReason(i) != NullReason::NotApplicable;
    const bool isJudged = isApplicable && block.IsJudged(i);
    this->Counts.JudgedCount += isJudged;
    if (std::isnan(value))
    {
      ++this->Counts.UndefinedCount;
      this->Counts.JudgedUndefinedCount += isJudged;
      this->Counts.NotApplicableCount += !isApplicable;
    }
    else
    {
      ++this->Counts.InfiniteCount;
      this->Counts.BelowCount += isJudged && value < acceptable.Low;
      this->Counts.AboveCount += isJudged && value > acceptable.High;
    }
  }
};

// Larger integers are irrelevant, because there would be too many bins of width 1.
constexpr double LargestInteger = 1e15;

bool IsInteger(double value)
{
  return std::abs(value) < LargestInteger &&
    static_cast<double>(static_cast<std::int64_t>(value)) == value;
}

void AddChunk(Totals& totals, const ValueBlock& block, vtkIdType begin, vtkIdType end,
  const ValueRange& acceptable)
{
  double min = totals.Min, max = totals.Max, minPositive = totals.MinPositive;
  std::int64_t count = 0, judged = 0, below = 0, above = 0;
  bool integers = totals.Counts.NonIntegerCount == 0;
  totals.Sum.Reserve(end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    if (!block.Contains(i))
    {
      continue;
    }
    ++count;
    const double value = block.Values[i] + 0.0; // -0 becomes 0
    if (IsNotFinite(value))
    {
      totals.AddNotFinite(block, i, acceptable);
      continue;
    }
    min = value < min ? value : min;
    max = value > max ? value : max;
    minPositive = value > 0 && value < minPositive ? value : minPositive;
    const bool isJudged = block.IsJudged(i);
    judged += isJudged;
    below += isJudged && value < acceptable.Low;
    above += isJudged && value > acceptable.High;
    integers = integers && IsInteger(value);
    totals.Sum.Add(value);
  }
  totals.Min = min;
  totals.Max = max;
  totals.MinPositive = minPositive;
  totals.Counts.Count += count;
  totals.Counts.JudgedCount += judged;
  totals.Counts.BelowCount += below;
  totals.Counts.AboveCount += above;
  totals.Counts.NonIntegerCount = !integers;
}

// The counts of a summary that are sums over parts and ranks.
constexpr std::int64_t Summary::* Counts[] = { &Summary::Count, &Summary::UndefinedCount,
  &Summary::NotApplicableCount, &Summary::InfiniteCount, &Summary::BelowCount, &Summary::AboveCount,
  &Summary::NonIntegerCount, &Summary::JudgedCount, &Summary::JudgedUndefinedCount };

// The element with the smallest id.
struct FirstElement
{
  vtkIdType Id = std::numeric_limits<vtkIdType>::max();
  ElementPlace Place;

  void Add(const FirstElement& other)
  {
    if (other.Id < this->Id)
    {
      *this = other;
    }
  }
};

// The second pass: powers of the deviations from the mean in units of 2^exponent, logarithms if all
// values are positive, and the locations of the extremes.
struct Deviations
{
  enum
  {
    First,
    Square,
    Cube,
    Fourth,
    Logarithm,
    NumberOfSums
  };
  std::array<ExactSum, NumberOfSums> Sums;
  FirstElement ArgMin, ArgMax;
};

void AddDeviations(Deviations& deviations, const ValueBlock& block, int blockNumber,
  vtkIdType begin, vtkIdType end, const Summary& summary, double unit)
{
  const double mean = summary.Mean * unit;
  const bool varies = summary.Min < summary.Max; // otherwise all deviations are 0
  const bool hasLogarithms = varies && summary.Min > 0;
  for (ExactSum& sum : deviations.Sums)
  {
    sum.Reserve(end - begin);
  }
  for (vtkIdType i = begin; i < end; ++i)
  {
    const double value = block.Values[i];
    if (!block.Contains(i) || IsNotFinite(value))
    {
      continue;
    }
    if (varies)
    {
      const double deviation = value * unit - mean;
      const double square = deviation * deviation;
      deviations.Sums[Deviations::First].Add(deviation);
      deviations.Sums[Deviations::Square].Add(square);
      deviations.Sums[Deviations::Cube].Add(square * deviation);
      deviations.Sums[Deviations::Fourth].Add(square * square);
    }
    if (hasLogarithms)
    {
      deviations.Sums[Deviations::Logarithm].Add(std::log(value));
    }
    if (value == summary.Min)
    {
      deviations.ArgMin.Add({ block.GetId(i), { blockNumber, i } });
    }
    if (value == summary.Max)
    {
      deviations.ArgMax.Add({ block.GetId(i), { blockNumber, i } });
    }
  }
}

// From sums in units of 2^exponent.
void SetMoments(const ExactTotals& sums, int exponent, Summary& summary)
{
  const std::int64_t count = summary.GetFiniteCount();
  // The deviations are relative to the rounded mean, which differs from the exact mean by this.
  const double d = sums.Divide(Deviations::First, count);
  const double raw2 = sums.Divide(Deviations::Square, count),
               raw3 = sums.Divide(Deviations::Cube, count),
               raw4 = sums.Divide(Deviations::Fourth, count);
  const double m2 = std::max(raw2 - d * d, 0.0);
  const double m3 = raw3 - 3 * d * raw2 + 2 * d * d * d;
  const double m4 = raw4 - 4 * d * raw3 + 6 * d * d * raw2 - 3 * d * d * d * d;
  summary.RootMeanSquare =
    std::ldexp(std::hypot(std::ldexp(summary.Mean, -exponent), std::sqrt(m2)), exponent);
  if (summary.Min > 0)
  {
    const double mean =
      summary.Min < summary.Max ? std::exp(sums.Divide(Deviations::Logarithm, count)) : summary.Min;
    summary.GeometricMean = std::min(std::max(mean, summary.Min), summary.Max);
  }
  if (count > 1)
  {
    const double correction = d * d * (static_cast<double>(count) / static_cast<double>(count - 1));
    const double variance = std::max(sums.Divide(Deviations::Square, count - 1) - correction, 0.0);
    summary.Variance = std::ldexp(variance, 2 * exponent);
    summary.StandardDeviation = std::ldexp(std::sqrt(variance), exponent);
  }
  if (m2 > 0)
  {
    summary.Skewness = m3 / m2 / std::sqrt(m2);
    summary.Kurtosis = m4 / m2 / m2 - 3;
  }
}

void SumUp(
  const Population& population, const ValueRange& acceptable, Summary& summary, Reducer& reducer)
{
  std::vector<Totals> parts = ForEachChunk<Totals>(population,
    [&](Totals& totals, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    { AddChunk(totals, block, begin, end, acceptable); });
  ExactTotals totals(1);
  double extremes[3] = { Infinity, Infinity, Infinity };
  for (Totals& part : parts)
  {
    for (std::size_t i = 0; i < std::size(Counts); ++i)
    {
      totals.Count(i) += part.Counts.*Counts[i];
    }
    totals.Add(0, part.Sum);
    extremes[0] = std::min(extremes[0], part.Min);
    extremes[1] = std::min(extremes[1], -part.Max);
    extremes[2] = std::min(extremes[2], part.MinPositive);
  }
  totals.Reduce(reducer);
  std::int64_t keys[3] = { ToKey(extremes[0]), ToKey(extremes[1]), ToKey(extremes[2]) };
  reducer.Min(keys, 3);

  for (std::size_t i = 0; i < std::size(Counts); ++i)
  {
    summary.*Counts[i] = totals.Count(i);
  }
  if (summary.GetFiniteCount() > 0)
  {
    summary.Min = FromKey(keys[0]);
    summary.Max = 0.0 - FromKey(keys[1]); // not -0
    const double minPositive = FromKey(keys[2]);
    summary.MinPositive = minPositive < Infinity ? minPositive : summary.MinPositive;
    summary.Sum = totals.Round(0);
    summary.Mean = totals.Divide(0, summary.GetFiniteCount());
  }
}
}

//------------------------------------------------------------------------------
Summary Summarize(
  const Population& population, const ValueRange& acceptable, Reducer& reducer, bool hasMoments)
{
  Summary summary;
  SumUp(population, acceptable, summary, reducer);
  if (!hasMoments)
  {
    return summary;
  }

  // Measure deviations in a power of two near the largest magnitude, so that squares neither
  // overflow nor underflow. The limit keeps the unit of denormal numbers in range.
  int exponent = 0;
  std::frexp(std::max(std::abs(summary.Min), std::abs(summary.Max)), &exponent);
  exponent = std::max(exponent, -1000) + 1;
  const double unit = std::ldexp(1.0, -exponent);

  std::vector<Deviations> parts = ForEachChunk<Deviations>(population,
    [&](Deviations& deviations, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      const int number = static_cast<int>(&block - population.data());
      AddDeviations(deviations, block, number, begin, end, summary, unit);
    });
  ExactTotals totals(Deviations::NumberOfSums);
  FirstElement argMin, argMax;
  for (Deviations& part : parts)
  {
    totals.AddEach(part.Sums);
    argMin.Add(part.ArgMin);
    argMax.Add(part.ArgMax);
  }
  totals.Reduce(reducer);
  std::int64_t ids[2] = { argMin.Id, argMax.Id };
  reducer.Min(ids, 2);

  if (summary.GetFiniteCount() > 0)
  {
    summary.ArgMin = static_cast<vtkIdType>(ids[0]);
    summary.ArgMax = static_cast<vtkIdType>(ids[1]);
    summary.ArgMinPlace = argMin.Id == summary.ArgMin ? argMin.Place : ElementPlace();
    summary.ArgMaxPlace = argMax.Id == summary.ArgMax ? argMax.Place : ElementPlace();
    SetMoments(totals, exponent, summary);
  }
  return summary;
}
}
