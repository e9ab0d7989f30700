// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/CellBoundary.h"
#include <algorithm>
#include <tuple>

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

namespace
{
//------------------------------------------------------------------------------
double Clamp(double value)
{
  return std::min(1.0, std::max(0.0, value));
}

//------------------------------------------------------------------------------
double GetSquaredDistanceToSegment(const Vector& point, const Vector& a, const Vector& b)
{
  const Vector edge = b - a;
  const double length2 = Norm2(edge);
  const double t = length2 > 0 ? Clamp(Dot(point - a, edge) / length2) : 0;
  return Norm2(point - (a + t * edge));
}

//------------------------------------------------------------------------------
// Six times the volume of a tetrahedron.
double GetDeterminant(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  return Dot(a - d, Cross(b - d, c - d));
}

//------------------------------------------------------------------------------
bool SegmentPierces(const Vector& p, const Vector& q, const Simplex& triangle)
{
  const Vector& a = triangle.Points[0];
  const Vector& b = triangle.Points[1];
  const Vector& c = triangle.Points[2];
  const double sideP = GetDeterminant(a, b, c, p);
  const double sideQ = GetDeterminant(a, b, c, q);
  if (!(sideP > 0 && sideQ < 0) && !(sideP < 0 && sideQ > 0))
  {
    return false;
  }
  const double ab = GetDeterminant(p, q, a, b);
  const double bc = GetDeterminant(p, q, b, c);
  const double ca = GetDeterminant(p, q, c, a);
  return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

//------------------------------------------------------------------------------
// Calls test(a, b) for the edges until it returns true.
template <typename Test>
bool HasEdge(const Simplex& simplex, Test&& test)
{
  const int numberOfEdges = simplex.Size == 3 ? 3 : simplex.Size - 1;
  for (int i = 0; i < numberOfEdges; ++i)
  {
    if (test(simplex.Points[i], simplex.Points[(i + 1) % simplex.Size]))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
double GetSquaredDistance(const Vector& point, const Simplex& simplex)
{
  const Vector* x = simplex.Points;
  if (simplex.Size == 1)
  {
    return Norm2(point - x[0]);
  }
  if (simplex.Size == 2)
  {
    return GetSquaredDistanceToSegment(point, x[0], x[1]);
  }
  // Above the interior of the triangle, the plane is nearest, otherwise an edge.
  const Vector normal = Cross(x[1] - x[0], x[2] - x[0]);
  const double norm2 = Norm2(normal);
  bool isAbove = norm2 > 0;
  double nearest = Bounds::Infinity;
  for (int i = 0; i < 3; ++i)
  {
    const Vector& a = x[i];
    const Vector& b = x[(i + 1) % 3];
    isAbove = isAbove && Dot(Cross(b - a, point - a), normal) >= 0;
    nearest = std::min(nearest, GetSquaredDistanceToSegment(point, a, b));
  }
  if (!isAbove)
  {
    return nearest;
  }
  const double height = Dot(point - x[0], normal);
  return std::min(nearest, height * height / norm2);
}

//------------------------------------------------------------------------------
double GetSquaredDistance(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  // If both nearest points are inside the segments; otherwise one of them is an end.
  const Vector u = b - a, v = d - c, w = a - c;
  const double uu = Norm2(u), uv = Dot(u, v), vv = Norm2(v);
  const double determinant = uu * vv - uv * uv;
  double nearest =
    std::min({ GetSquaredDistanceToSegment(a, c, d), GetSquaredDistanceToSegment(b, c, d),
      GetSquaredDistanceToSegment(c, a, b), GetSquaredDistanceToSegment(d, a, b) });
  if (determinant > 0)
  {
    const double s = (uv * Dot(v, w) - vv * Dot(u, w)) / determinant;
    const double t = (uu * Dot(v, w) - uv * Dot(u, w)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
    {
      nearest = std::min(nearest, Norm2((a + s * u) - (c + t * v)));
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
bool Touch(const Simplex& a, const Simplex& b, double tolerance)
{
  const double limit = tolerance * tolerance;
  const auto isNear = [&](const Simplex& points, const Simplex& simplex)
  {
    return std::any_of(points.Points, points.Points + points.Size,
      [&](const Vector& point) { return GetSquaredDistance(point, simplex) <= limit; });
  };
  if (isNear(a, b) || isNear(b, a))
  {
    return true;
  }
  const auto edgesAreNear = [&](const Vector& p, const Vector& q)
  {
    return HasEdge(
      b, [&](const Vector& r, const Vector& s) { return GetSquaredDistance(p, q, r, s) <= limit; });
  };
  return HasEdge(a, edgesAreNear) || Pierce(a, b);
}

//------------------------------------------------------------------------------
bool Pierce(const Simplex& a, const Simplex& b)
{
  const auto pierces = [](const Simplex& edges, const Simplex& triangle)
  {
    return triangle.Size == 3 &&
      HasEdge(
        edges, [&](const Vector& p, const Vector& q) { return SegmentPierces(p, q, triangle); });
  };
  return pierces(a, b) || pierces(b, a);
}

//------------------------------------------------------------------------------
bool IsAbove(const Simplex& triangle, const Vector& point)
{
  // Projected along Z: an edge counts if it crosses the line of the same Y to the right; its lower
  // end is included.
  bool isInside = false;
  for (int i = 0; i < 3; ++i)
  {
    const Vector* a = &triangle.Points[i];
    const Vector* b = &triangle.Points[(i + 1) % 3];
    if ((a->Y > point.Y) == (b->Y > point.Y))
    {
      continue;
    }
    // The same arithmetic for both triangles at an edge.
    if (std::tie(b->X, b->Y, b->Z) < std::tie(a->X, a->Y, a->Z))
    {
      std::swap(a, b);
    }
    const double x = a->X + (point.Y - a->Y) / (b->Y - a->Y) * (b->X - a->X);
    isInside = isInside != (point.X < x);
  }
  if (!isInside)
  {
    return false;
  }
  const Vector normal =
    Cross(triangle.Points[1] - triangle.Points[0], triangle.Points[2] - triangle.Points[0]);
  const double height = Dot(triangle.Points[0] - point, normal);
  return normal.Z > 0 ? height > 0 : height < 0;
}
}
