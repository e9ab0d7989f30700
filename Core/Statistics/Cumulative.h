// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cumulative.h
 * @brief How many elements, or how much of their weight, have values up to a limit.
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
  std::vector<double> Values;           ///< ascending, each once
  std::vector<std::int64_t> CountsUpTo; ///< elements whose value is at most that
  std::vector<double> WeightsUpTo;      ///< the same of their weights; empty without weights
};

/**
 * Positions of the sorted finite values (see OrderStatistics) with about as many elements between
 * one and the next: the first, the last and up to @a numberOfPoints - 2 others.
 */
std::vector<std::int64_t> GetPositionsOfCurve(const Summary& summary, int numberOfPoints);

/**
 * The curve at the values of @a sorted at GetPositionsOfCurve, and at those of @a alsoAt, which may
 * be infinite; a value that comes again and again is one point. Counts and weights are exact (see
 * Weights.h) and include -Inf. Collective; cost: a bisection in the points near its value for each
 * element.
 */
CumulativeCurve MakeCumulativeCurve(const Population& values, const Summary& summary,
  const OrderStatistics& sorted, int numberOfPoints, const Weights* weights, Reducer& reducer,
  const std::vector<double>& alsoAt = {});
}

#endif
