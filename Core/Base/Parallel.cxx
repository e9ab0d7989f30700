// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>

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
    const std::string words(std::istreambuf_iterator<char>(file), {});
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
}
