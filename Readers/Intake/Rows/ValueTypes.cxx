// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/ValueTypes.h"

#include "Base/Buffer.h"

#include "vtkDataArray.h"
#include "vtkSetGet.h" // for vtkTemplateMacro

#include <type_traits>

namespace camaron
{
//------------------------------------------------------------------------------
int GetVTKType(ValueType type)
{
  static const int types[] = { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_TYPE_INT64, VTK_TYPE_UINT64, VTK_FLOAT, VTK_DOUBLE };
  return types[static_cast<int>(type)];
}

//------------------------------------------------------------------------------
bool FindType(int vtkType, ValueType& type)
{
  const auto find = [](auto value)
  {
    constexpr int bytes = sizeof(value);
    constexpr bool isSigned = std::is_signed<decltype(value)>::value;
    return std::is_floating_point<decltype(value)>::value
      ? bytes == sizeof(float) ? ValueType::Float : ValueType::Double
      : bytes == 1 ? isSigned ? ValueType::Int8 : ValueType::UInt8
      : bytes == 2 ? isSigned ? ValueType::Int16 : ValueType::UInt16
      : bytes == 4 ? isSigned ? ValueType::Int32 : ValueType::UInt32
      : isSigned   ? ValueType::Int64
                   : ValueType::UInt64;
  };
  switch (vtkType)
  {
    vtkTemplateMacro(type = find(VTK_TT()); return true);
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
ValueType GetRealType(ValueType a, ValueType b)
{
  const auto fitsFloat = [](ValueType type)
  { return type == ValueType::Float || GetSize(type) <= 2; };
  return fitsFloat(a) && fitsFloat(b) ? ValueType::Float : ValueType::Double;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> MakeArray(ValueType type, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(GetVTKType(type)));
  array->SetNumberOfComponents(components);
  const vtkIdType size = tuples * components;
  if (size > 0)
  {
    array->SetVoidArray(AllocateLarge(static_cast<std::size_t>(size) * GetSize(type)), size, 0,
      vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  }
  return array;
}
}
