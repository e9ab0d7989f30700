// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/CellGeometry.h"

#include "Geometry/Bounds.h"
#include "Geometry/PointPairs.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace camaron
{
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
  if ((needs & (NeedsEdges | NeedsAngles)) && this->OwnTopology)
  {
    this->OwnTopology->FindEdges();
  }
  const unsigned oriented = NeedsVolume | NeedsDihedral | NeedsSolidAngle;
  if (isPolyhedron && (needs & oriented) && this->OwnTopology)
  {
    this->OwnTopology->CheckClosed();
    this->IsToBeOriented() && !this->Topology->IsClosed ? this->OwnTopology->MakeConsistent()
                                                        : this->OwnTopology->FindShells();
  }
  if (needs & (NeedsEdges | NeedsAngles))
  {
    this->ComputeEdges();
  }
  if (needs & NeedsAngles)
  {
    this->HasCollapsedEdge = this->IsZeroLength(this->GetMinEdgeLength());
  }
  const unsigned withFaces = NeedsFaces | NeedsAngles;
  if (needs & (this->IsTetrahedronByNodes() ? withFaces : withFaces | NeedsVolume))
  {
    this->ComputeFaces((needs & NeedsCentroid) != 0);
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
  const double length = camaron::GetZeroLength(*this->Options, diameter, this->AbsoluteTolerance);
  return { length, length * diameter, length * diameter * diameter };
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeBoxScale() const
{
  Bounds box;
  box.Add(Vector()); // the first point
  for (int i = 1; i < this->NumberOfPoints; ++i)
  {
    box.Add(this->Points[i]);
  }
  const Vector origin = this->LengthExponent == 0 ? this->Origin : -this->ToCell(Vector());
  const double largest =
    std::max(GetLargestComponent(box.Low + origin), GetLargestComponent(box.High + origin));
  this->AbsoluteTolerance = GetAbsoluteTolerance(largest);
  this->BoxScale = this->GetScale(box.GetDiagonal());
}

//------------------------------------------------------------------------------
double CellGeometry::GetDiameter() const
{
  if (this->Diameter < 0)
  {
    this->Diameter =
      std::sqrt(FindLargestSquaredDistance(this->Points.data(), this->NumberOfPoints));
  }
  return this->Diameter;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeEdges()
{
  const std::vector<CellTopology::Edge>& edges = this->Topology->Edges;
  this->SquaredLengths.resize(edges.size());
  double smallest =
    edges.empty() || this->HasRepeatedPoint ? 0 : std::numeric_limits<double>::max();
  double largest = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const double square =
      Norm2(this->Points[edges[e].Points[1]] - this->Points[edges[e].Points[0]]);
    this->SquaredLengths[e] = square;
    smallest = std::min(smallest, square);
    largest = std::max(largest, square);
  }
  if (edges.empty())
  {
    // Too few points for a face, but they may be distinct.
    largest = this->GetDiameter() * this->GetDiameter();
  }
  this->MinSquaredLength = smallest;
  this->MaxSquaredLength = largest;
}

//------------------------------------------------------------------------------
double CellGeometry::GetSumOfSquaredLengths() const
{
  return std::accumulate(this->SquaredLengths.begin(), this->SquaredLengths.end(), 0.0);
}

//------------------------------------------------------------------------------
double CellGeometry::GetTotalEdgeLength() const
{
  return std::accumulate(this->SquaredLengths.begin(), this->SquaredLengths.end(), 0.0,
    [](double sum, double square) { return sum + std::sqrt(square); });
}

//------------------------------------------------------------------------------
double CellGeometry::GetPerimeter() const
{
  const bool isFace = this->Topology->GetNumberOfFaces() > 0;
  const int size = isFace ? this->Topology->GetFaceSize(0) : 0;
  if (!isFace || size == this->GetNumberOfEdges())
  {
    return this->GetTotalEdgeLength();
  }
  double sum = 0;
  for (int i = 0; i < size; ++i)
  {
    const int* const corners = this->Topology->GetFace(0);
    sum += Norm(this->Points[corners[i]] - this->Points[corners[i == 0 ? size - 1 : i - 1]]);
  }
  return sum;
}

//------------------------------------------------------------------------------
// From the signed tetrahedra formed by the origin, every edge of a face and the center of that
// face.
void CellGeometry::ComputeCentroid()
{
  const int numberOfFaces = this->Topology->GetNumberOfFaces();
  if (this->Shapes & Polygons)
  {
    this->Centroid = numberOfFaces > 0 ? this->FaceCenters[0] : Vector();
    return;
  }
  Vector moment;
  double volume = 0; // times three
  for (int f = 0; f < numberOfFaces; ++f)
  {
    volume += Dot(this->FaceVectors[f], this->FaceCenters[f]);
    moment += this->FaceMoments[f];
  }
  if (!std::isnan(this->Volume) && !this->IsZeroVolume(volume / 3))
  {
    this->Centroid = (1 / (8 * volume)) * moment;
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
