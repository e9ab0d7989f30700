// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationMeter.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace
{
std::atomic<long long> InUse{ 0 };
std::atomic<long long> Peak{ 0 };
std::atomic<std::size_t> LargestRequest{ 0 };

//------------------------------------------------------------------------------
template <typename Number>
void Raise(std::atomic<Number>& maximum, Number value)
{
  Number seen = maximum.load(std::memory_order_relaxed);
  while (seen < value && !maximum.compare_exchange_weak(seen, value))
  {
  }
}

//------------------------------------------------------------------------------
void Gain(std::size_t bytes)
{
  const long long gained = static_cast<long long>(bytes);
  Raise(Peak, InUse.fetch_add(gained) + gained);
}
void Lose(std::size_t bytes)
{
  InUse -= static_cast<long long>(bytes);
}
}

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/allocator_interface.h>

namespace
{
constexpr bool Measures = true;

//------------------------------------------------------------------------------
void OnAllocation(const volatile void*, std::size_t bytes)
{
  Raise(LargestRequest, bytes);
  Gain(bytes);
}
void OnFree(const volatile void* memory)
{
  if (memory)
  {
    Lose(__sanitizer_get_allocated_size(const_cast<const void*>(memory)));
  }
}
const int Hooks = __sanitizer_install_malloc_and_free_hooks(OnAllocation, OnFree);
}

#elif defined(__GLIBC__)
#include <malloc.h>

namespace
{
constexpr bool Measures = true;
}

// glibc's names of the functions replaced here.
extern "C"
{
  void* __libc_malloc(std::size_t);
  void* __libc_calloc(std::size_t, std::size_t);
  void* __libc_realloc(void*, std::size_t);
  void* __libc_memalign(std::size_t, std::size_t);
  void __libc_free(void*);

  void* malloc(std::size_t bytes)
  {
    Raise(LargestRequest, bytes);
    void* memory = __libc_malloc(bytes);
    Gain(malloc_usable_size(memory));
    return memory;
  }
  void* calloc(std::size_t count, std::size_t bytes)
  {
    Raise(LargestRequest, count * bytes);
    void* memory = __libc_calloc(count, bytes);
    Gain(malloc_usable_size(memory));
    return memory;
  }
  void* realloc(void* old, std::size_t bytes)
  {
    Raise(LargestRequest, bytes);
    const std::size_t before = malloc_usable_size(old);
    void* memory = __libc_realloc(old, bytes);
    if (memory || bytes == 0)
    {
      Lose(before);
      Gain(malloc_usable_size(memory));
    }
    return memory;
  }
  void* memalign(std::size_t alignment, std::size_t bytes)
  {
    Raise(LargestRequest, bytes);
    void* memory = __libc_memalign(alignment, bytes);
    Gain(malloc_usable_size(memory));
    return memory;
  }
  void* aligned_alloc(std::size_t alignment, std::size_t bytes)
  {
    return memalign(alignment, bytes);
  }
  int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes)
  {
    *memory = memalign(alignment, bytes);
    return *memory ? 0 : ENOMEM;
  }
  void free(void* memory)
  {
    Lose(malloc_usable_size(memory));
    __libc_free(memory);
  }
}

#else
namespace
{
constexpr bool Measures = false;
}
#endif

namespace camaron
{
namespace testing
{
//------------------------------------------------------------------------------
AllocationMeter::AllocationMeter()
  : Before(InUse)
{
  Peak = this->Before;
  LargestRequest = 0;
}

//------------------------------------------------------------------------------
bool AllocationMeter::IsAvailable()
{
  return Measures;
}

//------------------------------------------------------------------------------
std::size_t AllocationMeter::GetPeak() const
{
  return static_cast<std::size_t>(std::max(Peak - this->Before, 0LL));
}

//------------------------------------------------------------------------------
std::size_t AllocationMeter::GetLargestRequest() const
{
  return LargestRequest;
}
}
}
