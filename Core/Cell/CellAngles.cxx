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
        this->FaceAngles[face] = this->ComputeFaceAngles(face);
      }
    }
    else
    {
      const AngleRangePair angles = this->GetRingAngles(this->Topology->GetFace(pair.First),
        this->Topology->GetFace(pair.Second), this->Topology->GetFaceSize(pair.First),
        VectorPair(this->FaceVectors[pair.First], this->FaceVectors[pair.Second]));
      this->FaceAngles[pair.First] = angles[0];
      this->FaceAngles[pair.Second] = angles[1];
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
// The angles of two faces with the same number of points, and with an area unless they are
// triangles.
inline AngleRangePair CellGeometry::GetRingAngles(
  const int* first, const int* second, int size, const VectorPair& area) const
{
  const Vector* const points = this->Points.data();
  const auto getPoint = [=](int i) { return VectorPair(points[first[i]], points[second[i]]); };
  AngleRangePair angles;
  if (size == 3)
  {
    AddTriangleAngles(getPoint(0), getPoint(1), getPoint(2), angles);
    return angles;
  }
  VectorPair point = getPoint(0), toPrevious = getPoint(size - 1) - point;
  for (int i = 0; i < size; ++i)
  {
    const VectorPair next = getPoint(i + 1 < size ? i + 1 : 0), toNext = next - point;
    const VectorPair normal = Cross(toNext, toPrevious);
    // Reflex if the normal at the corner is opposite to that of the face.
    const Pair sine = TurnSign(Sqrt(Dot(normal, normal)), Dot(normal, area));
    angles.Add(sine, Dot(toNext, toPrevious));
    toPrevious = point - next;
    point = next;
  }
  return angles;
}

//------------------------------------------------------------------------------
AngleRange CellGeometry::ComputeFaceAngles(int f)
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
  if (size < 3 || (size > 3 && this->IsZeroArea(this->FaceAreas[f])))
  {
    return {};
  }
  const VectorPair area(this->FaceVectors[f], this->FaceVectors[f]);
  return this->GetRingAngles(ring, ring, size, area)[0];
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
// For an edge without a length, or a face without an area, there is no angle.
void CellGeometry::AddDihedralAngle(int e, AngleRange& angles) const
{
  const CellTopology::Edge& edge = this->Topology->Edges[e];
  if (!this->IsZeroLength(std::sqrt(this->SquaredLengths[e])) &&
    !this->IsZeroArea(this->FaceAreas[edge.Faces[0]]) &&
    !this->IsZeroArea(this->FaceAreas[edge.Faces[1]]))
  {
    AngleRangePair both;
    this->AddDihedralAngles(e, e, both);
    angles.Add(both[0]);
  }
}

//------------------------------------------------------------------------------
// For two edges with a length, and faces with an area.
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
