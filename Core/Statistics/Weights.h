// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Weights.h
 * @brief Means and fractions in which elements are weighted, for example by volume.
 */
#ifndef camaron_Weights_h
#define camaron_Weights_h

#include "Statistics/OrderedKey.h"
#include "Statistics/Summary.h"

#include <algorithm> // for std::max
#include <cmath>     // for magnitudes

namespace camaron
{
/// The weight of an element: the magnitude of its value; 0 if it is not finite.
inline double GetWeight(const ValueBlock& weights, vtkIdType i)
{
  const double weight = std::abs(weights.Values[i]);
  return std::isfinite(weight) ? weight : 0;
}

/// A unit in which neither sums nor products overflow: a power of two whose product with the
/// magnitude is below 1; limited to normal numbers.
inline double GetUnit(double magnitude)
{
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, -std::max(exponent, -1000));
}

/// Collective. The unit of the largest weight.
inline double FindWeightUnit(const Population& weights, Reducer& reducer)
{
  double largest = 0;
  for (const double part : ForEachChunk<double>(weights,
         [](double& maximum, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           double chunkMaximum = maximum; // local copy, because the maxima of threads are adjacent
                                          // in memory
           for (vtkIdType i = begin; i < end; ++i)
           {
             chunkMaximum =
               block.Contains(i) ? std::max(chunkMaximum, GetWeight(block, i)) : chunkMaximum;
           }
           maximum = chunkMaximum;
         }))
  {
    largest = std::max(largest, part);
  }
  std::int64_t key = ToKey(largest);
  reducer.Max(&key, 1);
  return GetUnit(FromKey(key));
}

/// The weights of elements.
struct Weights
{
  Population Values; ///< with the same blocks as the weighted values
  double Unit = 1;   ///< from FindWeightUnit, for these or more weights
};

struct WeightedSummary
{
  /// Of all elements whose value is not NaN.
  double Weight = 0;
  /// Of the finite values; NaN if their total weight is 0.
  double Mean = std::numeric_limits<double>::quiet_NaN();
  /// Fraction of Weight of the elements outside the acceptable range, 0 to 1; NaN if Weight is 0.
  double BadFraction = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Collective. Products are rounded, sums are exact and rounded once, so the result does not depend
 * on the number of threads and ranks. The magnitude of a weight counts, because volumes of
 * inverted cells are negative; nonfinite weights count as 0.
 * @param summary the summary of @a values
 */
WeightedSummary SummarizeWeighted(const Population& values, const Summary& summary,
  const Weights& weights, const ValueRange& acceptable, Reducer& reducer);
}

#endif
