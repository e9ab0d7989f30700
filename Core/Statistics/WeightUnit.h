// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WeightUnit.h
 * @brief Weights of elements, and units in which neither sums nor products of weights overflow.
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

/// A power of two whose product with the magnitude is below 1; limited to normal numbers.
inline double GetUnit(double magnitude)
{
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, -std::max(exponent, -1000));
}

/// Collective. The unit of the largest weight.
inline double FindWeightUnit(const Population& weights, Reducer& reducer)
{
  double largest = 0;
  for (const double part : ForEachChunk<double>(weights,
         [](double& maximum, const ValueBlock& block, vtkIdType begin, vtkIdType end)
         {
           double chunkMaximum = maximum; // local copy, because the maxima of threads are adjacent
                                          // in memory
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
