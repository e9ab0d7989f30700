// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Local numbers of points and edges: wrong ones would mix up the points of a cell.
#include "Base/LocalNumbers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <random>
#include <vector>

using namespace camaron;

// As a map gives them, for lists of all lengths one after the other, whatever places the keys hash
// to.
TEST(LocalNumbers, OrderOfFirstOccurrence)
{
  std::mt19937_64 random(1);
  LocalNumbers numbering;
  for (const int size : { 0, 1, 2, 7, 80, 3, 500, 80, 20000, 5 })
  {
    for (const std::uint64_t spread :
      { std::uint64_t(1), std::uint64_t(30), std::uint64_t(1) << 62 })
    {
      std::vector<std::int64_t> keys;
      std::map<std::int64_t, int> expected;
      std::vector<int> firsts;
      for (int i = 0; i < size; ++i)
      {
        keys.push_back(static_cast<std::int64_t>(random() % spread));
        if (expected.emplace(keys[i], static_cast<int>(expected.size())).second)
        {
          firsts.push_back(i);
        }
      }
      std::vector<int> numbers(size);
      const int count = numbering.Number(size, [&](int i) { return keys[i]; }, numbers.data());
      ASSERT_EQ(count, static_cast<int>(expected.size()));
      for (int i = 0; i < size; ++i)
      {
        ASSERT_EQ(numbers[i], expected[keys[i]]) << size << " " << i;
      }
      for (int number = 0; number < count; ++number)
      {
        ASSERT_EQ(numbering.GetFirsts()[number], firsts[number]);
      }
    }
  }
}

// Keys that differ in high bits only, and multiples of large powers of two, as regular ids are.
TEST(LocalNumbers, RegularKeys)
{
  LocalNumbers numbering;
  for (int shift = 0; shift < 56; ++shift)
  {
    std::vector<int> numbers(200);
    const int count = numbering.Number(
      200, [shift](int i) { return std::int64_t(i % 100) << shift; }, numbers.data());
    EXPECT_EQ(count, 100);
    for (int i = 0; i < 200; ++i)
    {
      ASSERT_EQ(numbers[i], i % 100);
    }
  }
}
