// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PolygonTriangulator.h"

#include "Geometry/FacetRing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
/// Tolerances for roundoff, tried in turn until nothing overlaps, for a largest coordinate of 1:
/// numbers in double precision, the same far from the origin, in single precision, with six digits.
constexpr double Tolerances[] = { 1e-15, 1e-12, 1e-9, 1e-7, 1e-5 };
/// Area of a triangle of a fan, divided by the total area and multiplied by the cube of the number
/// of vertices, below which its vertices may be collinear. It is 100 and more for regular polygons.
constexpr double SmallestShare = 1e-9;
/// The limit for triangles without area that roundoff has reversed.
constexpr double RoundedShare = -1e-12;
/// Vector area divided by the sum of the areas below which parts of a polygon cancel.
constexpr double SmallestSum = 1e-13;

//------------------------------------------------------------------------------
bool IsBefore(const Vector& a, const Vector& b)
{
  return a.X != b.X ? a.X < b.X : std::tie(a.Y, a.Z) < std::tie(b.Y, b.Z);
}

//------------------------------------------------------------------------------
int FindFirst(const Vector* corners, int size)
{
  return static_cast<int>(std::min_element(corners, corners + size, IsBefore) - corners);
}
}

//------------------------------------------------------------------------------
void PolygonTriangulator::Cut(const Vector* corners, int size)
{
  this->Triangles.clear();
  this->Overlap = 0;
  if (size == 3)
  {
    this->Triangles.push_back({ { 0, 1, 2 } });
    this->Area = 0.5 * Norm(Cross(corners[1] - corners[0], corners[2] - corners[0]));
  }
  else if (size == 4)
  {
    this->CutQuadrilateral(corners);
  }
  else if (size > 4 && !this->CutFan(corners, size))
  {
    this->CutEars(corners, size);
  }
}

//------------------------------------------------------------------------------
void PolygonTriangulator::AddFan(int size, int first)
{
  const auto next = [size](int place) { return place + 1 < size ? place + 1 : 0; };
  for (int i = next(first), count = size - 2; count > 0; --count, i = next(i))
  {
    this->Triangles.push_back({ { first, i, next(i) } });
  }
}

//------------------------------------------------------------------------------
double PolygonTriangulator::GetLeastShare(int size) const
{
  const double corners = size;
  return this->KeepsFans ? RoundedShare : SmallestShare / (corners * corners * corners);
}

//------------------------------------------------------------------------------
// The diagonal at the first vertex, unless only the other one creates triangles with the
// orientation of the polygon.
void PolygonTriangulator::CutQuadrilateral(const Vector* corners)
{
  const int first = FindFirst(corners, 4);
  const auto corner = [&](int i) { return corners[(first + i) & 3]; };
  const Vector a = corner(1) - corner(0), b = corner(2) - corner(0), c = corner(3) - corner(0);
  const Vector ofFirst[2] = { Cross(a, b), Cross(b, c) };
  const Vector sum = ofFirst[0] + ofFirst[1];
  const bool cancels =
    Norm2(sum) <= SmallestSum * SmallestSum * (Norm2(ofFirst[0]) + Norm2(ofFirst[1]));
  const Vector& normal = cancels ? ofFirst[0] : sum;
  double smallest = std::min(Dot(ofFirst[0], normal), Dot(ofFirst[1], normal));
  int begin = first;
  if (!(smallest > this->GetLeastShare(4) * Norm2(normal)))
  {
    const Vector ofOther[2] = { Cross(b - a, c - a), Cross(a, c) };
    const double other = std::min(Dot(ofOther[0], normal), Dot(ofOther[1], normal));
    begin = other > smallest ? (first + 1) & 3 : first;
    smallest = std::max(smallest, other);
  }
  this->AddFan(4, begin);
  const double length = Norm(normal);
  this->Area = 0.5 * Norm(sum);
  this->Overlap = smallest < 0 ? -0.5 * smallest / length : 0;
}

//------------------------------------------------------------------------------
bool PolygonTriangulator::CutFan(const Vector* corners, int size)
{
  const int first = FindFirst(corners, size);
  const Vector& origin = corners[first];
  const auto next = [size](int place) { return place + 1 < size ? place + 1 : 0; };
  this->Normals.resize(size - 2);
  Vector sum;
  int place = next(first);
  Vector edge = corners[place] - origin;
  for (Vector& normal : this->Normals)
  {
    place = next(place);
    const Vector following = corners[place] - origin;
    normal = Cross(edge, following);
    sum += normal;
    edge = following;
  }
  const double share = this->GetLeastShare(size) * Norm2(sum);
  const bool isSeen = std::all_of(this->Normals.begin(), this->Normals.end(),
    [&](const Vector& normal) { return Dot(normal, sum) > share; });
  if (isSeen)
  {
    this->AddFan(size, first);
    this->Area = 0.5 * Norm(sum);
  }
  return isSeen;
}

