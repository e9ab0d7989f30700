// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PolygonTriangles.h"

#include "Drawing/PolygonTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool IsRepeated(const vtkIdType triangle[3])
{
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}
}

//------------------------------------------------------------------------------
void CutIntoTriangles(vtkPolyData* surface)
{
  const MeshView mesh(surface);
  PolygonTriangles triangles(mesh);
  vtkNew<vtkCellArray> cut;
  vtkNew<vtkIdList> cells;
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  for (vtkIdType other = 0; other < cell; ++other)
  {
    cells->InsertNextId(other);
  }
  const auto polygons = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal();
    polygons->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    polygons->GetCurrentCell(size, points);
    triangles.ForEach({ points, size, PolygonTriangles::Form::Straight },
      [&](const PolygonTriangles::Triangle& t)
      {
        const vtkIdType triangle[3] = { points[t.Corners[0]], points[t.Corners[1]],
          points[t.Corners[2]] };
        if (size == 3 || !IsRepeated(triangle))
        {
          cut->InsertNextCell(3, triangle);
          cells->InsertNextId(cell);
        }
      });
  }
  vtkNew<vtkCellData> data;
  data->CopyGlobalIdsOn();
  data->CopyAllOn();
  data->CopyAllocate(surface->GetCellData(), cells->GetNumberOfIds());
  data->CopyData(surface->GetCellData(), cells);
  surface->SetPolys(cut);
  surface->GetCellData()->ShallowCopy(data);
}
}
