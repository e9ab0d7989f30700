// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InspectionValues.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls visit(value) for every tuple.
template <typename Visit>
void ForEachValue(vtkDataArray* array, int component, Visit&& visit)
{
  const int size = array->GetNumberOfComponents();
  const int wanted = size == 1 || component >= size ? 0 : component;
  const auto visitAll = [&](auto* typed)
  {
    for (const auto tuple : vtk::DataArrayTupleRange(typed))
    {
      double squares = 0;
      for (const double value : tuple)
      {
        squares += value * value;
      }
      visit(wanted < 0 ? std::sqrt(squares) : static_cast<double>(tuple[wanted]));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, visitAll))
  {
    visitAll(array);
  }
}

//------------------------------------------------------------------------------
// If the largest value is at most twice the smallest, differences between values are exact (P.
// Sterbenz, Floating-point computation, 1974), so that conversion to float loses no digits that
// matter.
double FindOrigin(vtkDataArray* array, int component)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  ForEachValue(array, component,
    [&](double value)
    {
      if (std::isfinite(value))
      {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    });
  return low > 0 && high <= 2 * low ? low : high < 0 && low >= 2 * high ? high : 0;
}
}

//------------------------------------------------------------------------------
ArrayValues GetArrayValues(vtkDataArray* array, int component)
{
  ArrayValues result;
  result.Origin = FindOrigin(array, component);
  result.Values.reserve(array->GetNumberOfTuples());
  ForEachValue(
    array, component, [&](double value) { result.Values.push_back(result.FromOrigin(value)); });
  return result;
}

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
