// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Counters.h
 * @brief Thread-safe counters whose results do not depend on the order of updates.
 */
#ifndef camaron_Counters_h
#define camaron_Counters_h

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Criteria/Criterion.h"
#include "Mesh/FacetTable.h"

#include <atomic>  // for the numbers
#include <cmath>   // for rounding
#include <cstdint> // for sums

namespace camaron
{
/// An array with the same number in all entries.
template <typename Value>
LargeVector<std::atomic<Value>> MakeAtomics(std::size_t size, Value first)
{
  LargeVector<std::atomic<Value>> values(size);
  for (auto& value : values)
  {
    value.store(first, std::memory_order_relaxed);
  }
  return values;
}

class Counters
{
public:
  explicit Counters(std::size_t size)
    : Values(MakeAtomics<Index>(size, 0))
  {
  }
  void Add(vtkIdType i) { this->Values[i].fetch_add(1, std::memory_order_relaxed); }
  LargeVector<Index> Get() const { return { this->Values.begin(), this->Values.end() }; }

private:
  LargeVector<std::atomic<Index>> Values;
};

/// Keeps the minimum of values, for every entry.
template <typename Value>
class Minima
{
public:
  Minima(std::size_t size, Value largest)
    : Values(MakeAtomics(size, largest))
  {
  }
  void Add(vtkIdType i, Value value) { LowerTo(this->Values[i], value); }
  Value Get(vtkIdType i) const { return this->Values[i].load(std::memory_order_relaxed); }

private:
  LargeVector<std::atomic<Value>> Values;
};

/**
 * Sums of angles in radians or steradians, stored as integers so that they do not depend on the
 * order, even for cells of different pieces. A sum is NaN if any of its angles is, or if there are
 * none.
 */
class AngleSums
{
public:
  explicit AngleSums(std::size_t size)
    : Sums(MakeAtomics<std::int64_t>(size, 0))
    , Reasons(MakeAtomics(size, NoParts))
  {
  }
  void Add(vtkIdType i, double angle)
  {
    // Reasons of NaN are positive; 0 means that the value is defined.
    auto reason = static_cast<unsigned char>(GetNullReason(angle));
    unsigned char known = this->Reasons[i].load(std::memory_order_relaxed);
    while ((known == NoParts || reason > known) &&
      !this->Reasons[i].compare_exchange_weak(known, reason, std::memory_order_relaxed))
    {
    }
    if (!std::isnan(angle))
    {
      this->Sums[i].fetch_add(std::llround(angle * Resolution), std::memory_order_relaxed);
    }
  }
  double Get(vtkIdType i) const
  {
    const unsigned char reason = this->Reasons[i].load(std::memory_order_relaxed);
    return reason == 0
      ? static_cast<double>(this->Sums[i].load(std::memory_order_relaxed)) / Resolution
      : reason == NoParts ? Null(NullReason::NotApplicable)
                          : Null(static_cast<NullReason>(reason));
  }

private:
  static constexpr double Resolution = 0x1p49; // 2600 full circles fit into 63 bits
  static constexpr unsigned char NoParts = 255;
  LargeVector<std::atomic<std::int64_t>> Sums;
  LargeVector<std::atomic<unsigned char>> Reasons;
};
}

#endif
