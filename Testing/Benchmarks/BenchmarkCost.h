// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkCost.h
 * @brief Time and memory that a piece of work takes, and the least that opening a file takes.
 */
#ifndef camaron_BenchmarkCost_h
#define camaron_BenchmarkCost_h

#include "Base/Buffer.h"
#include "Scan/MappedFile.h"

#include "vtkTimerLog.h"

#include <algorithm>  // for medians
#include <atomic>     // for the sampler of memory
#include <chrono>     // for the sampler of memory
#include <cstring>    // for touching memory
#include <ctime>      // for processor time
#include <filesystem> // for files
#include <fstream>    // for what the system says
#include <functional> // for work
#include <string>     // for what the system says
#include <thread>     // for the sampler of memory
#include <utility>    // for pairs of times
#include <vector>     // for medians

#if defined(__GLIBC__)
#include <malloc.h> // for giving memory back
#endif

namespace camaron
{
//------------------------------------------------------------------------------
/// Anonymous memory of the process in bytes; 0 where the system does not say.
inline double GetMemory()
{
  std::ifstream status("/proc/self/status");
  std::string key;
  while (status >> key)
  {
    if (key == "RssAnon:")
    {
      double kilobytes;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
/// What a piece of work costs.
struct Cost
{
  double Wall = 0;
  double Processor = 0;
  double Peak = 0; ///< bytes above what was there before
};

//------------------------------------------------------------------------------
/// Median time of several runs, and the peak of memory in one more, sampled meanwhile.
inline Cost Measure(const std::function<void()>& work)
{
  constexpr int Repetitions = 5;
  std::vector<std::pair<double, double>> times;
  for (int i = 0; i < Repetitions; ++i)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    const std::clock_t processor = std::clock();
    work();
    times.emplace_back(vtkTimerLog::GetUniversalTime() - start,
      static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  const double before = GetMemory();
  std::atomic<bool> done{ false };
  double peak = before;
  std::thread sampler(
    [&]
    {
      while (!done)
      {
        peak = std::max(peak, GetMemory());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  work();
  done = true;
  sampler.join();
  return { times[Repetitions / 2].first, times[Repetitions / 2].second, peak - before };
}

//------------------------------------------------------------------------------
/// The floor of opening a file: maps it and touches as much fresh memory as the mesh has.
inline void MapAndTouch(const std::filesystem::path& path, double mesh)
{
  MappedFile file;
  ScanError error;
  file.Open(path.string(), error);
  constexpr std::size_t Page = 4096;
  volatile char sum = 0;
  for (std::size_t i = 0; i < file.size(); i += Page)
  {
    sum = static_cast<char>(sum + file.begin()[i]);
  }
  Buffer<char> memory(static_cast<vtkIdType>(mesh));
  std::memset(memory.data(), 1, static_cast<std::size_t>(mesh));
}
}

#endif
