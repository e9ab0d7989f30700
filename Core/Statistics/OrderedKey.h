// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OrderedKey.h
 * @brief Integer keys with the order of doubles: -Inf < ... < 0 < ... < +Inf, where -0 equals 0.
 */
#ifndef camaron_OrderedKey_h
#define camaron_OrderedKey_h

#include <cstdint> // for 64 bit integers
#include <cstring> // for the bits of a double

namespace camaron
{
/// The key of a value that is not NaN.
inline std::int64_t ToKey(double value)
{
  value += 0.0; // -0 becomes 0
  std::int64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  // The bits of negative numbers grow with their magnitude, so reverse their order.
  return bits ^ static_cast<std::int64_t>(static_cast<std::uint64_t>(bits >> 63) >> 1);
}

inline double FromKey(std::int64_t key)
{
  const std::int64_t bits =
    key ^ static_cast<std::int64_t>(static_cast<std::uint64_t>(key >> 63) >> 1);
  double value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

/// Whether a value is NaN or infinite.
inline bool IsNotFinite(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return (bits & 0x7ff0000000000000ull) == 0x7ff0000000000000ull;
}
}

#endif
