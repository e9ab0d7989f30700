// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics/ExactValue.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkVariant.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace camaron
{
namespace
{
constexpr double Modulus = 18446744073709551616.0; // 2^64

//------------------------------------------------------------------------------
// In arithmetic modulo 2^64, because the nearest double may be 2^63 or 2^64, which these integer
// types cannot represent.
std::uint64_t ToBits(double nearest)
{
  return nearest < 0    ? static_cast<std::uint64_t>(static_cast<std::int64_t>(nearest))
    : nearest < Modulus ? static_cast<std::uint64_t>(nearest)
                        : 0;
}

//------------------------------------------------------------------------------
template <typename Integer>
int GetRest(Integer value)
{
  const std::uint64_t bits = ToBits(static_cast<double>(value));
  return static_cast<int>(static_cast<std::int64_t>(static_cast<std::uint64_t>(value) - bits));
}

//------------------------------------------------------------------------------
struct TakeRests
{
  std::vector<std::int16_t> Rests;

  template <typename Array>
  void operator()(Array* array)
  {
    const auto values = vtk::DataArrayValueRange(array);
    using Value = typename decltype(values)::ValueType;
    if constexpr (std::is_integral_v<Value> && sizeof(Value) == sizeof(std::int64_t))
    {
      this->Rests.reserve(values.size());
      std::transform(values.begin(), values.end(), std::back_inserter(this->Rests),
        [](Value value) { return static_cast<std::int16_t>(GetRest(value)); });
    }
  }
};

//------------------------------------------------------------------------------
template <typename Integer>
bool Parse(const char* begin, const char* end, ExactValue& value)
{
  Integer integer;
  const auto [at, error] = std::from_chars(begin, end, integer);
  if (error != std::errc() || at != end)
  {
    return false;
  }
  value = ToExact(integer);
  return true;
}
}

//------------------------------------------------------------------------------
ExactValue ToExact(std::int64_t integer)
{
  return { static_cast<double>(integer), GetRest(integer) };
}

//------------------------------------------------------------------------------
ExactValue ToExact(std::uint64_t integer)
{
  return { static_cast<double>(integer), GetRest(integer) };
}

//------------------------------------------------------------------------------
ExactValue GetExact(vtkDataArray* array, vtkIdType i)
{
  if (!array->IsIntegral())
  {
    return { array->GetComponent(i, 0) };
  }
  const vtkVariant value = array->GetVariantValue(i * array->GetNumberOfComponents());
  return IsUnsigned(array) ? ToExact(static_cast<std::uint64_t>(value.ToUnsignedLongLong()))
                           : ToExact(static_cast<std::int64_t>(value.ToLongLong()));
}

//------------------------------------------------------------------------------
bool IsUnsigned(vtkDataArray* array)
{
  return array->IsIntegral() && array->GetDataTypeMin() == 0;
}

//------------------------------------------------------------------------------
bool IsInteger64(const ExactValue& value)
{
  constexpr double least = -Modulus / 2;
  // 2^64 is not a 64-bit integer, but may be the nearest double of one.
  return std::trunc(value.Value) == value.Value && value.Value >= least &&
    (value.Value < Modulus || (value.Value == Modulus && value.Rest < 0));
}

//------------------------------------------------------------------------------
std::uint64_t ToBits(const ExactValue& value)
{
  return ToBits(value.Value) + static_cast<std::uint64_t>(static_cast<std::int64_t>(value.Rest));
}

//------------------------------------------------------------------------------
std::string ToText(const ExactValue& value)
{
  const std::uint64_t bits = ToBits(value);
  return value.Value < 0 ? std::to_string(static_cast<std::int64_t>(bits)) : std::to_string(bits);
}

//------------------------------------------------------------------------------
std::vector<std::int16_t> GetRests(vtkDataArray* array)
{
  TakeRests rests;
  const bool isLong = array->IsIntegral() && array->GetDataTypeSize() == sizeof(std::int64_t);
  if (!isLong ||
    !vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>::Execute(array, rests) ||
    std::all_of(
      rests.Rests.begin(), rests.Rests.end(), [](std::int16_t rest) { return rest == 0; }))
  {
    return {};
  }
  return std::move(rests.Rests);
}

//------------------------------------------------------------------------------
bool ParseInteger(const std::string& text, ExactValue& value)
{
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  if (first == std::string::npos)
  {
    return false;
  }
  const char *const begin = text.data() + first, *const end = text.data() + last + 1;
  return Parse<std::int64_t>(begin, end, value) || Parse<std::uint64_t>(begin, end, value);
}
}
