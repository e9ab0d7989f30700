// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYTypes.h"

#include <type_traits>

namespace camaron
{
//------------------------------------------------------------------------------
const char* GetName(PLYType type)
{
  static const char* const names[] = { "char", "uchar", "short", "ushort", "int", "uint", "int64",
    "uint64", "float", "double" };
  return names[static_cast<int>(type)];
}

//------------------------------------------------------------------------------
int GetVTKType(PLYType type)
{
  static const int types[] = { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_TYPE_INT64, VTK_TYPE_UINT64, VTK_FLOAT, VTK_DOUBLE };
  return types[static_cast<int>(type)];
}

//------------------------------------------------------------------------------
bool FindType(int vtkType, PLYType& type)
{
  const auto integer = [&type](auto value)
  {
    constexpr int bytes = sizeof(value);
    constexpr bool isSigned = std::is_signed<decltype(value)>::value;
    type = bytes == 1 ? isSigned ? PLYType::Int8 : PLYType::UInt8
      : bytes == 2    ? isSigned ? PLYType::Int16 : PLYType::UInt16
      : bytes == 4    ? isSigned ? PLYType::Int32 : PLYType::UInt32
      : isSigned      ? PLYType::Int64
                      : PLYType::UInt64;
    return true;
  };
  switch (vtkType)
  {
    case VTK_CHAR:
      return integer(char());
    case VTK_SIGNED_CHAR:
      return integer(static_cast<signed char>(0));
    case VTK_UNSIGNED_CHAR:
      return integer(static_cast<unsigned char>(0));
    case VTK_SHORT:
      return integer(short());
    case VTK_UNSIGNED_SHORT:
      return integer(static_cast<unsigned short>(0));
    case VTK_INT:
      return integer(int());
    case VTK_UNSIGNED_INT:
      return integer(0u);
    case VTK_LONG:
      return integer(0l);
    case VTK_UNSIGNED_LONG:
      return integer(0ul);
    case VTK_LONG_LONG:
      return integer(0ll);
    case VTK_UNSIGNED_LONG_LONG:
      return integer(0ull);
    case VTK_ID_TYPE:
      return integer(vtkIdType());
    case VTK_FLOAT:
      type = PLYType::Float;
      return true;
    case VTK_DOUBLE:
      type = PLYType::Double;
      return true;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
PLYType GetRealType(PLYType a, PLYType b)
{
  const auto fitsFloat = [](PLYType type) { return type == PLYType::Float || GetSize(type) <= 2; };
  return fitsFloat(a) && fitsFloat(b) ? PLYType::Float : PLYType::Double;
}
}
