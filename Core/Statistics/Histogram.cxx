// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Histogram.h"

#include "Base/Number.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace camaron
{
namespace
{
// For more integers than this, bins contain several.
constexpr double MaximumOfIntegerBins = 1024;

// log2 with an error below 0.01: exponent, and a parabola through the mantissas 1 and 2.
double ApproximateLog2(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  const double exponent = static_cast<double>(static_cast<int>((bits >> 52) & 0x7ff) - 1023);
  bits = (bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull;
  double mantissa;
  std::memcpy(&mantissa, &bits, sizeof(mantissa));
  return exponent + (2.0 - mantissa / 3.0) * mantissa - 5.0 / 3.0;
}
}

//------------------------------------------------------------------------------
Bins::Bins(double low, double high, int numberOfBins, BinScale scale)
{
  if (low == high || numberOfBins < 1)
  {
    this->Edges = { low, high };
    this->PrepareGuess(Guess::Search);
    return;
  }
  const bool logarithmic = scale == BinScale::Logarithmic;
  const double first = logarithmic ? std::log10(low) : low;
  const double last = logarithmic ? std::log10(high) : high;
  const double step = (last - first) / numberOfBins;
  this->Edges.push_back(low);
  for (int i = 1; i < numberOfBins; ++i)
  {
    // The difference of two huge numbers may be out of range.
    const double weight = static_cast<double>(i) / numberOfBins;
    const double place = std::isinf(step) ? first * (1 - weight) + last * weight : first + i * step;
    const double edge = logarithmic ? std::pow(10.0, place) : place;
    // Adjacent doubles limit the number of bins; there are no empty ones.
    if (edge > this->Edges.back() && edge < high)
    {
      this->Edges.push_back(edge);
    }
  }
  this->Edges.push_back(high);
  this->PrepareGuess(logarithmic ? Guess::Logarithmic : Guess::Linear);
}

//------------------------------------------------------------------------------
Bins Bins::OfIntegers(std::int64_t low, std::int64_t high)
{
  Bins bins;
  for (std::int64_t i = low; i <= high + 1; ++i)
  {
    bins.Edges.push_back(static_cast<double>(i) - 0.5);
  }
  bins.PrepareGuess(Guess::Linear);
  return bins;
}

//------------------------------------------------------------------------------
void Bins::PrepareGuess(Guess guess)
{
  const bool logarithmic = guess == Guess::Logarithmic;
  const double low = logarithmic ? ApproximateLog2(this->Edges.front()) : this->Edges.front();
  const double high = logarithmic ? ApproximateLog2(this->Edges.back()) : this->Edges.back();
  this->Origin = low;
  this->Scale = static_cast<double>(this->GetSize()) / (high - low);
  // Extreme ranges and constant data have no usable scale.
  this->FirstGuess = std::isnormal(this->Scale) ? guess : Guess::Search;
}

//------------------------------------------------------------------------------
void Bins::MoveEdgeTo(double value, const std::vector<double>& kept)
{
  if (!(this->Edges.size() > 1 && this->Edges.front() < value && value < this->Edges.back()))
  {
    return;
  }
  const auto above = std::upper_bound(this->Edges.begin(), this->Edges.end(), value);
  const bool isLowerNearer = value - *(above - 1) < *above - value;
  const auto nearest = isLowerNearer ? above - 1 : above;
  const bool isFree = nearest != this->Edges.begin() && nearest != this->Edges.end() - 1 &&
    std::find(kept.begin(), kept.end(), *nearest) == kept.end();
  if (isFree)
  {
    *nearest = value;
  }
  else if (*(above - 1) != value)
  {
    this->Edges.insert(above, value);
  }
}

//------------------------------------------------------------------------------
double Bins::GetCenter(std::size_t bin) const
{
  const double low = this->Edges[bin], high = this->Edges[bin + 1];
  return this->FirstGuess == Guess::Logarithmic ? std::sqrt(low) * std::sqrt(high)
                                                : low / 2 + high / 2;
}

//------------------------------------------------------------------------------
Bins MakeBins(const Summary& summary, const BinSettings& settings)
{
  if (summary.GetFiniteCount() == 0)
  {
    return Bins();
  }
  const bool logarithmic = settings.Scale == BinScale::Logarithmic;
  double low = std::isfinite(settings.Range.Low) ? settings.Range.Low : summary.Min;
  double high = std::isfinite(settings.Range.High) ? settings.Range.High : summary.Max;
  if (logarithmic && !(low > 0))
  {
    low = summary.MinPositive;
  }
  // If one end is given and one is from the data, they may be reversed; then no value is between.
  high = std::max(low, high);
  if (logarithmic && !(low > 0 && high > 0))
  {
    return Bins();
  }
  const double first = std::ceil(low), last = std::floor(high);
  if (settings.OfIntegers && !logarithmic && summary.NonIntegerCount == 0 && low < high &&
    first <= last && last - first < MaximumOfIntegerBins && std::abs(first) < 1e15)
  {
    return Bins::OfIntegers(static_cast<std::int64_t>(first), static_cast<std::int64_t>(last));
  }
  Bins bins(low, high, settings.NumberOfBins, settings.Scale);
  for (const double edge : settings.Edges)
  {
    bins.MoveEdgeTo(edge, settings.Edges);
  }
  return bins;
}

//------------------------------------------------------------------------------
std::int64_t Histogram::GetTotal() const
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(),
    this->Underflow + this->Overflow + this->UndefinedCount + this->InfiniteCount);
}