//------------------------------------------------------------------------------
// False if any coordinate is nonfinite.
bool PolygonTriangulator::Order(const Vector* corners, int size)
{
  if (!std::all_of(corners, corners + size, IsFinite))
  {
    return false;
  }
  const auto at = [&](vtkIdType i)
  { return std::make_tuple(corners[i].X, corners[i].Y, corners[i].Z); };
  this->RunsBack = RingRunsDown(size, at);
  const auto back = [&](vtkIdType i) { return at(size - 1 - i); };
  const auto first =
    static_cast<int>(this->RunsBack ? FindLeastRotation(size, back) : FindLeastRotation(size, at));
  this->Sequence.resize(size);
  this->Places.resize(size);
  double largest = 0;
  for (int i = 0; i < size; ++i)
  {
    const int place = (first + i) % size;
    this->Sequence[i] = this->RunsBack ? size - 1 - place : place;
    this->Places[i] = corners[this->Sequence[i]] - corners[this->Sequence[0]];
    largest = std::max(largest, GetLargestComponent(this->Places[i]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Vector& place : this->Places)
  {
    place = TimesPowerOfTwo(place, -exponent);
  }
  this->Unit = std::ldexp(1.0, exponent);
  return std::isfinite(largest);
}

//------------------------------------------------------------------------------
// Along the vector area, onto the coordinate plane most perpendicular to it, so that coplanar
// points keep their coordinates. False if all vertices are collinear.
bool PolygonTriangulator::Project()
{
  Vector normal, largest;
  double sum = 0;
  for (std::size_t i = 1; i + 1 < this->Places.size(); ++i)
  {
    const Vector area = Cross(this->Places[i], this->Places[i + 1]);
    normal += area;
    sum += Norm(area);
    largest = Norm2(area) > Norm2(largest) ? area : largest;
  }
  normal = Norm(normal) > SmallestSum * sum ? normal : largest;
  const double square = Norm2(normal);
  if (!(square > 0))
  {
    return false;
  }
  const double x = std::abs(normal.X), y = std::abs(normal.Y), z = std::abs(normal.Z);
  const auto axis = x > y && x > z ? &Vector::X : y > z ? &Vector::Y : &Vector::Z;
  auto first = axis == &Vector::X ? &Vector::Y : axis == &Vector::Y ? &Vector::Z : &Vector::X;
  auto second = axis == &Vector::X ? &Vector::Z : axis == &Vector::Y ? &Vector::X : &Vector::Y;
  if (normal.*axis < 0)
  {
    std::swap(first, second);
  }
  this->Flat.clear();
  for (const Vector& place : this->Places)
  {
    const Vector flat = place - (Dot(normal, place) / square) * normal;
    this->Flat.push_back({ flat.*first, flat.*second, 0 });
  }
  this->Slope = std::sqrt(square) / std::abs(normal.*axis);
  return true;
}

//------------------------------------------------------------------------------
void PolygonTriangulator::Measure(const std::vector<Triangle>& triangles)
{
  this->Area = this->Overlap = 0;
  for (const Triangle& t : triangles)
  {
    const Vector a = this->Flat[t[1]] - this->Flat[t[0]], b = this->Flat[t[2]] - this->Flat[t[0]];
    const double area = 0.5 * this->Slope * (a.X * b.Y - a.Y * b.X);
    (area < 0 ? this->Overlap : this->Area) += std::abs(area);
  }
}

//------------------------------------------------------------------------------
void PolygonTriangulator::CutEars(const Vector* corners, int size)
{
  if (!this->Order(corners, size) || !this->Project())
  {
    this->Area = 0;
    this->AddFan(size, 0);
    return;
  }
  double area = 0, overlap = std::numeric_limits<double>::infinity();
  for (const double tolerance : Tolerances)
  {
    this->Ears.Cut(this->Flat.data(), this->Places.data(), size, tolerance, this->Tried);
    this->Measure(this->Tried);
    if (this->Overlap < overlap)
    {
      area = this->Area;
      overlap = this->Overlap;
      this->Triangles.swap(this->Tried);
    }
    if (overlap <= tolerance * area)
    {
      break;
    }
  }
  const double unitArea = this->Unit * this->Unit;
  this->Area = unitArea * (area - overlap);
  this->Overlap = unitArea * overlap;
  for (Triangle& triangle : this->Triangles)
  {
    for (int& corner : triangle)
    {
      corner = this->Sequence[corner];
    }
    if (this->RunsBack)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
}
}
