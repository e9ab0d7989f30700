// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Worst.h"

#include "Statistics/OrderedKey.h"
#include "Statistics/RadixSelect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
// True when a comes before b.
struct IsWorse
{
  WorstEnd End;
  bool operator()(const WorstElement& a, const WorstElement& b) const
  {
    if (a.Value != b.Value)
    {
      return (a.Value > b.Value) == (this->End == WorstEnd::Largest);
    }
    return a.Id < b.Id;
  }
};

// Smallest and largest key of those that a function gives.
template <typename GetKey>
void FindKeyRange(
  const Population& population, GetKey&& getKey, std::int64_t range[2], Reducer& reducer)
{
  struct Range
  {
    std::int64_t Low = std::numeric_limits<std::int64_t>::max();
    std::int64_t High = std::numeric_limits<std::int64_t>::min();
    std::int64_t Count = 0;
  };
  const std::vector<Range> parts = ForEachChunk<Range>(population,
    [&](Range& part, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      std::int64_t key;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (getKey(block, i, key))
        {
          part.Low = std::min(part.Low, key);
          part.High = std::max(part.High, key);
        }
      }
    });
  Range all;
  for (const Range& part : parts)
  {
    all.Low = std::min(all.Low, part.Low);
    all.High = std::max(all.High, part.High);
  }
  reducer.Min(&all.Low, 1);
  reducer.Max(&all.High, 1);
  range[0] = all.Low;
  range[1] = all.High;
}

template <typename GetKey>
std::int64_t CountKeys(const Population& population, GetKey&& getKey, Reducer& reducer)
{
  const std::vector<std::int64_t> parts = ForEachChunk<std::int64_t>(population,
    [&](std::int64_t& part, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      std::int64_t key, count = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        count += getKey(block, i, key);
      }
      part += count;
    });
  std::int64_t count = 0;
  for (const std::int64_t part : parts)
  {
    count += part;
  }
  reducer.Sum(&count, 1);
  return count;
}
}

//------------------------------------------------------------------------------
std::vector<WorstElement> FindWorst(const Population& population, std::int64_t count, WorstEnd end,
  Reducer& reducer, const std::function<void(WorstElement&)>& describe)
{
  const IsWorse isWorse{ end };
  const auto size = static_cast<std::size_t>(std::max<std::int64_t>(count, 0));
  // Heaps with the best of the worst on top, one per thread.
  using Heap = std::vector<WorstElement>;
  const std::vector<Heap> heaps = ForEachChunk<Heap>(population,
    [&](Heap& heap, const ValueBlock& block, vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const double value = block.Values[i] + 0.0;
        if (std::isnan(value) || !block.Contains(i) || size == 0)
        {
          continue;
        }
        if (heap.size() == size &&
          (end == WorstEnd::Largest ? value < heap.front().Value : value > heap.front().Value))
        {
          continue;
        }
        WorstElement element;
        element.Value = value;
        element.Id = block.GetId(i);
        element.Index = i;
        element.Block = static_cast<int>(&block - population.data());
        element.Process = reducer.GetProcess();
        if (heap.size() == size)
        {
          if (!isWorse(element, heap.front()))
          {
            continue;
          }
          std::pop_heap(heap.begin(), heap.end(), isWorse);
          heap.pop_back();
        }
        heap.push_back(element);
        std::push_heap(heap.begin(), heap.end(), isWorse);
      }
    });

  const auto sortAndCut = [&](Heap& list)
  {
    std::sort(list.begin(), list.end(), isWorse);
    list.resize(std::min(list.size(), size));
  };
  Heap worst;
  for (const Heap& heap : heaps)
  {
    worst.insert(worst.end(), heap.begin(), heap.end());
  }
  sortAndCut(worst);
  for (WorstElement& element : worst)
  {
    describe(element);
  }
  worst = reducer.GatherItems(worst);
  sortAndCut(worst);
  return worst;
}

//------------------------------------------------------------------------------
bool WorstLimit::Contains(const ValueBlock& block, vtkIdType i) const
{
  const double value = block.Values[i];
  if (this->Count == 0 || std::isnan(value) || !block.Contains(i))
  {
    return false;
  }
  const std::int64_t key = ToKey(value);
  if (key == this->Key)
  {
    return block.GetId(i) <= this->LastId;
  }
  return (key > this->Key) == (this->End == WorstEnd::Largest);
}

//------------------------------------------------------------------------------
WorstLimit FindWorstLimit(
  const Population& population, std::int64_t count, WorstEnd end, Reducer& reducer)
{
  const auto getKey = [](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  {
    const double value = block.Values[i];
    key = ToKey(value);
    return !std::isnan(value) && block.Contains(i);
  };
  const std::int64_t candidates = CountKeys(population, getKey, reducer);
  WorstLimit limit;
  limit.End = end;
  limit.Count = std::min(std::max<std::int64_t>(count, 0), candidates);
  if (limit.Count == 0)
  {
    return limit;
  }

  const bool largest = end == WorstEnd::Largest;
  std::int64_t range[2];
  FindKeyRange(population, getKey, range, reducer);
  const std::int64_t position = largest ? candidates - limit.Count : limit.Count - 1;
  limit.Key = SelectKeys(population, getKey, range[0], range[1], { position }, reducer).front();

  const auto isWorse = [&](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  { return getKey(block, i, key) && key != limit.Key && (key > limit.Key) == largest; };
  const std::int64_t numberOfWorse = CountKeys(population, isWorse, reducer);

  const auto getTiedId = [&](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  {
    const bool tied = getKey(block, i, key) && key == limit.Key;
    key = tied ? block.GetId(i) : 0;
    return tied;
  };
  FindKeyRange(population, getTiedId, range, reducer);
  limit.LastId = static_cast<vtkIdType>(SelectKeys(
    population, getTiedId, range[0], range[1], { limit.Count - numberOfWorse - 1 }, reducer)
                                          .front());
  return limit;
}
}
