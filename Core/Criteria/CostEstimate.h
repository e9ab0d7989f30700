// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CostEstimate.h
 * @brief How long criteria will take, to warn people before they start.
 */
#ifndef camaron_CostEstimate_h
#define camaron_CostEstimate_h

#include "Criteria/Criterion.h"

#include <vector> // for the criteria

namespace camaron
{
/**
 * About how many seconds the evaluation will take: right to a factor of two or three on machines of
 * today.
 * @param corners length of the lists of points of all cells
 * @param threads that work at the same time
 */
double EstimateSeconds(
  const std::vector<const Criterion*>& criteria, double corners, int threads);
}

#endif
