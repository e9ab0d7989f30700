// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Cumulative.h
 * @brief How many elements, or how much of their weight, have values up to a limit.
 */
#ifndef camaron_Cumulative_h
#define camaron_Cumulative_h

#include "Statistics/Summary.h"

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
 * The curve at values of elements, of which there are about as many between one and the next: the first, the last and up
 * to @a numberOfPoints - 2 others of the sorted finite values; a value that comes again and again is one point. Counts
 * and weights are exact (see Weights.h) and include -Inf. Collective; cost: of as many quantiles, and a bisection in
 * the points for each element.
 * @param weights the same blocks as @a values, or nullptr
 * @param alsoAt further values of points, of elements or not, infinite ones included
 */
CumulativeCurve MakeCumulativeCurve(const Population& values, const Summary& summary, int numberOfPoints,
  const Population* weights, Reducer& reducer, const std::vector<double>& alsoAt = {});
}

#endif
