// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
constexpr double MinRelativeTolerance = 1e-12; // quality criteria, section 1
constexpr double RoundingUnits = 8;
}

//------------------------------------------------------------------------------
void CellGeometry::Compute(unsigned needs)
{
  if (!(this->Shapes & PolygonsAndPolyhedra))
  {
    return;
  }
  const bool isPolyhedron = (this->Shapes & Polyhedra) != 0;
  if (needs & NeedsCentroid)
  {
    needs |= isPolyhedron ? NeedsFaces | NeedsVolume : NeedsFaces;
  }
  if ((needs & (NeedsEdges | NeedsCorners | NeedsDihedral | NeedsSolidAngle)) &&
    this->Topology == &this->OwnTopology)
  {
    this->OwnTopology.FindEdges();
  }
  const unsigned oriented = NeedsVolume | NeedsDihedral | NeedsSolidAngle;
  if (isPolyhedron && (needs & oriented) && this->Topology == &this->OwnTopology)
  {
    this->OwnTopology.CheckClosed();
    this->IsToBeOriented() && !this->Topology->IsClosed ? this->OwnTopology.MakeConsistent()
                                                        : this->OwnTopology.FindShells();
  }
  if (needs & (NeedsEdges | NeedsCorners | NeedsDihedral | NeedsSolidAngle))
  {
    this->ComputeEdges();
  }
  const bool isStandardTetrahedron = this->IsStandard && (this->Shapes & Tetrahedra);
  const unsigned withFaces = NeedsFaces | NeedsCorners | NeedsDihedral | NeedsSolidAngle;
  if (needs & (isStandardTetrahedron ? withFaces : withFaces | NeedsVolume))
  {
    this->ComputeFaces();
  }
  if (isPolyhedron && (needs & oriented))
  {
    this->ComputeVolume();
  }
  if (needs & NeedsCentroid)
  {
    this->ComputeCentroid();
  }
  if (needs & NeedsCorners)
  {
    this->ComputeCorners();
  }
  if (isPolyhedron && (needs & NeedsDihedral))
  {
    this->ComputeDihedralAngles();
  }
  if (isPolyhedron && (needs & NeedsSolidAngle))
  {
    this->ComputeSolidAngles();
  }
}

