// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/CellBoundary.h"

namespace camaron
{
//------------------------------------------------------------------------------
void CellBoundary::AddSimplex(const Simplex& simplex)
{
  this->Simplices.push_back(simplex);
  this->Box.Add(simplex.GetBounds());
}

//------------------------------------------------------------------------------
void CellBoundary::AddPolygon(const vtkIdType* points, vtkIdType size)
{
  if (size <= 3)
  {
    Simplex simplex;
    for (vtkIdType i = 0; i < size; ++i)
    {
      simplex.Points[simplex.Size++] = this->Mesh.GetPoint(points[i]);
    }
    this->AddSimplex(simplex);
    return;
  }
  this->Corners.resize(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Corners[i] = this->Mesh.GetPoint(points[i]);
  }
  this->Triangulator.Cut(this->Corners.data(), static_cast<int>(size));
  for (const PolygonTriangulator::Triangle& t : this->Triangulator.GetTriangles())
  {
    this->AddSimplex({ { this->Corners[t[0]], this->Corners[t[1]], this->Corners[t[2]] }, 3 });
  }
}

//------------------------------------------------------------------------------
void CellBoundary::Load(vtkIdType cell)
{
  this->Simplices.clear();
  this->Box = Bounds();
  const int dimension = this->Facets.GetDimension(cell);
  this->IsSolid = dimension == 3;
  if (dimension == 3)
  {
    this->Facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType) { this->AddPolygon(points, size); });
  }
  else if (dimension == 2)
  {
    this->Facets.GetPolygon(cell, this->Polygon);
    this->AddPolygon(this->Polygon.data(), static_cast<vtkIdType>(this->Polygon.size()));
  }
  else
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    const vtkIdType step = dimension == 1 ? 1 : 0;
    for (vtkIdType i = 0; i + step < points.Size; ++i)
    {
      const vtkIdType ends[2] = { points[i], points[i + step] };
      this->AddPolygon(ends, 1 + step);
    }
  }
}

//------------------------------------------------------------------------------
Vector CellBoundary::GetMiddle() const
{
  const Vector origin = this->Box.GetCenter();
  double length = 0, count = 0;
  Vector byLength, byCount;
  for (const Simplex& simplex : this->Simplices)
  {
    const Vector& first = simplex.Points[0];
    const Vector& last = simplex.Points[simplex.Size - 1];
    const Vector middle = 0.5 * (first + last) - origin;
    byLength += Norm(last - first) * middle;
    byCount += middle;
    length += Norm(last - first);
    count += 1;
  }
  return origin + (length > 0 ? (1 / length) * byLength : (1 / count) * byCount);
}

//------------------------------------------------------------------------------
bool CellBoundary::Contains(const Vector& point) const
{
  bool isInside = false;
  for (const Simplex& simplex : this->Simplices)
  {
    isInside = isInside != (simplex.Size == 3 && IsAbove(simplex, point));
  }
  return this->IsSolid && isInside;
}
}
