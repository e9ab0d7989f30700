// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShortNumbers.h
 * @brief Fast parser of lists of ids, which are numbers with few digits.
 *
 * Parsing one number after the other makes the processor wait, because the next number begins
 * where the previous one ends. Instead, the digits among many characters are found at once.
 */
#ifndef camaron_ShortNumbers_h
#define camaron_ShortNumbers_h

#include <cstddef> // for std::ptrdiff_t
#include <cstdint> // for integers of known size
#include <cstring> // for std::memcpy

#if defined(__SSE2__)
#include <emmintrin.h> // for 16 characters at once
#endif

namespace camaron
{
namespace detail
{
constexpr std::uint64_t EveryByte = 0x0101010101010101u;

/// Characters minus '0', so that digits are bytes below ten.
inline std::uint64_t LoadDigits(const char* p)
{
  std::uint64_t word;
  std::memcpy(&word, p, sizeof(word));
  return word ^ EveryByte * '0';
}

/// Bit i is set if the i-th of 16 characters is a digit. Without SSE2, digits after a non-ASCII
/// character may be missing.
inline std::uint32_t FindDigits(const char* p)
{
#if defined(__SSE2__)
  const __m128i characters = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
  const __m128i digits = _mm_sub_epi8(characters, _mm_set1_epi8('0'));
  return static_cast<std::uint32_t>(
    _mm_movemask_epi8(_mm_cmpeq_epi8(_mm_min_epu8(digits, _mm_set1_epi8(9)), digits)));
#else
  std::uint32_t found = 0;
  for (int i = 0; i < 16; i += 8)
  {
    const std::uint64_t word = LoadDigits(p + i);
    const std::uint64_t others = ((word + EveryByte * (0x80 - 10)) | word) & (EveryByte * 0x80);
    // Moves bit 7 of byte k to bit 56 + k.
    found |= (static_cast<std::uint32_t>(others * 0x0002040810204081u >> 56) ^ 0xff) << i;
  }
  return found;
#endif
}

/// The number with this many digits, 1 to 8, at the start of a word of digits.
inline std::int32_t ToNumber(std::uint64_t word, int digits)
{
  // With leading zeros, adjacent bytes combine to numbers of two, four and eight digits.
  constexpr std::uint64_t EveryFourth = 0x000000ff000000ffu;
  word <<= 64 - 8 * digits;
  word = word * 10 + (word >> 8);
  word = (word & EveryFourth) * ((std::uint64_t(1000000) << 32) + 100) +
    (word >> 16 & EveryFourth) * ((std::uint64_t(10000) << 32) + 1);
  return static_cast<std::int32_t>(word >> 32);
}
}

/**
 * Reads numbers of at most 8 digits, each after one blank and before a blank or a line feed.
 * Returns the number of numbers read, and moves @a text behind them. Stops at anything else, at
 * numbers not below @a limit, and at the last characters of the text; reads nothing on machines
 * with unknown byte order.
 */
inline std::int32_t ReadShortNumbers(
  const char*& text, const char* end, std::int32_t count, std::int64_t limit, std::int32_t* numbers)
{
  std::int32_t read = 0;
#if defined(__GNUC__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  constexpr int Width = 8, Half = 16, Window = 2 * Half;
  while (read < count && end - text >= Window + Width && *text == ' ')
  {
    const std::uint32_t digits = detail::FindDigits(text) | detail::FindDigits(text + Half) << Half;
    const char* const begin = text;
    const char* place = text;            // a blank
    std::uint32_t others = ~digits >> 1; // characters after the blank, as far as they are in the
                                         // window
    while (read < count && others != 0)
    {
      const int size = __builtin_ctz(others);
      if (static_cast<unsigned int>(size - 1) >= Width)
      {
        return read;
      }
      const std::int32_t number = detail::ToNumber(detail::LoadDigits(place + 1), size);
      const char* const next = place + size + 1;
      if (number >= limit || (*next != ' ' && *next != '\n'))
      {
        return read;
      }
      numbers[read++] = number;
      place = text = next;
      if (*next != ' ')
      {
        return read;
      }
      others >>= size + 1;
    }
    if (text == begin)
    {
      return read;
    }
  }
#else
  (void)text;
  (void)end;
  (void)count;
  (void)limit;
  (void)numbers;
#endif
  return read;
}
}

#endif