//------------------------------------------------------------------------------
// Counts of one thread.
class BinCounter
{
public:
  // Neighboring values often share a bin; counting them alternately in several lanes avoids waiting
  // for the last increment to be stored.
  static constexpr vtkIdType NumberOfLanes = 4;
  std::vector<std::int64_t> Lanes;
  Histogram Outside;

  void Add(const ValueBlock& block, vtkIdType begin, vtkIdType end, const Bins& bins)
  {
    const double origin = bins.Origin, scale = bins.Scale;
    const double last = static_cast<double>(bins.GetSize()) - 1;
    // In this form a single instruction each, and correct for NaN, which gets no bin.
    const auto clamp = [last](double guess)
    {
      guess = guess < last ? guess : last;
      return guess > 0 ? guess : 0;
    };
    switch (bins.FirstGuess)
    {
      case Bins::Guess::Linear:
        this->Add(
          block, begin, end, bins, [=](double value) { return clamp((value - origin) * scale); });
        break;
      case Bins::Guess::Logarithmic:
        this->Add(block, begin, end, bins,
          [=](double value) { return clamp((ApproximateLog2(value) - origin) * scale); });
        break;
      case Bins::Guess::Search:
        this->Add(block, begin, end, bins, [](double) { return 0.0; });
        break;
    }
  }

private:
  struct Limits
  {
    double Low, High;
  };
  std::vector<Limits> LimitsOfBins;

  template <typename GuessBin>
  void Add(
    const ValueBlock& block, vtkIdType begin, vtkIdType end, const Bins& bins, GuessBin&& guessBin)
  {
    this->Lanes.resize(bins.GetSize() * NumberOfLanes);
    this->LimitsOfBins.assign(1, { Infinity, -Infinity }); // if there are no bins
    for (std::size_t bin = 0; bin < bins.GetSize(); ++bin)
    {
      this->LimitsOfBins.resize(bin + 1);
      this->LimitsOfBins[bin] = { bins.Edges[bin], bins.Edges[bin + 1] };
    }

    // First guess for a batch, which the compiler vectorizes, then check.
    constexpr vtkIdType batchSize = 256;
    std::int32_t guesses[batchSize];
    for (vtkIdType first = begin; first < end; first += batchSize)
    {
      const vtkIdType size = std::min(batchSize, end - first);
      const double* values = block.Values + first;
      const unsigned char* skip = block.Skip ? block.Skip + first : nullptr;
      for (vtkIdType i = 0; i < size; ++i)
      {
        guesses[i] = static_cast<std::int32_t>(guessBin(values[i]));
      }
      const Limits* limits = this->LimitsOfBins.data();
      std::int64_t* lanes = this->Lanes.data();
      for (vtkIdType i = 0; i < size; ++i)
      {
        const double value = values[i];
        const Limits& guess = limits[guesses[i]];
        if (skip && skip[i])
        {
          continue;
        }
        if (value >= guess.Low && value < guess.High)
        {
          ++lanes[guesses[i] * NumberOfLanes + i % NumberOfLanes];
        }
        else
        {
          this->Search(value, bins.Edges);
        }
      }
    }
  }

  void Search(double value, const std::vector<double>& edges)
  {
    if (!std::isfinite(value))
    {
      ++(std::isnan(value) ? this->Outside.UndefinedCount : this->Outside.InfiniteCount);
    }
    else if (edges.empty() || value < edges.front())
    {
      ++this->Outside.Underflow;
    }
    else if (value > edges.back())
    {
      ++this->Outside.Overflow;
    }
    else
    {
      // The last bin includes its upper edge.
      const auto next = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
      ++this->Lanes[(next - edges.begin() - 1) * NumberOfLanes];
    }
  }
};

//------------------------------------------------------------------------------
Histogram CountBins(const Population& population, const Bins& bins, Reducer& reducer)
{
  const std::vector<BinCounter> parts = ForEachChunk<BinCounter>(population,
    [&](BinCounter& counter, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    { counter.Add(block, begin, end, bins); });
  const std::size_t size = bins.GetSize();
  constexpr std::int64_t Histogram::* outside[] = { &Histogram::Underflow, &Histogram::Overflow,
    &Histogram::UndefinedCount, &Histogram::InfiniteCount };
  std::vector<std::int64_t> sums(size + std::size(outside));
  for (const BinCounter& part : parts)
  {
    for (std::size_t i = 0; i < part.Lanes.size(); ++i)
    {
      sums[i / BinCounter::NumberOfLanes] += part.Lanes[i];
    }
    for (std::size_t i = 0; i < std::size(outside); ++i)
    {
      sums[size + i] += part.Outside.*outside[i];
    }
  }
  reducer.Sum(sums.data(), sums.size());

  Histogram histogram;
  histogram.Counts.assign(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(size));
  for (std::size_t i = 0; i < std::size(outside); ++i)
  {
    histogram.*outside[i] = sums[size + i];
  }
  return histogram;
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> CountJudged(
  const Population& population, const Bins& bins, Reducer& reducer)
{
  std::vector<std::vector<unsigned char>> masks;
  Population judged = population;
  for (ValueBlock& block : judged)
  {
    if (block.Shapes)
    {
      std::vector<unsigned char>& mask = masks.emplace_back(block.Size);
      ParallelFor(block.Size, LightGrain,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType i = begin; i < end; ++i)
          {
            mask[i] = !block.Contains(i) || !block.IsJudged(i);
          }
        });
      block.Skip = mask.data();
    }
  }
  return CountBins(judged, bins, reducer).Counts;
}
}
