// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHalfSpaces.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

vtkStandardNewMacro(vtkHalfSpaces);

//------------------------------------------------------------------------------
vtkHalfSpaces::vtkHalfSpaces()
{
  this->ClearPlanes();
}

//------------------------------------------------------------------------------
void vtkHalfSpaces::AddPlane(const double pointAndNormal[6])
{
  this->Points->InsertNextPoint(pointAndNormal);
  this->Normals->InsertNextTuple(pointAndNormal + 3);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHalfSpaces::ClearPlanes()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  this->SetPoints(points);
  this->SetNormals(normals);
  this->Modified();
}
