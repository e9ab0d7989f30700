// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * @brief Loads and stores 32 bit values of either byte order at any address.
 */
#ifndef camaron_Bytes_h
#define camaron_Bytes_h

#include <cstdint> // for integers of known size
#include <cstring> // for std::memcpy

namespace camaron
{
enum class ByteOrder
{
  Little,
  Big
};

/// The machine's own order.
inline ByteOrder GetByteOrder()
{
  const std::uint16_t probe = 1;
  unsigned char first;
  std::memcpy(&first, &probe, 1);
  return first == 1 ? ByteOrder::Little : ByteOrder::Big;
}

inline std::uint32_t SwapBytes(std::uint32_t v)
{
  return v >> 24 | (v >> 8 & 0xff00u) | (v << 8 & 0xff0000u) | v << 24;
}

/// Tells the processor that memory will be read soon. A wish, not a need.
inline void Prefetch(const void* memory)
{
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  (void)memory;
#endif
}

/// Loads a 4 byte value; @a swap when its byte order is not the machine's.
template <typename Value>
inline Value Load(const char* bytes, bool swap)
{
  static_assert(sizeof(Value) == 4, "4 byte values only");
  std::uint32_t word;
  std::memcpy(&word, bytes, 4);
  word = swap ? SwapBytes(word) : word;
  Value value;
  std::memcpy(&value, &word, 4);
  return value;
}

template <typename Value>
inline void Store(char* bytes, Value value, bool swap)
{
  static_assert(sizeof(Value) == 4, "4 byte values only");
  std::uint32_t word;
  std::memcpy(&word, &value, 4);
  word = swap ? SwapBytes(word) : word;
  std::memcpy(bytes, &word, 4);
}
}

#endif
