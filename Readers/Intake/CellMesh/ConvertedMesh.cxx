// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/ConvertedMesh.h"

#include "Intake/CellMesh/OutputMesh.h"
#include "Mesh/CellFacets.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
vtkNew<vtkPoints> MakePoints(const OutputMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh.HasFloatPoints() ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(mesh.GetNumberOfPoints());
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    double x[3];
    mesh.GetPoint(point, x);
    points->SetPoint(point, x);
  }
  return points;
}

//------------------------------------------------------------------------------
void AddCells(const OutputMesh& mesh, vtkUnstructuredGrid* grid)
{
  grid->Allocate(mesh.GetNumberOfCells());
  CellFacets facets(mesh.GetInput());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const unsigned char type = mesh.GetCellType(cell);
    ids->Reset();
    if (type == VTK_POLYHEDRON)
    {
      const vtkIdType inputCell = mesh.GetInputCell(cell);
      ids->InsertNextId(facets.GetNumberOfFacets(inputCell));
      facets.ForEach(inputCell,
        [&](const vtkIdType* nodes, vtkIdType size, vtkIdType)
        {
          ids->InsertNextId(size);
          for (vtkIdType i = 0; i < size; ++i)
          {
            ids->InsertNextId(mesh.GetPointOf(nodes[i]));
          }
        });
    }
    else
    {
      const IndexRange nodes = mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i < nodes.Size; ++i)
      {
        ids->InsertNextId(nodes[i]);
      }
    }
    grid->InsertNextCell(type, ids);
  }
}

//------------------------------------------------------------------------------
void AddArray(const OutputMesh& mesh, vtkDataArray* array, vtkUnstructuredGrid* grid)
{
  const auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  copy->SetName(array->GetName());
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  copy->SetNumberOfTuples(mesh.GetNumberOfCells());
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    copy->SetTuple(cell, mesh.GetInputCell(cell), array);
  }
  grid->GetCellData()->AddArray(copy);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> ConvertMesh(vtkDataSet* mesh, const CellConversion& how,
  const std::string& path, const std::vector<std::string>& arrays, Warnings& warnings,
  ScanError& error, const Progress& progress)
{
  OutputMesh converted;
  if (!ConvertCells(mesh, how, path, converted, warnings, error, progress))
  {
    return nullptr;
  }
  if (converted.HasInputCells() && converted.HasInputPoints())
  {
    return mesh;
  }
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(converted));
  AddCells(converted, grid);
  for (const std::string& name : arrays)
  {
    if (vtkDataArray* const array = mesh->GetCellData()->GetArray(name.c_str()))
    {
      AddArray(converted, array, grid);
    }
  }
  grid->SetFieldData(mesh->GetFieldData());
  return grid;
}
}
