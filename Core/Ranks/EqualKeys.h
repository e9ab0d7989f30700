// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EqualKeys.h
 * @brief The exchange between ranks: items with equal keys meet on one rank.
 *
 * An item is a plain struct with GetKey(), which returns a comparable value, and GetHash(), which
 * is the same for equal keys and decides which rank receives them.
 */
#ifndef camaron_EqualKeys_h
#define camaron_EqualKeys_h

#include "Ranks/Reducer.h"

#include <algorithm> // for sorting
#include <tuple>     // for comparisons
#include <vector>    // for the items

namespace camaron
{
/// An item received from a rank, and its index among those.
template <typename Item>
struct Received
{
  std::size_t Process, Number;
  const Item* Sent;
};

/// Calls @a visit(const std::vector<Received<Item>>&) for every group of equal keys in lists from
/// all ranks, in ascending order of keys; a group is sorted by rank, then by index.
template <typename Item, typename Visit>
void ForEachKey(const std::vector<std::vector<Item>>& lists, Visit&& visit)
{
  using Key = std::decay_t<decltype(lists[0][0].GetKey())>;
  std::vector<std::tuple<Key, std::size_t, std::size_t>> all; // keys, ranks, indices
  for (std::size_t process = 0; process < lists.size(); ++process)
  {
    for (std::size_t i = 0; i < lists[process].size(); ++i)
    {
      all.emplace_back(lists[process][i].GetKey(), process, i);
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<Received<Item>> group;
  for (auto first = all.cbegin(); first != all.cend();)
  {
    group.clear();
    const Key& key = std::get<0>(*first);
    for (; first != all.cend() && std::get<0>(*first) == key; ++first)
    {
      const std::size_t process = std::get<1>(*first), number = std::get<2>(*first);
      group.push_back({ process, number, &lists[process][number] });
    }
    visit(group);
  }
}

/**
 * Collective. For each item of this rank, the answer of one rank that receives all items with its
 * key: @a answer(const std::vector<Received<Item>>& group, std::vector<Result>& results) sets a
 * result for each item of the group.
 */
template <typename Result, typename Item, typename Answer>
std::vector<Result> AskEachOfEqual(
  const std::vector<Item>& items, Reducer& reducer, Answer&& answer)
{
  return reducer.Ask(
    items, [&](const Item& item) { return item.GetHash() % reducer.GetNumberOfProcesses(); },
    [&](const std::vector<std::vector<Item>>& lists)
    {
      std::vector<std::vector<Result>> answers;
      for (const std::vector<Item>& list : lists)
      {
        answers.emplace_back(list.size());
      }
      std::vector<Result> results;
      ForEachKey(lists,
        [&](const std::vector<Received<Item>>& group)
        {
          results.resize(group.size());
          answer(group, results);
          for (std::size_t i = 0; i < group.size(); ++i)
          {
            answers[group[i].Process][group[i].Number] = results[i];
          }
        });
      return answers;
    });
}

/// Collective. The same with one result for the whole group: @a answer(group) returns it.
template <typename Item, typename Answer>
auto AskAboutEqual(const std::vector<Item>& items, Reducer& reducer, Answer&& answer)
{
  using Group = std::vector<Received<Item>>;
  using Result = std::decay_t<decltype(answer(Group()))>;
  return AskEachOfEqual<Result>(items, reducer,
    [&](const Group& group, std::vector<Result>& results)
    { std::fill(results.begin(), results.end(), answer(group)); });
}

/**
 * Collective. Calls @a visit(std::vector<Item>&) for every group of several items with equal keys,
 * of all ranks, that has an item of this rank; it is sorted by rank, then as in @a items.
 */
template <typename Item, typename Visit>
void ForEachEqual(const std::vector<Item>& items, Reducer& reducer, Visit&& visit)
{
  const auto numberOfProcesses = static_cast<std::size_t>(reducer.GetNumberOfProcesses());
  std::vector<std::vector<Item>> sent(numberOfProcesses), answers(numberOfProcesses);
  for (const Item& item : items)
  {
    sent[item.GetHash() % numberOfProcesses].push_back(item);
  }
  ForEachKey(reducer.ExchangeItems(std::move(sent)),
    [&](const std::vector<Received<Item>>& group)
    {
      for (std::size_t i = 0; i < group.size() && group.size() > 1; ++i)
      {
        if (i == 0 || group[i].Process != group[i - 1].Process)
        {
          for (const Received<Item>& item : group)
          {
            answers[group[i].Process].push_back(*item.Sent);
          }
        }
      }
    });
  std::vector<Item> group;
  for (const std::vector<Item>& list : reducer.ExchangeItems(std::move(answers)))
  {
    for (auto first = list.begin(); first != list.end(); first += group.size())
    {
      const auto last = std::find_if(
        first, list.end(), [&](const Item& item) { return item.GetKey() != first->GetKey(); });
      group.assign(first, last);
      visit(group);
    }
  }
}
}

#endif
