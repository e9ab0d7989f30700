// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * @brief Loads and stores values of either byte order at any address.
 */
#ifndef camaron_Bytes_h
#define camaron_Bytes_h

#include <cstddef> // for std::ptrdiff_t
#include <cstdint> // for integers of known size
#include <cstring> // for std::memcpy
#include <string>  // for bytes to append to

namespace camaron
{
enum class ByteOrder
{
  Little,
  Big
};

/// The byte order of this machine.
inline ByteOrder GetByteOrder()
{
  const std::uint16_t probe = 1;
  unsigned char first;
  std::memcpy(&first, &probe, 1);
  return first == 1 ? ByteOrder::Little : ByteOrder::Big;
}

inline std::uint8_t SwapBytes(std::uint8_t v)
{
  return v;
}
inline std::uint16_t SwapBytes(std::uint16_t v)
{
  return static_cast<std::uint16_t>(v >> 8 | v << 8);
}
#if defined(__GNUC__)
// One instruction, always inline.
inline std::uint32_t SwapBytes(std::uint32_t v)
{
  return __builtin_bswap32(v);
}
inline std::uint64_t SwapBytes(std::uint64_t v)
{
  return __builtin_bswap64(v);
}
#else
inline std::uint32_t SwapBytes(std::uint32_t v)
{
  return v >> 24 | (v >> 8 & 0xff00u) | (v << 8 & 0xff0000u) | v << 24;
}
inline std::uint64_t SwapBytes(std::uint64_t v)
{
  return std::uint64_t(SwapBytes(static_cast<std::uint32_t>(v))) << 32 |
    SwapBytes(static_cast<std::uint32_t>(v >> 32));
}
#endif

namespace detail
{
/// The unsigned integer with this number of bytes.
template <std::size_t Size>
struct WordOf;
template <>
struct WordOf<1>
{
  using Type = std::uint8_t;
};
template <>
struct WordOf<2>
{
  using Type = std::uint16_t;
};
template <>
struct WordOf<4>
{
  using Type = std::uint32_t;
};
template <>
struct WordOf<8>
{
  using Type = std::uint64_t;
};
}

/// Hints the processor that memory will be read soon.
inline void Prefetch(const void* memory)
{
#if defined(__GNUC__)
  __builtin_prefetch(memory);
#else
  (void)memory;
#endif
}

/// Loads a value of 1, 2, 4 or 8 bytes; @a swap if its byte order is not that of the machine.
template <typename Value>
inline Value Load(const char* bytes, bool swap)
{
  typename detail::WordOf<sizeof(Value)>::Type word;
  std::memcpy(&word, bytes, sizeof(Value));
  word = swap ? SwapBytes(word) : word;
  Value value;
  std::memcpy(&value, &word, sizeof(Value));
  return value;
}

template <typename Value>
inline void Store(char* bytes, Value value, bool swap)
{
  typename detail::WordOf<sizeof(Value)>::Type word;
  std::memcpy(&word, &value, sizeof(Value));
  word = swap ? SwapBytes(word) : word;
  std::memcpy(bytes, &word, sizeof(Value));
}

/// A value at any address, in the byte order of the machine.
template <typename Value>
struct Unaligned
{
  char Bytes[sizeof(Value)];
  operator Value() const { return Load<Value>(this->Bytes, false); }
};

/// Appends the bytes of the values get(0) to get(count - 1), converted to a type: faster than one
/// by one.
template <typename Value, typename Get>
inline void AppendBytes(std::string& bytes, std::ptrdiff_t count, Get&& get, bool swap)
{
  const std::size_t before = bytes.size();
  bytes.resize(before + static_cast<std::size_t>(count) * sizeof(Value));
  char* to = &bytes[before];
  for (std::ptrdiff_t i = 0; i < count; ++i)
  {
    Store(to, static_cast<Value>(get(i)), swap);
    to += sizeof(Value);
  }
}

/// Appends the bytes of a value.
template <typename Value>
inline void AppendBytes(std::string& bytes, Value value, bool swap)
{
  AppendBytes<Value>(bytes, 1, [value](std::ptrdiff_t) { return value; }, swap);
}

/// Puts the bytes of numbers together of which @a from has all first ones, then all second ones,
/// and so on; numbers that are neither 2, 4 nor 8 bytes long are copied.
template <int Size = 0>
void Unshuffle(const char* from, std::ptrdiff_t bytes, int size, char* to)
{
  if constexpr (Size == 0)
  {
    const auto unshuffle = size == 2 ? Unshuffle<2>
      : size == 4                    ? Unshuffle<4>
      : size == 8                    ? Unshuffle<8>
                                     : Unshuffle<1>;
    return unshuffle(from, bytes, size, to);
  }
  else
  {
    const std::ptrdiff_t count = bytes / Size;
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      for (int byte = 0; byte < Size; ++byte)
      {
        to[i * Size + byte] = from[byte * count + i];
      }
    }
  }
}
}

#endif
