// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistributionDistance.h
 * @brief How far the distributions of two populations are apart.
 */
#ifndef camaron_DistributionDistance_h
#define camaron_DistributionDistance_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <limits> // for NaN

namespace camaron
{
/// The distance of Kolmogorov and Smirnov.
struct DistributionDistance
{
  /// Largest difference of the distribution functions, 0 to 1; NaN if one of the populations has no
  /// value.
  double Distance = std::numeric_limits<double>::quiet_NaN();
  /// The smallest value where they differ as much.
  double Value = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Collective. Exact: the shares of values up to x are counted at every x that is a value; NaN is
 * left out, infinite values take part. Cost: of a sort, and see RankKeys.
 */
DistributionDistance FindDistributionDistance(
  const Population& a, const Population& b, Reducer& reducer);
}

#endif
