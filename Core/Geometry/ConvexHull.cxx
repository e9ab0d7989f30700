// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/ConvexHull.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr double RoundingUnits = 8;
constexpr double MaxTolerance = 1e-3; // for a set of size 1

//------------------------------------------------------------------------------
bool IsSingle(double x)
{
  return static_cast<float>(x) == x;
}

//------------------------------------------------------------------------------
// The roundoff of the points. The decimal digits of the values show whether they were single
// precision before, not their type.
double GetPrecision(const std::vector<Vector>& points, double largest)
{
  const bool areSingle = largest < std::numeric_limits<float>::max() &&
    std::all_of(
      points.begin(), points.end(),
      [](const Vector& p) { return IsSingle(p.X) && IsSingle(p.Y) && IsSingle(p.Z); });
  return RoundingUnits * largest *
    (areSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
}
}

//------------------------------------------------------------------------------
void ConvexHull::Compute(const std::vector<Vector>& points)
{
  this->Faces.clear();
  if (this->MakeRound(points))
  {
    this->AddHalfSpaces();
    // In every direction the points extend at least 1 / Radius: their mean is 0, their variance 1,
    // which is at most the product of the extents in both directions (Bhatia and Davis 2000).
    const double size = 2 * this->Radius;
    this->Polar.SetBox({ -size, -size, -size }, { size, size, size });
    this->Polar.Clip(this->HalfSpaces, this->Tolerance, [](double) { return true; });
    this->CollectFaces();
  }
}

//------------------------------------------------------------------------------
// Scales sets, including flat and slender ones, to the same size in all directions, which does not
// change the vertices of faces. Returns false for sets without volume.
bool ConvexHull::MakeRound(const std::vector<Vector>& points)
{
  this->Round = points;
  Vector mean;
  double largest = 0;
  for (const Vector& point : points)
  {
    mean += (1.0 / static_cast<double>(points.size())) * point;
    largest = std::max(largest, GetLargestComponent(point));
  }
  double covariance[3][3] = {}, axes[3][3], squares[3];
  for (Vector& point : this->Round)
  {
    point = point - mean;
    const double x[3] = { point.X, point.Y, point.Z };
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        covariance[row][column] += x[row] * x[column] / static_cast<double>(points.size());
      }
    }
  }
  double* rows[3] = { covariance[0], covariance[1], covariance[2] };
  double* vectors[3] = { axes[0], axes[1], axes[2] };
  vtkMath::Jacobi(rows, squares, vectors); // largest first, vectors in columns
  Vector along[3] = { { axes[0][0], axes[1][0], axes[2][0] },
    { axes[0][1], axes[1][1], axes[2][1] } };
  along[2] = Cross(along[0], along[1]); // keeps the orientation of faces
  double sizes[3] = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Vector& point :
      this->Round) // again, because roundoff hides small ones in the matrix
    {
      sizes[axis] +=
        Dot(point, along[axis]) * Dot(point, along[axis]) / static_cast<double>(points.size());
    }
    sizes[axis] = std::sqrt(sizes[axis]);
  }
  const double smallest = *std::min_element(sizes, sizes + 3);
  if (!(smallest > RoundingUnits * std::numeric_limits<double>::epsilon() * largest))
  {
    return false;
  }
  this->Tolerance = std::min(MaxTolerance, GetPrecision(points, largest) / smallest);
  this->Radius = 0;
  for (Vector& point : this->Round)
  {
    point = { Dot(point, along[0]) / sizes[0], Dot(point, along[1]) / sizes[1],
      Dot(point, along[2]) / sizes[2] };
    this->Radius = std::max(this->Radius, Norm(point));
  }
  return true;
}

//------------------------------------------------------------------------------
void ConvexHull::AddHalfSpaces()
{
  this->HalfSpaces.clear();
  this->Sources.clear();
  for (std::size_t point = 0; point < this->Round.size(); ++point)
  {
    const double length = Norm(this->Round[point]);
    if (length * this->Radius > this->Tolerance) // otherwise inside
    {
      this->HalfSpaces.push_back({ (1 / length) * this->Round[point], 1 / length });
      this->Sources.push_back(static_cast<int>(point));
    }
  }
}

//------------------------------------------------------------------------------
// A face for each vertex of the polar polyhedron; its points are those of the faces around the
// vertex.
void ConvexHull::CollectFaces()
{
  const ConvexPolyhedron& polar = this->Polar;
  this->IsDone.assign(polar.GetPoints().size(), 0);
  for (int first = 0; first < polar.GetNumberOfFaces(); ++first)
  {
    for (int corner = 0; corner < polar.GetFaceSize(first); ++corner)
    {
      const int center = polar.GetFace(first)[corner];
      if (this->IsDone[center])
      {
        continue;
      }
      this->IsDone[center] = 1;
      std::vector<int> points;
      int face = first;
      do
      {
        points.push_back(
          polar.GetHalfSpace(face) < 0 ? -1 : this->Sources[polar.GetHalfSpace(face)]);
        const int* const corners = polar.GetFace(face);
        const auto at = std::find(corners, corners + polar.GetFaceSize(face), center) - corners;
        face = at < polar.GetFaceSize(face) ? polar.GetNeighbors(face)[at] : first;
      } while (face != first && points.size() <= this->Sources.size());
      if (face != first || std::find(points.begin(), points.end(), -1) != points.end())
      {
        this->Faces.clear(); // practically flat
        return;
      }
      std::reverse(points.begin(), points.end()); // they were found clockwise
      this->Faces.push_back(std::move(points));
    }
  }
}
}
