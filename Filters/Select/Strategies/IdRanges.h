// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IdRanges.h
 * @brief Lists such as "3, 10-20, 40" or "-5, -3--1".
 */
#ifndef camaron_IdRanges_h
#define camaron_IdRanges_h

#include "Statistics/ExactValue.h"

#include <string> // for the text
#include <vector> // for the ranges

namespace camaron
{
/// Integers of 64 bits, both ends included.
struct IdRange
{
  ExactValue First, Last;
};

/// Ascending ranges that do not overlap. Throws std::invalid_argument, which names the property.
std::vector<IdRange> ParseIdRanges(const char* property, const std::string& list);

/// Whether an id is in one of the ranges of ParseIdRanges.
bool Contains(const std::vector<IdRange>& ranges, const ExactValue& id);
}

#endif
