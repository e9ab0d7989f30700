// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionValues.h"

#include "ArrayValues.h"

#include "vtkDataArray.h"

#include <vector>

namespace camaron
{
//------------------------------------------------------------------------------
void InspectionValues::Update(vtkDataArray* array, int component)
{
  const vtkMTimeType time = array ? array->GetMTime() : 0;
  if (array == this->Array && time == this->Time && component == this->Component)
  {
    return;
  }
  this->Release();
  this->Array = array;
  this->Time = time;
  this->Component = component;
  if (!array)
  {
    return;
  }
  const ArrayValues values = GetArrayValues(array, component);
  this->Values.Upload(values.Values.data(), values.Values.size());
  this->Origin = values.Origin;
}

//------------------------------------------------------------------------------
void InspectionValues::Release()
{
  this->Values.Release();
  this->Array = nullptr;
  this->Origin = 0;
}
}
