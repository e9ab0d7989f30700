// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks/KeyRanks.h"

#include "Ranks/EqualKeys.h"

#include <algorithm>
#include <functional>
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
// The positions of the keys from each rank.
std::vector<std::vector<KeyRank>> RankRange(
  const std::vector<std::vector<KeyCounts>>& lists, Reducer& reducer)
{
  using Counts = std::array<std::int64_t, 2>;
  const auto add = [](Counts& sum, const Counts& counts)
  { std::transform(counts.begin(), counts.end(), sum.begin(), sum.begin(), std::plus<>()); };
  Counts total = {};
  std::vector<std::vector<KeyRank>> answers;
  for (const std::vector<KeyCounts>& list : lists)
  {
    answers.emplace_back(list.size());
    for (const KeyCounts& item : list)
    {
      add(total, item.Counts);
    }
  }
  const std::vector<Counts> totals = reducer.GatherItems(std::vector<Counts>{ total });
  Counts before = {};
  for (int process = 0; process < reducer.GetProcess(); ++process)
  {
    add(before, totals[process]);
  }
  ForEachKey(lists,
    [&](const std::vector<Received<KeyCounts>>& group)
    {
      KeyRank rank = { before, {} };
      for (const Received<KeyCounts>& item : group)
      {
        add(rank.Counts, item.Sent->Counts);
      }
      for (const Received<KeyCounts>& item : group)
      {
        answers[item.Process][item.Number] = rank;
      }
      add(before, rank.Counts);
    });
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
