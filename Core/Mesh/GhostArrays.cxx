// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/GhostArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace camaron
{
namespace
{
constexpr int Kinds[] = { vtkDataObject::CELL, vtkDataObject::POINT };
constexpr double MaxByte = std::numeric_limits<unsigned char>::max();

//------------------------------------------------------------------------------
vtkAbstractArray* GetGhosts(vtkDataSet* data, int kind)
{
  return data->GetAttributes(kind)->GetAbstractArray(vtkDataSetAttributes::GhostArrayName());
}

//------------------------------------------------------------------------------
bool IsOneEach(vtkAbstractArray* array, vtkIdType size)
{
  return array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == size;
}

//------------------------------------------------------------------------------
// A byte may have been written as signed; its bits count.
bool FitsByte(double value, int type)
{
  const bool isSignedByte = type == VTK_SIGNED_CHAR || type == VTK_CHAR;
  return (isSignedByte || value >= 0) && value <= MaxByte;
}

//------------------------------------------------------------------------------
// nullptr if the values cannot be ghost flags.
vtkSmartPointer<vtkUnsignedCharArray> ToBytes(vtkAbstractArray* array, vtkIdType size)
{
  auto* const values = vtkDataArray::SafeDownCast(array);
  if (!values || !IsOneEach(array, size) || !values->IsIntegral())
  {
    return nullptr;
  }
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(vtkDataSetAttributes::GhostArrayName());
  bytes->SetNumberOfValues(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double value = values->GetTuple1(i);
    if (!FitsByte(value, values->GetDataType()))
    {
      return nullptr;
    }
    bytes->SetValue(i, static_cast<unsigned char>(static_cast<int>(value)));
  }
  return bytes;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> WithGhostBytes(vtkDataSet* data)
{
  vtkSmartPointer<vtkDataSet> result = data;
  for (const int kind : Kinds)
  {
    vtkAbstractArray* const ghosts = GetGhosts(data, kind);
    if (!ghosts || vtkUnsignedCharArray::SafeDownCast(ghosts))
    {
      continue;
    }
    if (const auto bytes = ToBytes(ghosts, data->GetNumberOfElements(kind)))
    {
      if (result == data)
      {
        result.TakeReference(data->NewInstance());
        result->ShallowCopy(data);
      }
      result->GetAttributes(kind)->AddArray(bytes);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void CheckGhosts(vtkDataSet* data)
{
  for (const int kind : Kinds)
  {
    vtkAbstractArray* const ghosts = GetGhosts(data, kind);
    const vtkIdType size = data->GetNumberOfElements(kind);
    if (ghosts && !(vtkUnsignedCharArray::SafeDownCast(ghosts) && IsOneEach(ghosts, size)))
    {
      throw std::runtime_error(std::string("vtkGhostType of the ") +
        (kind == vtkDataObject::CELL ? "cells" : "points") + ": expected " + std::to_string(size) +
        " integers from 0 to 255, found " + std::to_string(ghosts->GetNumberOfTuples()) +
        " tuples of " + std::to_string(ghosts->GetNumberOfComponents()) + " of type " +
        ghosts->GetDataTypeAsString() +
        (ghosts->IsIntegral() ? ", some of them out of range" : ""));
    }
  }
}
}
