// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::RangedArray
 * @brief A VTK array with one component that computes its range much faster than VTK.
 *
 * ParaView requests the ranges of all arrays of every filter; for dozens of arrays this takes
 * longer than computing their values. The ranges are those of VTK: without NaN, finite ranges
 * without infinities, and without ghosts if there are any. Otherwise this is an @a Array, and
 * copies are plain arrays.
 */
#ifndef camaron_RangedArray_h
#define camaron_RangedArray_h

#include "Base/Parallel.h"

#include "vtkObjectFactory.h" // for the standard New
#include "vtkTypeTraits.h"    // for what VTK's ranges begin with

#include <algorithm>   // for std::min
#include <cmath>       // for std::isfinite
#include <mutex>       // for threads that add what they found
#include <type_traits> // for std::is_floating_point

namespace camaron
{
/// Minimum and maximum of a set of values; minimum above maximum if it is empty.
template <typename Value>
struct SmallestAndLargest
{
  Value Low = vtkTypeTraits<Value>::Max();
  Value High = vtkTypeTraits<Value>::Min();

  /// Ignores NaN.
  void Add(Value value)
  {
    this->Low = value < this->Low ? value : this->Low;
    this->High = value > this->High ? value : this->High;
  }
  void Add(const SmallestAndLargest& other)
  {
    this->Low = std::min(this->Low, other.Low);
    this->High = std::max(this->High, other.High);
  }
  bool IsFinite() const
  {
    return !std::is_floating_point<Value>::value ||
      (std::isfinite(static_cast<double>(this->Low)) &&
        std::isfinite(static_cast<double>(this->High)));
  }
};

/// Of the values for which @a counts(index) is true.
template <typename Value, typename Counts>
SmallestAndLargest<Value> FindSmallestAndLargest(
  const Value* values, vtkIdType size, Counts&& counts)
{
  constexpr vtkIdType grain = 1 << 16;
  constexpr int numberOfLanes = 4; // independent of each other, for instruction-level parallelism
  SmallestAndLargest<Value> all;
  std::mutex mutex;
  ParallelFor(size, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      SmallestAndLargest<Value> lanes[numberOfLanes];
      vtkIdType i = begin;
      for (; i + numberOfLanes <= end; i += numberOfLanes)
      {
        for (int lane = 0; lane < numberOfLanes; ++lane)
        {
          if (counts(i + lane))
          {
            lanes[lane].Add(values[i + lane]);
          }
        }
      }
      for (; i < end; ++i)
      {
        if (counts(i))
        {
          lanes[0].Add(values[i]);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (const SmallestAndLargest<Value>& lane : lanes)
      {
        all.Add(lane);
      }
    });
  return all;
}

template <typename Array>
class RangedArray final : public Array
{
public:
  static RangedArray* New() { VTK_STANDARD_NEW_BODY(RangedArray); }

protected:
  using Value = typename Array::ValueType;

  using Array::ComputeFiniteScalarRange;
  using Array::ComputeScalarRange;

  bool ComputeScalarRange(
    double* range, const unsigned char* ghosts, unsigned char ghostsToSkip) override
  {
    if (!this->HasScalars())
    {
      return Array::ComputeScalarRange(range, ghosts, ghostsToSkip);
    }
    return Set(range, this->Find(ghosts, ghostsToSkip));
  }

  bool ComputeFiniteScalarRange(
    double* range, const unsigned char* ghosts, unsigned char ghostsToSkip) override
  {
    if (!this->HasScalars())
    {
      return Array::ComputeFiniteScalarRange(range, ghosts, ghostsToSkip);
    }
    const SmallestAndLargest<Value> all = this->Find(ghosts, ghostsToSkip);
    if (all.IsFinite())
    {
      return Set(range, all);
    }
    const Value* const values = this->GetPointer(0);
    return Set(range,
      FindSmallestAndLargest(values, this->GetNumberOfValues(),
        [=](vtkIdType i)
        {
          return std::isfinite(static_cast<double>(values[i])) &&
            !(ghosts && (ghosts[i] & ghostsToSkip));
        }));
  }

private:
  // Users of the array may change its number of components or remove its values.
  bool HasScalars() const
  {
    return this->GetNumberOfComponents() == 1 && this->GetNumberOfValues() > 0;
  }

  SmallestAndLargest<Value> Find(const unsigned char* ghosts, unsigned char ghostsToSkip)
  {
    const Value* const values = this->GetPointer(0);
    const vtkIdType size = this->GetNumberOfValues();
    return ghosts ? FindSmallestAndLargest(
                      values, size, [=](vtkIdType i) { return !(ghosts[i] & ghostsToSkip); })
                  : FindSmallestAndLargest(values, size, [](vtkIdType) { return true; });
  }

  static bool Set(double* range, const SmallestAndLargest<Value>& found)
  {
    range[0] = static_cast<double>(found.Low);
    range[1] = static_cast<double>(found.High);
    return true;
  }
};
}

#endif
