// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

#include "Criteria/SimpleShapes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace camaron
{
namespace
{
constexpr double Pi = 3.141592653589793238462643383279502884;
constexpr double MinRelativeTolerance = 1e-12; // quality criteria, section 1
constexpr double RoundingUnits = 8;
constexpr int MaxStandardPoints = 12;
}

//------------------------------------------------------------------------------
// A cell of a fixed 3D type whose points are all different.
struct CellGeometry::StandardCell
{
  CellTopology Topology;
  unsigned Shapes = 0;
};

//------------------------------------------------------------------------------
const CellGeometry::StandardCell* CellGeometry::GetStandardCells()
{
  static const std::array<StandardCell, 256> cells = []
  {
    std::array<StandardCell, 256> result;
    for (int type = 0; type < 256; ++type)
    {
      const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
      CellTopology& topology = result[type].Topology;
      topology.Clear();
      topology.NumberOfPoints = shape.NumberOfCorners;
      for (int f = 0; f < shape.NumberOfFaces; ++f)
      {
        topology.AddFace(
          shape.FacePoints + shape.FaceOffsets[f], shape.FaceOffsets[f + 1] - shape.FaceOffsets[f]);
      }
      if (shape.NumberOfFaces > 0)
      {
        topology.Finish();
        topology.FindShells();
        topology.MakeVertexFigures();
        result[type].Shapes = Polyhedra | FindSimpleShape(topology);
      }
    }
    return result;
  }();
  return cells.data();
}

//------------------------------------------------------------------------------
CellGeometry::CellGeometry()
  : CellShapes(&GetCellShape(0))
  , StandardCells(GetStandardCells())
  , Points(MaxStandardPoints)
{
}

//------------------------------------------------------------------------------
void CellGeometry::Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options)
{
  this->CellType = mesh.GetCellType(cell);
  this->HasFloatPoints = mesh.HasFloatPoints();
  this->Options = &options;
  this->TrustFaceOrientation = options.TrustFaceOrientation;
  this->DegeneracyTolerance = options.DegeneracyTolerance;
  this->AngleFactor = options.Angles == AngleUnit::Degrees ? 180 / Pi : 1;
  this->Shapes = 0;
  this->BoxScale.Length = -1;
  this->Diameter = -1;
  this->SurfaceArea = -1;
  this->StatusIsKnown = false;
  this->Kernel.Clear();
  this->HasRepeatedPoint = false;
  this->OrientationSign = 1;
  this->NumberOfPoints = 0;
  const CellShape& shape = this->CellShapes[this->CellType];
  this->IsStandard = !shape.ListsFaces;
  if (shape.Dimension == 3)
  {
    this->IsStandard ? this->LoadStandard(mesh, shape, mesh.GetCellPoints(cell))
                     : this->LoadPolyhedron(mesh, cell);
  }
  else if (shape.Dimension == 2)
  {
    this->LoadPolygon(mesh, shape, mesh.GetCellPoints(cell));
    this->Shapes = Polygons |
      (this->NumberOfPoints == 3        ? Triangles
          : this->IsQuadrilateral() ? Quadrilaterals
                                        : 0u);
  }
  // 0 times NaN or infinity is NaN.
  double zero = 0 * (this->Origin.X + this->Origin.Y + this->Origin.Z);
  for (int i = 1; i < this->NumberOfPoints; ++i)
  {
    zero += 0 * (this->Points[i].X + this->Points[i].Y + this->Points[i].Z);
  }
  this->Finite = this->NumberOfPoints == 0 || zero == 0;
}

//------------------------------------------------------------------------------
void CellGeometry::LoadStandard(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = shape.NumberOfCorners;
  vtkIdType ids[MaxStandardPoints];
  bool distinct = true;
  for (int i = 0; i < size; ++i)
  {
    ids[i] = points[i];
    for (int j = 0; j < i; ++j)
    {
      distinct = distinct && ids[j] != ids[i];
    }
  }
  if (!distinct)
  {
    this->LoadCollapsed(mesh, shape, points);
    return;
  }
  double x[3];
  mesh.GetPoint(ids[0], x);
  const Vector origin = { x[0], x[1], x[2] };
  Vector* to = this->Points.data(); // has room for every standard cell
  to[0] = Vector();
  for (int i = 1; i < size; ++i)
  {
    mesh.GetPoint(ids[i], x);
    to[i] = { x[0] - origin.X, x[1] - origin.Y, x[2] - origin.Z };
  }
  this->Origin = origin;
  this->NumberOfPoints = size;
  this->Nodes = points;
  this->Topology = &this->StandardCells[this->CellType].Topology;
  this->Shapes = this->StandardCells[this->CellType].Shapes;
}

