// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/FacesOfCells.h"

#include "Base/Parallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Adds to a cursor and returns the new value. A single thread needs no locks.
vtkIdType Add(std::atomic<vtkIdType>& cursor, vtkIdType value, bool isAlone)
{
  if (!isAlone)
  {
    return cursor.fetch_add(value, std::memory_order_relaxed) + value;
  }
  const vtkIdType sum = cursor.load(std::memory_order_relaxed) + value;
  cursor.store(sum, std::memory_order_relaxed);
  return sum;
}
}

//------------------------------------------------------------------------------
Buffer<std::int32_t> ListFacesOfCells(const Buffer<std::int32_t>& sides, vtkIdType numberOfCells)
{
  const bool isAlone = vtkSMPTools::GetEstimatedNumberOfThreads() <= 1;
  const auto forEachSide = [&](auto&& visit)
  {
    ParallelFor(sides.size(), MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType side = begin; side < end; ++side)
        {
          if (sides[side] >= 0)
          {
            visit(sides[side], side / 2);
          }
        }
      });
  };
  // Per cell its number of faces, then the begin of its ids, finally their end.
  std::vector<std::atomic<vtkIdType>> cursors(static_cast<std::size_t>(numberOfCells));
  forEachSide([&](std::int32_t cell, vtkIdType) { Add(cursors[cell], 1, isAlone); });
  const vtkIdType total = ParallelScan(
    numberOfCells, HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = end - begin;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        sum += cursors[cell];
      }
      return sum;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType size = cursors[cell];
        cursors[cell] = ++before;
        before += size;
      }
    });
  Buffer<std::int32_t> words(total);
  forEachSide([&](std::int32_t cell, vtkIdType face)
    { words[Add(cursors[cell], 1, isAlone) - 1] = static_cast<std::int32_t>(face); });
  ParallelFor(numberOfCells, HeavyGrain,
    [&](vtkIdType firstCell, vtkIdType lastCell)
    {
      for (vtkIdType cell = firstCell; cell < lastCell; ++cell)
      {
        std::int32_t* const begin = words.data() + (cell > 0 ? cursors[cell - 1] + 1 : 1);
        std::int32_t* const end = words.data() + cursors[cell];
        begin[-1] = static_cast<std::int32_t>(end - begin);
        if (!std::is_sorted(begin, end)) // as several threads may have stored them
        {
          std::sort(begin, end);
        }
      }
    });
  return words;
}
}
