// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Parallel.h
 * @brief Multithreaded loops with vtkSMPTools, even if ParaView was built to run them sequentially.
 *
 * Some packages of ParaView select VTK's Sequential backend although STDThread is compiled in.
 * Unless the user selected a backend (VTK_SMP_BACKEND_IN_USE) or called vtkSMPTools::SetBackend
 * with another one, these loops run on STDThread with one thread per core or VTK_SMP_MAX_THREADS.
 * With more than one MPI rank, VTK's choice is kept, because the ranks already share the cores.
 */
#ifndef camaron_Parallel_h
#define camaron_Parallel_h

#include "Base/FunctionRef.h" // for parameters

#include "vtkType.h" // for vtkIdType

#include <atomic>    // for values that several threads lower
#include <exception> // for errors in threads
#include <mutex>     // for errors in threads

namespace camaron
{
/// Grains of loops and sizes of chunks, by what an item takes: a copy, a look into some lists, or a
/// computation.
constexpr vtkIdType LightGrain = 1 << 16;
constexpr vtkIdType MediumGrain = 1 << 12;
constexpr vtkIdType HeavyGrain = 1 << 10;

/// Whether loops should run on STDThread although VTK's current backend is Sequential.
bool NeedsThreads();

/**
 * Returns when no other thread runs, or after 0.5 s. When a process ends, VTK (9.3 and later) waits
 * forever for a thread that was just about to sleep when it told its threads to end: one of some
 * thousand processes with short loops.
 */
void AwaitSleepingThreads();

/// Calls AwaitSleepingThreads when the process ends.
void AwaitSleepingThreadsAtExit();

/// Keeps the first exception of functions that run in code through which no exception may pass: in
/// a thread, it would end the process.
class FirstException
{
public:
  template <typename Function>
  void Catch(Function&& function)
  {
    try
    {
      function();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Exception = this->Exception ? this->Exception : std::current_exception();
    }
  }
  void Rethrow() const
  {
    if (this->Exception)
    {
      std::rethrow_exception(this->Exception);
    }
  }

private:
  std::exception_ptr Exception;
  std::mutex Mutex;
};

/// Calls @a function(), in which vtkSMPTools uses threads as described above.
void WithThreads(FunctionRef<void()> function);

/// Calls @a function(begin, end) for ranges of [0, size); @a grain is their minimum size, or 0 to
/// let VTK choose. Rethrows the first exception of the calls.
void ParallelFor(vtkIdType size, vtkIdType grain, FunctionRef<void(vtkIdType, vtkIdType)> function);

/// Calls @a function(i) for i in [0, size); @a grain as in ParallelFor.
template <typename Function>
void ParallelForEach(vtkIdType size, vtkIdType grain, Function&& function)
{
  ParallelFor(size, grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        function(i);
      }
    });
}

/**
 * Exclusive prefix sum over fixed chunks: calls @a count(begin, end) for the sum of each chunk,
 * @a prepare(total), then @a place(begin, end, sumBefore) for each chunk.
 * @return the total
 */
vtkIdType ParallelScan(vtkIdType size, vtkIdType chunk,
  FunctionRef<vtkIdType(vtkIdType, vtkIdType)> count, FunctionRef<void(vtkIdType)> prepare,
  FunctionRef<void(vtkIdType, vtkIdType, vtkIdType)> place);

/// The same without a preparation.
vtkIdType ParallelScan(vtkIdType size, vtkIdType chunk,
  FunctionRef<vtkIdType(vtkIdType, vtkIdType)> count,
  FunctionRef<void(vtkIdType, vtkIdType, vtkIdType)> place);

/// Replaces a value by a lower one. Thread-safe; other memory is not ordered by it.
template <typename Value>
void LowerTo(std::atomic<Value>& least, Value value)
{
  Value current = least.load(std::memory_order_relaxed);
  while (value < current && !least.compare_exchange_weak(current, value, std::memory_order_relaxed))
  {
  }
}
}

#endif