//------------------------------------------------------------------------------
CellGeometry::Scale CellGeometry::GetScale(double diameter) const
{
  const double length = this->DegeneracyTolerance > 0
    ? this->DegeneracyTolerance * diameter
    : std::max(MinRelativeTolerance * diameter, this->AbsoluteTolerance);
  return { length, length * diameter, length * diameter * diameter };
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeBoxScale() const
{
  Vector low, high; // the first point is the origin
  for (int i = 1; i < this->NumberOfPoints; ++i)
  {
    const Vector& point = this->Points[i];
    low = { std::min(low.X, point.X), std::min(low.Y, point.Y), std::min(low.Z, point.Z) };
    high = { std::max(high.X, point.X), std::max(high.Y, point.Y), std::max(high.Z, point.Z) };
  }
  const Vector a = low + this->Origin, b = high + this->Origin;
  const double largest = std::max({ std::abs(a.X), std::abs(a.Y), std::abs(a.Z), std::abs(b.X),
    std::abs(b.Y), std::abs(b.Z) });
  this->AbsoluteTolerance = RoundingUnits * largest *
    (this->HasFloatPoints ? std::numeric_limits<float>::epsilon()
                          : std::numeric_limits<double>::epsilon());
  this->BoxScale = this->GetScale(Norm(high - low));
}

//------------------------------------------------------------------------------
double CellGeometry::GetDiameter() const
{
  if (this->Diameter < 0)
  {
    double largest = 0;
    for (int i = 0; i < this->NumberOfPoints; ++i)
    {
      for (int j = 0; j < i; ++j)
      {
        largest = std::max(largest, Norm2(this->Points[i] - this->Points[j]));
      }
    }
    this->Diameter = std::sqrt(largest);
  }
  return this->Diameter;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeEdges()
{
  const std::vector<CellTopology::Edge>& edges = this->Topology->Edges;
  this->SquaredLengths.resize(edges.size());
  double smallest = edges.empty() || this->HasRepeatedPoint ? 0 : std::numeric_limits<double>::max();
  double largest = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const double square = Norm2(this->Points[edges[e].Points[1]] - this->Points[edges[e].Points[0]]);
    this->SquaredLengths[e] = square;
    smallest = std::min(smallest, square);
    largest = std::max(largest, square);
  }
  if (edges.empty())
  {
    // Too few points for a face, yet they may lie apart.
    largest = this->GetDiameter() * this->GetDiameter();
  }
  this->MinSquaredLength = smallest;
  this->MaxSquaredLength = largest;
  this->HasCollapsedEdge = this->IsZeroLength(std::sqrt(smallest));
}

//------------------------------------------------------------------------------
double CellGeometry::GetSumOfSquaredLengths() const
{
  double sum = 0;
  for (const double square : this->SquaredLengths)
  {
    sum += square;
  }
  return sum;
}

//------------------------------------------------------------------------------
double CellGeometry::GetTotalEdgeLength() const
{
  double sum = 0;
  for (const double square : this->SquaredLengths)
  {
    sum += std::sqrt(square);
  }
  return sum;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeFaces()
{
  const CellTopology& topology = *this->Topology;
  const int numberOfFaces = topology.GetNumberOfFaces();
  this->FaceVectors.resize(numberOfFaces);
  this->FaceCenters.resize(numberOfFaces);
  this->FaceAreas.resize(numberOfFaces);
  for (int f = 0; f < numberOfFaces; ++f)
  {
    const int* face = topology.GetFace(f);
    const int size = topology.GetFaceSize(f);
    const Vector& p0 = this->Points[face[0]];
    if (size == 3)
    {
      const Vector &p1 = this->Points[face[1]], &p2 = this->Points[face[2]];
      this->FaceVectors[f] = 0.5 * Cross(p1 - p0, p2 - p0);
      this->FaceCenters[f] = (1.0 / 3) * (p0 + p1 + p2);
      this->FaceAreas[f] = Norm(this->FaceVectors[f]);
      continue;
    }
    Vector sum, mean;
    for (int i = 0; i < size; ++i)
    {
      mean += this->Points[face[i]];
    }
    mean = (1.0 / size) * mean;
    // Twice the vector area, and the centre from triangles about the mean with signed weights. The
    // weights need the direction of the whole area: moments keep the products until it is known.
    Vector moments[3];
    Vector previous = this->Points[face[size - 1]] - mean;
    for (int i = 0; i < size; ++i)
    {
      const Vector next = this->Points[face[i]] - mean;
      const Vector triangle = Cross(previous, next);
      const Vector ends = previous + next;
      sum += triangle;
      moments[0] += triangle.X * ends;
      moments[1] += triangle.Y * ends;
      moments[2] += triangle.Z * ends;
      previous = next;
    }
    const double square = Norm2(sum);
    this->FaceVectors[f] = 0.5 * sum;
    this->FaceAreas[f] = 0.5 * std::sqrt(square);
    Vector offset;
    if (!this->IsZeroArea(this->FaceAreas[f]))
    {
      offset = (1 / (3 * square)) * (sum.X * moments[0] + sum.Y * moments[1] + sum.Z * moments[2]);
    }
    this->FaceCenters[f] = mean + offset;
  }
}

//------------------------------------------------------------------------------
double CellGeometry::GetFanArea(int f) const
{
  const int* face = this->Topology->GetFace(f);
  const int size = this->Topology->GetFaceSize(f);
  if (size == 3)
  {
    return this->FaceAreas[f];
  }
  const Vector& center = this->FaceCenters[f];
  double sum = 0;
  Vector previous = this->Points[face[size - 1]] - center;
  for (int i = 0; i < size; ++i)
  {
    const Vector next = this->Points[face[i]] - center;
    const Vector triangle = Cross(previous, next);
    const double area = Norm(triangle);
    sum += Dot(triangle, this->FaceVectors[f]) < 0 ? -area : area;
    previous = next;
  }
  return 0.5 * sum;
}

//------------------------------------------------------------------------------
double CellGeometry::GetSurfaceArea() const
{
  if (this->SurfaceArea < 0)
  {
    this->SurfaceArea = 0;
    for (int f = 0; f < this->Topology->GetNumberOfFaces(); ++f)
    {
      this->SurfaceArea += this->GetFanArea(f);
    }
  }
  return this->SurfaceArea;
}

//------------------------------------------------------------------------------
// From the tetrahedra of the origin, every edge of a face and the centre of that face, with signs.
void CellGeometry::ComputeCentroid()
{
  const CellTopology& topology = *this->Topology;
  if (this->Shapes & Polygons)
  {
    this->Centroid = topology.GetNumberOfFaces() > 0 ? this->FaceCenters[0] : Vector();
    return;
  }
  Vector moment;
  double volume = 0; // times six
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* face = topology.GetFace(f);
    const int size = topology.GetFaceSize(f);
    const Vector& center = this->FaceCenters[f];
    for (int i = 0; i < size; ++i)
    {
      const Vector &a = this->Points[face[i]], &b = this->Points[face[i + 1 < size ? i + 1 : 0]];
      const double part = Dot(center, Cross(a, b));
      volume += part;
      moment += part * (a + b + center);
    }
  }
  if (!std::isnan(this->Volume) && !this->IsZeroVolume(volume / 6))
  {
    this->Centroid = (1 / (4 * volume)) * moment;
    return;
  }
  Vector sum;
  for (int i = 0; i < this->NumberOfPoints; ++i)
  {
    sum += this->Points[i];
  }
  this->Centroid = (1.0 / std::max(1, this->NumberOfPoints)) * sum;
}
}
