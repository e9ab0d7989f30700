// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centers of the faces of CellGeometry: the innermost loops of all criteria. Faces with
// the same number of points are processed two at a time.
#include "Cell/CellGeometry.h"
#include "Mesh/CellTopology.h"

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
  const auto getPoint = this->GetPointsOf(pair);
  const VectorPair p0 = getPoint(0), p1 = getPoint(1), p2 = getPoint(2);
  const VectorPair area = 0.5 * Cross(p1 - p0, p2 - p0), center = (1.0 / 3) * (p0 + p1 + p2);
  this->KeepFaces(pair, area, center, Sqrt(Dot(area, area)));
  if (withMoments)
  {
    this->KeepMoments(pair, 6 * (Dot(center, area) * center));
  }
}

//------------------------------------------------------------------------------
// As for polygons below, but opposite edges of the triangles about the mean cancel.
void CellGeometry::ComputeQuadrilaterals(const CellTopology::FacePair& pair, bool withMoments)
{
  const auto getPoint = this->GetPointsOf(pair);
  const VectorPair p0 = getPoint(0), p1 = getPoint(1), p2 = getPoint(2), p3 = getPoint(3);
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
  const int size = this->Topology->GetFaceSize(pair.First);
  const auto getPoint = this->GetPointsOf(pair);
  VectorPair mean;
  for (int i = 0; i < size; ++i)
  {
    mean = mean + getPoint(i);
  }
  mean = (1.0 / size) * mean;
  // Twice the vector area, and the center from triangles about the mean with signed weights. The
  // weights require the direction of the total area, so products are stored as moments until it is
  // known.
  VectorPair sum, momentsX, momentsY, momentsZ;
  VectorPair previous = getPoint(size - 1) - mean;
  for (int i = 0; i < size; ++i)
  {
    const VectorPair next = getPoint(i) - mean;
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
// Takes the mean of the points, twice the vector area, and weigh(v), which is the sum over the
// triangles about the mean of their ends weighted by the product of v and twice their vector area.
template <typename Weigh>
void CellGeometry::ComputeCenters(const CellTopology::FacePair& pair, bool withMoments,
  const VectorPair& mean, const VectorPair& sum, Weigh&& weigh)
{
  const Pair square = Dot(sum, sum), area = 0.5 * Sqrt(square);
  Pair factor = 1.0 / (3.0 * square);
  for (int lane = 0; lane < 2; ++lane)
  {
    if (this->IsZeroArea(area[lane]))
    {
      factor[lane] = 0;
    }
  }
  const VectorPair offset = factor * weigh(sum), center = mean + offset;
  this->KeepFaces(pair, 0.5 * sum, center, area);
  if (withMoments)
  {
    // The sum over the tetrahedra formed by the origin, every edge and the center.
    this->KeepMoments(
      pair, 3 * (Dot(center, sum) * mean) + Dot(offset, sum) * center + weigh(center));
  }
}

//------------------------------------------------------------------------------
void CellGeometry::KeepFaces(const CellTopology::FacePair& pair, const VectorPair& areas,
  const VectorPair& centers, Pair sizes)
{
  int lane = 0;
  for (const int face : { pair.First, pair.Second })
  {
    this->FaceVectors[face] = areas[lane];
    this->FaceCenters[face] = centers[lane];
    this->FaceAreas[face] = sizes[lane++];
  }
}

//------------------------------------------------------------------------------
void CellGeometry::KeepMoments(const CellTopology::FacePair& pair, const VectorPair& moments)
{
  this->FaceMoments[pair.First] = moments[0];
  this->FaceMoments[pair.Second] = moments[1];
}

//------------------------------------------------------------------------------
Pair CellGeometry::GetFanAreas(const CellTopology::FacePair& pair) const
{
  const int size = this->Topology->GetFaceSize(pair.First);
  if (size <= 3)
  {
    return MakePair(this->FaceAreas[pair.First], this->FaceAreas[pair.Second]);
  }
  const auto getPoint = this->GetPointsOf(pair);
  // A face without area has no orientation that triangles could be opposite to.
  const auto getNormal = [this](int face)
  { return this->IsZeroArea(this->FaceAreas[face]) ? Vector() : this->FaceVectors[face]; };
  const VectorPair center(this->FaceCenters[pair.First], this->FaceCenters[pair.Second]);
  const VectorPair normal(getNormal(pair.First), getNormal(pair.Second));
  VectorPair previous = getPoint(size - 1) - center;
  Pair sum = {};
  for (int i = 0; i < size; ++i)
  {
    const VectorPair next = getPoint(i) - center;
    const VectorPair triangle = Cross(previous, next);
    sum = sum + TurnSign(Sqrt(Dot(triangle, triangle)), Dot(triangle, normal));
    previous = next;
  }
  return 0.5 * sum;
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeFanAreas() const
{
  const int numberOfFaces = this->Topology->GetNumberOfFaces();
  this->FanAreas.resize(numberOfFaces);
  for (const CellTopology::FacePair& pair : this->Topology->FacePairs)
  {
    const Pair areas = this->GetFanAreas(pair);
    this->FanAreas[pair.First] = areas[0];
    this->FanAreas[pair.Second] = areas[1];
  }
  // Every surface bounded by the edges of a face has at least its vector area, but the triangles of
  // a self-intersecting face may add up to less.
  this->SurfaceArea = 0;
  for (int f = 0; f < numberOfFaces; ++f)
  {
    this->SurfaceArea += std::max(this->FanAreas[f], this->FaceAreas[f]);
  }
}
}
