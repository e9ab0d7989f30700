// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Quantiles.h
 * @brief Exact quantiles, order statistics and cumulative curves of a population.
 */
#ifndef camaron_Quantiles_h
#define camaron_Quantiles_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"
#include "Statistics/Summary.h"
#include "Statistics/Weights.h"

#include <cstdint> // for positions
#include <vector>  // for fractions and values

namespace camaron
{
/**
 * Collective. Quantiles of the finite values at @a fractions in [0, 1], in any order; NaN without
 * finite values. Interpolates linearly between adjacent sorted values (type 7 of Hyndman and Fan,
 * the default of R and numpy). The result does not depend on threads or ranks.
 */
std::vector<double> GetQuantiles(const Population& population, const Summary& summary,
  const std::vector<double>& fractions, Reducer& reducer);

/// Selected values of the sorted list of finite values, at positions counted from 0.
class OrderStatistics
{
public:
  /// Collective. @a positions may be in any order, and must be empty without finite values.
  OrderStatistics(const Population& population, const Summary& summary,
    std::vector<std::int64_t> positions, Reducer& reducer);

  /// The value at one of the positions.
  double Get(std::int64_t position) const;

private:
  std::vector<std::int64_t> Positions; // ascending and distinct
  std::vector<double> Values;
};

/// The positions that these quantiles depend on.
std::vector<std::int64_t> GetPositionsOfQuantiles(
  const Summary& summary, const std::vector<double>& fractions);
/// Quantiles from the values at those positions.
std::vector<double> GetQuantiles(
  const OrderStatistics& sorted, const Summary& summary, const std::vector<double>& fractions);

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
