// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYColumnWriting.h
 * @brief Conversion of values from their type in the file to the type of the array.
 */
#ifndef camaron_PLYColumnWriting_h
#define camaron_PLYColumnWriting_h

#include "PLYRows.h"

#include <atomic>      // for counts
#include <type_traits> // for the kinds of types

namespace camaron
{
/// A value from 0 to 255.
template <typename In>
std::uint8_t ToColor(In value)
{
  if constexpr (std::is_floating_point<In>::value)
  {
    // NaN becomes 0.
    return value >= In(1) ? 255
      : value > In(0)     ? static_cast<std::uint8_t>(value * 255 + In(0.5))
                          : 0;
  }
  else
  {
    return value < In(0)                        ? 0
      : static_cast<std::uint64_t>(value) > 255 ? 255
                                                : static_cast<std::uint8_t>(value);
  }
}

/// Whether ToColor preserves the value.
template <typename In>
bool IsColor(In value)
{
  if constexpr (std::is_floating_point<In>::value)
  {
    return value >= In(0) && value <= In(1);
  }
  else
  {
    return value >= In(0) && static_cast<std::uint64_t>(value) <= 255;
  }
}

/**
 * Calls @a function(in, out, convert) with values of the types of a property and of its column; @a
 * oddColors counts values out of the range of colors.
 */
template <typename Function>
void WithConversion(
  PLYType type, const PLYColumn& column, std::atomic<vtkIdType>& oddColors, Function&& function)
{
  WithType(type,
    [&](auto in)
    {
      using In = decltype(in);
      if (column.Conversion == PLYConversion::Color)
      {
        function(in, std::uint8_t(),
          [&oddColors](In value)
          {
            if (!IsColor(value))
            {
              oddColors.fetch_add(1, std::memory_order_relaxed);
            }
            return ToColor(value);
          });
      }
      else if (column.Type == type)
      {
        function(in, in, [](In value) { return value; });
      }
      else if (column.Type == PLYType::Float)
      {
        function(in, float(), [](In value) { return static_cast<float>(value); });
      }
      else
      {
        function(in, double(), [](In value) { return static_cast<double>(value); });
      }
    });
}
}

#endif
