// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/CellKernel.h"

#include "Cell/CellGeometry.h"
#include "Cell/FaceRing.h"
#include "Geometry/BoxTree.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
/// Number of half-spaces times points up to which all pairs are tested.
constexpr std::size_t FewChecks = 4096;

//------------------------------------------------------------------------------
// For many well-separated points.
bool ContainMany(const std::vector<HalfSpace>& halfSpaces, const Vector* points, std::size_t size,
  double tolerance)
{
  BoxTree tree;
  tree.Build(points, size);
  return std::none_of(halfSpaces.begin(), halfSpaces.end(),
    [&](const HalfSpace& halfSpace)
    {
      const Vector& normal = halfSpace.Normal;
      return tree.FindAny(
        [&](const Bounds& box)
        {
          const Vector outermost = { normal.X > 0 ? box.High.X : box.Low.X,
            normal.Y > 0 ? box.High.Y : box.Low.Y, normal.Z > 0 ? box.High.Z : box.Low.Z };
          return halfSpace.GetDistance(outermost) > tolerance;
        },
        [&](std::size_t place)
        { return halfSpace.GetDistance(points[tree.GetOrder()[place]]) > tolerance; });
    });
}

//------------------------------------------------------------------------------
bool ContainAll(const std::vector<HalfSpace>& halfSpaces, const Vector* points, std::size_t size,
  double tolerance)
{
  if (halfSpaces.size() * size > FewChecks)
  {
    return ContainMany(halfSpaces, points, size, tolerance);
  }
  for (const HalfSpace& halfSpace : halfSpaces)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      if (halfSpace.GetDistance(points[i]) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Half-spaces of a self-intersecting cell may intersect outside of it.
void AddBox(const Bounds& box, int dimension, std::vector<HalfSpace>& halfSpaces)
{
  const Vector axes[] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (int axis = 0; axis < dimension; ++axis)
  {
    halfSpaces.push_back({ axes[axis], Dot(axes[axis], box.High) });
    halfSpaces.push_back({ -axes[axis], -Dot(axes[axis], box.Low) });
  }
}

//------------------------------------------------------------------------------
Ball GetBallAround(const Bounds& box)
{
  return { box.GetCenter(), 0.5 * box.GetDiagonal() };
}
}

//------------------------------------------------------------------------------
void CellKernel::Clear()
{
  this->IsPrepared = this->HasRatio = this->HasInscribedRadius = this->HasEnclosingRadius = false;
}

//------------------------------------------------------------------------------
// Half-planes and convexity of a face with an area.
void CellKernel::FindSheet(const CellGeometry& cell, int face, Sheet& sheet) const
{
  const FaceRing ring(cell, face);
  const Vector normal = Unit(cell.GetFaceVector(face));
  const Vector away = std::abs(normal.X) < 0.5 ? Vector{ 1, 0, 0 } : Vector{ 0, 1, 0 };
  sheet.Center = cell.GetFaceCenter(face);
  sheet.U = Unit(Cross(away, normal));
  sheet.V = Cross(normal, sheet.U);
  sheet.Box = Bounds();
  sheet.Box.Add(Vector()); // the center
  sheet.Corners.clear();
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector offset = ring.GetBegin(i) - sheet.Center;
    sheet.Corners.push_back({ Dot(offset, sheet.U), Dot(offset, sheet.V), 0 });
    sheet.Box.Add(sheet.Corners.back());
  }
  sheet.HalfPlanes.clear();
  Vector previous = sheet.Corners.back();
  for (const Vector& corner : sheet.Corners)
  {
    const Vector edge = corner - previous;
    const double length = Norm(edge);
    if (length > cell.GetZeroLength())
    {
      const Vector outward = { edge.Y / length, -edge.X / length, 0 };
      sheet.HalfPlanes.push_back({ outward, Dot(outward, 0.5 * (corner + previous)) });
    }
    previous = corner;
  }
  AddBox(sheet.Box, 2, sheet.HalfPlanes);
  sheet.IsConvex =
    ContainAll(sheet.HalfPlanes, sheet.Corners.data(), sheet.Corners.size(), cell.GetZeroLength());
}

//------------------------------------------------------------------------------
// Stores the kernel of a face in Clipped; returns its area.
double CellKernel::ClipSheet(const CellGeometry& cell, const Sheet& sheet)
{
  this->Clipped.SetBox(sheet.Box.Low, sheet.Box.High);
  for (const HalfSpace& halfPlane : sheet.HalfPlanes)
  {
    this->Clipped.Clip(halfPlane, cell.GetZeroLength());
  }
  return this->Clipped.GetArea();
}

//------------------------------------------------------------------------------
void CellKernel::FindHalfSpaces(const CellGeometry& cell)
{
  this->HalfSpaces.clear();
  const double sign = cell.GetVolume() < 0 ? -1 : 1;
  for (int face = 0; face < cell.GetTopology().GetNumberOfFaces(); ++face)
  {
    this->AddHalfSpaces(cell, face, sign);
  }
  AddBox(this->Box, 3, this->HalfSpaces);
}

