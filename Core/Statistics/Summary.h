// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Summary.h
 * @brief Counts, extremes and moments of a population.
 *
 * Every number is bitwise identical for any number of threads and ranks and any order of the
 * elements: sums are exact and rounded once, deviations are relative to the final mean. Central
 * moments mk are means of the k-th powers of the deviations.
 */
#ifndef camaron_Summary_h
#define camaron_Summary_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint> // for counts
#include <limits>  // for NaN

namespace camaron
{
/// A closed range of values; infinite ends mean no limit.
struct ValueRange
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
};

/// Location of an element on its rank: block of the population and index in the block; -1 on other
/// ranks.
struct ElementPlace
{
  int Block = -1;
  vtkIdType Index = -1;
};

struct Summary
{
  static constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

  std::int64_t Count = 0;              ///< elements
  std::int64_t UndefinedCount = 0;     ///< NaN
  std::int64_t NotApplicableCount = 0; ///< NaN because of NotApplicable
  std::int64_t InfiniteCount = 0;      ///< +Inf and -Inf
  std::int64_t JudgedCount = 0;        ///< applicable elements that the acceptable range applies to
  std::int64_t JudgedUndefinedCount = 0; ///< of these, undefined values
  std::int64_t BelowCount = 0;      ///< judged elements below the acceptable range, including -Inf
  std::int64_t AboveCount = 0;      ///< judged elements above the acceptable range, including +Inf
  std::int64_t NonIntegerCount = 0; ///< 0 if all finite values are integers, else positive

  /// Number of elements for which the value is defined.
  std::int64_t GetApplicableCount() const { return this->Count - this->NotApplicableCount; }
  std::int64_t GetFiniteCount() const
  {
    return this->Count - this->UndefinedCount - this->InfiniteCount;
  }

  ///@{
  /// Of the finite values; NaN if there are none, the deviations also if there is only one.
  double Min = NaN;
  double Max = NaN;
  double MinPositive = NaN; ///< smallest positive value
  double Mean = NaN;
  double StandardDeviation = NaN; ///< divisor count - 1
  double Variance = NaN;
  double Skewness = NaN; ///< m3 / m2^1.5; NaN for constant values
  double Kurtosis = NaN; ///< m4 / m2^2 - 3; NaN for constant values
  double RootMeanSquare = NaN;
  double GeometricMean = NaN; ///< NaN unless all values are positive
  double Sum = 0;
  ///@}

  ///@{
  /// Smallest id among the elements with the smallest and the largest finite value, or -1.
  vtkIdType ArgMin = -1;
  vtkIdType ArgMax = -1;
  ElementPlace ArgMinPlace, ArgMaxPlace;
  ///@}
};

/// Collective. Two passes over the values; without moments one, which leaves the deviations, the
/// other means and the smallest ids unknown.
Summary Summarize(const Population& population, const ValueRange& acceptable, Reducer& reducer,
  bool hasMoments = true);
}

#endif
