// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PLYTypes.h"

#include "vtkSetGet.h" // for vtkTemplateMacro

#include <type_traits>

namespace camaron
{
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
  const auto find = [](auto value)
  {
    constexpr int bytes = sizeof(value);
    constexpr bool isSigned = std::is_signed<decltype(value)>::value;
    return std::is_floating_point<decltype(value)>::value
      ? bytes == sizeof(float) ? PLYType::Float : PLYType::Double
      : bytes == 1 ? isSigned ? PLYType::Int8 : PLYType::UInt8
      : bytes == 2 ? isSigned ? PLYType::Int16 : PLYType::UInt16
      : bytes == 4 ? isSigned ? PLYType::Int32 : PLYType::UInt32
      : isSigned   ? PLYType::Int64
                   : PLYType::UInt64;
  };
  switch (vtkType)
  {
    vtkTemplateMacro(type = find(VTK_TT()); return true);
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
