// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Summary.h
 * @brief Counts, extremes and moments of a population.
 *
 * Every number is the same bit for bit for any number of threads and processes and any order of the
 * elements: sums are exact before they are rounded once, deviations are taken from the final mean.
 * Central moments mk are means of the k-th powers of the deviations.
 */
#ifndef camaron_Summary_h
#define camaron_Summary_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint> // for counts
#include <limits>  // for NaN

namespace camaron
{
/// A closed range of values; infinite where it has no end.
struct ValueRange
{
  double Low = -std::numeric_limits<double>::infinity();
  double High = std::numeric_limits<double>::infinity();
};

/// Where a process has an element: block of the population and place in the block; -1 on other
/// processes.
struct ElementPlace
{
  int Block = -1;
  vtkIdType Index = -1;
};

struct Summary
{
  std::int64_t Count = 0;              ///< elements
  std::int64_t NullCount = 0;          ///< NaN
  std::int64_t NotApplicableCount = 0; ///< those nulls whose reason is NotApplicable
  std::int64_t InfCount = 0;           ///< +Inf and -Inf
  std::int64_t JudgedCount =
    0; ///< of the applicable ones those of shapes that the acceptable range is for
  std::int64_t BelowCount =
    0; ///< of the judged ones; smaller than the acceptable range, -Inf included
  std::int64_t AboveCount = 0;      ///< larger than the acceptable range, +Inf included
  std::int64_t NonIntegerCount = 0; ///< 0 if every finite value is an integer, else positive

  /// Elements for which the value has a meaning.
  std::int64_t GetApplicableCount() const { return this->Count - this->NotApplicableCount; }
  std::int64_t GetFiniteCount() const { return this->Count - this->NullCount - this->InfCount; }

  ///@{
  /// Of the finite values; NaN if there are none, the deviations also if there is only one.
  double Min = std::numeric_limits<double>::quiet_NaN();
  double Max = std::numeric_limits<double>::quiet_NaN();
  int MinRest = 0, MaxRest = 0; ///< what integers have beyond them, see ExactValue
  double MinPositive = std::numeric_limits<double>::quiet_NaN(); ///< smallest value above 0
  double Mean = std::numeric_limits<double>::quiet_NaN();
  double StandardDeviation = std::numeric_limits<double>::quiet_NaN(); ///< divisor count - 1
  double Variance = std::numeric_limits<double>::quiet_NaN();
  double Skewness =
    std::numeric_limits<double>::quiet_NaN(); ///< m3 / m2^1.5, NaN also of constant values
  double Kurtosis =
    std::numeric_limits<double>::quiet_NaN(); ///< m4 / m2^2 - 3, NaN also of constant values
  double RootMeanSquare = std::numeric_limits<double>::quiet_NaN();
  double GeometricMean =
    std::numeric_limits<double>::quiet_NaN(); ///< NaN also unless all values are above 0
  double Sum = 0;
  ///@}

  ///@{
  /// Smallest identity among the elements with the smallest and largest finite value, else -1.
  vtkIdType ArgMin = -1;
  vtkIdType ArgMax = -1;
  ElementPlace ArgMinPlace, ArgMaxPlace;
  ///@}
};

/// Collective. Two passes over the values.
Summary Summarize(const Population& population, const ValueRange& acceptable, Reducer& reducer);
}

#endif
