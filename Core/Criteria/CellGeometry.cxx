// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

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

//------------------------------------------------------------------------------
// The topology of every standard type, whose points are all different.
const CellTopology& GetStandardTopology(unsigned char cellType)
{
  static const std::array<CellTopology, 256> topologies = []
  {
    std::array<CellTopology, 256> result;
    for (int type = 0; type < 256; ++type)
    {
      const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
      CellTopology& topology = result[type];
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
      }
    }
    return result;
  }();
  return topologies[cellType];
}

//------------------------------------------------------------------------------
AngleRange NullAngles(NullReason reason)
{
  return { Null(reason), Null(reason) };
}

//------------------------------------------------------------------------------
// An angle in [0, 2 pi) as its sine and cosine times any positive factor, compared without atan2.
struct Direction
{
  double Sine = 0, Cosine = 0;

  double Order() const
  {
    const double sum = std::abs(this->Sine) + std::abs(this->Cosine);
    const double x = sum > 0 ? this->Cosine / sum : 1;
    return this->Sine >= 0 ? 1 - x : 3 + x;
  }
  double Angle() const
  {
    const double angle = std::atan2(this->Sine, this->Cosine);
    return angle < 0 ? angle + 2 * Pi : angle;
  }
};

//------------------------------------------------------------------------------
class DirectionRange
{
public:
  void Add(const Direction& direction)
  {
    const double order = direction.Order();
    if (order < this->MinOrder)
    {
      this->MinOrder = order;
      this->Min = direction;
    }
    if (order > this->MaxOrder)
    {
      this->MaxOrder = order;
      this->Max = direction;
    }
  }
  AngleRange Get() const
  {
    return this->MaxOrder < 0 ? NullAngles(NullReason::Degenerate)
                              : AngleRange{ this->Min.Angle(), this->Max.Angle() };
  }

private:
  double MinOrder = 5, MaxOrder = -1; // Order() is in [0, 4)
  Direction Min, Max;
};
}

//------------------------------------------------------------------------------
void CellGeometry::Load(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options)
{
  this->CellType = mesh.GetCellType(cell);
  this->TrustFaceOrientation = options.TrustFaceOrientation;
  this->AngleFactor = options.Angles == AngleUnit::Degrees ? 180 / Pi : 1;
  this->Shapes = 0;
  this->Diameter = -1;
  this->HasRepeatedPoint = false;
  this->OrientationSign = 1;
  this->Points.clear();
  this->PointIds.clear();
  const CellShape& shape = GetCellShape(this->CellType);
  this->HigherOrder = shape.IsHigherOrder;
  if (shape.Dimension == 3)
  {
    this->Shapes = Polyhedra;
    if (this->CellType == VTK_POLYHEDRON)
    {
      this->LoadPolyhedron(mesh, cell);
    }
    else
    {
      this->LoadStandard(mesh, shape, mesh.GetCellPoints(cell));
    }
    bool isTetrahedron = this->Points.size() == 4 && this->Topology->GetNumberOfFaces() == 4;
    for (int f = 0; f < this->Topology->GetNumberOfFaces() && isTetrahedron; ++f)
    {
      isTetrahedron = this->Topology->GetFaceSize(f) == 3;
    }
    this->Shapes |= isTetrahedron ? Tetrahedra : 0u;
  }
  else if (shape.Dimension == 2)
  {
    this->Shapes = Polygons;
    this->LoadPolygon(mesh, shape, mesh.GetCellPoints(cell));
    this->Shapes |= this->Points.size() == 3 ? Triangles : 0u;
  }
  else
  {
    return;
  }

  Vector low, high; // the first point is the origin
  for (const Vector& point : this->Points)
  {
    low = { std::min(low.X, point.X), std::min(low.Y, point.Y), std::min(low.Z, point.Z) };
    high = { std::max(high.X, point.X), std::max(high.Y, point.Y), std::max(high.Z, point.Z) };
  }
  this->BoxDiagonal = Norm(high - low);
  const double epsilon = mesh.HasFloatPoints() ? std::numeric_limits<float>::epsilon()
                                               : std::numeric_limits<double>::epsilon();
  const Vector &o = this->Origin, a = low + o, b = high + o;
  const double largest = std::max({ std::abs(a.X), std::abs(a.Y), std::abs(a.Z), std::abs(b.X),
    std::abs(b.Y), std::abs(b.Z) });
  this->RelativeTolerance =
    options.DegeneracyTolerance > 0 ? options.DegeneracyTolerance : MinRelativeTolerance;
  this->AbsoluteTolerance = options.DegeneracyTolerance > 0 ? 0 : RoundingUnits * epsilon * largest;
}

