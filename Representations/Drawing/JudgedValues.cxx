// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "JudgedValues.h"

#include "AcceptableRanges.h"
#include "Elements/ElementCriteria.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkUnsignedShortArray.h"
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

// Of the cells of a mesh, or, if it is a surface that says so, of the cells of its faces. Faces of
// which that is not known have a shape that no criterion of 3D cells applies to.
std::vector<std::uint16_t> FindShapes(vtkUnstructuredGrid* grid)
{
  auto* known = vtkArrayDownCast<vtkUnsignedShortArray>(
    grid->GetCellData()->GetAbstractArray(GetCellShapesName()));
  if (!known || known->GetNumberOfValues() != grid->GetNumberOfCells())
  {
    return FindCellShapes(grid);
  }
  return { known->GetPointer(0), known->GetPointer(0) + known->GetNumberOfValues() };
}
}

//------------------------------------------------------------------------------
vtkDataArray* JudgedValues::Update(
  vtkDataArray* values, vtkUnstructuredGrid* grid, std::optional<double> others)
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
  const double other = others.value_or(FindInside(criterion->Acceptable));
  const bool isSame = other == this->Others || (std::isnan(other) && std::isnan(this->Others));
  if (values != this->Values || time != this->Time || !isSame)
  {
    const std::vector<std::uint16_t> shapes = FindShapes(grid);
    const auto isOther = [judged, criterion](std::uint16_t shape)
    { return !(shape & judged) && (shape & criterion->AppliesTo); };
    this->Judged = values;
    if (std::any_of(shapes.begin(), shapes.end(), isOther))
    {
      auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
      doubles->DeepCopy(values);
      double* const value = doubles->GetPointer(0);
      for (std::size_t cell = 0; cell < shapes.size(); ++cell)
      {
        value[cell] = isOther(shapes[cell]) && !std::isnan(value[cell]) ? other : value[cell];
      }
      this->Judged = doubles;
    }
    this->Values = values;
    this->Others = other;
    this->Time = time;
  }
  return this->Judged;
}
}
