// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/LocalNumbers.h"

namespace camaron
{
namespace
{
constexpr int PlacesPerKey = 16;
constexpr int SmallestBits = 6; // of the table
}

//------------------------------------------------------------------------------
void LocalNumbers::Start(int size)
{
  int bits = SmallestBits;
  while ((std::size_t(1) << bits) < static_cast<std::size_t>(size) * PlacesPerKey)
  {
    ++bits;
  }
  this->Shift = 64 - bits;
  if (this->Table.size() < std::size_t(1) << bits)
  {
    this->Table.resize(std::size_t(1) << bits);
  }
  if (this->Keys.size() < static_cast<std::size_t>(size))
  {
    this->Keys.resize(2 * static_cast<std::size_t>(size));
    this->Places.resize(this->Keys.size());
    this->Firsts.resize(this->Keys.size());
    this->Open.resize(this->Keys.size());
  }
}

//------------------------------------------------------------------------------
// Renumbers the Keys if some of them collided in the table.
int LocalNumbers::NumberAgain(int size, int* numbers)
{
  this->FindFirsts(size);
  int* const firsts = this->Firsts.data();
  int count = 0;
  for (int i = 0; i < size; ++i)
  {
    const int first = firsts[i];
    numbers[i] = first == i ? count : numbers[first];
    firsts[count] = i; // at most i
    count += first == i;
  }
  return count;
}

//------------------------------------------------------------------------------
// Stores the first position of every key in Firsts.
void LocalNumbers::FindFirsts(int size)
{
  const std::uint64_t* const keys = this->Keys.data();
  int *const table = this->Table.data(), *const firsts = this->Firsts.data(),
             *const open = this->Open.data();
  const int shift = this->Shift;
  std::uint64_t factor = HashFactor;
  for (int i = size - 1; i >= 0; --i)
  {
    table[keys[i] * factor >> shift] = i;
  }
  int numberOfOpen = 0;
  for (int i = 0; i < size; ++i)
  {
    const int first = table[keys[i] * factor >> shift];
    firsts[i] = first;
    open[numberOfOpen] = i;
    numberOfOpen += keys[first] != keys[i];
  }
  while (numberOfOpen > 0)
  {
    factor = factor * HashFactor | 1;
    for (int k = numberOfOpen - 1; k >= 0; --k)
    {
      table[keys[open[k]] * factor >> shift] = open[k];
    }
    int numberLeft = 0;
    for (int k = 0; k < numberOfOpen; ++k)
    {
      const int i = open[k], first = table[keys[i] * factor >> shift];
      firsts[i] = first;
      open[numberLeft] = i;
      numberLeft += keys[first] != keys[i];
    }
    numberOfOpen = numberLeft;
  }
}
}
