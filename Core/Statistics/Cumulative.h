// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cumulative.h
 * @brief Cumulative distribution: the number or total weight of elements with values up to a limit.
 */
#ifndef camaron_Cumulative_h
#define camaron_Cumulative_h

#include "Statistics/Quantiles.h"
#include "Statistics/Weights.h"

#include <cstdint> // for counts
#include <vector>  // for the curve

namespace camaron
{
/// Points of a cumulative distribution function.
struct CumulativeCurve
{
  std::vector<double> Values;           ///< ascending and distinct
  std::vector<std::int64_t> CountsUpTo; ///< number of elements with at most this value
  std::vector<double> WeightsUpTo;      ///< total weight of these elements; empty without weights
};

/**
 * Positions among the sorted finite values (see OrderStatistics), spaced evenly: the first, the
 * last and up to @a numberOfPoints - 2 others.
 */
std::vector<std::int64_t> GetPositionsOfCurve(const Summary& summary, int numberOfPoints);

/**
 * Collective. The curve at the values of @a sorted at GetPositionsOfCurve, and at the values
 * @a alsoAt, which may be infinite; repeated values are one point. Counts and weights are exact
 * (see Weights.h) and include -Inf. Cost: a bisection per element.
 */
CumulativeCurve MakeCumulativeCurve(const Population& values, const Summary& summary,
  const OrderStatistics& sorted, int numberOfPoints, const Weights* weights, Reducer& reducer,
  const std::vector<double>& alsoAt = {});
}

#endif
