// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointSetHulls.h"

#include "Mesh/MeshView.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasPointSets(vtkUnstructuredGrid* grid)
{
  const MeshView mesh(grid);
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (mesh.GetCellType(cell) == VTK_CONVEX_POINT_SET)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
// Rare cells, so clarity first.
vtkSmartPointer<vtkUnstructuredGrid> WithHulls(vtkUnstructuredGrid* grid, int hullType)
{
  if (!HasPointSets(grid))
  {
    return grid;
  }
  vtkNew<vtkCellArray> connectivity, faces, locations;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> points;
  vtkNew<vtkCellArray> cellFaces;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    const int type = grid->GetCellType(id);
    grid->GetCellPoints(id, points);
    connectivity->InsertNextCell(points);
    locations->InsertNextCell(0);
    if (type == VTK_CONVEX_POINT_SET)
    {
      grid->GetCell(id, cell);
      const int numberOfFaces = cell->GetNumberOfFaces();
      for (int f = 0; f < numberOfFaces; ++f)
      {
        locations->InsertCellPoint(faces->InsertNextCell(cell->GetFace(f)->GetPointIds()));
      }
      locations->UpdateCellCount(numberOfFaces);
    }
    else if (type == VTK_POLYHEDRON)
    {
      grid->GetPolyhedronFaces(id, cellFaces);
      for (vtkIdType f = 0; f < cellFaces->GetNumberOfCells(); ++f)
      {
        cellFaces->GetCellAtId(f, points);
        locations->InsertCellPoint(faces->InsertNextCell(points));
      }
      locations->UpdateCellCount(static_cast<int>(cellFaces->GetNumberOfCells()));
    }
    types->InsertNextValue(
      static_cast<unsigned char>(type == VTK_CONVEX_POINT_SET ? hullType : type));
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  result->SetPolyhedralCells(types, connectivity, locations, faces);
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return result;
}
}
