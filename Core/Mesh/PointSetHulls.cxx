// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointSetHulls.h"

#include "Geometry/ConvexHull.h"
#include "Mesh/MeshView.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasPointSets(const MeshView& mesh)
{
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (mesh.GetCellType(cell) == VTK_CONVEX_POINT_SET)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<Vector> GetPoints(const MeshView& mesh, vtkIdList* ids)
{
  std::vector<Vector> result;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    result.push_back(mesh.GetPoint(ids->GetId(i)));
  }
  return result;
}
}

//------------------------------------------------------------------------------
// Such cells are rare, so clarity takes precedence over speed.
vtkSmartPointer<vtkUnstructuredGrid> WithHulls(vtkUnstructuredGrid* grid, int hullType)
{
  const MeshView mesh(grid);
  if (!HasPointSets(mesh))
  {
    return grid;
  }
  vtkNew<vtkCellArray> connectivity, faces, locations;
  vtkNew<vtkUnsignedCharArray> types;
  ConvexHull hull;
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
      int numberOfFaces = 0;
      const std::vector<Vector> corners = GetPoints(mesh, points);
      if (std::all_of(corners.begin(), corners.end(), IsFinite))
      {
        hull.Compute(corners);
        for (const std::vector<int>& face : hull.GetFaces())
        {
          locations->InsertCellPoint(faces->InsertNextCell(static_cast<int>(face.size())));
          for (const int corner : face)
          {
            faces->InsertCellPoint(points->GetId(corner));
          }
        }
        numberOfFaces = static_cast<int>(hull.GetFaces().size());
      }
      else if (hullType == VTK_CONVEX_POINT_SET)
      {
        // A face with all points lets evaluations detect the nonfinite coordinates.
        locations->InsertCellPoint(faces->InsertNextCell(points));
        numberOfFaces = 1;
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