//------------------------------------------------------------------------------
// A standard cell with a point used twice is what remains of its faces.
void CellGeometry::LoadCollapsed(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  this->CornerIds.resize(shape.NumberOfCorners);
  for (int i = 0; i < shape.NumberOfCorners; ++i)
  {
    this->CornerIds[i] = points[i];
  }
  int locals[MaxStandardPoints];
  this->NumberPoints(mesh, locals);
  this->OwnTopology.Clear();
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    int face[CellShape::MaxFacePoints];
    int size = 0;
    for (int i = shape.FaceOffsets[f]; i < shape.FaceOffsets[f + 1]; ++i)
    {
      face[size++] = locals[shape.FacePoints[i]];
    }
    this->OwnTopology.AddFace(face, size);
  }
  this->FinishOwnTopology();
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolygon(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = static_cast<int>(shape.NumberOfCorners ? shape.NumberOfCorners
      : this->CellType == VTK_QUADRATIC_POLYGON           ? points.Size / 2
                                                          : points.Size);
  this->CornerIds.resize(size);
  for (int i = 0; i < size; ++i)
  {
    this->CornerIds[i] = points[this->CellType == VTK_PIXEL && i > 1 ? 5 - i : i];
  }
  this->OwnTopology.Clear();
  this->OwnTopology.AddFace(size);
  this->OwnTopology.FacePoints.resize(size);
  this->NumberPoints(mesh, this->OwnTopology.FacePoints.data());
  this->FinishOwnTopology();
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolyhedron(const MeshView& mesh, vtkIdType cell)
{
  CellTopology& topology = this->OwnTopology;
  topology.Clear();
  const IndexRange faces = mesh.GetPolyhedronFaces(cell);
  for (vtkIdType f = 0; f < faces.Size; ++f)
  {
    topology.AddFace(static_cast<int>(mesh.GetPolyhedronFacePoints(faces[f]).Size));
  }
  const int size = topology.FaceOffsets.back();
  topology.FacePoints.resize(size);
  this->CornerIds.resize(size);
  vtkIdType* to = this->CornerIds.data();
  for (vtkIdType f = 0; f < faces.Size; ++f)
  {
    const IndexRange points = mesh.GetPolyhedronFacePoints(faces[f]);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      *to++ = points[i];
    }
  }
  this->NumberPoints(mesh, topology.FacePoints.data());
  this->FinishOwnTopology(this->NumberOfPoints > MaxSimpleNodes);
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
// Takes the different points of CornerIds; @a numbers are their local numbers.
void CellGeometry::NumberPoints(const MeshView& mesh, int* numbers)
{
  const vtkIdType* ids = this->CornerIds.data();
  const int count = this->PointNumbers.Number(
    static_cast<int>(this->CornerIds.size()), [ids](int i) { return ids[i]; }, numbers);
  this->NumberOfPoints = count;
  this->PointIds.resize(count);
  if (this->Points.size() < static_cast<std::size_t>(count))
  {
    this->Points.resize(2 * count);
  }
  double x[3];
  for (int point = 0; point < count; ++point)
  {
    const vtkIdType id = ids[this->PointNumbers.GetFirst(point)];
    this->PointIds[point] = id;
    mesh.GetPoint(id, x);
    if (point == 0)
    {
      this->Origin = { x[0], x[1], x[2] };
    }
    this->Points[point] = { x[0] - this->Origin.X, x[1] - this->Origin.Y, x[2] - this->Origin.Z };
  }
}

//------------------------------------------------------------------------------
void CellGeometry::FinishOwnTopology(bool edgesCanWait)
{
  this->OwnTopology.NumberOfPoints = this->NumberOfPoints;
  this->HasRepeatedPoint = this->OwnTopology.Finish(edgesCanWait);
  this->Topology = &this->OwnTopology;
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
