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
  this->ClearNumbers();
}

//------------------------------------------------------------------------------
void vtkHalfSpaces::AddNumber(double number)
{
  this->Numbers.push_back(number);
  if (this->Numbers.size() % 6 == 0)
  {
    const double* plane = &this->Numbers[this->Numbers.size() - 6];
    this->Points->InsertNextPoint(plane);
    this->Normals->InsertNextTuple(plane + 3);
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHalfSpaces::ClearNumbers()
{
  this->Numbers.clear();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  this->SetPoints(points);
  this->SetNormals(normals);
  this->Modified();
}