//------------------------------------------------------------------------------
void CellKernel::AddHalfSpaces(const CellGeometry& cell, int face, double sign)
{
  const FaceRing ring(cell, face);
  const Vector& center = cell.GetFaceCenter(face);
  const double zeroArea = cell.GetZeroLength() * this->Box.GetDiagonal();
  const Vector normal = sign * Unit(cell.GetFaceVector(face));
  const HalfSpace plane = { normal, Dot(normal, center) };
  // A self-intersecting face may have no area, and no plane, but opposite triangles.
  bool isPlanar = cell.GetFaceArea(face) > zeroArea;
  for (int i = 0; isPlanar && i < ring.GetSize(); ++i)
  {
    isPlanar = std::abs(plane.GetDistance(ring.GetBegin(i))) <= cell.GetZeroLength();
  }
  if (isPlanar)
  {
    this->HalfSpaces.push_back(plane);
    return;
  }
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector triangle = Cross(ring.GetBegin(i) - center, ring.GetEnd(i) - center);
    const double area = Norm(triangle);
    if (area > zeroArea)
    {
      const Vector outward = (sign / area) * triangle;
      this->HalfSpaces.push_back({ outward, Dot(outward, center) });
    }
  }
}

//------------------------------------------------------------------------------
void CellKernel::Prepare(const CellGeometry& cell)
{
  if (this->IsPrepared)
  {
    return;
  }
  this->IsPrepared = true;
  Ball ball;
  if (cell.GetShapes() & Polygons)
  {
    this->FindSheet(cell, 0, this->Polygon);
    this->Convex = this->Polygon.IsConvex;
    ball = FindLargestBall(this->Polygon.HalfPlanes, 2, GetBallAround(this->Polygon.Box));
  }
  else
  {
    this->Box = Bounds();
    const std::size_t numberOfPoints = cell.GetNumberOfPoints();
    for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
    {
      this->Box.Add(cell.GetPoint(i));
    }
    this->FindHalfSpaces(cell);
    this->Convex =
      ContainAll(this->HalfSpaces, &cell.GetPoint(0), numberOfPoints, cell.GetZeroLength());
    ball = FindLargestBall(this->HalfSpaces, 3, GetBallAround(this->Box));
  }
  this->Radius = ball.Radius > cell.GetZeroLength() ? ball.Radius : 0;
}

//------------------------------------------------------------------------------
double CellKernel::GetRadius(const CellGeometry& cell)
{
  this->Prepare(cell);
  return this->Radius;
}

//------------------------------------------------------------------------------
double CellKernel::GetRatio(const CellGeometry& cell)
{
  this->Prepare(cell);
  if (this->Radius == 0)
  {
    return 0;
  }
  if (this->Convex)
  {
    return 1;
  }
  if (!this->HasRatio)
  {
    this->HasRatio = true;
    if (cell.GetShapes() & Polygons)
    {
      this->Ratio = this->ClipSheet(cell, this->Polygon) / cell.GetPolygonArea();
    }
    else
    {
      this->MakePolyhedron(cell, [](double) { return true; });
      this->Ratio = this->Polyhedron.GetVolume() / std::abs(cell.GetVolume());
    }
    this->Ratio = std::min(1.0, this->Ratio);
  }
  return this->Ratio;
}

//------------------------------------------------------------------------------
bool CellKernel::MakePolyhedron(const CellGeometry& cell, const std::function<bool(double)>& goesOn)
{
  this->Prepare(cell);
  if (this->Radius == 0)
  {
    this->Polyhedron.Clear();
    return true;
  }
  this->Polyhedron.SetBox(this->Box.Low, this->Box.High);
  return this->Polyhedron.Clip(this->HalfSpaces, cell.GetZeroLength(), goesOn);
}

//------------------------------------------------------------------------------
void CellKernel::MakePolygon(const CellGeometry& cell, std::vector<Vector>& corners)
{
  this->Prepare(cell);
  corners.clear();
  if (this->Radius == 0)
  {
    return;
  }
  const Sheet& sheet = this->Polygon;
  this->ClipSheet(cell, sheet);
  for (const Vector& point : this->Clipped.GetPoints())
  {
    corners.push_back(sheet.Center + point.X * sheet.U + point.Y * sheet.V);
  }
}

//------------------------------------------------------------------------------
double CellKernel::GetInscribedRadius(const CellGeometry& polygon)
{
  this->Prepare(polygon);
  if (this->Convex)
  {
    return this->Radius;
  }
  if (!this->HasInscribedRadius)
  {
    this->HasInscribedRadius = true;
    this->InscribedRadius = this->Circle.Find(this->Polygon.Corners).Radius;
  }
  return this->InscribedRadius;
}

//------------------------------------------------------------------------------
double CellKernel::GetEnclosingRadius(const CellGeometry& cell)
{
  if (!this->HasEnclosingRadius)
  {
    this->HasEnclosingRadius = true;
    this->Points.clear();
    for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
    {
      this->Points.push_back(cell.GetPoint(i));
    }
    this->EnclosingRadius = FindSmallestBall(this->Points).Radius;
  }
  return this->EnclosingRadius;
}

//------------------------------------------------------------------------------
double CellKernel::GetFaceRatio(const CellGeometry& cell, int face)
{
  if (cell.IsZeroArea(cell.GetFaceArea(face)))
  {
    return 0;
  }
  if (cell.GetTopology().GetFaceSize(face) == 3)
  {
    return 1;
  }
  this->FindSheet(cell, face, this->Face);
  return this->Face.IsConvex
    ? 1
    : std::min(1.0, this->ClipSheet(cell, this->Face) / cell.GetFaceArea(face));
}
}
