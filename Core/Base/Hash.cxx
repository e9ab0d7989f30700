// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Hash.h"

#include "Base/Parallel.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace camaron
{
namespace
{
constexpr vtkIdType BlockSize = 1 << 20; // bytes

//------------------------------------------------------------------------------
// In four lanes, which the processor computes at the same time.
std::uint64_t HashBytes(const unsigned char* bytes, vtkIdType size, std::uint64_t seed)
{
  std::uint64_t lanes[4] = { seed, seed + 1, seed + 2, seed + 3 };
  std::uint64_t words[4];
  for (; size >= static_cast<vtkIdType>(sizeof(words));
    size -= sizeof(words), bytes += sizeof(words))
  {
    std::memcpy(words, bytes, sizeof(words));
    for (int i = 0; i < 4; ++i)
    {
      lanes[i] = MixHash(lanes[i], words[i]);
    }
  }
  std::memset(words, 0, sizeof(words));
  std::memcpy(words, bytes, static_cast<std::size_t>(size));
  std::uint64_t hash = MixHash(seed, static_cast<std::uint64_t>(size));
  for (int i = 0; i < 4; ++i)
  {
    hash = MixHash(hash, MixHash(lanes[i], words[i]));
  }
  return hash;
}
}

//------------------------------------------------------------------------------
std::uint64_t HashContent(vtkDataArray* array, std::uint64_t seed)
{
  std::uint64_t hash = MixHash(seed, static_cast<std::uint64_t>(array->GetNumberOfValues()));
  if (!array->HasStandardMemoryLayout())
  {
    return hash;
  }
  const auto* const bytes = static_cast<const unsigned char*>(array->GetVoidPointer(0));
  const vtkIdType size = array->GetNumberOfValues() * array->GetDataTypeSize();
  std::atomic<std::uint64_t> sum{ 0 }; // so that the order of blocks does not matter
  ParallelFor((size + BlockSize - 1) / BlockSize, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const vtkIdType first = block * BlockSize;
        sum += HashBytes(bytes + first, std::min(BlockSize, size - first), MixHash(hash, block));
      }
    });
  return MixHash(hash, sum);
}
}
