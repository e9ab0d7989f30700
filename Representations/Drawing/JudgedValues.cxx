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
#include <utility>

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
// Of the cells of a mesh, or, if it is a surface that says so, of the cells of its faces. Faces of
// which that is not known have a shape that no criterion of 3D cells applies to.
void JudgedValues::UpdateShapes(vtkUnstructuredGrid* grid)
{
  auto* known = vtkArrayDownCast<vtkUnsignedShortArray>(
    grid->GetCellData()->GetAbstractArray(GetCellShapesName()));
  if (known && known->GetNumberOfValues() == grid->GetNumberOfCells())
  {
    this->Cells.clear();
    this->Shapes.assign(known->GetPointer(0), known->GetPointer(0) + known->GetNumberOfValues());
    return;
  }
  DataVersion cells = GetCellBoundsVersion(grid);
  if (cells != this->Cells)
  { // which other criteria of the mesh share
    this->Shapes = FindCellShapes(grid);
    this->Cells = std::move(cells);
  }
}

//------------------------------------------------------------------------------
vtkDataArray* JudgedValues::Update(
  vtkDataArray* values, vtkUnstructuredGrid* grid, const std::optional<Marks>& marks)
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
  if (values != this->Values || time != this->Time || !(marks == this->Marked))
  {
    this->UpdateShapes(grid);
    const auto isOther = [judged, criterion](std::uint16_t shape)
    { return !(shape & judged) && (shape & criterion->AppliesTo); };
    this->Judged = values;
    if (std::any_of(this->Shapes.begin(), this->Shapes.end(), isOther))
    {
      const double other = marks ? marks->Others : FindInside(criterion->Acceptable);
      auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
      doubles->DeepCopy(values);
      double* const value = doubles->GetPointer(0);
      for (std::size_t cell = 0; cell < this->Shapes.size(); ++cell)
      {
        if (isOther(this->Shapes[cell]) && !std::isnan(value[cell]))
        {
          value[cell] = other;
        }
        else if (marks && value[cell] < marks->Least)
        {
          value[cell] = marks->Least;
        }
      }
      this->Judged = doubles;
    }
    this->Values = values;
    this->Marked = marks;
    this->Time = time;
  }
  return this->Judged;
}
}
