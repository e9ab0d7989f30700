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

#include "vtkSMPTools.h"
#include "vtkTimerLog.h"
#include "vtkVersion.h"

#include <algorithm>  // for medians
#include <atomic>     // for the sampler of memory
#include <chrono>     // for the sampler of memory
#include <cstdio>     // for records
#include <cstdlib>    // for records
#include <cstring>    // for touching memory
#include <ctime>      // for processor time
#include <filesystem> // for files
#include <fstream>    // for what the system says
#include <functional> // for work
#include <string>     // for what the system says
#include <thread>     // for the sampler of memory
#include <tuple>      // for times
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
struct Measurement
{
  double Wall = 0; ///< of the median run
  double Processor = 0;
  double Peak = 0;                              ///< bytes above what was there before
  std::vector<std::pair<double, double>> Times; ///< wall and processor of all runs, sorted
};

//------------------------------------------------------------------------------
/// Peak of anonymous memory while @a work runs, above what was there before.
inline double MeasurePeak(const std::function<void()>& work)
{
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
  return peak - before;
}

//------------------------------------------------------------------------------
/// Memory of one run, and the median time of five more; of fewer once they have taken a minute.
inline Measurement Measure(const std::function<void()>& work)
{
  constexpr std::size_t Repetitions = 5;
  constexpr double Enough = 60;
  Measurement cost;
  cost.Peak = MeasurePeak(work);
  for (double spent = 0; cost.Times.size() < Repetitions && spent < Enough;)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    const std::clock_t processor = std::clock();
    work();
    cost.Times.emplace_back(vtkTimerLog::GetUniversalTime() - start,
      static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
    spent += cost.Times.back().first;
  }
  std::sort(cost.Times.begin(), cost.Times.end());
  std::tie(cost.Wall, cost.Processor) = cost.Times[cost.Times.size() / 2];
  return cost;
}

//------------------------------------------------------------------------------
/// Our name in records; every other name is that of a peer.
constexpr char Ours[] = "Camarón";

//------------------------------------------------------------------------------
/// Adds a line of JSON about a measurement to the file that CAMARON_BENCHMARK_RECORDS names, for
/// report.py, which compares records of the same work and mesh. @a size is that of the result in
/// bytes, or 0.
inline void Record(const std::string& work, const std::string& mesh, const std::string& by,
  double cells, const Measurement& cost, double size = 0)
{
  const char* const path = std::getenv("CAMARON_BENCHMARK_RECORDS");
  std::FILE* const file = path ? std::fopen(path, "a") : nullptr;
  if (!file)
  {
    return;
  }
  std::fprintf(file,
    "{\"work\": \"%s\", \"mesh\": \"%s\", \"by\": \"%s\", \"cells\": %.0f, \"peak\": %.0f, "
    "\"size\": %.0f, \"threads\": %d, \"backend\": \"%s\", \"vtk\": \"%s\", \"times\": [",
    work.c_str(), mesh.c_str(), by.c_str(), cells, cost.Peak, size,
    vtkSMPTools::GetEstimatedNumberOfThreads(), vtkSMPTools::GetBackend(),
    vtkVersion::GetVTKVersion());
  for (const auto& [wall, processor] : cost.Times)
  {
    std::fprintf(
      file, "%s[%.4g, %.4g]", &wall == &cost.Times[0].first ? "" : ", ", wall, processor);
  }
  std::fprintf(file, "]}\n");
  std::fclose(file);
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
