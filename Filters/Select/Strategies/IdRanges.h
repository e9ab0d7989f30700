// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file IdRanges.h
 * @brief Parses lists of ids and ranges of ids, such as "3, 10-20, 40" or "-5, -3--1".
 */
#ifndef camaron_IdRanges_h
#define camaron_IdRanges_h

#include <cstdint> // for ids
#include <string>  // for the text
#include <vector>  // for the ranges

namespace camaron
{
/// A range of ids; both ends are included.
struct IdRange
{
  std::int64_t First, Last;
};

/// The ranges in ascending order, without overlaps. Throws std::invalid_argument with the name of
/// the property if the list is not valid.
std::vector<IdRange> ParseIdRanges(const char* property, const std::string& list);

/// Whether an id is in one of the ranges that ParseIdRanges returned.
bool Contains(const std::vector<IdRange>& ranges, std::int64_t id);
}

#endif
