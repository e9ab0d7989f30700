// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Correlation.h
 * @brief Correlation of two values of the same elements.
 *
 * The two populations must have the same blocks. An element counts if it belongs to the first
 * population and both its values are valid. Results are bitwise identical for any number of
 * threads and ranks.
 */
#ifndef camaron_Correlation_h
#define camaron_Correlation_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <vector> // for ranks

namespace camaron
{
/**
 * Collective. Pearson's correlation of the pairs of finite values, from -1 to 1; NaN for fewer
 * than two pairs or constant values. Two passes with exact sums.
 */
double CorrelateLinearly(const Population& x, const Population& y, Reducer& reducer);

/// Values of all blocks; NaN for elements that do not count.
using BlockRanks = std::vector<std::vector<double>>;

/**
 * Collective. Twice the rank of each value that is not NaN, from 2; equal values have the mean of
 * their ranks, so doubled ranks are integers. For the cost see RankKeys.
 */
BlockRanks FindDoubledRanks(const Population& values, Reducer& reducer);
}

#endif
