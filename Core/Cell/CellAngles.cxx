// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The angles of CellGeometry: interior angles of faces, dihedral and solid angles. Faces, edges and
// points are processed two at a time, or one by one if anything is collapsed or straight.
#include "Base/DisjointSets.h"
#include "Cell/AnglePairs.h"
#include "Cell/CellGeometry.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
void CellGeometry::ComputeCorners()
{
  this->FaceAngles.resize(this->Topology->GetNumberOfFaces());
  for (const CellTopology::FacePair& pair : this->Topology->FacePairs)
  {
    const bool isTriangle = this->Topology->GetFaceSize(pair.First) == 3;
    const double area = std::min(this->FaceAreas[pair.First], this->FaceAreas[pair.Second]);
    if (this->HasCollapsedEdge || (!isTriangle && this->IsZeroArea(area)))
    {
      for (const int face : { pair.First, pair.Second })
      {
        this->FaceAngles[face].Clear();
        this->ComputeFaceAngles(face, this->FaceAngles[face]);
      }
    }
    else
    {
      isTriangle ? this->ComputeTriangleAngles(pair) : this->ComputePolygonAngles(pair);
    }
  }
}

//------------------------------------------------------------------------------
AngleRange CellGeometry::JoinFaceAngles() const
{
  AngleRange angles;
  for (const CellTopology::FacePair& pair : this->Topology->FacePairs)
  {
    angles.Add(this->FaceAngles[pair.First]);
    angles.Add(this->FaceAngles[pair.Second]);
  }
  return angles;
}

