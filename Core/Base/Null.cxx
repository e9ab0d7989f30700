// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Null.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace camaron
{
namespace
{
// A quiet NaN with a signature, so that other NaNs are not interpreted as a reason.
constexpr std::uint64_t QuietNaN = 0x7ff8000000000000ull;
constexpr std::uint64_t Mark = 0x0000ca3a20000000ull;
constexpr std::uint64_t ReasonBits = 0xffull;
constexpr std::uint64_t PayloadBits = 0x0007ffffffffff00ull;
}

//------------------------------------------------------------------------------
double Null(NullReason reason)
{
  const std::uint64_t bits = QuietNaN | Mark | static_cast<std::uint64_t>(reason);
  double value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

//------------------------------------------------------------------------------
NullReason GetNullReason(double value)
{
  if (!std::isnan(value))
  {
    return NullReason::Value;
  }
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return (bits & PayloadBits) == Mark ? static_cast<NullReason>(bits & ReasonBits)
                                      : NullReason::Degenerate;
}
}
