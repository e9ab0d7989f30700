// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/FileStates.h"

#include "Base/Hash.h"
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>

#include <unistd.h>

namespace camaron
{
namespace
{
thread_local FileStates* Current = nullptr;

//------------------------------------------------------------------------------
std::uint64_t Hash(std::initializer_list<long long> values)
{
  std::uint64_t hash = 0;
  for (const long long value : values)
  {
    hash = MixHash(hash, static_cast<std::uint64_t>(value));
  }
  return hash;
}

//------------------------------------------------------------------------------
long long GetHost()
{
  char name[256] = {};
  gethostname(name, sizeof(name) - 1);
  return static_cast<long long>(std::hash<std::string>()(name));
}

//------------------------------------------------------------------------------
void AddTo(long long& sum, std::uint64_t value)
{
  sum = static_cast<long long>(static_cast<std::uint64_t>(sum) + value);
}
}

//------------------------------------------------------------------------------
FileStates::FileStates()
{
  Current = this;
}

//------------------------------------------------------------------------------
FileStates::~FileStates()
{
  Current = nullptr;
}

//------------------------------------------------------------------------------
void FileStates::Add(const std::string& path, const File& file)
{
  if (Current)
  {
    Current->Paths.push_back(path);
    State& sum = Current->Sum;
    AddTo(sum.Place, Hash({ GetHost(), file.Device }));
    AddTo(sum.Size, Hash({ file.Size }));
    AddTo(sum.Identity, Hash({ file.Node, file.Seconds, file.Nanoseconds }));
  }
}

//------------------------------------------------------------------------------
bool FileStates::AreSame(const std::vector<State>& states)
{
  std::map<long long, long long> identities; // by place
  for (const State& state : states)
  {
    const auto known = identities.emplace(state.Place, state.Identity).first;
    if (state.Size != states.front().Size || state.Identity != known->second)
    {
      return false;
    }
  }
  return true;
}
}
