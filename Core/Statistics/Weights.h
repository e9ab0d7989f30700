// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Weights.h
 * @brief Means and fractions in which elements are weighted, for example by volume.
 */
#ifndef camaron_Weights_h
#define camaron_Weights_h

#include "Statistics/Summary.h"

namespace camaron
{
/// The weights of elements.
struct Weights
{
  Population Values; ///< with the same blocks as the weighted values
  double Unit = 1;   ///< from FindWeightUnit (WeightUnit.h), for these or more weights
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
