// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PolygonTriangles.h"

#include "Mesh/Vector.h"

#include "vtkPoints.h"

namespace camaron
{
//------------------------------------------------------------------------------
// No corner turns against the polygon as a whole. Corners without a direction do not count.
bool PolygonTriangles::IsConvex(const vtkIdType* points, vtkIdType size)
{
  this->Coordinates.resize(3 * size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Mesh.GetPoint(points[i], &this->Coordinates[3 * i]);
  }
  const auto corner = [&](vtkIdType i)
  {
    const double* x = &this->Coordinates[3 * i];
    return Vector{ x[0], x[1], x[2] };
  };
  const Vector first = corner(0);
  Vector normal;
  for (vtkIdType i = 1; i + 1 < size; ++i)
  {
    normal += Cross(corner(i) - first, corner(i + 1) - first);
  }
  Vector before = first - corner(size - 1);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Vector after = corner(i + 1 < size ? i + 1 : 0) - corner(i);
    if (Dot(Cross(before, after), normal) < 0)
    {
      return false;
    }
    before = after;
  }
  return true;
}

//------------------------------------------------------------------------------
// VTK gives up on polygons that cross themselves: the rest of those is filled up with a fan.
void PolygonTriangles::ClipEars(const vtkIdType* points, vtkIdType size)
{
  this->Polygon->PointIds->SetNumberOfIds(size);
  this->Polygon->Points->SetNumberOfPoints(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Polygon->PointIds->SetId(i, points[i]);
    this->Polygon->Points->SetPoint(i, &this->Coordinates[3 * i]);
  }
  if (!this->Polygon->TriangulateLocalIds(0, this->Ears) ||
    this->Ears->GetNumberOfIds() != 3 * (size - 2))
  {
    this->Ears->SetNumberOfIds(3 * (size - 2));
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      this->Ears->SetId(3 * i - 3, 0);
      this->Ears->SetId(3 * i - 2, i);
      this->Ears->SetId(3 * i - 1, i + 1);
    }
  }
}
}
