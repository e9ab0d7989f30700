// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HashMix.h
 * @brief One step of a hash that is good enough where nobody chooses the values.
 */
#ifndef camaron_HashMix_h
#define camaron_HashMix_h

#include <cstdint> // for hashes

namespace camaron
{
inline std::uint64_t MixHash(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio (D. Knuth, TAOCP 3, 6.4)
  return hash ^ (hash >> 29);
}
}

#endif
