// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/ExactSum.h"
#include "Statistics/OrderedKey.h"
#include "StatisticsTesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace camaron;
using namespace camaron::testing;

//------------------------------------------------------------------------------
// Wrong carries or rounding would show up in sums that cancel; the expected values are exact by
// construction.
TEST(ExactSum, IsExact)
{
  const auto sum = [](const std::vector<double>& values)
  {
    ExactSum exact;
    exact.Reserve(static_cast<std::int64_t>(values.size()));
    for (const double value : values)
    {
      exact.Add(value);
    }
    return ExactSum::Round(exact.GetLimbs());
  };
  EXPECT_EQ(sum({}), 0.0);
  EXPECT_EQ(sum({ 1e308, 1.0, -1e308 }), 1.0);
  EXPECT_EQ(sum({ 1.0, 1e100, 1.0, -1e100 }), 2.0);
  EXPECT_EQ(sum({ 1e308, 1e308 }), Infinity);
  EXPECT_EQ(sum({ -1e308, -1e308 }), -Infinity);
  EXPECT_EQ(sum({ 5e-324, 5e-324 }), 1e-323);
  EXPECT_EQ(sum({ -5e-324, 2.2250738585072014e-308 }), 2.2250738585072009e-308);
  // Ties to even: 2^53 + 1 is not a double; a bit far below decides.
  EXPECT_EQ(sum({ 9007199254740992.0, 1.0 }), 9007199254740992.0);
  EXPECT_EQ(sum({ 9007199254740994.0, 1.0 }), 9007199254740996.0);
  EXPECT_EQ(sum({ 9007199254740992.0, 1.0, 1e-300 }), 9007199254740994.0);
  EXPECT_EQ(sum({ -9007199254740992.0, -1.0, -1e-300 }), -9007199254740994.0);
  EXPECT_EQ(sum({ 0.1, 0.2, -0.3 }), 2.7755575615628914e-17); // python: fsum

  std::vector<double> list;
  std::mt19937_64 random(7);
  while (list.size() < 20000)
  {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      list.push_back(value);
      list.push_back(-value);
    }
  }
  std::shuffle(list.begin(), list.end(), random);
  EXPECT_EQ(sum(list), 0.0);
}

//------------------------------------------------------------------------------
// A mean of equal values must be that value, else constant data would deviate from their mean.
TEST(ExactSum, DividesWithOneRounding)
{
  for (const double value : { 0.1, 1.0 / 3, 5e-324, 1.7e308, -2.2250738585072014e-308 })
  {
    for (const int count : { 1, 3, 7, 1000, 12345 })
    {
      ExactSum exact;
      exact.Reserve(count);
      for (int i = 0; i < count; ++i)
      {
        exact.Add(value);
      }
      EXPECT_EQ(ExactSum::Divide(exact.GetLimbs(), count), value) << count;
    }
  }
  ExactSum one;
  one.Reserve(1);
  one.Add(1.0);
  EXPECT_EQ(ExactSum::Divide(one.GetLimbs(), 3), 1.0 / 3);
  EXPECT_EQ(ExactSum::Divide(one.GetLimbs(), 9007199254740993), 1.1102230246251564e-16);
  ExactSum smallest;
  smallest.Reserve(1);
  smallest.Add(5e-324);
  EXPECT_EQ(ExactSum::Divide(smallest.GetLimbs(), 2), 0.0) << "a tie goes to even";
  smallest.Reserve(1);
  smallest.Add(1e-323);
  EXPECT_EQ(ExactSum::Divide(smallest.GetLimbs(), 2), 1e-323) << "1.5 units are a tie";
}

//------------------------------------------------------------------------------
// Keys out of order would give wrong extremes and quantiles.
TEST(OrderedKey, OrdersAsDoubles)
{
  const std::vector<double> ascending = { -Infinity, -1.7e308, -1.0, -2.3e-308, -5e-324, 0.0,
    5e-324, 2.3e-308, 1.0, 1.0000000000000002, 1.7e308, Infinity };
  for (std::size_t i = 0; i < ascending.size(); ++i)
  {
    EXPECT_EQ(FromKey(ToKey(ascending[i])), ascending[i]);
    if (i > 0)
    {
      EXPECT_LT(ToKey(ascending[i - 1]), ToKey(ascending[i]));
    }
  }
  EXPECT_EQ(ToKey(-0.0), ToKey(0.0));
}
