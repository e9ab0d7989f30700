// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistributionDistance.h
 * @brief Distance of the distributions of two populations.
 */
#ifndef camaron_DistributionDistance_h
#define camaron_DistributionDistance_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <limits> // for NaN

namespace camaron
{
/// The Kolmogorov-Smirnov distance.
struct DistributionDistance
{
  /// Maximum difference of the cumulative distribution functions, 0 to 1; NaN if a population has
  /// no value.
  double Distance = std::numeric_limits<double>::quiet_NaN();
  /// The smallest value with this difference.
  double Value = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Collective. Exact: the fractions of values up to x are compared at every value x. NaN is
 * ignored, infinite values count. Cost: a sort and RankKeys.
 */
DistributionDistance FindDistributionDistance(
  const Population& a, const Population& b, Reducer& reducer);
}

#endif
