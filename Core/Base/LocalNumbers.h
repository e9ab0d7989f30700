// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LocalNumbers
 * @brief Numbers the different keys of a short list in the order in which they first occur.
 *
 * For the points and edges of one cell. Whether a key is new is as hard to foresee as the mesh is
 * irregular, so nothing branches on it: every key writes its position into a hash table, the first
 * of the list last, and what it then finds there is the first position of the same key. Where a key
 * has taken the place of another one, those that it concerns go through the same with other hashes.
 * Holds its memory for the next list.
 */
#ifndef camaron_LocalNumbers_h
#define camaron_LocalNumbers_h

#include "Base/Hash.h"

#include <cstdint> // for keys
#include <vector>  // for the table

namespace camaron
{
class LocalNumbers
{
public:
  /// Sets numbers[i] for i in [0, size) from the keys key(i); returns how many differ.
  template <typename Key>
  int Number(int size, Key&& key, int* numbers)
  {
    this->Start(size);
    std::uint64_t* const keys = this->Keys.data();
    int *const table = this->Table.data(), *const places = this->Places.data();
    const int shift = this->Shift;
    for (int i = 0; i < size; ++i)
    {
      keys[i] = static_cast<std::uint64_t>(key(i));
      places[i] = static_cast<int>(keys[i] * HashFactor >> shift);
    }
    for (int i = size - 1; i >= 0; --i)
    {
      table[places[i]] = i;
    }
    int* const firsts = this->Firsts.data();
    std::uint64_t isOpen = 0;
    int count = 0;
    for (int i = 0; i < size; ++i)
    {
      const int first =
        table[places[i]]; // at most i: what is written to firsts below was read before
      isOpen |= keys[first] ^ keys[i];
      numbers[i] = count;
      numbers[i] = numbers[first];
      firsts[count] = i; // overwritten unless the key is new
      count += first == i;
    }
    return isOpen ? this->NumberAgain(size, numbers) : count;
  }

  /// Of every number where in the list it occurs first.
  const int* GetFirsts() const { return this->Firsts.data(); }

private:
  void Start(int size);
  int NumberAgain(int size, int* numbers);
  void FindFirsts(int size);

  std::vector<std::uint64_t> Keys; // grows to the longest list
  std::vector<int> Table, Places, Firsts, Open;
  int Shift = 0; // of a hash to its place in the table
};
}

#endif
