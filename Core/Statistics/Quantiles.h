// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Quantiles.h
 * @brief Exact quantiles and order statistics of a population.
 */
#ifndef camaron_Quantiles_h
#define camaron_Quantiles_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"
#include "Statistics/Summary.h"

#include <cstdint> // for positions
#include <vector>  // for fractions and values

namespace camaron
{
/**
 * Quantiles of the finite values at @a fractions in [0, 1], any order; NaN if there is no finite
 * value. Between two elements of the sorted values they are interpolated linearly (type 7 of
 * Hyndman and Fan, the default of R and numpy). Collective; the result does not depend on threads
 * or processes.
 */
std::vector<double> GetQuantiles(const Population& population, const Summary& summary,
  const std::vector<double>& fractions, Reducer& reducer);

/// The finite values at @a positions of their sorted list: ascending, without repetition, from 0.
/// Collective. The values at some positions, from 0, of the sorted finite values.
class OrderStatistics
{
public:
  /// Collective; @a positions in any order, none of them where there is no finite value.
  OrderStatistics(const Population& population, const Summary& summary,
    std::vector<std::int64_t> positions, Reducer& reducer);

  /// At one of the positions.
  double Get(std::int64_t position) const;

private:
  std::vector<std::int64_t> Positions; // ascending, each once
  std::vector<double> Values;
};

/// The positions that the quantiles depend on.
std::vector<std::int64_t> GetPositionsOfQuantiles(
  const Summary& summary, const std::vector<double>& fractions);
/// Quantiles from the values at these positions.
std::vector<double> GetQuantiles(
  const OrderStatistics& sorted, const Summary& summary, const std::vector<double>& fractions);
}

#endif
