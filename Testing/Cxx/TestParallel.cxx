// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Parallel.h"
#include "Base/Progress.h"
#include "Base/Text.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

using namespace camaron;

namespace
{
constexpr vtkIdType NumberOfItems = 1000;

void FailInTheMiddle(vtkIdType begin, vtkIdType end)
{
  if (begin <= NumberOfItems / 2 && NumberOfItems / 2 < end)
  {
    throw std::runtime_error("middle");
  }
}
}

//------------------------------------------------------------------------------
// If this fails, a lack of memory in a thread ends ParaView instead of the filter.
TEST(Parallel, ExceptionsOfThreads)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 4, "STDThread", false },
    []
    {
      for (const vtkIdType grain : { 0, 1, 10 })
      {
        EXPECT_THROW(ParallelFor(NumberOfItems, grain, FailInTheMiddle), std::runtime_error);
      }
      EXPECT_THROW(Progress().For(NumberOfItems, FailInTheMiddle), std::runtime_error);
      EXPECT_THROW(ParallelForEach(NumberOfItems, 1, [](vtkIdType) { throw std::bad_alloc(); }),
        std::bad_alloc);
    });
}

//------------------------------------------------------------------------------
// Whoever catches the exception goes on with the backend of before.
TEST(Parallel, BackendAfterAnException)
{
  const std::string before = vtkSMPTools::GetBackend();
  EXPECT_THROW(WithThreads([] { throw std::runtime_error("inside"); }), std::runtime_error);
  EXPECT_EQ(before, vtkSMPTools::GetBackend());
}

//------------------------------------------------------------------------------
// If this fails, processes hang when they end: rarely, but for ever.
TEST(Parallel, AwaitSleepingThreads)
{
  if (!std::filesystem::exists("/proc/self/task"))
  {
    GTEST_SKIP() << "this system does not tell which threads run";
  }
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::milliseconds(20);
  std::atomic<bool> isDone{ false };
  std::thread busy(
    [&]
    {
      while (Clock::now() < end)
      {
      }
      isDone = true;
    });
  AwaitSleepingThreads();
  EXPECT_TRUE(isDone);
  busy.join();
}

//------------------------------------------------------------------------------
TEST(Parallel, Reasons)
{
  EXPECT_EQ(GetReason(std::runtime_error("words")), "words");
  EXPECT_EQ(GetReason(std::bad_alloc()), "there is not enough memory");
}
