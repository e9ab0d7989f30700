// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Buffer.h"

#include <cstdint>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace camaron
{
//------------------------------------------------------------------------------
void* AllocateLarge(std::size_t bytes)
{
#if defined(__linux__)
  constexpr std::size_t HugePage = std::size_t(1) << 21; // on x86-64 and most ARM systems
  if (bytes >= 2 * HugePage)
  {
    // Use the last huge page if it is nearly full, otherwise small pages, to waste little memory.
    const std::size_t rest = bytes % HugePage;
    const std::size_t size = rest >= HugePage / 4 * 3 ? bytes - rest + HugePage : bytes;
    void* memory = nullptr;
    if (posix_memalign(&memory, HugePage, size) != 0)
    {
      throw std::bad_alloc();
    }
    madvise(memory, size / HugePage * HugePage, MADV_HUGEPAGE); // a hint that may fail
    return memory;
  }
#endif
  void* memory = std::malloc(bytes > 0 ? bytes : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

//------------------------------------------------------------------------------
void FreeLarge(void* memory)
{
  std::free(memory);
}
}
