// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TeamReducer.h
 * @brief Processes of a parallel run as threads that wait for each other.
 */
#ifndef camaron_TeamReducer_h
#define camaron_TeamReducer_h

#include "Ranks/Reducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <utility>
#include <vector>

namespace camaron
{
namespace testing
{
class Team
{
public:
  explicit Team(int size)
    : Size(size)
    , Slots(size)
  {
  }

  // Every process calls it with its bytes and gets those of all.
  std::vector<std::vector<char>> Exchange(int process, const std::vector<char>& bytes)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Slots[process] = bytes;
    this->Wait(lock);
    const std::vector<std::vector<char>> all = this->Slots;
    this->Wait(lock);
    return all;
  }

  const int Size;

private:
  void Wait(std::unique_lock<std::mutex>& lock)
  {
    const int generation = this->Generation;
    if (++this->Waiting == this->Size)
    {
      this->Waiting = 0;
      ++this->Generation;
      this->Condition.notify_all();
    }
    this->Condition.wait(lock, [&] { return generation != this->Generation; });
  }

  std::vector<std::vector<char>> Slots;
  std::mutex Mutex;
  std::condition_variable Condition;
  int Waiting = 0;
  int Generation = 0;
};

class TeamReducer : public Reducer
{
public:
  TeamReducer(Team& team, int process)
    : Processes(team)
    , Process(process)
  {
  }
  int GetNumberOfProcesses() const override { return this->Processes.Size; }
  int GetProcess() const override { return this->Process; }
  void Sum(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return a + b; });
  }
  void Min(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return std::min(a, b); });
  }
  void Max(std::int64_t* values, std::size_t size) override
  {
    this->Combine(values, size, [](std::int64_t a, std::int64_t b) { return std::max(a, b); });
  }
  std::vector<char> Gather(const std::vector<char>& bytes, std::vector<std::size_t>& sizes) override
  {
    std::vector<char> result;
    sizes.clear();
    for (const std::vector<char>& part : this->Processes.Exchange(this->Process, bytes))
    {
      sizes.push_back(part.size());
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  std::vector<std::vector<char>> Exchange(std::vector<std::vector<char>>&& lists) override
  {
    // All hear all lists, one receiver after the other, and keep what is theirs.
    std::vector<std::vector<char>> received;
    for (int receiver = 0; receiver < this->Processes.Size; ++receiver)
    {
      const auto all = this->Processes.Exchange(this->Process, lists[receiver]);
      received = receiver == this->Process ? all : received;
    }
    return received;
  }

private:
  template <typename Operation>
  void Combine(std::int64_t* values, std::size_t size, Operation&& operation)
  {
    const char* begin = reinterpret_cast<const char*>(values);
    const auto all =
      this->Processes.Exchange(this->Process, { begin, begin + size * sizeof(*values) });
    for (int process = 0; process < this->Processes.Size; ++process)
    {
      ASSERT_EQ(all[process].size(), size * sizeof(*values)) << "processes do not agree";
      for (std::size_t i = 0; i < size; ++i)
      {
        std::int64_t other;
        std::memcpy(&other, all[process].data() + i * sizeof(other), sizeof(other));
        values[i] = process == 0 ? other : operation(values[i], other);
      }
    }
  }

  Team& Processes;
  int Process;
};
}
}

#endif
