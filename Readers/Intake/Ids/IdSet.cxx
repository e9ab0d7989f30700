// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Ids/IdSet.h"

namespace camaron
{
//------------------------------------------------------------------------------
void IdSet::AddMissing(const IdSet& other)
{
  for (std::size_t w = 0; w < this->Words.size(); ++w)
  {
    std::uint64_t missing = ~other.Words[w].load(std::memory_order_relaxed);
    if (w + 1 == this->Words.size() && this->Limit % 64 != 0)
    {
      missing &= (std::uint64_t(1) << this->Limit % 64) - 1;
    }
    this->Words[w].fetch_or(missing, std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
void IdSet::AddAll(const IdSet& other)
{
  for (std::size_t w = 0; w < this->Words.size(); ++w)
  {
    this->Words[w].fetch_or(
      other.Words[w].load(std::memory_order_relaxed), std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
vtkIdType IdSet::Number()
{
  this->Before.resize(this->Words.size());
  this->Members = 0;
  for (std::size_t w = 0; w < this->Words.size(); ++w)
  {
    this->Before[w] = static_cast<std::uint32_t>(this->Members);
    this->Members += CountBits(this->Words[w].load(std::memory_order_relaxed));
  }
  return this->Members;
}

//------------------------------------------------------------------------------
std::vector<std::int32_t> IdSet::GetMembers() const
{
  std::vector<std::int32_t> members;
  members.reserve(static_cast<std::size_t>(this->Members));
  for (vtkIdType id = 0; id < this->Limit; ++id)
  {
    const std::uint64_t rest = this->Words[id >> 6].load(std::memory_order_relaxed) >> (id & 63);
    if (rest == 0)
    {
      id |= 63;
    }
    else if (rest & 1)
    {
      members.push_back(static_cast<std::int32_t>(id));
    }
  }
  return members;
}
}
