// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WeightUnit.h
 * @brief What weights count for, and units in which neither sums nor products of them overflow.
 */
#ifndef camaron_WeightUnit_h
#define camaron_WeightUnit_h

#include "Ranks/Reducer.h"
#include "Statistics/OrderedKey.h"
#include "Statistics/Population.h"

#include <algorithm> // for std::max
#include <cmath>     // for magnitudes

namespace camaron
{
/// Its magnitude; 0 if it is not finite.
inline double GetWeight(const ValueBlock& weights, vtkIdType i)
{
  const double weight = std::abs(weights.Values[i]);
  return std::isfinite(weight) ? weight : 0;
}

/// A power of two, times which a magnitude is below 1; limited so that it is a normal number.
inline double GetUnit(double magnitude)
{
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, -std::max(exponent, -1000));
}

/// Of the largest weight. Collective.
inline double FindWeightUnit(const Population& weights, Reducer& reducer)
{
  double largest = 0;
  for (const double part : ForEachChunk<double>(weights,
         [](double& maximum, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           double chunkMaximum = maximum; // threads' own lie side by side
           for (vtkIdType i = begin; i < end; ++i)
           {
             chunkMaximum =
               block.Contains(i) ? std::max(chunkMaximum, GetWeight(block, i)) : chunkMaximum;
           }
           maximum = chunkMaximum;
         }))
  {
    largest = std::max(largest, part);
  }
  std::int64_t key = ToKey(largest);
  reducer.Max(&key, 1);
  return GetUnit(FromKey(key));
}
}

#endif
