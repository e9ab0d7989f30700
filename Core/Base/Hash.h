// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Hash.h
 * @brief Hashes of numbers and of the values of arrays.
 */
#ifndef camaron_Hash_h
#define camaron_Hash_h

#include <cstdint> // for the hash

class vtkDataArray;

namespace camaron
{
inline std::uint64_t MixHash(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ull; // 2^64 / golden ratio (D. Knuth, TAOCP 3, 6.4)
  return hash ^ (hash >> 29);
}

/**
 * Does not depend on the number of threads. Arrays that are computed have no content but their
 * parameters, which change with their time: only their size counts.
 */
std::uint64_t HashContent(vtkDataArray* array, std::uint64_t seed);
}

#endif
