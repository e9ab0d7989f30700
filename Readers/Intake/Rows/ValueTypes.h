// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ValueTypes.h
 * @brief The types of numbers in the rows of a table, see TableRows.
 */
#ifndef camaron_ValueTypes_h
#define camaron_ValueTypes_h

#include "vtkSmartPointer.h" // for arrays
#include "vtkType.h"         // for VTK's types

#include <cstdint>     // for integers of known size
#include <type_traits> // for signs

class vtkDataArray;

namespace camaron
{
enum class ValueType : unsigned char
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float,
  Double
};

/// Calls @a function(value) with a value of the C++ type.
template <typename Function>
auto WithType(ValueType type, Function&& function)
{
  switch (type)
  {
    case ValueType::Int8:
      return function(std::int8_t());
    case ValueType::UInt8:
      return function(std::uint8_t());
    case ValueType::Int16:
      return function(std::int16_t());
    case ValueType::UInt16:
      return function(std::uint16_t());
    case ValueType::Int32:
      return function(std::int32_t());
    case ValueType::UInt32:
      return function(std::uint32_t());
    case ValueType::Int64:
      return function(std::int64_t());
    case ValueType::UInt64:
      return function(std::uint64_t());
    case ValueType::Float:
      return function(float());
    default:
      return function(double());
  }
}

inline bool IsReal(ValueType type)
{
  return type == ValueType::Float || type == ValueType::Double;
}

inline bool IsSigned(ValueType type)
{
  return WithType(type, [](auto value) { return std::is_signed<decltype(value)>::value; });
}

/// Bytes of a value.
inline int GetSize(ValueType type)
{
  return WithType(type, [](auto value) { return static_cast<int>(sizeof(value)); });
}

/// Names in PLY files: in the form that all programs understand, and with the number of bits, if
/// any.
constexpr const char* ValueTypeNames[][2] = { { "char", "int8" }, { "uchar", "uint8" },
  { "short", "int16" }, { "ushort", "uint16" }, { "int", "int32" }, { "uint", "uint32" },
  { "int64", "" }, { "uint64", "" }, { "float", "float32" }, { "double", "float64" } };
inline const char* GetName(ValueType type)
{
  return ValueTypeNames[static_cast<int>(type)][0];
}
/// VTK's type of arrays.
int GetVTKType(ValueType type);
/// The type that stores all values of a VTK array; false if it is not numeric.
bool FindType(int vtkType, ValueType& type);

/// An array of exactly this size, not initialized.
vtkSmartPointer<vtkDataArray> MakeArray(ValueType type, int components, vtkIdType tuples);

/// The smallest real type that stores all values of both exactly, as far as double does.
ValueType GetRealType(ValueType a, ValueType b);
}

#endif
