// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RadixSelect.h
 * @brief Finds the k-th smallest integer keys of a distributed population, exactly and without
 * sorting.
 *
 * Counts keys in bins, keeps those in the bins of the wanted positions, and continues with the
 * ranges of these bins. Continuous data are reduced to a few keys by the first round; data with
 * few distinct values are finished after it. Each round needs two reductions whose size only
 * depends on the number of positions.
 */
#ifndef camaron_RadixSelect_h
#define camaron_RadixSelect_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint> // for 64 bit integers
#include <limits>  // for empty ranges
#include <vector>  // for positions and keys

namespace camaron
{
/// The part of the algorithm that only works on keys.
class RadixSelector
{
public:
  /// Bins per range; the counters of one range fit into the first-level cache.
  static constexpr int NumberOfBins = 2048;

  /// A range of keys that contains wanted positions.
  struct Window
  {
    std::int64_t Low, High; ///< smallest and largest key
    std::int64_t Before;    ///< number of keys below Low
    int Shift;              ///< bits of a key that are irrelevant for its bin

    Window(std::int64_t low, std::int64_t high, std::int64_t before);
    int GetBin(std::int64_t key) const
    {
      const auto offset = static_cast<std::uint64_t>(key) - static_cast<std::uint64_t>(this->Low);
      return static_cast<int>(offset >> this->Shift);
    }
  };

  /// Candidates of one thread, for each window.
  using Candidates = std::vector<std::vector<std::int64_t>>;

  /// @param low,high smallest and largest of all keys
  /// @param positions ascending, from 0
  RadixSelector(std::int64_t low, std::int64_t high, const std::vector<std::int64_t>& positions);

  /// For each bin of the first window: 0, or 1 + the number of the window that replaces it.
  const std::vector<int>& GetFirstTable() const { return this->Tables.front(); }

  /// Takes the counts of the bins of all windows, and creates their tables.
  void Refine(const std::vector<std::int64_t>& counts);
  /// Continues until the keys at all positions are known.
  std::vector<std::int64_t> Finish(std::vector<Candidates>& candidates, Reducer& reducer);

private:
  bool Narrow(const std::vector<Candidates>& candidates, Reducer& reducer);
  std::vector<std::int64_t> Count(
    const std::vector<Candidates>& candidates, Reducer& reducer) const;
  void Keep(std::vector<Candidates>& candidates) const;

  std::vector<std::int64_t> Positions;
  std::vector<Window> Windows;
  std::vector<std::vector<int>> Tables;
  std::vector<std::int64_t> NextBefore; // of the next windows
};

/**
 * Keys at @a positions (ascending, from 0) of the sorted keys. @a getKey(block, i, key) returns
 * false if element i has no key. @a low and @a high are the smallest and largest keys of all ranks.
 * @a getBin(key) returns the bin of the first round: any nondecreasing function with values from 0
 * to RadixSelector::NumberOfBins - 1; the more evenly it distributes the keys, the better.
 */
template <typename GetKey, typename GetBin>
std::vector<std::int64_t> SelectKeys(const Population& population, GetKey&& getKey, GetBin&& getBin,
  std::int64_t low, std::int64_t high, const std::vector<std::int64_t>& positions, Reducer& reducer)
{
  if (positions.empty() || low == high)
  {
    return std::vector<std::int64_t>(positions.size(), low);
  }
  RadixSelector selector(low, high, positions);

  using Counts = std::vector<std::int64_t>;
  const std::vector<Counts> partialCounts = ForEachChunk<Counts>(population,
    [&](Counts& counts, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      counts.resize(RadixSelector::NumberOfBins);
      std::int64_t* bins = counts.data();
      std::int64_t key;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (getKey(block, i, key))
        {
          ++bins[getBin(key)];
        }
      }
    });
  Counts counts(RadixSelector::NumberOfBins);
  for (const Counts& part : partialCounts)
  {
    for (std::size_t bin = 0; bin < part.size(); ++bin)
    {
      counts[bin] += part[bin];
    }
  }
  reducer.Sum(counts.data(), counts.size());
  selector.Refine(counts);

  using Candidates = RadixSelector::Candidates;
  const std::vector<int>& table = selector.GetFirstTable();
  std::vector<Candidates> candidates = ForEachChunk<Candidates>(population,
    [&](Candidates& kept, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      kept.resize(positions.size());
      std::int64_t key;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (getKey(block, i, key))
        {
          if (const int next = table[getBin(key)])
          {
            kept[next - 1].push_back(key);
          }
        }
      }
    });
  return selector.Finish(candidates, reducer);
}

/// The same with bins from the leading bits of the keys.
template <typename GetKey>
std::vector<std::int64_t> SelectKeys(const Population& population, GetKey&& getKey,
  std::int64_t low, std::int64_t high, const std::vector<std::int64_t>& positions, Reducer& reducer)
{
  const RadixSelector::Window window(low, high, 0);
  return SelectKeys(
    population, getKey, [window](std::int64_t key) { return window.GetBin(key); }, low, high,
    positions, reducer);
}
}

#endif
