// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Summary.h"

#include "Criteria/Criterion.h"
#include "Statistics/ExactSum.h"
#include "Statistics/OrderedKey.h"

#include <array>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

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
    if (std::isnan(value))
    {
      ++this->Counts.NullCount;
      this->Counts.NotApplicableCount += block.GetNullReason(i) == NullReason::NotApplicable;
    }
    else
    {
      ++this->Counts.InfCount;
      this->Counts.BelowCount += value < acceptable.Low;
      this->Counts.AboveCount += value > acceptable.High;
    }
  }
};

// Integers of doubles above this are not of interest: bins of width 1 would be too many.
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
  std::int64_t count = 0, below = 0, above = 0;
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
    below += value < acceptable.Low;
    above += value > acceptable.High;
    integers = integers && IsInteger(value);
    totals.Sum.Add(value);
  }
  totals.Min = min;
  totals.Max = max;
  totals.MinPositive = minPositive;
  totals.Counts.Count += count;
  totals.Counts.BelowCount += below;
  totals.Counts.AboveCount += above;
  totals.Counts.NonIntegerCount = !integers;
}

// Sums counts and limbs of parts and processes at once.
constexpr std::size_t NumberOfCounts = 7;
using CountsAndLimbs =
  std::array<std::int64_t, NumberOfCounts + std::tuple_size<ExactSum::Limbs>::value>;

void AddLimbs(CountsAndLimbs& sums, ExactSum& sum)
{
  const ExactSum::Limbs limbs = sum.GetLimbs();
  for (std::size_t i = 0; i < limbs.size(); ++i)
  {
    sums[NumberOfCounts + i] += limbs[i];
  }
}

ExactSum::Limbs GetLimbs(const CountsAndLimbs& sums)
{
  ExactSum::Limbs limbs;
  std::copy(sums.begin() + NumberOfCounts, sums.end(), limbs.begin());
  return limbs;
}

// The second pass: deviations from the mean in units of 2^exponent, and the places of the extremes.
struct Deviations
{
  ExactSum SquareSum;
  vtkIdType ArgMin = std::numeric_limits<vtkIdType>::max();
  vtkIdType ArgMax = std::numeric_limits<vtkIdType>::max();
};

void AddDeviations(Deviations& deviations, const ValueBlock& block, vtkIdType begin, vtkIdType end,
  const Summary& summary, double unit)
{
  const double mean = summary.Mean * unit;
  deviations.SquareSum.Reserve(end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    const double value = block.Values[i];
    if (!block.Contains(i) || IsNotFinite(value))
    {
      continue;
    }
    const double deviation = value * unit - mean;
    deviations.SquareSum.Add(deviation * deviation);
    if (value == summary.Min)
    {
      deviations.ArgMin = std::min(deviations.ArgMin, block.GetId(i));
    }
    if (value == summary.Max)
    {
      deviations.ArgMax = std::min(deviations.ArgMax, block.GetId(i));
    }
  }
}

void SumUp(
  const Population& population, const ValueRange& acceptable, Summary& summary, Reducer& reducer)
{
  std::vector<Totals> parts = ForEachChunk<Totals>(population,
    [&](Totals& totals, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    { AddChunk(totals, block, begin, end, acceptable); });
  CountsAndLimbs sums = {};
  double extremes[3] = { Infinity, Infinity, Infinity };
  for (Totals& part : parts)
  {
    const Summary& counts = part.Counts;
    const std::array<std::int64_t, NumberOfCounts> list = { { counts.Count, counts.NullCount,
      counts.NotApplicableCount, counts.InfCount, counts.BelowCount, counts.AboveCount,
      counts.NonIntegerCount } };
    for (std::size_t i = 0; i < NumberOfCounts; ++i)
    {
      sums[i] += list[i];
    }
    AddLimbs(sums, part.Sum);
    extremes[0] = std::min(extremes[0], part.Min);
    extremes[1] = std::min(extremes[1], -part.Max);
    extremes[2] = std::min(extremes[2], part.MinPositive);
  }
  reducer.Sum(sums.data(), sums.size());
  std::int64_t keys[3] = { ToKey(extremes[0]), ToKey(extremes[1]), ToKey(extremes[2]) };
  reducer.Min(keys, 3);

  summary.Count = sums[0];
  summary.NullCount = sums[1];
  summary.NotApplicableCount = sums[2];
  summary.InfCount = sums[3];
  summary.BelowCount = sums[4];
  summary.AboveCount = sums[5];
  summary.NonIntegerCount = sums[6];
  if (summary.GetFiniteCount() > 0)
  {
    summary.Min = FromKey(keys[0]);
    summary.Max = 0.0 - FromKey(keys[1]); // not -0
    const double minPositive = FromKey(keys[2]);
    summary.MinPositive = minPositive < Infinity ? minPositive : summary.MinPositive;
    summary.Sum = ExactSum::Round(GetLimbs(sums));
    summary.Mean = ExactSum::Divide(GetLimbs(sums), summary.GetFiniteCount());
  }
}
}

//------------------------------------------------------------------------------
Summary Summarize(const Population& population, const ValueRange& acceptable, Reducer& reducer)
{
  Summary summary;
  SumUp(population, acceptable, summary, reducer);

  // Measure deviations in a power of two near the largest magnitude, so that no square overflows or
  // vanishes. The limit keeps the unit of denormal numbers in range.
  int exponent = 0;
  std::frexp(std::max(std::abs(summary.Min), std::abs(summary.Max)), &exponent);
  exponent = std::max(exponent, -1000) + 1;
  const double unit = std::ldexp(1.0, -exponent);

  std::vector<Deviations> parts = ForEachChunk<Deviations>(population,
    [&](Deviations& deviations, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    { AddDeviations(deviations, block, begin, end, summary, unit); });
  CountsAndLimbs sums = {};
  std::int64_t ids[2] = { std::numeric_limits<vtkIdType>::max(),
    std::numeric_limits<vtkIdType>::max() };
  for (Deviations& part : parts)
  {
    AddLimbs(sums, part.SquareSum);
    ids[0] = std::min<std::int64_t>(ids[0], part.ArgMin);
    ids[1] = std::min<std::int64_t>(ids[1], part.ArgMax);
  }
  reducer.Sum(sums.data(), sums.size());
  reducer.Min(ids, 2);

  if (summary.GetFiniteCount() > 0)
  {
    summary.ArgMin = static_cast<vtkIdType>(ids[0]);
    summary.ArgMax = static_cast<vtkIdType>(ids[1]);
  }
  if (summary.GetFiniteCount() > 1)
  {
    const double variance = ExactSum::Divide(GetLimbs(sums), summary.GetFiniteCount() - 1);
    summary.Variance = std::ldexp(variance, 2 * exponent);
    summary.StandardDeviation = std::ldexp(std::sqrt(variance), exponent);
  }
  return summary;
}
}
