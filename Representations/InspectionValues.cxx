// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionValues.h"

#include "vtkDataArray.h"

#include <cmath>
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
  const int size = array->GetNumberOfComponents();
  if (size == 1 || component >= size)
  {
    component = 0;
  }
  std::vector<double> tuple(size);
  std::vector<float> values(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), tuple.data());
    double squares = 0;
    for (const double value : tuple)
    {
      squares += value * value;
    }
    values[i] = static_cast<float>(component < 0 ? std::sqrt(squares) : tuple[component]);
  }
  this->Values.Upload(values.data(), values.size());
}

//------------------------------------------------------------------------------
void InspectionValues::Release()
{
  this->Values.Release();
  this->Array = nullptr;
}
}
