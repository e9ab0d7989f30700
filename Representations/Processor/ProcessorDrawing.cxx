// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessorDrawing.h"

#include "InspectionArrays.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
//------------------------------------------------------------------------------
void ProcessorDrawing::Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* coloring,
  vtkUnstructuredGrid* grid, const InspectionStyle& style)
{
  vtkPolyData* surface = this->GetSurface(grid, style);
  if (surface->GetNumberOfCells() == 0)
  {
    return;
  }
  this->Mapper->vtkMapper::ShallowCopy(coloring);
  this->Mapper->SetInputData(surface);
  this->Mapper->SetCellIdArrayName(CellIdsName);
  this->Mapper->SetPointIdArrayName(PointIdsName);
  this->Mapper->SetProcessIdArrayName(ProcessIdsName);
  this->Mapper->SetCompositeIdArrayName(BlockIdsName);

  vtkProperty* property = this->Actor->GetProperty();
  if (this->PropertyTime != actor->GetProperty()->GetMTime())
  {
    this->PropertyTime = actor->GetProperty()->GetMTime();
    property->DeepCopy(actor->GetProperty());
  }
  property->SetEdgeVisibility(style.Faces && style.Edges);
  this->Actor->SetUserMatrix(actor->GetMatrix());
  this->Actor->SetPropertyKeys(actor->GetPropertyKeys());
  if (this->Actor->GetMTime() < actor->GetMTime())
  {
    this->Actor->Modified(); // it does not notice that its matrix has changed
  }
  this->Mapper->RenderPiece(renderer, this->Actor);
}
}
