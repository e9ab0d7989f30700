// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/DistributionDistance.h"

#include "Base/Parallel.h"
#include "Ranks/KeyRanks.h"
#include "Statistics/OrderedKey.h"

#include "vtkSMPTools.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The sorted keys of all values except NaN, including infinite ones.
std::vector<std::int64_t> SortKeys(const Population& population)
{
  using Keys = std::vector<std::int64_t>;
  Keys keys;
  for (const Keys& part : ForEachChunk<Keys>(population,
         [](Keys& list, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           for (vtkIdType i = begin; i < end; ++i)
           {
             if (block.Contains(i) && !std::isnan(block.Values[i]))
             {
               list.push_back(ToKey(block.Values[i]));
             }
           }
         }))
  {
    keys.insert(keys.end(), part.begin(), part.end());
  }
  WithThreads([&] { vtkSMPTools::Sort(keys.begin(), keys.end()); });
  return keys;
}

//------------------------------------------------------------------------------
// Counts of each key in two sorted lists.
std::vector<KeyCounts> CountKeys(
  const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b)
{
  std::vector<KeyCounts> counts;
  auto inA = a.begin(), inB = b.begin();
  while (inA != a.end() || inB != b.end())
  {
    const std::int64_t key = inB == b.end() || (inA != a.end() && *inA < *inB) ? *inA : *inB;
    KeyCounts item = { key, {} };
    for (; inA != a.end() && *inA == key; ++inA)
    {
      ++item.Counts[0];
    }
    for (; inB != b.end() && *inB == key; ++inB)
    {
      ++item.Counts[1];
    }
    counts.push_back(item);
  }
  return counts;
}
}

//------------------------------------------------------------------------------
DistributionDistance FindDistributionDistance(
  const Population& a, const Population& b, Reducer& reducer)
{
  const std::vector<std::int64_t> keysOfA = SortKeys(a), keysOfB = SortKeys(b);
  std::int64_t sizes[2] = { static_cast<std::int64_t>(keysOfA.size()),
    static_cast<std::int64_t>(keysOfB.size()) };
  reducer.Sum(sizes, 2);
  if (sizes[0] == 0 || sizes[1] == 0)
  {
    return {};
  }
  const std::vector<KeyCounts> own = CountKeys(keysOfA, keysOfB);
  const std::vector<KeyRank> ranks = RankKeys(own, reducer);

  // Every key is assigned to a rank, which compares the functions there.
  double largest = 0;
  std::int64_t where = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    double shares[2];
    for (int list = 0; list < 2; ++list)
    {
      shares[list] = static_cast<double>(ranks[i].Before[list] + ranks[i].Counts[list]) /
        static_cast<double>(sizes[list]);
    }
    const double difference = std::abs(shares[0] - shares[1]);
    if (difference > largest || where > own.back().Key)
    {
      largest = difference;
      where = own[i].Key;
    }
  }
  std::int64_t key = ToKey(largest);
  reducer.Max(&key, 1);
  where = ToKey(largest) == key ? where : std::numeric_limits<std::int64_t>::max();
  reducer.Min(&where, 1);
  return { FromKey(key), FromKey(where) };
}
}
