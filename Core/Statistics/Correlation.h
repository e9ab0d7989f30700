// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Correlation.h
 * @brief How two values of the same elements go together.
 *
 * Populations of pairs have the same blocks; an element counts if the first population contains it,
 * and if both its values are as asked for. Results are the same, bit for bit, for any number of
 * threads and processes.
 */
#ifndef camaron_Correlation_h
#define camaron_Correlation_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <vector> // for ranks

namespace camaron
{
/**
 * Collective. Pearson's correlation of the pairs of finite values, -1 to 1; NaN for less than two
 * pairs or constant values. Two passes with exact sums.
 */
double CorrelateLinearly(const Population& x, const Population& y, Reducer& reducer);

/// Values of all blocks, NaN for elements that do not count.
using BlockRanks = std::vector<std::vector<double>>;

/**
 * Collective. Twice the rank of each value among those that are not NaN, from 2; equal values have
 * the mean of their ranks. So the numbers are whole. Cost: see RankKeys.
 */
BlockRanks FindDoubledRanks(const Population& values, Reducer& reducer);
}

#endif
