// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Several MPI ranks on a machine already share its cores. MPI launchers set environment variables.
bool IsOneOfManyRanks()
{
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS", "SLURM_NTASKS" })
  {
    const char* value = std::getenv(name);
    if (value && std::atoi(value) > 1)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Of this process, as far as the system tells: the third word of stat, after a name in parentheses.
int CountRunningThreads()
{
  int count = 0;
  std::error_code error;
  for (auto task = std::filesystem::directory_iterator("/proc/self/task", error);
    !error && task != std::filesystem::directory_iterator(); task.increment(error))
  {
    std::ifstream file(task->path() / "stat");
    std::string words;
    std::getline(file, words, '\0'); // empty if the thread ends meanwhile; an iterator would throw
    const std::size_t name = words.rfind(") ");
    count += name != std::string::npos && words[name + 2] == 'R';
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool NeedsThreads()
{
  static const bool allowed = !std::getenv("VTK_SMP_BACKEND_IN_USE") && !IsOneOfManyRanks();
  const char* backend = vtkSMPTools::GetBackend();
  return allowed && backend && std::strcmp(backend, "Sequential") == 0 &&
    !vtkSMPTools::IsParallelScope();
}

//------------------------------------------------------------------------------
void AwaitSleepingThreads()
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  while (CountRunningThreads() > 1 && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

//------------------------------------------------------------------------------
void AwaitSleepingThreadsAtExit()
{
  static const int registered = std::atexit(AwaitSleepingThreads);
  (void)registered;
}

//------------------------------------------------------------------------------
void WithThreads(FunctionRef<void()> function)
{
  if (!NeedsThreads())
  {
    function();
    return;
  }
  FirstException error; // LocalScope has to restore VTK's backend
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 0, "STDThread", false }, [&] { error.Catch(function); });
  error.Rethrow();
}

//------------------------------------------------------------------------------
void ParallelFor(vtkIdType size, vtkIdType grain, FunctionRef<void(vtkIdType, vtkIdType)> function)
{
  if (size <= grain)
  {
    if (size > 0)
    {
      function(0, size);
    }
    return;
  }
  FirstException error;
  // VTK orders the threads before and after the loop where ThreadSanitizer does not see it.
  std::atomic<int> order{ 0 };
  order.store(1, std::memory_order_release);
  WithThreads(
    [&]
    {
      // VTK passes every range from one thread to another, which may cost more than the range.
      constexpr vtkIdType MostPerThread = 32;
      const vtkIdType most = MostPerThread * vtkSMPTools::GetEstimatedNumberOfThreads();
      vtkSMPTools::For(0, size, grain > 0 ? std::max(grain, size / most) : 0,
        [&](vtkIdType begin, vtkIdType end)
        {
          order.load(std::memory_order_acquire);
          error.Catch([&] { function(begin, end); });
          order.fetch_add(1, std::memory_order_acq_rel);
        });
    });
  order.load(std::memory_order_acquire);
  AwaitSleepingThreadsAtExit(); // VTK's threads exist now, so they end later
  error.Rethrow();
}

//------------------------------------------------------------------------------
vtkIdType ParallelScan(vtkIdType size, vtkIdType chunk,
  FunctionRef<vtkIdType(vtkIdType, vtkIdType)> count, FunctionRef<void(vtkIdType)> prepare,
  FunctionRef<void(vtkIdType, vtkIdType, vtkIdType)> place)
{
  const vtkIdType numberOfChunks = (size + chunk - 1) / chunk;
  std::vector<vtkIdType> sums(numberOfChunks + 1, 0);
  const auto last = [=](vtkIdType c)
  { return c * chunk + chunk < size ? c * chunk + chunk : size; };
  ParallelForEach(numberOfChunks, 1, [&](vtkIdType c) { sums[c + 1] = count(c * chunk, last(c)); });
  for (vtkIdType c = 0; c < numberOfChunks; ++c)
  {
    sums[c + 1] += sums[c];
  }
  prepare(sums[numberOfChunks]);
  ParallelForEach(numberOfChunks, 1, [&](vtkIdType c) { place(c * chunk, last(c), sums[c]); });
  return sums[numberOfChunks];
}

//------------------------------------------------------------------------------
vtkIdType ParallelScan(vtkIdType size, vtkIdType chunk,
  FunctionRef<vtkIdType(vtkIdType, vtkIdType)> count,
  FunctionRef<void(vtkIdType, vtkIdType, vtkIdType)> place)
{
  return ParallelScan(size, chunk, count, [](vtkIdType) {}, place);
}
}
