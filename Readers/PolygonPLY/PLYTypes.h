// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PLYTypes.h
 * @brief The types of values in PLY files.
 */
#ifndef camaron_PLYTypes_h
#define camaron_PLYTypes_h

#include "vtkType.h" // for VTK's types

#include <cstdint>     // for integers of known size
#include <limits>      // for the ranges of types
#include <string_view> // for names

namespace camaron
{
/// The encoding of a file, in the order of the writer's property.
enum class PLYEncoding
{
  Text = 0,
  LittleEndian = 1,
  BigEndian = 2
};

constexpr std::string_view PLYEncodingNames[] = { "ascii", "binary_little_endian",
  "binary_big_endian" };

enum class PLYType : unsigned char
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
auto WithType(PLYType type, Function&& function)
{
  switch (type)
  {
    case PLYType::Int8:
      return function(std::int8_t());
    case PLYType::UInt8:
      return function(std::uint8_t());
    case PLYType::Int16:
      return function(std::int16_t());
    case PLYType::UInt16:
      return function(std::uint16_t());
    case PLYType::Int32:
      return function(std::int32_t());
    case PLYType::UInt32:
      return function(std::uint32_t());
    case PLYType::Int64:
      return function(std::int64_t());
    case PLYType::UInt64:
      return function(std::uint64_t());
    case PLYType::Float:
      return function(float());
    default:
      return function(double());
  }
}

inline bool IsReal(PLYType type)
{
  return type == PLYType::Float || type == PLYType::Double;
}

/// Bytes of a value.
inline int GetSize(PLYType type)
{
  return WithType(type, [](auto value) { return static_cast<int>(sizeof(value)); });
}

/// Names in files: in the form that all programs understand, and with the number of bits, if any.
constexpr const char* PLYTypeNames[][2] = { { "char", "int8" }, { "uchar", "uint8" },
  { "short", "int16" }, { "ushort", "uint16" }, { "int", "int32" }, { "uint", "uint32" },
  { "int64", "" }, { "uint64", "" }, { "float", "float32" }, { "double", "float64" } };
inline const char* GetName(PLYType type)
{
  return PLYTypeNames[static_cast<int>(type)][0];
}
/// VTK's type of arrays.
int GetVTKType(PLYType type);
/// The type that stores all values of a VTK array; false if it is not numeric.
bool FindType(int vtkType, PLYType& type);

/// The smallest real type that stores all values of both exactly, as far as double does.
PLYType GetRealType(PLYType a, PLYType b);
}

#endif