//------------------------------------------------------------------------------
void CellGeometry::KeepAngles(const CellTopology::FacePair& pair, const AngleRangePair& angles)
{
  this->FaceAngles[pair.First] = angles[0];
  this->FaceAngles[pair.Second] = angles[1];
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeTriangleAngles(const CellTopology::FacePair& pair)
{
  const int *first = this->Topology->GetFace(pair.First),
            *second = this->Topology->GetFace(pair.Second);
  const auto getPoint = [&](int i)
  { return VectorPair(this->Points[first[i]], this->Points[second[i]]); };
  AngleRangePair angles;
  AddTriangleAngles(getPoint(0), getPoint(1), getPoint(2), angles);
  this->KeepAngles(pair, angles);
}

//------------------------------------------------------------------------------
void CellGeometry::ComputePolygonAngles(const CellTopology::FacePair& pair)
{
  const int *first = this->Topology->GetFace(pair.First),
            *second = this->Topology->GetFace(pair.Second);
  const int size = this->Topology->GetFaceSize(pair.First);
  const Vector* points = this->Points.data();
  const VectorPair area(this->FaceVectors[pair.First], this->FaceVectors[pair.Second]);
  VectorPair point(points[first[0]], points[second[0]]);
  VectorPair toPrevious = VectorPair(points[first[size - 1]], points[second[size - 1]]) - point;
  AngleRangePair angles;
  for (int i = 0; i < size; ++i)
  {
    const int k = i + 1 < size ? i + 1 : 0;
    const VectorPair next(points[first[k]], points[second[k]]), toNext = next - point;
    const VectorPair normal = Cross(toNext, toPrevious);
    // Reflex if the normal at the corner is opposite to that of the face.
    const Pair sine = TurnSign(Sqrt(Dot(normal, normal)), Dot(normal, area));
    angles.Add(sine, Dot(toNext, toPrevious));
    toPrevious = point - next;
    point = next;
  }
  this->KeepAngles(pair, angles);
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeFaceAngles(int f, AngleRange& angles)
{
  const int* ring = this->Topology->GetFace(f);
  int size = this->Topology->GetFaceSize(f);
  if (this->HasCollapsedEdge)
  {
    // Skip points at the same position as the previous one.
    this->Ring.clear();
    for (int i = 0; i < size; ++i)
    {
      if (this->Ring.empty() ||
        !this->IsZeroLength(Norm(this->Points[ring[i]] - this->Points[this->Ring.back()])))
      {
        this->Ring.push_back(ring[i]);
      }
    }
    while (this->Ring.size() > 1 &&
      this->IsZeroLength(Norm(this->Points[this->Ring.back()] - this->Points[this->Ring.front()])))
    {
      this->Ring.pop_back();
    }
    ring = this->Ring.data();
    size = static_cast<int>(this->Ring.size());
  }
  const Vector* points = this->Points.data();
  if (size == 3)
  {
    // All angles have the same sine scaled by the lengths of their sides: twice the area.
    const Vector a = points[ring[1]] - points[ring[0]], b = points[ring[2]] - points[ring[1]],
                 c = points[ring[0]] - points[ring[2]];
    const double sine = Norm(Cross(a, b));
    angles.Add(sine, -Dot(a, b));
    angles.Add(sine, -Dot(b, c));
    angles.Add(sine, -Dot(c, a));
    return;
  }
  if (size < 3 || this->IsZeroArea(this->FaceAreas[f]))
  {
    return;
  }
  Vector toPrevious = points[ring[size - 1]] - points[ring[0]];
  for (int i = 0; i < size; ++i)
  {
    const Vector toNext = points[ring[i + 1 < size ? i + 1 : 0]] - points[ring[i]];
    const Vector normal = Cross(toNext, toPrevious);
    const double sine = Norm(normal);
    const bool reflex = Dot(normal, this->FaceVectors[f]) < 0;
    angles.Add(reflex ? -sine : sine, Dot(toNext, toPrevious));
    toPrevious = -toNext;
  }
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeDihedralAngles()
{
  this->DihedralAngles.Clear();
  if (!this->Topology->IsClosed || !this->Topology->IsManifold)
  {
    this->DihedralAngles.Clear(NullReason::InvalidTopology);
    return;
  }
  const int numberOfEdges = static_cast<int>(this->Topology->Edges.size());
  if (this->HasCollapsedEdge ||
    this->IsZeroArea(*std::min_element(this->FaceAreas.begin(), this->FaceAreas.end())))
  {
    for (int e = 0; e < numberOfEdges; ++e)
    {
      this->AddDihedralAngle(e, this->DihedralAngles);
    }
    return;
  }
  AngleRangePair angles;
  for (int e = 0; e < numberOfEdges; e += 2)
  {
    this->AddDihedralAngles(e, std::min(e + 1, numberOfEdges - 1), angles);
  }
  this->DihedralAngles.Add(angles[0]);
  this->DihedralAngles.Add(angles[1]);
}

//------------------------------------------------------------------------------
void CellGeometry::AddDihedralAngle(int e, AngleRange& angles) const
{
  const CellTopology::Edge& edge = this->Topology->Edges[e];
  const double length = std::sqrt(this->SquaredLengths[e]);
  const double area0 = this->FaceAreas[edge.Faces[0]], area1 = this->FaceAreas[edge.Faces[1]];
  if (this->IsZeroLength(length) || this->IsZeroArea(area0) || this->IsZeroArea(area1))
  {
    return;
  }
  const Vector &s0 = this->FaceVectors[edge.Faces[0]], &s1 = this->FaceVectors[edge.Faces[1]];
  const Vector along = this->Points[edge.Points[1]] - this->Points[edge.Points[0]];
  // pi - atan2(e (n0 x n1), n0 n1), scaled by the edge length and both areas. Roundoff must not
  // turn an angle of 0 into 2 pi.
  double sine = this->OrientationSign * Dot(along, Cross(s0, s1));
  if (std::abs(sine) <= DihedralRounding * length * area0 * area1)
  {
    sine = 0;
  }
  angles.Add(sine, -length * Dot(s0, s1));
}

//------------------------------------------------------------------------------
// The same for two edges with a length, and two faces with an area each.
inline void CellGeometry::AddDihedralAngles(int first, int second, AngleRangePair& angles) const
{
  const CellTopology::Edge *a = &this->Topology->Edges[first], *b = &this->Topology->Edges[second];
  const auto areasOf = [&](int side)
  { return MakePair(this->FaceAreas[a->Faces[side]], this->FaceAreas[b->Faces[side]]); };
  const auto vectorsOf = [&](int side)
  { return VectorPair(this->FaceVectors[a->Faces[side]], this->FaceVectors[b->Faces[side]]); };
  const auto endsOf = [&](int end)
  { return VectorPair(this->Points[a->Points[end]], this->Points[b->Points[end]]); };
  const Pair length = Sqrt(MakePair(this->SquaredLengths[first], this->SquaredLengths[second]));
  const AnglePair angle = GetDihedralAngles(endsOf(1) - endsOf(0), length, vectorsOf(0),
    vectorsOf(1), areasOf(0), areasOf(1), MakePair(this->OrientationSign, this->OrientationSign));
  angles.Add(angle.Sine, angle.Cosine);
}

//------------------------------------------------------------------------------
double CellGeometry::GetDihedralAngle(int edge) const
{
  AngleRange angle;
  if (!this->Topology->IsClosed || !this->Topology->IsManifold)
  {
    angle.Clear(NullReason::InvalidTopology);
  }
  else
  {
    this->AddDihedralAngle(edge, angle);
  }
  return angle.GetMin();
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeSolidAngles()
{
  const bool collapsed = this->HasCollapsedEdge;
  if (this->OwnTopology)
  {
    this->OwnTopology->MakeVertexFigures();
  }
  if (collapsed)
  {
    this->MergeCollapsedEdges();
  }
  const CellTopology& topology = collapsed ? this->MergedTopology : *this->Topology;
  if (!this->Topology->IsClosed || !topology.HasVertexFigures)
  {
    this->HalfSolidAngles.Clear(NullReason::InvalidTopology);
    return;
  }
  this->EdgeDirections.resize(topology.Edges.size());
  for (std::size_t e = 0; e < topology.Edges.size(); ++e)
  {
    const CellTopology::Edge& edge = topology.Edges[e];
    this->EdgeDirections[e] = Unit(this->Points[edge.Points[1]] - this->Points[edge.Points[0]]);
  }
  this->HalfSolidAngles.Clear();
  AngleRangePair simple;
  int waiting = -1; // a point with three edges
  for (int point = 0; point < topology.NumberOfPoints; ++point)
  {
    const int valence = topology.SpokeOffsets[point + 1] - topology.SpokeOffsets[point];
    if (valence == 3 && waiting < 0 && !collapsed)
    {
      waiting = point;
    }
    else if (valence == 3 && !collapsed)
    {
      if (!this->AddSimpleAngles(topology, waiting, point, simple))
      {
        this->AddSolidAngle(topology, waiting, this->HalfSolidAngles);
        this->AddSolidAngle(topology, point, this->HalfSolidAngles);
      }
      waiting = -1;
    }
    else if (valence > 0)
    {
      this->AddSolidAngle(topology, point, this->HalfSolidAngles);
    }
  }
  if (waiting >= 0)
  {
    this->AddSolidAngle(topology, waiting, this->HalfSolidAngles);
  }
  this->HalfSolidAngles.Add(simple[0]);
  this->HalfSolidAngles.Add(simple[1]);
}

//------------------------------------------------------------------------------
// For two points with three edges each. Returns false, without adding anything, if the general
// method is required.
bool CellGeometry::AddSimpleAngles(
  const CellTopology& topology, int first, int second, AngleRangePair& halfAngles) const
{
  const CellTopology::Spoke *a = &topology.Spokes[topology.SpokeOffsets[first]],
                            *b = &topology.Spokes[topology.SpokeOffsets[second]];
  const auto getSign = [&](int edge, int point)
  { return static_cast<double>(1 - 2 * (topology.Edges[edge].Points[0] != point)); };
  const auto getSpoke = [&](int i)
  {
    return MakePair(getSign(a[i].Edge, first), getSign(b[i].Edge, second)) *
      VectorPair(this->EdgeDirections[a[i].Edge], this->EdgeDirections[b[i].Edge]);
  };
  const auto getVector = [&](int i)
  { return VectorPair(this->FaceVectors[a[i].Face], this->FaceVectors[b[i].Face]); };
  const auto getArea = [&](int i)
  { return MakePair(this->FaceAreas[a[i].Face], this->FaceAreas[b[i].Face]); };
  const VectorPair spokes[] = { getSpoke(0), getSpoke(1), getSpoke(2) };
  const VectorPair vectors[] = { getVector(0), getVector(1), getVector(2) };
  const Pair areas[] = { getArea(0), getArea(1), getArea(2) };
  Pair isSimple;
  const AnglePair half = GetHalfSolidAngles(
    spokes, vectors, areas, MakePair(this->OrientationSign, this->OrientationSign), isSimple);
  if (isSimple[0] == 0 || isSimple[1] == 0)
  {
    return false;
  }
  halfAngles.Add(half.Sine, half.Cosine);
  return true;
}

//------------------------------------------------------------------------------
double CellGeometry::GetSolidAngle(int point)
{
  if (this->HalfSolidAngles.IsEmpty())
  {
    return this->HalfSolidAngles.GetMin();
  }
  const std::vector<CellTopology::Edge>& edges = this->Topology->Edges;
  for (std::size_t e = 0; this->HasCollapsedEdge && e < edges.size(); ++e)
  {
    const bool isEnd = edges[e].Points[0] == point || edges[e].Points[1] == point;
    if (isEnd && this->IsZeroLength(this->GetEdgeLength(static_cast<int>(e))))
    {
      return Null(NullReason::Degenerate);
    }
  }
  AngleRange half;
  const CellTopology& topology = this->HasCollapsedEdge ? this->MergedTopology : *this->Topology;
  if (topology.SpokeOffsets[point + 1] > topology.SpokeOffsets[point])
  {
    this->AddSolidAngle(topology, point, half);
  }
  return Twice(half.GetMin());
}

//------------------------------------------------------------------------------
// Area of the spherical polygon of the spokes, as triangles of Van Oosterom and Strackee between
// its sides and an arbitrary point. Each has tan(area / 2) as a quotient: the product of these
// quotients as complex numbers has the sum of the halves as its argument, in [0, 2 pi), like half
// of the area.
CellGeometry::HalfAngle CellGeometry::SumFan(const Vector& corner, int numberOfSpokes) const
{
  HalfAngle half = { 0, 1, 4 };
  const Vector* a = &this->Spokes[numberOfSpokes - 1];
  for (int i = 0; i < numberOfSpokes; ++i)
  {
    const Vector* b = &this->Spokes[i];
    if (a != &corner && b != &corner)
    {
      const double y = Dot(corner, Cross(*a, *b));
      const double x = 1 + Dot(corner, *a) + Dot(*a, *b) + Dot(*b, corner);
      const double product = half.Cosine * x - half.Sine * y;
      half.Sine = half.Sine * x + half.Cosine * y;
      half.Cosine = product;
      half.Smallest = std::min(half.Smallest, x * x + y * y);
    }
    a = b;
  }
  return half;
}

//------------------------------------------------------------------------------
void CellGeometry::AddSolidAngle(const CellTopology& topology, int point, AngleRange& halfAngles)
{
  const bool merged = &topology == &this->MergedTopology;
  const int first = topology.SpokeOffsets[point], last = topology.SpokeOffsets[point + 1];
  const auto direction = [&](int spoke)
  {
    const int edge = topology.Spokes[spoke].Edge;
    const Vector& along = this->EdgeDirections[edge];
    return topology.Edges[edge].Points[0] == point ? along : -along;
  };
  // A spoke may add a second direction.
  this->Spokes.resize(std::max<std::size_t>(this->Spokes.size(), 2 * (last - first)));
  int numberOfSpokes = 0;
  Vector spoke = direction(first);
  for (int s = first; s < last; ++s)
  {
    const Vector next = direction(s + 1 < last ? s + 1 : first);
    this->Spokes[numberOfSpokes++] = spoke;
    // Across the face between the two spokes; if its corner is straight or reflex, the short arc
    // between them is not a side of the spherical polygon.
    const int f = topology.Spokes[s].Face, number = merged ? topology.FaceNumbers[f] : f;
    const bool isTriangle = topology.GetFaceSize(f) == 3;
    if (Dot(spoke, next) < 0 && this->IsZeroArea(this->FaceAreas[number]) &&
      (isTriangle || Norm(Cross(next, spoke)) <= StraightCorner))
    {
      return; // a straight corner of a face whose side is undefined
    }
    if (!isTriangle)
    {
      const Vector& area = this->FaceVectors[number];
      const double turn = Dot(Cross(next, spoke), area);
      const double flat = StraightCorner * this->FaceAreas[number];
      if (turn < -flat || (turn < 0 && Dot(spoke, next) > 0))
      {
        this->Spokes[numberOfSpokes++] = Unit(-(spoke + next));
      }
      else if (turn <= flat && Dot(spoke, next) < 0)
      {
        this->Spokes[numberOfSpokes++] = Unit(Cross(area, next));
      }
    }
    spoke = next;
  }
  HalfAngle half = this->SumFan(this->Spokes[0], numberOfSpokes);
  if (half.Smallest < DegenerateFan)
  {
    // Directions that are unlikely to be special in a mesh; the best one counts.
    const Vector others[] = { { 2, 3, 4 }, { -3, 1, -2 }, { 1, -4, 2 } };
    for (const Vector& other : others)
    {
      const HalfAngle found = this->SumFan(Unit(other), numberOfSpokes);
      half = found.Smallest > half.Smallest ? found : half;
    }
  }
  double sine = this->OrientationSign * half.Sine;
  const double cosine = half.Cosine;
  if (sine < 0 && cosine > 0 && -sine <= SolidRounding * cosine)
  {
    sine = 0;
  }
  halfAngles.Add(sine, cosine);
}

//------------------------------------------------------------------------------
// Only keeps one of the points that a collapsed edge joins.
void CellGeometry::MergeCollapsedEdges()
{
  const CellTopology& topology = *this->Topology;
  DisjointSets joined(topology.NumberOfPoints);
  for (int point = 0; point < topology.NumberOfPoints; ++point)
  {
    joined.Insert(point);
  }
  for (std::size_t e = 0; e < topology.Edges.size(); ++e)
  {
    if (this->IsZeroLength(this->GetEdgeLength(static_cast<int>(e))))
    {
      joined.Join(topology.Edges[e].Points[0], topology.Edges[e].Points[1]);
    }
  }
  this->MergedTopology.Clear();
  this->MergedTopology.NumberOfPoints = topology.NumberOfPoints;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    const int* face = topology.GetFace(f);
    this->Ring.clear();
    for (int i = 0; i < topology.GetFaceSize(f); ++i)
    {
      this->Ring.push_back(static_cast<int>(joined.Find(face[i])));
    }
    this->MergedTopology.AddFace(this->Ring.data(), static_cast<int>(this->Ring.size()));
  }
  this->MergedTopology.Finish();
  this->MergedTopology.MakeVertexFigures();
}
}
