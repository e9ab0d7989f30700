// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ValueChanges.h
 * @brief How two populations differ: elements that have become better or worse, and the distance of
 * the distributions.
 */
#ifndef camaron_ValueChanges_h
#define camaron_ValueChanges_h

#include "Criteria/Criterion.h"
#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint> // for counts
#include <limits>  // for NaN

namespace camaron
{
struct ValueChanges
{
  std::int64_t Compared = 0; ///< elements with a value in at least one of the populations
  std::int64_t Improved = 0;
  std::int64_t Worsened = 0;
  std::int64_t Unchanged = 0; ///< others of Compared changed without a good or bad direction
};

/**
 * Collective. Compares @a before with @a after, which must have the same blocks; @a after defines
 * which elements count. Values are unchanged if they differ by at most @a tolerance times the
 * larger magnitude. Any value is better than none.
 */
ValueChanges CountChanges(const Population& before, const Population& after, Better better,
  double tolerance, Reducer& reducer);

/// after - before for elements [begin, end); NaN if either is NaN, 0 if both are the same infinity.
void FindDifferences(const ValueBlock& before, const ValueBlock& after, vtkIdType begin,
  vtkIdType end, double* differences);

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
