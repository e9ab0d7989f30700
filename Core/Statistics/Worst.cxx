// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Worst.h"

#include "Base/Parallel.h"
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

struct KeyRange
{
  std::int64_t Low = std::numeric_limits<std::int64_t>::max();
  std::int64_t High = std::numeric_limits<std::int64_t>::min();
  std::int64_t Count = 0;
};

// Minimum, maximum and number of the keys returned by a function.
template <typename GetKey>
KeyRange FindKeyRange(const Population& population, GetKey&& getKey, Reducer& reducer)
{
  const std::vector<KeyRange> parts = ForEachChunk<KeyRange>(population,
    [&](KeyRange& part, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      KeyRange range = part;
      std::int64_t key;
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (getKey(block, i, key))
        {
          range.Low = std::min(range.Low, key);
          range.High = std::max(range.High, key);
          ++range.Count;
        }
      }
      part = range;
    });
  KeyRange all;
  for (const KeyRange& part : parts)
  {
    all.Low = std::min(all.Low, part.Low);
    all.High = std::max(all.High, part.High);
    all.Count += part.Count;
  }
  reducer.Min(&all.Low, 1);
  reducer.Max(&all.High, 1);
  reducer.Sum(&all.Count, 1);
  return all;
}

// The worst elements of a part, as a heap with the best of them on top.
class WorstHeap
{
public:
  std::vector<WorstElement> Elements;

  void Add(const Population& population, const ValueBlock& block, vtkIdType begin, vtkIdType end,
    std::size_t size, WorstEnd worstEnd)
  {
    const IsWorse isWorse{ worstEnd };
    const double sign = worstEnd == WorstEnd::Largest ? 1 : -1;
    for (vtkIdType i = begin; i < end; ++i)
    {
      // False for NaN, and for nearly every value once the heap is full.
      if (!(sign * block.Values[i] >= this->Limit) || !block.Contains(i))
      {
        continue;
      }
      WorstElement element;
      element.Value = block.Values[i] + 0.0; // -0 becomes 0
      element.Id = block.GetId(i);
      element.Index = i;
      element.Block = static_cast<int>(&block - population.data());
      if (this->Elements.size() == size)
      {
        if (!isWorse(element, this->Elements.front()))
        {
          continue;
        }
        std::pop_heap(this->Elements.begin(), this->Elements.end(), isWorse);
        this->Elements.pop_back();
      }
      this->Elements.push_back(element);
      std::push_heap(this->Elements.begin(), this->Elements.end(), isWorse);
      if (this->Elements.size() == size)
      {
        this->Limit = sign * this->Elements.front().Value;
      }
    }
  }

private:
  double Limit = -std::numeric_limits<double>::infinity();
};
}

//------------------------------------------------------------------------------
std::vector<WorstElement> FindWorst(const Population& population, std::int64_t count, WorstEnd end,
  Reducer& reducer, const std::function<void(WorstElement&)>& describe)
{
  std::vector<WorstElement> worst;
  const auto size = static_cast<std::size_t>(std::max<std::int64_t>(count, 0));
  if (size == 0)
  {
    return worst;
  }
  const auto sortAndCut = [&]
  {
    std::sort(worst.begin(), worst.end(), IsWorse{ end });
    worst.resize(std::min(worst.size(), size));
  };
  const std::vector<WorstHeap> heaps = ForEachChunk<WorstHeap>(population,
    [&](WorstHeap& heap, const ValueBlock& block, vtkIdType first, vtkIdType last)
    { heap.Add(population, block, first, last, size, end); });
  for (const WorstHeap& heap : heaps)
  {
    worst.insert(worst.end(), heap.Elements.begin(), heap.Elements.end());
  }
  sortAndCut();
  for (WorstElement& element : worst)
  {
    describe(element);
  }
  worst = reducer.GatherItems(worst);
  sortAndCut();
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

namespace
{
struct Choice
{
  std::int64_t Key;
  std::int64_t Remaining; // number of elements to select from those with exactly that key
};

// The key at which this number of elements, those with the largest or smallest keys, is reached.
template <typename GetKey>
Choice Choose(const Population& population, const GetKey& getKey, std::int64_t count, bool largest,
  Reducer& reducer)
{
  const KeyRange range = FindKeyRange(population, getKey, reducer);
  const std::int64_t position = largest ? range.Count - count : count - 1;
  const std::int64_t last =
    SelectKeys(population, getKey, range.Low, range.High, { position }, reducer).front();
  const auto isBeyond = [&](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  { return getKey(block, i, key) && key != last && (key > last) == largest; };
  return { last, count - FindKeyRange(population, isBeyond, reducer).Count };
}
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
  const bool largest = end == WorstEnd::Largest;
  WorstLimit limit;
  limit.End = end;
  limit.Count =
    std::min(std::max<std::int64_t>(count, 0), FindKeyRange(population, getKey, reducer).Count);
  if (limit.Count == 0)
  {
    return limit;
  }
  const Choice choice = Choose(population, getKey, limit.Count, largest, reducer);
  limit.Key = choice.Key;
  // Of the elements with exactly that value, those with the smallest ids complete the list.
  const auto getId = [&](const ValueBlock& block, vtkIdType i, std::int64_t& key)
  {
    const bool isTied = getKey(block, i, key) && key == limit.Key;
    key = block.GetId(i);
    return isTied;
  };
  limit.LastId =
    static_cast<vtkIdType>(Choose(population, getId, choice.Remaining, false, reducer).Key);
  return limit;
}

//------------------------------------------------------------------------------
MissingValues::MissingValues(const Population& population)
  : Blocks(population)
  , Values(population.size())
{
  constexpr int grain = 1 << 16;
  for (std::size_t b = 0; b < population.size(); ++b)
  {
    const ValueBlock& block = population[b];
    std::vector<double>& values = this->Values[b];
    values.assign(block.Size, std::numeric_limits<double>::quiet_NaN());
    ParallelForEach(block.Size, grain,
      [&](vtkIdType i)
      {
        if (std::isnan(block.Values[i]) && block.GetNullReason(i) != NullReason::NotApplicable)
        {
          values[i] = 0;
        }
      });
    this->Blocks[b] = block.WithValues(values.data());
  }
}
}
