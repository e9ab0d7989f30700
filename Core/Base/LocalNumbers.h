// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::LocalNumbers
 * @brief Numbers the distinct keys of a short list in the order of their first occurrence.
 *
 * Used for the points and edges of one cell. In an irregular mesh, branches on whether a key is
 * new would be mispredicted, so there are none: every key writes its position into a hash table,
 * in reverse order, and then finds the first position of the same key there. Keys that collide
 * with another key are processed again with other hashes. Memory is reused for the next list.
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
  /// Sets numbers[i] for i in [0, size) from the keys key(i); returns the number of distinct keys.
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
        table[places[i]]; // at most i, so writing to firsts below does not affect later reads
      isOpen |= keys[first] ^ keys[i];
      numbers[i] = count;
      numbers[i] = numbers[first];
      firsts[count] = i; // overwritten later unless the key is new
      count += first == i;
    }
    return isOpen ? this->NumberAgain(size, numbers) : count;
  }

  /// For every number, where it first occurs in the list.
  const int* GetFirsts() const { return this->Firsts.data(); }

private:
  void Start(int size);
  int NumberAgain(int size, int* numbers);
  void FindFirsts(int size);

  std::vector<std::uint64_t> Keys; // grows to the size of the longest list
  std::vector<int> Table, Places, Firsts, Open;
  int Shift = 0; // maps a hash to its entry in the table
};
}

#endif
