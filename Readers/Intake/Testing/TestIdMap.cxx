// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions of arbitrary ids, against std::map.
#include "Intake/Ids/IdMap.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

using namespace camaron;

namespace
{
void ExpectFinds(const std::vector<std::int32_t>& ids)
{
  IdMap map;
  map.Build(ids.data(), static_cast<vtkIdType>(ids.size()));
  std::map<std::int64_t, std::int32_t> expected;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    expected[ids[i]] = static_cast<std::int32_t>(i);
  }
  EXPECT_EQ(map.GetNumberOfRepeated(), static_cast<vtkIdType>(ids.size() - expected.size()));
  EXPECT_EQ(map.GetLeast(), expected.begin()->first);
  EXPECT_EQ(map.GetGreatest(), expected.rbegin()->first);
  for (const auto& entry : expected)
  {
    ASSERT_EQ(map.Find(entry.first), entry.second);
    for (const std::int64_t other : { entry.first - 1, entry.first + 1 })
    {
      const auto found = expected.find(other);
      ASSERT_EQ(map.Find(other), found == expected.end() ? -1 : found->second);
    }
  }
  for (const std::int64_t other : { INT64_MIN, std::int64_t(-1), std::int64_t(0), INT64_MAX })
  {
    EXPECT_EQ(map.Find(other), expected.count(other) ? expected[other] : -1);
  }
}
}

//------------------------------------------------------------------------------
// If this fails, elements get the wrong nodes.
TEST(IdMap, FindsIdsOfEveryKind)
{
  ExpectFinds({ 5 });
  ExpectFinds({ INT32_MAX });
  ExpectFinds({ 1, 2, 3, 4 });
  ExpectFinds({ 7, 8, 9 });
  ExpectFinds({ 3, 2, 1, 9 });
  ExpectFinds({ 1, INT32_MAX });
  ExpectFinds({ 100, 5000000, 2000000000, 70000 });
  std::mt19937 random(7);
  for (const std::int32_t range : { 900, 5000, 100000, INT32_MAX - 1 })
  {
    std::vector<std::int32_t> ids;
    for (int i = 0; i < 1000; ++i)
    {
      ids.push_back(1 + static_cast<std::int32_t>(random() % static_cast<unsigned>(range)));
    }
    ExpectFinds(ids);
    std::sort(ids.begin(), ids.end());
    ExpectFinds(ids);
  }
  // Dense, and one far away.
  std::vector<std::int32_t> ids;
  for (int i = 1; i < 3000; ++i)
  {
    ids.push_back(i);
  }
  ids.push_back(2000000000);
  ExpectFinds(ids);
}

//------------------------------------------------------------------------------
// If this fails, the earlier of two definitions is shown.
TEST(IdMap, LaterOnesReplaceEarlierOnes)
{
  for (const std::int32_t id : { 4, 2000000000 })
  {
    const std::vector<std::int32_t> ids{ id, 2, id, 3 };
    IdMap map;
    map.Build(ids.data(), 4);
    EXPECT_EQ(map.Find(id), 2);
    EXPECT_EQ(map.GetNumberOfRepeated(), 1);
  }
  IdMap map;
  EXPECT_EQ(map.Find(1), -1);
  map.Build(nullptr, 0);
  EXPECT_EQ(map.Find(0), -1);
  EXPECT_EQ(map.Find(1), -1);
}
