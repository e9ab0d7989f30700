// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/PointSetHulls.h"

#include "Geometry/ConvexHull.h"
#include "Mesh/CellWriter.h"
#include "Mesh/MeshView.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
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
  CellWriter writer;
  ConvexHull hull;
  vtkNew<vtkIdList> points;
  vtkNew<vtkCellArray> cellFaces;
  const auto addFace = [&]
  {
    std::for_each(
      points->begin(), points->end(), [&](vtkIdType point) { writer.AddFacePoint(point); });
    writer.EndFace();
  };
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    const int type = grid->GetCellType(id);
    grid->GetCellPoints(id, points);
    std::for_each(points->begin(), points->end(), [&](vtkIdType point) { writer.AddPoint(point); });
    if (type == VTK_CONVEX_POINT_SET)
    {
      const std::vector<Vector> corners = GetPoints(mesh, points);
      if (std::all_of(corners.begin(), corners.end(), IsFinite))
      {
        hull.Compute(corners);
        for (const std::vector<int>& face : hull.GetFaces())
        {
          for (const int corner : face)
          {
            writer.AddFacePoint(points->GetId(corner));
          }
          writer.EndFace();
        }
      }
      else if (hullType == VTK_CONVEX_POINT_SET)
      {
        addFace(); // with all points, so that evaluations detect the nonfinite coordinates
      }
    }
    else if (type == VTK_POLYHEDRON)
    {
      grid->GetPolyhedronFaces(id, cellFaces);
      for (vtkIdType f = 0; f < cellFaces->GetNumberOfCells(); ++f)
      {
        cellFaces->GetCellAtId(f, points);
        addFace();
      }
    }
    writer.EndCell(static_cast<unsigned char>(type == VTK_CONVEX_POINT_SET ? hullType : type));
  }
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(grid->GetPoints());
  writer.SetCells(result);
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return result;
}
}
