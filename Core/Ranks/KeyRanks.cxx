// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/KeyRanks.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// First keys of the ranges of all ranks but the first, so that each has about the same number of
// keys.
std::vector<std::int64_t> ChooseLimits(const std::vector<KeyCounts>& own, Reducer& reducer)
{
  struct Sample
  {
    std::int64_t Key, Weight;
  };
  constexpr std::size_t samplesPerProcess = 256; // the sizes of ranges then differ by a few percent
  std::vector<Sample> samples;
  const std::size_t size = std::min(own.size(), samplesPerProcess);
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t begin = own.size() * i / size, end = own.size() * (i + 1) / size;
    samples.push_back({ own[begin].Key, static_cast<std::int64_t>(end - begin) });
  }
  samples = reducer.GatherItems(samples);
  std::sort(
    samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.Key < b.Key; });
  std::int64_t total = 0;
  for (const Sample& sample : samples)
  {
    total += sample.Weight;
  }
  const int numberOfProcesses = reducer.GetNumberOfProcesses();
  std::vector<std::int64_t> limits;
  std::int64_t before = 0;
  for (const Sample& sample : samples)
  {
    while (static_cast<int>(limits.size()) + 1 < numberOfProcesses &&
      before >= total / numberOfProcesses * (static_cast<int>(limits.size()) + 1))
    {
      limits.push_back(sample.Key);
    }
    before += sample.Weight;
  }
  limits.resize(numberOfProcesses - 1, std::numeric_limits<std::int64_t>::max());
  return limits;
}

//------------------------------------------------------------------------------
// The positions of the keys from each rank, which are ascending.
std::vector<std::vector<KeyRank>> RankRange(
  const std::vector<std::vector<KeyCounts>>& lists, Reducer& reducer)
{
  std::vector<std::int64_t> keys;
  for (const std::vector<KeyCounts>& list : lists)
  {
    for (const KeyCounts& item : list)
    {
      keys.push_back(item.Key);
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());

  std::vector<KeyRank> ranks(keys.size(), KeyRank{ {}, {} });
  const auto forEach = [&](auto&& function)
  {
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      std::size_t place = 0;
      for (const KeyCounts& item : lists[process])
      {
        while (keys[place] < item.Key)
        {
          ++place;
        }
        function(process, item, ranks[place]);
      }
    }
  };
  std::array<std::int64_t, 2> total = {};
  forEach(
    [&](std::size_t, const KeyCounts& item, KeyRank& rank)
    {
      for (int list = 0; list < 2; ++list)
      {
        rank.Counts[list] += item.Counts[list];
        total[list] += item.Counts[list];
      }
    });
  const auto totals = reducer.GatherItems(std::vector<std::array<std::int64_t, 2>>{ total });
  std::array<std::int64_t, 2> before = {};
  for (int process = 0; process < reducer.GetProcess(); ++process)
  {
    before[0] += totals[process][0];
    before[1] += totals[process][1];
  }
  for (KeyRank& rank : ranks)
  {
    rank.Before = before;
    before[0] += rank.Counts[0];
    before[1] += rank.Counts[1];
  }
  std::vector<std::vector<KeyRank>> answers(lists.size());
  forEach([&](std::size_t process, const KeyCounts&, const KeyRank& rank)
    { answers[process].push_back(rank); });
  return answers;
}
}

//------------------------------------------------------------------------------
std::vector<KeyRank> RankKeys(const std::vector<KeyCounts>& own, Reducer& reducer)
{
  if (reducer.GetNumberOfProcesses() == 1)
  {
    std::vector<KeyRank> ranks;
    ranks.reserve(own.size());
    std::array<std::int64_t, 2> before = {};
    for (const KeyCounts& item : own)
    {
      ranks.push_back({ before, item.Counts });
      before[0] += item.Counts[0];
      before[1] += item.Counts[1];
    }
    return ranks;
  }
  const std::vector<std::int64_t> limits = ChooseLimits(own, reducer);
  return reducer.Ask(
    own, [&](const KeyCounts& item)
    { return std::upper_bound(limits.begin(), limits.end(), item.Key) - limits.begin(); },
    [&](const std::vector<std::vector<KeyCounts>>& lists) { return RankRange(lists, reducer); });
}
}
