// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ValueChanges.h"

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
void AddChange(double before, double after, Better better, double tolerance, ValueChanges& changes)
{
  const bool wasNull = std::isnan(before), isNull = std::isnan(after);
  if (wasNull && isNull)
  {
    return;
  }
  ++changes.Compared;
  if (wasNull || isNull)
  {
    ++(wasNull ? changes.Improved : changes.Worsened);
    return;
  }
  // Halves, because the difference of two numbers may be out of range; infinities are unchanged if
  // equal.
  const double limit = tolerance * std::max(std::abs(before), std::abs(after)) / 2;
  const bool areClose = std::isfinite(limit) && std::abs(after / 2 - before / 2) <= limit;
  if (before == after || areClose)
  {
    ++changes.Unchanged;
  }
  else if (better != Better::Neither)
  {
    ++((before < after) == (better == Better::Bigger) ? changes.Improved : changes.Worsened);
  }
}
}

//------------------------------------------------------------------------------
ValueChanges CountChanges(const Population& before, const Population& after, Better better,
  double tolerance, Reducer& reducer)
{
  std::int64_t counts[4] = {};
  for (const ValueChanges& part : ForEachChunk<ValueChanges>(after,
         [&](ValueChanges& changes, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           const ValueBlock& other = before[&block - after.data()];
           for (vtkIdType i = begin; i < end; ++i)
           {
             if (block.Contains(i))
             {
               AddChange(other.Values[i], block.Values[i], better, tolerance, changes);
             }
           }
         }))
  {
    counts[0] += part.Compared;
    counts[1] += part.Improved;
    counts[2] += part.Worsened;
    counts[3] += part.Unchanged;
  }
  reducer.Sum(counts, 4);
  return { counts[0], counts[1], counts[2], counts[3] };
}

//------------------------------------------------------------------------------
void FindDifferences(const ValueBlock& before, const ValueBlock& after, vtkIdType begin,
  vtkIdType end, double* differences)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    const double from = before.Values[i], to = after.Values[i];
    differences[i] = from == to ? 0 : to - from;
  }
}

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
