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

//------------------------------------------------------------------------------
std::size_t Hash(vtkIdType id)
{
  return static_cast<std::size_t>(static_cast<std::uint64_t>(id) * 0x9e3779b97f4a7c15ull >> 32);
}
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
        topology.FindEdges();
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
inline int CellGeometry::AddPoint(const MeshView& mesh, vtkIdType id)
{
  double x[3];
  mesh.GetPoint(id, x);
  if (this->NumberOfPoints == 0)
  {
    this->Origin = { x[0], x[1], x[2] };
  }
  const Vector point = { x[0] - this->Origin.X, x[1] - this->Origin.Y, x[2] - this->Origin.Z };
  if (this->NumberOfPoints == static_cast<int>(this->Points.size()))
  {
    this->Points.resize(2 * this->Points.size());
  }
  this->Points[this->NumberOfPoints] = point;
  return this->NumberOfPoints++;
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
  int locals[MaxStandardPoints];
  this->StartHashTable(shape.NumberOfCorners);
  for (int i = 0; i < shape.NumberOfCorners; ++i)
  {
    locals[i] = this->FindOrAddPoint(mesh, points[i]);
  }
  this->OwnTopology.Clear();
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    this->LocalFace.clear();
    for (int i = shape.FaceOffsets[f]; i < shape.FaceOffsets[f + 1]; ++i)
    {
      this->LocalFace.push_back(locals[shape.FacePoints[i]]);
    }
    this->AddFace(this->LocalFace.data(), static_cast<int>(this->LocalFace.size()));
  }
  this->FinishOwnTopology();
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
// Local numbers of points are found by an open hash table with at least twice as many places as points.
void CellGeometry::StartHashTable(vtkIdType expectedPoints)
{
  std::size_t places = 16;
  while (places < 2 * static_cast<std::size_t>(expectedPoints + 1))
  {
    places *= 2;
  }
  this->HashTable.assign(places, -1);
  this->PointIds.clear();
}

//------------------------------------------------------------------------------
inline int CellGeometry::FindOrAddPoint(const MeshView& mesh, vtkIdType id)
{
  const std::size_t mask = this->HashTable.size() - 1;
  std::size_t place = Hash(id) & mask;
  while (this->HashTable[place] >= 0)
  {
    if (this->PointIds[this->HashTable[place]] == id)
    {
      return this->HashTable[place];
    }
    place = (place + 1) & mask;
  }
  const int local = this->AddPoint(mesh, id);
  this->HashTable[place] = local;
  this->PointIds.push_back(id);
  if (2 * this->PointIds.size() > this->HashTable.size())
  {
    // The cell has more points than its own list says.
    const std::vector<vtkIdType> ids(this->PointIds);
    this->StartHashTable(2 * static_cast<vtkIdType>(ids.size()));
    for (const vtkIdType known : ids)
    {
      place = Hash(known) & (this->HashTable.size() - 1);
      while (this->HashTable[place] >= 0)
      {
        place = (place + 1) & (this->HashTable.size() - 1);
      }
      this->HashTable[place] = static_cast<int>(this->PointIds.size());
      this->PointIds.push_back(known);
    }
  }
  return local;
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolygon(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = static_cast<int>(shape.NumberOfCorners ? shape.NumberOfCorners
      : this->CellType == VTK_QUADRATIC_POLYGON           ? points.Size / 2
                                                          : points.Size);
  this->OwnTopology.Clear();
  this->LocalFace.resize(size);
  this->StartHashTable(size);
  for (int i = 0; i < size; ++i)
  {
    const int node = this->CellType == VTK_PIXEL && i > 1 ? 5 - i : i;
    this->LocalFace[i] = this->FindOrAddPoint(mesh, points[node]);
  }
  this->AddFace(this->LocalFace.data(), size);
  this->FinishOwnTopology();
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolyhedron(const MeshView& mesh, vtkIdType cell)
{
  this->OwnTopology.Clear();
  this->StartHashTable(mesh.GetCellPoints(cell).Size);
  const IndexRange faces = mesh.GetPolyhedronFaces(cell);
  for (vtkIdType f = 0; f < faces.Size; ++f)
  {
    const IndexRange points = mesh.GetPolyhedronFacePoints(faces[f]);
    this->LocalFace.resize(points.Size);
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      this->LocalFace[i] = this->FindOrAddPoint(mesh, points[i]);
    }
    this->AddFace(this->LocalFace.data(), static_cast<int>(points.Size));
  }
  this->FinishOwnTopology();
  this->Shapes = Polyhedra | FindSimpleShape(*this->Topology);
}

//------------------------------------------------------------------------------
void CellGeometry::AddFace(const int* points, int size)
{
  this->HasRepeatedPoint = this->OwnTopology.AddFace(points, size) || this->HasRepeatedPoint;
}

//------------------------------------------------------------------------------
void CellGeometry::FinishOwnTopology()
{
  this->OwnTopology.NumberOfPoints = this->NumberOfPoints;
  this->OwnTopology.FindEdges();
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
  const unsigned oriented = NeedsVolume | NeedsDihedral | NeedsSolidAngle;
  if (isPolyhedron && !this->IsStandard && !this->TrustFaceOrientation && (needs & oriented) &&
    !this->Topology->IsClosed)
  {
    this->OwnTopology.MakeConsistent();
  }
  else if (isPolyhedron && !this->IsStandard)
  {
    this->OwnTopology.MakeOneGroup();
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
// Volume under the faces of a group, or of all groups; also right for a group alone when it is closed.
double CellGeometry::SumVolume(int group) const
{
  double sum = 0;
  for (int f = 0; f < this->Topology->GetNumberOfFaces(); ++f)
  {
    if (group < 0 || this->Topology->GetGroup(f) == group)
    {
      sum += Dot(this->FaceVectors[f], this->FaceCenters[f]);
    }
  }
  return sum / 3;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeVolume()
{
  if (!this->Topology->IsClosed || this->Topology->GetNumberOfFaces() < 4)
  {
    this->Volume = Null(NullReason::InvalidTopology);
    return;
  }
  if (!this->IsStandard && !this->TrustFaceOrientation)
  {
    this->OrientPolyhedron();
  }
  this->Volume = this->IsStandard && (this->Shapes & Tetrahedra)
    ? Dot(this->Points[1], Cross(this->Points[2], this->Points[3])) / 6
    : this->SumVolume(-1);
  this->OrientationSign = this->Volume < 0 ? -1 : 1;
}

//------------------------------------------------------------------------------
void CellGeometry::OrientPolyhedron()
{
  for (int group = 0; group < this->OwnTopology.GetNumberOfGroups(); ++group)
  {
    if (this->SumVolume(group) < 0)
    {
      this->OwnTopology.ReverseFaces(group);
      for (int f = 0; f < this->OwnTopology.GetNumberOfFaces(); ++f)
      {
        if (this->OwnTopology.GetGroup(f) == group)
        {
          this->FaceVectors[f] = -this->FaceVectors[f];
        }
      }
    }
  }
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
