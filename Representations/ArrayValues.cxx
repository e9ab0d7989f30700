// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayValues.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <cmath>

namespace camaron
{
std::vector<float> GetArrayValues(vtkDataArray* array, int component)
{
  const int size = array->GetNumberOfComponents();
  const int wanted = size == 1 || component >= size ? 0 : component;
  std::vector<float> values(array->GetNumberOfTuples());
  std::size_t next = 0;
  for (const auto tuple : vtk::DataArrayTupleRange(array))
  {
    double squares = 0;
    for (const double value : tuple)
    {
      squares += value * value;
    }
    values[next++] = static_cast<float>(wanted < 0 ? std::sqrt(squares) : tuple[wanted]);
  }
  return values;
}
}
