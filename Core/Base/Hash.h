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
/// 2^64 divided by the golden ratio, odd: the upper bits of a product with it are a fast hash
/// (D. Knuth, The Art of Computer Programming 3, 6.4).
constexpr std::uint64_t HashFactor = 0x9e3779b97f4a7c15ull;

/// A fast hash of a sequence of values, one at a time.
inline std::uint64_t MixHash(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * HashFactor;
  return hash ^ (hash >> 29);
}

/// A good hash of one value: the finalizer of splitmix64 (G. Steele et al., Fast splittable
/// pseudorandom number generators, 2014).
inline std::uint64_t Mix(std::uint64_t value)
{
  value += HashFactor;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
  return value ^ (value >> 31);
}

/// A hash of a set of values, in any order.
struct SetHash
{
  std::uint64_t Low = 0, High = 0;

  /// @a hash is a good hash of a value.
  void Add(std::uint64_t hash)
  {
    this->Low += hash;
    this->High += Mix(hash);
  }
  bool operator==(const SetHash& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

/**
 * Hash of the values of an array. Does not depend on the number of threads. Implicit arrays are
 * hashed by their size only, because changing their parameters changes their modification time.
 */
std::uint64_t HashContent(vtkDataArray* array, std::uint64_t seed);
}

#endif
