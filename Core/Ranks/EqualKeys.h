// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EqualKeys.h
 * @brief Finds items of several ranks with equal keys, after all ranks have sent their keys to one
 * of them.
 */
#ifndef camaron_EqualKeys_h
#define camaron_EqualKeys_h

#include <algorithm> // for sorting
#include <tuple>     // for comparisons
#include <vector>    // for the keys

namespace camaron
{
/// A key among those received from a rank.
struct ReceivedKey
{
  std::size_t Process, Number;
};

/**
 * Calls @a visit(const std::vector<ReceivedKey>&) for every group of equal keys, in ascending
 * order; the keys of a group are sorted by rank, then by index.
 * @param lists lists of items from every rank; GetKey() of an item must return a comparable key
 */
template <typename Keyed, typename Visit>
void ForEachKey(const std::vector<std::vector<Keyed>>& lists, Visit&& visit)
{
  std::vector<ReceivedKey> all;
  for (std::size_t process = 0; process < lists.size(); ++process)
  {
    for (std::size_t i = 0; i < lists[process].size(); ++i)
    {
      all.push_back({ process, i });
    }
  }
  const auto get = [&lists](const ReceivedKey& at) -> const Keyed&
  { return lists[at.Process][at.Number]; };
  std::sort(all.begin(), all.end(),
    [&get](const ReceivedKey& a, const ReceivedKey& b)
    {
      const auto keyA = get(a).GetKey(), keyB = get(b).GetKey();
      return keyA == keyB ? std::tie(a.Process, a.Number) < std::tie(b.Process, b.Number)
                          : keyA < keyB;
    });
  std::vector<ReceivedKey> group;
  for (auto first = all.cbegin(); first != all.cend();)
  {
    const auto last = std::find_if(first, all.cend(),
      [&](const ReceivedKey& at) { return !(get(at).GetKey() == get(*first).GetKey()); });
    group.assign(first, last);
    visit(group);
    first = last;
  }
}
}

#endif