//------------------------------------------------------------------------------
int CellGeometry::AddPoint(const MeshView& mesh, vtkIdType id)
{
  double x[3];
  mesh.GetPoint(id, x);
  if (this->Points.empty())
  {
    this->Origin = { x[0], x[1], x[2] };
  }
  this->Points.push_back({ x[0] - this->Origin.X, x[1] - this->Origin.Y, x[2] - this->Origin.Z });
  this->PointIds.push_back(id);
  return static_cast<int>(this->Points.size()) - 1;
}

//------------------------------------------------------------------------------
// Local number of a point by an open hash table with twice as many places as points.
int CellGeometry::FindOrAddPoint(const MeshView& mesh, vtkIdType id)
{
  const std::size_t mask = this->HashTable.size() - 1;
  std::size_t place = (static_cast<std::size_t>(id) * 0x9e3779b97f4a7c15ull >> 32) & mask;
  while (this->HashTable[place] >= 0)
  {
    if (this->PointIds[this->HashTable[place]] == id)
    {
      return this->HashTable[place];
    }
    place = (place + 1) & mask;
  }
  return this->HashTable[place] = this->AddPoint(mesh, id);
}

//------------------------------------------------------------------------------
void CellGeometry::LoadStandard(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = shape.NumberOfCorners;
  bool distinct = true;
  for (int i = 0; i < size; ++i)
  {
    const vtkIdType id = points[i];
    for (int j = 0; j < i; ++j)
    {
      distinct = distinct && this->PointIds[j] != id;
    }
    this->AddPoint(mesh, id);
  }
  this->IsStandard = true;
  if (distinct)
  {
    this->Topology = &GetStandardTopology(this->CellType);
    return;
  }
  // A point used twice: the cell is what remains of its faces.
  int locals[CellShape::MaxFacePoints];
  const std::vector<vtkIdType> ids(this->PointIds);
  this->Points.clear();
  this->PointIds.clear();
  for (int i = 0; i < size; ++i)
  {
    const auto known = std::find(this->PointIds.begin(), this->PointIds.end(), ids[i]);
    locals[i] = known != this->PointIds.end() ? static_cast<int>(known - this->PointIds.begin())
                                              : this->AddPoint(mesh, ids[i]);
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
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolygon(
  const MeshView& mesh, const CellShape& shape, const IndexRange& points)
{
  const int size = static_cast<int>(shape.NumberOfCorners ? shape.NumberOfCorners
      : this->CellType == VTK_QUADRATIC_POLYGON           ? points.Size / 2
                                                          : points.Size);
  this->IsStandard = true;
  this->OwnTopology.Clear();
  this->LocalFace.clear();
  std::size_t places = 16;
  while (places < 2 * static_cast<std::size_t>(size))
  {
    places *= 2;
  }
  this->HashTable.assign(places, -1);
  for (int i = 0; i < size; ++i)
  {
    const int node = this->CellType == VTK_PIXEL && i > 1 ? 5 - i : i;
    this->LocalFace.push_back(this->FindOrAddPoint(mesh, points[node]));
  }
  this->AddFace(this->LocalFace.data(), size);
  this->FinishOwnTopology();
}

//------------------------------------------------------------------------------
void CellGeometry::LoadPolyhedron(const MeshView& mesh, vtkIdType cell)
{
  this->IsStandard = false;
  this->OwnTopology.Clear();
  const IndexRange faces = mesh.GetPolyhedronFaces(cell);
  std::size_t places = 64;
  while (places < 2 * static_cast<std::size_t>(mesh.GetCellPoints(cell).Size))
  {
    places *= 2;
  }
  this->HashTable.assign(places, -1);
  for (vtkIdType f = 0; f < faces.Size; ++f)
  {
    const IndexRange points = mesh.GetPolyhedronFacePoints(faces[f]);
    this->LocalFace.clear();
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      // The cell's own list of points may be wrong: keep a place free.
      if (2 * (this->Points.size() + 1) > this->HashTable.size())
      {
        this->HashTable.assign(2 * this->HashTable.size(), -1);
        const std::size_t mask = this->HashTable.size() - 1;
        for (int known = 0; known < static_cast<int>(this->PointIds.size()); ++known)
        {
          std::size_t place =
            (static_cast<std::size_t>(this->PointIds[known]) * 0x9e3779b97f4a7c15ull >> 32) & mask;
          while (this->HashTable[place] >= 0)
          {
            place = (place + 1) & mask;
          }
          this->HashTable[place] = known;
        }
      }
      this->LocalFace.push_back(this->FindOrAddPoint(mesh, points[i]));
    }
    this->AddFace(this->LocalFace.data(), static_cast<int>(this->LocalFace.size()));
  }
  this->FinishOwnTopology();
}

//------------------------------------------------------------------------------
void CellGeometry::AddFace(const int* points, int size)
{
  this->HasRepeatedPoint = this->OwnTopology.AddFace(points, size) || this->HasRepeatedPoint;
}

//------------------------------------------------------------------------------
void CellGeometry::FinishOwnTopology()
{
  this->OwnTopology.NumberOfPoints = static_cast<int>(this->Points.size());
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
  if (needs & (NeedsEdges | NeedsSolidAngle))
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
double CellGeometry::GetThreshold(double diameter) const
{
  return std::max(this->RelativeTolerance * diameter, this->AbsoluteTolerance);
}

// The box is at least as large as the diameter: only what may be zero pays for the exact answer.
//------------------------------------------------------------------------------
bool CellGeometry::IsZeroLength(double length) const
{
  return length <= this->GetThreshold(this->BoxDiagonal) &&
    length <= this->GetThreshold(this->GetDiameter());
}

//------------------------------------------------------------------------------
bool CellGeometry::IsZeroArea(double area) const
{
  const auto threshold = [this](double h) { return this->GetThreshold(h) * h; };
  return area <= threshold(this->BoxDiagonal) && area <= threshold(this->GetDiameter());
}

//------------------------------------------------------------------------------
bool CellGeometry::IsZeroVolume(double volume) const
{
  const auto threshold = [this](double h) { return this->GetThreshold(h) * h * h; };
  return std::abs(volume) <= threshold(this->BoxDiagonal) &&
    std::abs(volume) <= threshold(this->GetDiameter());
}

//------------------------------------------------------------------------------
double CellGeometry::GetDiameter() const
{
  if (this->Diameter < 0)
  {
    double largest = 0;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
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
  this->EdgeLengths.resize(edges.size());
  double smallest = edges.empty() || this->HasRepeatedPoint ? 0 : std::numeric_limits<double>::max();
  double largest = 0, total = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const double length =
      Norm(this->Points[edges[e].Points[1]] - this->Points[edges[e].Points[0]]);
    this->EdgeLengths[e] = length;
    smallest = std::min(smallest, length);
    largest = std::max(largest, length);
    total += length;
  }
  this->TotalEdgeLength = total;
  this->MinEdgeLength = smallest;
  this->MaxEdgeLength = largest;
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
  double sum = 0;
  for (int f = 0; f < this->Topology->GetNumberOfFaces(); ++f)
  {
    sum += this->GetFanArea(f);
  }
  return sum;
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
void CellGeometry::ComputeCorners()
{
  const int numberOfFaces = this->Topology->GetNumberOfFaces();
  this->FaceAngles.resize(numberOfFaces);
  for (int f = 0; f < numberOfFaces; ++f)
  {
    this->FaceAngles[f] = this->ComputeFaceAngles(f);
  }
}

//------------------------------------------------------------------------------
AngleRange CellGeometry::ComputeFaceAngles(int f)
{
  // Points that lie where the previous one does are passed over.
  const int* face = this->Topology->GetFace(f);
  this->Ring.clear();
  for (int i = 0; i < this->Topology->GetFaceSize(f); ++i)
  {
    if (this->Ring.empty() ||
      !this->IsZeroLength(Norm(this->Points[face[i]] - this->Points[this->Ring.back()])))
    {
      this->Ring.push_back(face[i]);
    }
  }
  while (this->Ring.size() > 1 &&
    this->IsZeroLength(Norm(this->Points[this->Ring.back()] - this->Points[this->Ring.front()])))
  {
    this->Ring.pop_back();
  }
  const int size = static_cast<int>(this->Ring.size());
  const bool isTriangle = size == 3;
  if (size < 3 || (!isTriangle && this->IsZeroArea(this->FaceAreas[f])))
  {
    return NullAngles(NullReason::Degenerate);
  }
  DirectionRange range;
  Vector toPrevious = this->Points[this->Ring[size - 1]] - this->Points[this->Ring[0]];
  for (int i = 0; i < size; ++i)
  {
    const Vector toNext =
      this->Points[this->Ring[i + 1 < size ? i + 1 : 0]] - this->Points[this->Ring[i]];
    const Vector normal = Cross(toNext, toPrevious);
    const double sine = Norm(normal);
    const bool reflex = !isTriangle && Dot(normal, this->FaceVectors[f]) < 0;
    range.Add({ reflex ? -sine : sine, Dot(toNext, toPrevious) });
    toPrevious = -toNext;
  }
  return range.Get();
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeDihedralAngles()
{
  if (!this->Topology->IsClosed || !this->Topology->IsManifold)
  {
    this->DihedralAngles = NullAngles(NullReason::InvalidTopology);
    return;
  }
  DirectionRange range;
  for (const CellTopology::Edge& edge : this->Topology->Edges)
  {
    const Vector along = this->Points[edge.Points[1]] - this->Points[edge.Points[0]];
    const double length = Norm(along);
    const double area0 = this->FaceAreas[edge.Faces[0]], area1 = this->FaceAreas[edge.Faces[1]];
    if (this->IsZeroArea(area0) || this->IsZeroArea(area1) || this->IsZeroLength(length))
    {
      continue;
    }
    const Vector &s0 = this->FaceVectors[edge.Faces[0]], &s1 = this->FaceVectors[edge.Faces[1]];
    // pi - atan2(e (n0 x n1), n0 n1), with everything times both areas; rounding must not turn an angle
    // of 0 into one of 2 pi.
    double sine = this->OrientationSign * Dot(along, Cross(s0, s1)) / length;
    const double cosine = -Dot(s0, s1);
    constexpr double rounding = 1e-14;
    if (std::abs(sine) <= rounding * area0 * area1)
    {
      sine = 0;
    }
    range.Add({ sine, cosine });
  }
  this->DihedralAngles = range.Get();
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeSolidAngles()
{
  const bool collapsed = this->IsZeroLength(this->MinEdgeLength);
  if (collapsed)
  {
    this->MergeCollapsedEdges();
  }
  else if (this->Topology == &this->OwnTopology)
  {
    this->OwnTopology.MakeVertexFigures();
  }
  const CellTopology& topology = collapsed ? this->MergedTopology : *this->Topology;
  if (!this->Topology->IsClosed || !topology.HasVertexFigures)
  {
    this->SolidAngles = NullAngles(NullReason::InvalidTopology);
    return;
  }
  this->SolidAngles = { std::numeric_limits<double>::max(), -1 };
  for (int point = 0; point < topology.NumberOfPoints; ++point)
  {
    if (topology.SpokeOffsets[point + 1] > topology.SpokeOffsets[point])
    {
      const double angle = this->ComputeSolidAngle(topology, point);
      this->SolidAngles.Min = std::min(this->SolidAngles.Min, angle);
      this->SolidAngles.Max = std::max(this->SolidAngles.Max, angle);
    }
  }
  if (this->SolidAngles.Max < 0)
  {
    this->SolidAngles = NullAngles(NullReason::Degenerate);
  }
}

//------------------------------------------------------------------------------
// Area of the spherical polygon of the spokes, as a fan of Van Oosterom and Strackee's triangles.
double CellGeometry::ComputeSolidAngle(const CellTopology& topology, int point)
{
  const bool merged = &topology == &this->MergedTopology;
  const Vector& origin = this->Points[point];
  const int first = topology.SpokeOffsets[point], last = topology.SpokeOffsets[point + 1];
  this->Spokes.clear();
  Vector spoke = Unit(this->Points[topology.Spokes[first].Point] - origin);
  for (int s = first; s < last; ++s)
  {
    const Vector next =
      Unit(this->Points[topology.Spokes[s + 1 < last ? s + 1 : first].Point] - origin);
    this->Spokes.push_back(spoke);
    // The face between the two spokes; where its corner is straight or reflex the short arc between
    // them is not its side of the spherical polygon.
    const int f = topology.Spokes[s].Face;
    if (topology.GetFaceSize(f) > 3)
    {
      const Vector& area = this->FaceVectors[merged ? this->MergedFaces[f] : f];
      const double turn = Dot(Cross(next, spoke), area);
      constexpr double straight = 1e-9;
      if (turn <= straight * Norm(area) && Dot(spoke, next) < 0)
      {
        const Vector inward = Unit(Cross(area, next));
        const Vector reflex = Unit(-(spoke + next));
        this->Spokes.push_back(turn < -straight * Norm(area) ? reflex : inward);
      }
      else if (turn < 0)
      {
        this->Spokes.push_back(Unit(-(spoke + next)));
      }
    }
    spoke = next;
  }
  double sum = 0;
  const Vector& a = this->Spokes[0];
  for (std::size_t i = 1; i + 1 < this->Spokes.size(); ++i)
  {
    const Vector &b = this->Spokes[i], &c = this->Spokes[i + 1];
    sum += 2 * std::atan2(Dot(a, Cross(b, c)), 1 + Dot(a, b) + Dot(b, c) + Dot(c, a));
  }
  sum *= this->OrientationSign;
  sum = std::fmod(sum, 4 * Pi);
  constexpr double rounding = 1e-12;
  return sum < -rounding ? sum + 4 * Pi : std::max(sum, 0.0);
}

//------------------------------------------------------------------------------
// Leaves only one of the points that a collapsed edge joins.
void CellGeometry::MergeCollapsedEdges()
{
  const CellTopology& topology = *this->Topology;
  this->Representatives.resize(topology.NumberOfPoints);
  for (int point = 0; point < topology.NumberOfPoints; ++point)
  {
    this->Representatives[point] = point;
  }
  const auto find = [this](int point)
  {
    while (this->Representatives[point] != point)
    {
      point = this->Representatives[point];
    }
    return point;
  };
  for (std::size_t e = 0; e < topology.Edges.size(); ++e)
  {
    if (this->IsZeroLength(this->EdgeLengths[e]))
    {
      const int a = find(topology.Edges[e].Points[0]), b = find(topology.Edges[e].Points[1]);
      this->Representatives[std::max(a, b)] = std::min(a, b);
    }
  }
  this->MergedTopology.Clear();
  this->MergedTopology.NumberOfPoints = topology.NumberOfPoints;
  this->MergedFaces.clear();
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* face = topology.GetFace(f);
    this->Ring.clear();
    for (int i = 0; i < topology.GetFaceSize(f); ++i)
    {
      this->Ring.push_back(find(face[i]));
    }
    const int before = this->MergedTopology.GetNumberOfFaces();
    this->MergedTopology.AddFace(this->Ring.data(), static_cast<int>(this->Ring.size()));
    if (this->MergedTopology.GetNumberOfFaces() > before)
    {
      this->MergedFaces.push_back(f);
    }
  }
  this->MergedTopology.MakeVertexFigures();
}
}
