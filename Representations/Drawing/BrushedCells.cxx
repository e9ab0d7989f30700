// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BrushedCells.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArrayRange.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
vtkDataArray* BrushedCells::Update(const std::vector<Brush>& brushes, vtkUnstructuredGrid* grid)
{
  const vtkMTimeType time = grid->GetCellData()->GetMTime();
  if (this->Cells && time == this->Time && brushes == this->Brushes)
  {
    return this->Cells;
  }
  this->Time = time;
  this->Brushes = brushes;
  this->Cells = vtkSmartPointer<vtkUnsignedCharArray>::New();
  this->Cells->SetNumberOfValues(grid->GetNumberOfCells());
  this->Cells->FillValue(0);
  for (const Brush& brush : brushes)
  {
    vtkDataArray* const values = grid->GetCellData()->GetArray(brush.Array.c_str());
    const auto select = [this, &brush](auto* typed)
    {
      unsigned char* cell = this->Cells->GetPointer(0);
      for (const double value : vtk::DataArrayValueRange<1>(typed))
      {
        const bool isInside = value >= brush.Values[0] && value <= brush.Values[1];
        *cell = isInside ? brush.Selects : *cell;
        ++cell;
      }
    };
    if (values && values->GetNumberOfComponents() == 1 &&
      !vtkArrayDispatch::Dispatch::Execute(values, select))
    {
      select(values);
    }
  }
  return this->Cells;
}
}
