// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/Buffer.h"

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
  constexpr std::size_t HugePage = std::size_t(1) << 21; // of x86-64 and of most ARM systems
  if (bytes >= 2 * HugePage)
  {
    void* memory = nullptr;
    if (posix_memalign(&memory, HugePage, bytes) != 0)
    {
      throw std::bad_alloc();
    }
    // Whole huge pages only, so that the rest of the last one is not paid for. A wish, not a need.
    madvise(memory, bytes / HugePage * HugePage, MADV_HUGEPAGE);
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
