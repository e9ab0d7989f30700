// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file KeyRanks.h
 * @brief Where keys come in the sorted order of those of all processes.
 *
 * Every process takes over a range of the keys and counts what others send to it; the ranges hold
 * about as many keys each. No process gets all of them. The result does not depend on the ranges.
 */
#ifndef camaron_KeyRanks_h
#define camaron_KeyRanks_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <array>   // for counts
#include <cstdint> // for 64 bit integers
#include <vector>  // for lists

namespace camaron
{
/// How often a key is there in each of two lists.
struct KeyCounts
{
  std::int64_t Key;
  std::array<std::int64_t, 2> Counts;
};

/// Over all processes.
struct KeyRank
{
  std::array<std::int64_t, 2> Before; ///< smaller keys in each list
  std::array<std::int64_t, 2> Counts; ///< keys that are the same
};

/**
 * Collective. The rank of each of @a own, which are ascending and distinct. Cost: of every key on
 * other processes 24 bytes sent and 32 received, and a sort of what the process takes over.
 */
std::vector<KeyRank> RankKeys(const std::vector<KeyCounts>& own, Reducer& reducer);

/// The sorted keys (OrderedKey.h) of all values that are not NaN, infinite ones included.
std::vector<std::int64_t> SortKeys(const Population& population);
}

#endif
