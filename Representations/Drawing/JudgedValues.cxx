// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "JudgedValues.h"

#include "AcceptableRanges.h"
#include "Elements/ElementCriteria.h"

#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// A value so far from the limits that rounding to float does not move it across them.
double FindInside(const double (&limits)[2])
{
  if (std::isfinite(limits[0]) && std::isfinite(limits[1]))
  {
    return limits[0] / 2 + limits[1] / 2;
  }
  return std::isfinite(limits[0]) ? limits[0] + std::abs(limits[0]) + 1
                                  : limits[1] - std::abs(limits[1]) - 1;
}
}

//------------------------------------------------------------------------------
vtkDataArray* JudgedValues::Update(vtkDataArray* values, vtkUnstructuredGrid* grid)
{
  const Criterion* const criterion =
    values && values->GetName() ? FindAnyCriterion(values->GetName()) : nullptr;
  const unsigned judged = criterion ? GetJudgedShapes(*criterion) : AnyCell;
  if ((judged & AnyCell) || !criterion->HasAcceptableRange() ||
    values->GetNumberOfComponents() != 1)
  {
    return values;
  }
  const vtkMTimeType time = std::max(values->GetMTime(), grid->GetMTime());
  if (values != this->Values || time != this->Time)
  {
    const std::vector<std::uint16_t> shapes = FindCellShapes(grid);
    const double inside = FindInside(criterion->Acceptable);
    auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(values);
    double* const value = doubles->GetPointer(0);
    for (std::size_t cell = 0; cell < shapes.size(); ++cell)
    {
      // Undefined values keep their color.
      value[cell] = (shapes[cell] & judged) || std::isnan(value[cell]) ? value[cell] : inside;
    }
    this->Values = values;
    this->Time = time;
    this->Judged = doubles;
  }
  return this->Judged;
}
}
