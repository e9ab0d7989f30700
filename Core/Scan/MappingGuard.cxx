// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/MappingGuard.h"

#if !defined(_WIN32)
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <sys/mman.h>
#endif

namespace camaron
{
#if defined(_WIN32)
//------------------------------------------------------------------------------
bool MappingGuard::Enter(void*, std::size_t)
{
  return false; // nothing is mapped there
}
void MappingGuard::Leave() {}
bool MappingGuard::IsLost() const
{
  return false;
}
#else
namespace
{
/// A guarded mapping; unused while Begin is 0. The signal handler takes no locks.
struct Place
{
  std::atomic<std::uintptr_t> Begin{ 0 };
  std::atomic<std::uintptr_t> End{ 0 };
  std::atomic<bool> Lost{ false };
};
constexpr int NumberOfPlaces = 64; // files read at the same time; further files are copied
Place Places[NumberOfPlaces];

std::mutex Mutex; // protects the following members
int NumberOfGuards = 0;
bool IsInstalled = false;
struct sigaction Previous; // constant while this handler is installed

//------------------------------------------------------------------------------
bool Replace(const void* address)
{
  const auto fault = reinterpret_cast<std::uintptr_t>(address);
  for (Place& place : Places)
  {
    const std::uintptr_t begin = place.Begin.load();
    const std::uintptr_t end = place.End.load();
    if (begin != 0 && begin <= fault && fault < end)
    {
      // All of it, so that the contents do not change again.
      place.Lost = true;
      return mmap(reinterpret_cast<void*>(begin), end - begin, PROT_READ,
               MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) != MAP_FAILED;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void OnBusError(int signal, siginfo_t* info, void* context)
{
  const int before = errno;
  const bool isOurs = Replace(info->si_addr);
  errno = before;
  if (isOurs)
  {
    return;
  }
  if (Previous.sa_flags & SA_SIGINFO)
  {
    Previous.sa_sigaction(signal, info, context);
  }
  else if (Previous.sa_handler == SIG_DFL || Previous.sa_handler == SIG_IGN)
  {
    // Ends the process when the access is repeated, as without this handler.
    sigaction(SIGBUS, &Previous, nullptr);
    if (info->si_code <= 0) // sent by a process
    {
      raise(signal);
    }
  }
  else
  {
    Previous.sa_handler(signal);
  }
}

//------------------------------------------------------------------------------
bool IsCurrent()
{
  struct sigaction current;
  return sigaction(SIGBUS, nullptr, &current) == 0 && (current.sa_flags & SA_SIGINFO) &&
    current.sa_sigaction == OnBusError;
}

//------------------------------------------------------------------------------
bool Install()
{
  if (IsInstalled)
  {
    return IsCurrent();
  }
  struct sigaction ours = {};
  ours.sa_sigaction = OnBusError;
  ours.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&ours.sa_mask);
  IsInstalled =
    sigaction(SIGBUS, nullptr, &Previous) == 0 && sigaction(SIGBUS, &ours, nullptr) == 0;
  return IsInstalled;
}
}

//------------------------------------------------------------------------------
bool MappingGuard::Enter(void* mapping, std::size_t size)
{
  this->Leave();
  const std::lock_guard<std::mutex> lock(Mutex);
  int slot = 0;
  while (slot < NumberOfPlaces && Places[slot].Begin != 0)
  {
    ++slot;
  }
  if (slot == NumberOfPlaces || !Install())
  {
    return false;
  }
  ++NumberOfGuards;
  this->Slot = slot;
  Place& place = Places[slot];
  place.Lost = false;
  place.End = reinterpret_cast<std::uintptr_t>(mapping) + size;
  place.Begin = reinterpret_cast<std::uintptr_t>(mapping);
  return true;
}

//------------------------------------------------------------------------------
void MappingGuard::Leave()
{
  if (this->Slot < 0)
  {
    return;
  }
  const std::lock_guard<std::mutex> lock(Mutex);
  Places[this->Slot].Begin = 0;
  this->Slot = -1;
  // A handler that is no longer the current one may still be called by that one.
  if (--NumberOfGuards == 0 && IsCurrent() && sigaction(SIGBUS, &Previous, nullptr) == 0)
  {
    IsInstalled = false;
  }
}

//------------------------------------------------------------------------------
bool MappingGuard::IsLost() const
{
  return this->Slot >= 0 && Places[this->Slot].Lost;
}
#endif
}
