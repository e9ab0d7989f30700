// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Weights.h
 * @brief Means and shares in which elements count by a weight, such as their volume.
 */
#ifndef camaron_Weights_h
#define camaron_Weights_h

#include "Statistics/Summary.h"

namespace camaron
{
/// What elements count for.
struct Weights
{
  Population Values; ///< the same blocks as what is weighed
  double Unit = 1;   ///< of FindWeightUnit (WeightUnit.h), for these or more of them
};

struct WeightedSummary
{
  /// Of all elements whose value is not null.
  double Weight = 0;
  /// Of the finite values; NaN without any that weighs something.
  double Mean = std::numeric_limits<double>::quiet_NaN();
  /// Share of Weight of the elements with a value outside of the acceptable range, 0 to 1; NaN if
  /// nothing weighs.
  double BadFraction = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Sums are exact and rounded once, each product is rounded before: the result does not depend on
 * the number of threads and processes. A weight counts with its magnitude, as volumes of inverted
 * cells are negative; weights that are not finite count as 0.
 * @param summary of @a values
 */
WeightedSummary SummarizeWeighted(const Population& values, const Summary& summary,
  const Weights& weights, const ValueRange& acceptable, Reducer& reducer);
}

#endif
