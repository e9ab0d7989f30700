// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementArrays.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename Array>
auto* Add(vtkPolyData* elements, const char* name, vtkIdType size)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(size);
  std::fill_n(array->GetPointer(0), size, 0);
  elements->GetCellData()->AddArray(array);
  return array->GetPointer(0);
}
}

//------------------------------------------------------------------------------
ElementArrays::ElementArrays(vtkDataSet* mesh, vtkPolyData* elements, AngleUnit angles)
  : Elements(elements)
  , Angles(angles)
  , GlobalIds(mesh->GetCellData()->GetGlobalIds())
{
  if (vtkPointSet* points = vtkPointSet::SafeDownCast(mesh))
  {
    elements->SetPoints(points->GetPoints());
  }
  elements->GetPointData()->ShallowCopy(mesh->GetPointData());
  if (vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray())
  {
    this->Ghosts = ghosts->GetPointer(0);
  }
}

//------------------------------------------------------------------------------
vtkIdType* ElementArrays::AddIds(const char* name)
{
  return Add<vtkIdTypeArray>(this->Elements, name, this->Size);
}

//------------------------------------------------------------------------------
unsigned char* ElementArrays::AddFlags(const char* name)
{
  return Add<vtkUnsignedCharArray>(this->Elements, name, this->Size);
}

//------------------------------------------------------------------------------
unsigned char* ElementArrays::AddGhosts()
{
  return this->AddFlags(vtkDataSetAttributes::GhostArrayName());
}

//------------------------------------------------------------------------------
double* ElementArrays::AddReals(const char* name, enum Unit unit)
{
  double* values = Add<vtkDoubleArray>(this->Elements, name, this->Size);
  if (unit == Unit::Angle)
  {
    this->Elements->GetCellData()->GetArray(name)->GetInformation()->Set(
      vtkDataArray::UNITS_LABEL(), this->Angles == AngleUnit::Degrees ? "deg" : "rad");
  }
  return values;
}

//------------------------------------------------------------------------------
vtkIdType ElementArrays::GetGlobalCell(vtkIdType cell) const
{
  return this->GlobalIds ? static_cast<vtkIdType>(this->GlobalIds->GetComponent(cell, 0)) : cell;
}

//------------------------------------------------------------------------------
unsigned char ElementArrays::BelongsToGhost(const Index* cells, std::size_t size) const
{
  const Index* const first = std::min_element(cells, cells + size,
    [this](Index a, Index b) { return this->GetGlobalCell(a) < this->GetGlobalCell(b); });
  return size > 0 && (this->Ghosts[*first] & vtkDataSetAttributes::DUPLICATECELL)
    ? vtkDataSetAttributes::DUPLICATECELL
    : 0;
}
}
