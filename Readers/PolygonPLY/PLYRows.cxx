// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYRows.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
//------------------------------------------------------------------------------
bool PLYSizes::Finish()
{
  constexpr vtkIdType Chunk = 1 << 16;
  const vtkIdType count = this->Offsets.size() - 1;
  std::int32_t* const sizes = this->Offsets.data() + 1;
  std::mutex mutex;
  std::int32_t least = INT32_MAX, greatest = 0;
  ParallelScan(
    count, Chunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      const auto range = std::minmax_element(sizes + begin, sizes + end);
      for (vtkIdType i = begin; i < end; ++i)
      {
        sum += sizes[i];
      }
      const std::lock_guard<std::mutex> lock(mutex);
      least = std::min(least, *range.first);
      greatest = std::max(greatest, *range.second);
      return sum;
    },
    [this](vtkIdType total) { this->Total = total; },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      // The sum may be too large for the offsets.
      for (vtkIdType i = begin; i < end && this->Total <= INT32_MAX; ++i)
      {
        before += sizes[i];
        sizes[i] = static_cast<std::int32_t>(before);
      }
    });
  if (this->Total > INT32_MAX)
  {
    return false;
  }
  this->Common = count > 0 && least == greatest ? least : -1;
  this->Offsets[0] = 0;
  return true;
}

//------------------------------------------------------------------------------
std::string PLYRows::DescribeIds(const PLYIds& expected)
{
  const std::string range =
    expected.Limit > 0 ? " from 0 to " + std::to_string(expected.Limit - 1) : " (there are none)";
  return expected.What + range + (expected.HasBreaks ? ", or -1" : "");
}
}
