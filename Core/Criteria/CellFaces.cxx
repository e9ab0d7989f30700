// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centres of the faces of CellGeometry: the innermost loops of all criteria. Faces with equally many
// points are taken two at a time.
#include "Criteria/CellGeometry.h"
#include "Mesh/VectorPair.h"

namespace camaron
{
//------------------------------------------------------------------------------
void CellGeometry::ComputeFaces(bool withMoments)
{
  const int numberOfFaces = this->Topology->GetNumberOfFaces();
  if (this->OwnTopology)
  {
    this->OwnTopology->FindFacePairs();
  }
  this->FaceVectors.resize(numberOfFaces);
  this->FaceCenters.resize(numberOfFaces);
  this->FaceAreas.resize(numberOfFaces);
  this->FaceMoments.resize(withMoments ? numberOfFaces : 0);
  for (const CellTopology::FacePair& pair : this->Topology->FacePairs)
  {
    switch (this->Topology->GetFaceSize(pair.First))
    {
      case 3:
        this->ComputeTriangles(pair, withMoments);
        break;
      case 4:
        this->ComputeQuadrilaterals(pair, withMoments);
        break;
      default:
        this->ComputePolygons(pair, withMoments);
    }
  }
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeTriangles(const CellTopology::FacePair& pair, bool withMoments)
{
  const int *first = this->Topology->GetFace(pair.First), *second = this->Topology->GetFace(pair.Second);
  const Vector* points = this->Points.data();
  const VectorPair p0(points[first[0]], points[second[0]]), p1(points[first[1]], points[second[1]]),
    p2(points[first[2]], points[second[2]]);
  const VectorPair area = 0.5 * Cross(p1 - p0, p2 - p0), center = (1.0 / 3) * (p0 + p1 + p2);
  this->KeepFaces(pair, area, center, Sqrt(Dot(area, area)));
  if (withMoments)
  {
    this->KeepMoments(pair, 6 * (Dot(center, area) * center));
  }
}

//------------------------------------------------------------------------------
// As polygons below, where opposite edges of the triangles about the mean add up to nothing.
void CellGeometry::ComputeQuadrilaterals(const CellTopology::FacePair& pair, bool withMoments)
{
  const int *first = this->Topology->GetFace(pair.First), *second = this->Topology->GetFace(pair.Second);
  const Vector* points = this->Points.data();
  const VectorPair p0(points[first[0]], points[second[0]]), p1(points[first[1]], points[second[1]]),
    p2(points[first[2]], points[second[2]]), p3(points[first[3]], points[second[3]]);
  const VectorPair mean = 0.25 * (p0 + p1 + p2 + p3);
  const VectorPair v0 = p0 - mean, v1 = p1 - mean, v2 = p2 - mean;
  const VectorPair a = Cross(v0, v1), b = Cross(v1, v2), c = Cross(v0, v2);
  const VectorPair difference = a - b, weight0 = difference - c, weight1 = -1 * (difference + c);
  const VectorPair ends0 = v0 + v1, ends1 = v1 + v2;
  this->ComputeCenters(pair, withMoments, mean, Cross(p2 - p0, p3 - p1),
    [&](const VectorPair& v) { return Dot(v, weight0) * ends0 + Dot(v, weight1) * ends1; });
}

//------------------------------------------------------------------------------
void CellGeometry::ComputePolygons(const CellTopology::FacePair& pair, bool withMoments)
{
  const int *first = this->Topology->GetFace(pair.First), *second = this->Topology->GetFace(pair.Second);
  const int size = this->Topology->GetFaceSize(pair.First);
  const Vector* points = this->Points.data();
  VectorPair mean;
  for (int i = 0; i < size; ++i)
  {
    mean = mean + VectorPair(points[first[i]], points[second[i]]);
  }
  mean = (1.0 / size) * mean;
  // Twice the vector area, and the centre from triangles about the mean with signed weights. The
  // weights need the direction of the whole area: moments keep the products until it is known.
  VectorPair sum, momentsX, momentsY, momentsZ;
  VectorPair previous = VectorPair(points[first[size - 1]], points[second[size - 1]]) - mean;
  for (int i = 0; i < size; ++i)
  {
    const VectorPair next = VectorPair(points[first[i]], points[second[i]]) - mean;
    const VectorPair triangle = Cross(previous, next), ends = previous + next;
    sum = sum + triangle;
    momentsX = momentsX + triangle.X * ends;
    momentsY = momentsY + triangle.Y * ends;
    momentsZ = momentsZ + triangle.Z * ends;
    previous = next;
  }
  this->ComputeCenters(pair, withMoments, mean, sum,
    [&](const VectorPair& v) { return v.X * momentsX + v.Y * momentsY + v.Z * momentsZ; });
}

//------------------------------------------------------------------------------
// From the mean of the points, twice the vector area, and weigh(v), the sum over the triangles about the mean of
// their ends weighted by the product of v and twice their vector area.
template <typename Weigh>
void CellGeometry::ComputeCenters(const CellTopology::FacePair& pair, bool withMoments,
  const VectorPair& mean, const VectorPair& sum, Weigh&& weigh)
{
  const Pair square = Dot(sum, sum), area = MakePair(0.5, 0.5) * Sqrt(square);
  const VectorPair weighted = weigh(sum);
  const auto getOffset = [&](int i)
  { return this->IsZeroArea(area[i]) ? Vector() : (1 / (3 * square[i])) * weighted[i]; };
  const VectorPair offset(getOffset(0), getOffset(1)), center = mean + offset;
  this->KeepFaces(pair, 0.5 * sum, center, area);
  if (withMoments)
  {
    // What the sum over the tetrahedra of the origin, every edge and the centre comes to.
    this->KeepMoments(
      pair, 3 * (Dot(center, sum) * mean) + Dot(offset, sum) * center + weigh(center));
  }
}

//------------------------------------------------------------------------------
void CellGeometry::KeepFaces(const CellTopology::FacePair& pair, const VectorPair& areas,
  const VectorPair& centers, const Pair& sizes)
{
  for (const int i : { 0, 1 })
  {
    const int face = i == 0 ? pair.First : pair.Second;
    this->FaceVectors[face] = areas[i];
    this->FaceCenters[face] = centers[i];
    this->FaceAreas[face] = sizes[i];
  }
}

//------------------------------------------------------------------------------
void CellGeometry::KeepMoments(const CellTopology::FacePair& pair, const VectorPair& moments)
{
  this->FaceMoments[pair.First] = moments[0];
  this->FaceMoments[pair.Second] = moments[1];
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeFanAreas() const
{
  const CellTopology& topology = *this->Topology;
  this->FanAreas.resize(topology.GetNumberOfFaces());
  const Vector* points = this->Points.data();
  for (const CellTopology::FacePair& pair : topology.FacePairs)
  {
    const int *first = topology.GetFace(pair.First), *second = topology.GetFace(pair.Second);
    const int size = topology.GetFaceSize(pair.First);
    if (size == 3)
    {
      this->FanAreas[pair.First] = this->FaceAreas[pair.First];
      this->FanAreas[pair.Second] = this->FaceAreas[pair.Second];
      continue;
    }
    const VectorPair center(this->FaceCenters[pair.First], this->FaceCenters[pair.Second]);
    // A face without an area has no side that triangles may be turned away from.
    const auto getNormal = [this](int face)
    { return this->IsZeroArea(this->FaceAreas[face]) ? Vector() : this->FaceVectors[face]; };
    const VectorPair normal(getNormal(pair.First), getNormal(pair.Second));
    VectorPair previous = VectorPair(points[first[size - 1]], points[second[size - 1]]) - center;
    Pair sum = MakePair(0, 0);
    for (int i = 0; i < size; ++i)
    {
      const VectorPair next = VectorPair(points[first[i]], points[second[i]]) - center;
      const VectorPair triangle = Cross(previous, next);
      sum = sum + TurnSign(Sqrt(Dot(triangle, triangle)), Dot(triangle, normal));
      previous = next;
    }
    this->FanAreas[pair.First] = 0.5 * sum[0];
    this->FanAreas[pair.Second] = 0.5 * sum[1];
  }
  // No surface within the edges of a face is less than its vector area, to which triangles of a face that crosses
  // itself need not add up.
  this->SurfaceArea = 0;
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    this->SurfaceArea += std::max(this->FanAreas[f], this->FaceAreas[f]);
  }
}
}
