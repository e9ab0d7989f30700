// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/RadixSelect.h"

#include "Base/Parallel.h"

namespace camaron
{
//------------------------------------------------------------------------------
RadixSelector::Window::Window(std::int64_t low, std::int64_t high, std::int64_t before)
  : Low(low)
  , High(high)
  , Before(before)
  , Shift(0)
{
  const auto width = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  while ((width >> this->Shift) >= NumberOfBins)
  {
    ++this->Shift;
  }
}

//------------------------------------------------------------------------------
RadixSelector::RadixSelector(
  std::int64_t low, std::int64_t high, const std::vector<std::int64_t>& positions)
  : Positions(positions)
  , Windows(1, Window(low, high, 0))
{
}

//------------------------------------------------------------------------------
void RadixSelector::Refine(const std::vector<std::int64_t>& counts)
{
  this->Tables.assign(this->Windows.size(), std::vector<int>(NumberOfBins, 0));
  this->NextBefore.clear();
  std::size_t position = 0;
  for (std::size_t w = 0; w < this->Windows.size(); ++w)
  {
    std::int64_t before = this->Windows[w].Before;
    for (int bin = 0; bin < NumberOfBins; ++bin)
    {
      const std::int64_t after = before + counts[w * NumberOfBins + bin];
      if (position < this->Positions.size() && this->Positions[position] < after)
      {
        this->NextBefore.push_back(before);
        this->Tables[w][bin] = static_cast<int>(this->NextBefore.size());
        while (position < this->Positions.size() && this->Positions[position] < after)
        {
          ++position;
        }
      }
      before = after;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> RadixSelector::Finish(
  std::vector<Candidates>& candidates, Reducer& reducer)
{
  while (!this->Narrow(candidates, reducer))
  {
    this->Refine(this->Count(candidates, reducer));
    this->Keep(candidates);
  }
  std::vector<std::int64_t> keys;
  std::size_t w = 0;
  for (const std::int64_t position : this->Positions)
  {
    while (w + 1 < this->Windows.size() && this->Windows[w + 1].Before <= position)
    {
      ++w;
    }
    keys.push_back(this->Windows[w].Low);
  }
  return keys;
}

//------------------------------------------------------------------------------
// Replaces the windows by the ranges of the candidates; true when each is a single key.
bool RadixSelector::Narrow(const std::vector<Candidates>& candidates, Reducer& reducer)
{
  const std::size_t size = this->NextBefore.size();
  std::vector<std::int64_t> low(size, std::numeric_limits<std::int64_t>::max());
  std::vector<std::int64_t> high(size, std::numeric_limits<std::int64_t>::min());
  for (const Candidates& part : candidates)
  {
    for (std::size_t w = 0; w < size && w < part.size(); ++w)
    {
      for (const std::int64_t key : part[w])
      {
        low[w] = std::min(low[w], key);
        high[w] = std::max(high[w], key);
      }
    }
  }
  reducer.Min(low.data(), size);
  reducer.Max(high.data(), size);

  this->Windows.clear();
  bool done = true;
  for (std::size_t w = 0; w < size; ++w)
  {
    this->Windows.emplace_back(low[w], high[w], this->NextBefore[w]);
    done = done && low[w] == high[w];
  }
  return done;
}

//------------------------------------------------------------------------------
std::vector<std::int64_t> RadixSelector::Count(
  const std::vector<Candidates>& candidates, Reducer& reducer) const
{
  std::vector<std::int64_t> counts(this->Windows.size() * NumberOfBins);
  for (const Candidates& part : candidates)
  {
    for (std::size_t w = 0; w < this->Windows.size() && w < part.size(); ++w)
    {
      for (const std::int64_t key : part[w])
      {
        ++counts[w * NumberOfBins + this->Windows[w].GetBin(key)];
      }
    }
  }
  reducer.Sum(counts.data(), counts.size());
  return counts;
}

//------------------------------------------------------------------------------
// Sorts the candidates into the windows that the tables lead to, and drops the others.
void RadixSelector::Keep(std::vector<Candidates>& candidates) const
{
  ParallelForEach(static_cast<vtkIdType>(candidates.size()), 1,
    [&](vtkIdType part)
    {
      Candidates kept(this->NextBefore.size());
      for (std::size_t w = 0; w < this->Windows.size() && w < candidates[part].size(); ++w)
      {
        for (const std::int64_t key : candidates[part][w])
        {
          if (const int next = this->Tables[w][this->Windows[w].GetBin(key)])
          {
            kept[next - 1].push_back(key);
          }
        }
      }
      candidates[part] = std::move(kept);
    });
}
}
