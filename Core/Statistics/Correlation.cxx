// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/Correlation.h"

#include "Base/Parallel.h"
#include "Ranks/ExactTotals.h"
#include "Ranks/KeyRanks.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/Weights.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sums or means of several terms of each pair.
template <std::size_t Size, typename Number>
struct OfPairs
{
  std::array<Number, Size> Terms = {};
  std::int64_t Count = 0;
  double Largest[2] = { 0, 0 }; ///< magnitudes of x and y
};

template <std::size_t Size, typename Terms>
OfPairs<Size, double> FindMeans(
  const Population& x, const Population& y, Terms&& terms, Reducer& reducer)
{
  using Part = OfPairs<Size, ExactSum>;
  std::vector<Part> parts = ForEachChunk<Part>(x,
    [&](Part& part, const ValueBlock& block, vtkIdType begin, vtkIdType end)
    {
      const ValueBlock& other = y[&block - x.data()];
      for (ExactSum& sum : part.Terms)
      {
        sum.Reserve(end - begin);
      }
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double a = block.Values[i], b = other.Values[i];
        if (!block.Contains(i) || IsNotFinite(a) || IsNotFinite(b))
        {
          continue;
        }
        ++part.Count;
        part.Largest[0] = std::max(part.Largest[0], std::abs(a));
        part.Largest[1] = std::max(part.Largest[1], std::abs(b));
        const std::array<double, Size> values = terms(a, b);
        for (std::size_t s = 0; s < Size; ++s)
        {
          part.Terms[s].Add(values[s]);
        }
      }
    });
  ExactTotals totals(Size);
  OfPairs<Size, double> result;
  for (Part& part : parts)
  {
    totals.AddEach(part.Terms);
    totals.Count(0) += part.Count;
    for (int i = 0; i < 2; ++i)
    {
      result.Largest[i] = std::max(result.Largest[i], part.Largest[i]);
    }
  }
  totals.Reduce(reducer);
  std::int64_t keys[2] = { ToKey(result.Largest[0]), ToKey(result.Largest[1]) };
  reducer.Max(keys, 2);
  result.Count = totals.Count(0);
  for (int i = 0; i < 2; ++i)
  {
    result.Largest[i] = FromKey(keys[i]);
  }
  for (std::size_t s = 0; s < Size && result.Count > 0; ++s)
  {
    result.Terms[s] = totals.Divide(s, result.Count);
  }
  return result;
}
}

//------------------------------------------------------------------------------
double CorrelateLinearly(const Population& x, const Population& y, Reducer& reducer)
{
  const OfPairs<2, double> means = FindMeans<2>(
    x, y, [](double a, double b) { return std::array<double, 2>{ { a, b } }; }, reducer);
  if (means.Count < 2)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // In units that prevent overflow of products of deviations.
  const double units[2] = { GetUnit(means.Largest[0]) / 2, GetUnit(means.Largest[1]) / 2 };
  const double centers[2] = { means.Terms[0] * units[0], means.Terms[1] * units[1] };
  const std::array<double, 5> sums = FindMeans<5>(
    x, y,
    [&](double a, double b)
    {
      const double da = a * units[0] - centers[0], db = b * units[1] - centers[1];
      return std::array<double, 5>{ { da, db, da * da, db * db, da * db } };
    },
    reducer)
                                       .Terms;
  // The deviations are relative to rounded means.
  const double squareOfX = sums[2] - sums[0] * sums[0], squareOfY = sums[3] - sums[1] * sums[1];
  const double product = sums[4] - sums[0] * sums[1];
  if (!(squareOfX > 0 && squareOfY > 0))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double correlation = product / std::sqrt(squareOfX * squareOfY);
  return std::min(std::max(correlation, -1.0), 1.0);
}

//------------------------------------------------------------------------------
BlockRanks FindDoubledRanks(const Population& values, Reducer& reducer)
{
  struct Item
  {
    std::int64_t Key;
    double* Rank;
  };
  using Items = std::vector<Item>;
  BlockRanks result;
  for (const ValueBlock& block : values)
  {
    result.emplace_back(block.Size, std::numeric_limits<double>::quiet_NaN());
  }
  Items items;
  for (const Items& part : ForEachChunk<Items>(values,
         [&](Items& list, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           double* ranks = result[&block - values.data()].data();
           for (vtkIdType i = begin; i < end; ++i)
           {
             if (block.Contains(i) && !std::isnan(block.Values[i]))
             {
               list.push_back({ ToKey(block.Values[i]), ranks + i });
             }
           }
         }))
  {
    items.insert(items.end(), part.begin(), part.end());
  }
  WithThreads(
    [&]
    {
      vtkSMPTools::Sort(
        items.begin(), items.end(), [](const Item& a, const Item& b) { return a.Key < b.Key; });
    });
  std::vector<KeyCounts> own;
  for (const Item& item : items)
  {
    if (own.empty() || own.back().Key != item.Key)
    {
      own.push_back({ item.Key, {} });
    }
    ++own.back().Counts[0];
  }
  const std::vector<KeyRank> ranks = RankKeys(own, reducer);
  auto item = items.begin();
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    const auto rank = static_cast<double>(2 * ranks[i].Before[0] + ranks[i].Counts[0] + 1);
    for (std::int64_t count = own[i].Counts[0]; count > 0; --count)
    {
      *(item++)->Rank = rank;
    }
  }
  return result;
}
}
