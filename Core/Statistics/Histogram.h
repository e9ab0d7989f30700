// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Histogram.h
 * @brief Bins, and the number of values of a population in each.
 */
#ifndef camaron_Histogram_h
#define camaron_Histogram_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"
#include "Statistics/Summary.h"

#include <cstdint> // for counts
#include <vector>  // for edges and counts

namespace camaron
{
enum class BinScale
{
  Linear,
  Logarithmic
};

/**
 * @brief Edges of bins, and the bin of a value.
 *
 * Bin i is exactly [edge i, edge i+1); the last bin includes its upper edge. Constant data have
 * one bin [x, x].
 */
class Bins
{
public:
  /// No bins.
  Bins() = default;
  /// Bins of equal width, or of equal ratio of edges (both ends > 0), from @a low to @a high.
  Bins(double low, double high, int numberOfBins, BinScale scale);
  /// One bin [i - 1/2, i + 1/2) for each integer from @a low to @a high.
  static Bins OfIntegers(std::int64_t low, std::int64_t high);

  std::size_t GetSize() const { return this->Edges.empty() ? 0 : this->Edges.size() - 1; }
  const std::vector<double>& GetEdges() const { return this->Edges; }
  /// Moves the edge nearest to @a value there, so that no bin has values of both sides, unless it
  /// is outside the range. Edges in @a kept stay; another one is inserted instead.
  void MoveEdgeTo(double value, const std::vector<double>& kept);

  /// Center of a bin on its scale.
  double GetCenter(std::size_t bin) const;

private:
  friend class BinCounter;
  enum class Guess
  {
    Linear,
    Logarithmic,
    Search
  };
  void PrepareGuess(Guess guess);

  std::vector<double> Edges;
  // Starting point of the search for a bin: (f(value) - Origin) * Scale.
  Guess FirstGuess = Guess::Search;
  double Origin = 0;
  double Scale = 0;
};

/// Settings that do not depend on the data.
struct BinSettings
{
  int NumberOfBins = 50;
  BinScale Scale = BinScale::Linear;
  /// Range of the bins; infinite ends are replaced by those of the data (of the positive data, if
  /// logarithmic).
  ValueRange Range;
  /// The values are integers by definition, such as counts.
  bool OfIntegers = false;
  /// Values at which bins have an edge if they are inside the range; bins of single integers have
  /// their own.
  std::vector<double> Edges;
};

/**
 * Bins for the data of @a summary: one per integer for a moderate number of integers, one for
 * constant data, none without finite (positive, if logarithmic) values.
 */
Bins MakeBins(const Summary& summary, const BinSettings& settings);

/// All counts of a histogram add up to the number of elements.
struct Histogram
{
  std::vector<std::int64_t> Counts;
  std::int64_t Underflow = 0; ///< finite and below the first edge
  std::int64_t Overflow = 0;  ///< finite and above the last edge
  std::int64_t UndefinedCount = 0;
  std::int64_t InfiniteCount = 0;

  std::int64_t GetTotal() const;
};

/// Collective. About 2 ns per value.
Histogram CountBins(const Population& population, const Bins& bins, Reducer& reducer);

/// Collective. For each bin, the number of its elements that the acceptable range applies to.
std::vector<std::int64_t> CountJudged(
  const Population& population, const Bins& bins, Reducer& reducer);
}

#endif
