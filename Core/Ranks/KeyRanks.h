// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeyRanks.h
 * @brief Positions of keys in the sorted order of the keys of all ranks.
 *
 * Every rank counts the keys of one range, which the other ranks send to it; the ranges contain
 * about the same number of keys, and no rank receives all. The result does not depend on the
 * ranges.
 */
#ifndef camaron_KeyRanks_h
#define camaron_KeyRanks_h

#include "Ranks/Reducer.h"

#include <array>   // for counts
#include <cstdint> // for 64 bit integers
#include <vector>  // for lists

namespace camaron
{
/// Number of occurrences of a key in each of two lists.
struct KeyCounts
{
  std::int64_t Key;
  std::array<std::int64_t, 2> Counts;
  std::int64_t GetKey() const { return this->Key; }
};

/// Position of a key over all ranks.
struct KeyRank
{
  std::array<std::int64_t, 2> Before; ///< number of smaller keys in each list
  std::array<std::int64_t, 2> Counts; ///< number of equal keys in each list
};

/**
 * Collective. The positions of @a own, which must be ascending and distinct. Cost: for every key
 * on other ranks 24 bytes sent and 32 received, and a sort of the received keys.
 */
std::vector<KeyRank> RankKeys(const std::vector<KeyCounts>& own, Reducer& reducer);
}

#endif
