// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas and centers of the faces of CellGeometry: the innermost loops of all criteria. Faces with
// the same number of points are processed two or four at a time.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi" // as in VectorQuad.h
#endif

#include "Base/VectorQuad.h"
#include "Cell/CellGeometry.h"
#include "Mesh/CellTopology.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Faces of a cell with the same number of points, one per SIMD lane; lanes may repeat a face.
template <typename Lanes_>
class FaceGroup
{
public:
  using Lanes = Lanes_;
  using Vectors = VectorLanes<Lanes>;
  static constexpr int Size = sizeof(Lanes) / sizeof(double);

  // Calls visit(const FaceGroup&) for groups of all faces, by size. Requires FindFacePairs.
  template <typename Visit>
  static void ForEach(const CellTopology& topology, Visit&& visit)
  {
    const std::vector<CellTopology::FacePair>& pairs = topology.FacePairs;
    for (std::size_t first = 0; first < pairs.size();)
    {
      FaceGroup group;
      group.NumberOfPoints = topology.GetFaceSize(pairs[first].First);
      std::size_t pair = first;
      for (int lane = 0; lane < Size; lane += 2)
      {
        const bool isNext =
          first < pairs.size() && topology.GetFaceSize(pairs[first].First) == group.NumberOfPoints;
        pair = isNext ? first++ : pair;
        group.SetFace(topology, lane, pairs[pair].First);
        group.SetFace(topology, lane + 1, pairs[pair].Second);
      }
      visit(group);
    }
  }

  int GetFace(int lane) const { return this->Faces[lane]; }
  // The number of points of each face.
  int GetNumberOfPoints() const { return this->NumberOfPoints; }

  // Gathers the vectors get(face) of all lanes.
  template <typename Get>
  Vectors Gather(Get&& get) const
  {
    if constexpr (Size == 2)
    {
      return { get(this->Faces[0]), get(this->Faces[1]) };
    }
    else
    {
      return { get(this->Faces[0]), get(this->Faces[1]), get(this->Faces[2]), get(this->Faces[3]) };
    }
  }

  // The points of all faces at the same local corner.
  Vectors GetCorner(const Vector* points, int corner) const
  {
    if constexpr (Size == 2)
    {
      return { points[this->Rings[0][corner]], points[this->Rings[1][corner]] };
    }
    else
    {
      return { points[this->Rings[0][corner]], points[this->Rings[1][corner]],
        points[this->Rings[2][corner]], points[this->Rings[3][corner]] };
    }
  }

private:
  void SetFace(const CellTopology& topology, int lane, int face)
  {
    this->Faces[lane] = face;
    this->Rings[lane] = topology.GetFace(face);
  }

  int NumberOfPoints = 0;
  int Faces[Size];
  const int* Rings[Size];
};
}

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
  UsesVectorQuads ? this->ComputeFacesInQuads(withMoments)
                  : this->ComputeFacesIn<FaceGroup<Pair>>(withMoments);
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::ComputeFacesIn(bool withMoments)
{
  Group::ForEach(*this->Topology,
    [&](const Group& group)
    {
      switch (group.GetNumberOfPoints())
      {
        case 3:
          this->ComputeTriangles(group, withMoments);
          break;
        case 4:
          this->ComputeQuadrilaterals(group, withMoments);
          break;
        default:
          this->ComputePolygons(group, withMoments);
      }
    });
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::ComputeTriangles(const Group& group, bool withMoments)
{
  using Vectors = typename Group::Vectors;
  const Vector* points = this->Points.data();
  const Vectors p0 = group.GetCorner(points, 0), p1 = group.GetCorner(points, 1),
                p2 = group.GetCorner(points, 2);
  const Vectors area = 0.5 * Cross(p1 - p0, p2 - p0), center = (1.0 / 3) * (p0 + p1 + p2);
  this->KeepFaces(group, area, center, Sqrt(Dot(area, area)));
  if (withMoments)
  {
    this->KeepMoments(group, 6 * (Dot(center, area) * center));
  }
}

//------------------------------------------------------------------------------
// As for polygons below, but opposite edges of the triangles about the mean cancel.
template <typename Group>
void CellGeometry::ComputeQuadrilaterals(const Group& group, bool withMoments)
{
  using Vectors = typename Group::Vectors;
  const Vector* points = this->Points.data();
  const Vectors p0 = group.GetCorner(points, 0), p1 = group.GetCorner(points, 1),
                p2 = group.GetCorner(points, 2), p3 = group.GetCorner(points, 3);
  const Vectors mean = 0.25 * (p0 + p1 + p2 + p3);
  const Vectors v0 = p0 - mean, v1 = p1 - mean, v2 = p2 - mean;
  const Vectors a = Cross(v0, v1), b = Cross(v1, v2), c = Cross(v0, v2);
  const Vectors difference = a - b, weight0 = difference - c, weight1 = -1 * (difference + c);
  const Vectors ends0 = v0 + v1, ends1 = v1 + v2;
  this->ComputeCenters(group, withMoments, mean, Cross(p2 - p0, p3 - p1),
    [&](const Vectors& v) { return Dot(v, weight0) * ends0 + Dot(v, weight1) * ends1; });
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::ComputePolygons(const Group& group, bool withMoments)
{
  using Vectors = typename Group::Vectors;
  const int size = group.GetNumberOfPoints();
  const Vector* points = this->Points.data();
  Vectors mean;
  for (int i = 0; i < size; ++i)
  {
    mean = mean + group.GetCorner(points, i);
  }
  mean = (1.0 / size) * mean;
  // Twice the vector area, and the center from triangles about the mean with signed weights. The
  // weights require the direction of the total area, so products are stored as moments until it is
  // known.
  Vectors sum, momentsX, momentsY, momentsZ;
  Vectors previous = group.GetCorner(points, size - 1) - mean;
  for (int i = 0; i < size; ++i)
  {
    const Vectors next = group.GetCorner(points, i) - mean;
    const Vectors triangle = Cross(previous, next), ends = previous + next;
    sum = sum + triangle;
    momentsX = momentsX + triangle.X * ends;
    momentsY = momentsY + triangle.Y * ends;
    momentsZ = momentsZ + triangle.Z * ends;
    previous = next;
  }
  this->ComputeCenters(group, withMoments, mean, sum,
    [&](const Vectors& v) { return v.X * momentsX + v.Y * momentsY + v.Z * momentsZ; });
}

//------------------------------------------------------------------------------
// Takes the mean of the points, twice the vector area, and weigh(v), which is the sum over the
// triangles about the mean of their ends weighted by the product of v and twice their vector area.
template <typename Group, typename Weigh>
void CellGeometry::ComputeCenters(const Group& group, bool withMoments,
  const typename Group::Vectors& mean, const typename Group::Vectors& sum, Weigh&& weigh)
{
  using Vectors = typename Group::Vectors;
  using Lanes = typename Group::Lanes;
  const Lanes square = Dot(sum, sum), area = 0.5 * Sqrt(square);
  Lanes factor = 1.0 / (3.0 * square);
  for (int lane = 0; lane < Group::Size; ++lane)
  {
    if (this->IsZeroArea(area[lane]))
    {
      factor[lane] = 0;
    }
  }
  const Vectors offset = factor * weigh(sum), center = mean + offset;
  this->KeepFaces(group, 0.5 * sum, center, area);
  if (withMoments)
  {
    // The sum over the tetrahedra formed by the origin, every edge and the center.
    this->KeepMoments(
      group, 3 * (Dot(center, sum) * mean) + Dot(offset, sum) * center + weigh(center));
  }
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::KeepFaces(const Group& group, const typename Group::Vectors& areas,
  const typename Group::Vectors& centers, const typename Group::Lanes& sizes)
{
  for (int lane = 0; lane < Group::Size; ++lane)
  {
    const int face = group.GetFace(lane);
    this->FaceVectors[face] = areas[lane];
    this->FaceCenters[face] = centers[lane];
    this->FaceAreas[face] = sizes[lane];
  }
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::KeepMoments(const Group& group, const typename Group::Vectors& moments)
{
  for (int lane = 0; lane < Group::Size; ++lane)
  {
    this->FaceMoments[group.GetFace(lane)] = moments[lane];
  }
}

//------------------------------------------------------------------------------
void CellGeometry::ComputeFanAreas() const
{
  const int numberOfFaces = this->Topology->GetNumberOfFaces();
  this->FanAreas.resize(numberOfFaces);
  UsesVectorQuads ? this->ComputeFanAreasInQuads() : this->ComputeFanAreasIn<FaceGroup<Pair>>();
  // Every surface bounded by the edges of a face has at least its vector area, but the triangles of
  // a self-intersecting face may add up to less.
  this->SurfaceArea = 0;
  for (int f = 0; f < numberOfFaces; ++f)
  {
    this->SurfaceArea += std::max(this->FanAreas[f], this->FaceAreas[f]);
  }
}

//------------------------------------------------------------------------------
template <typename Group>
void CellGeometry::ComputeFanAreasIn() const
{
  using Vectors = typename Group::Vectors;
  using Lanes = typename Group::Lanes;
  const Vector* points = this->Points.data();
  Group::ForEach(*this->Topology,
    [&](const Group& group)
    {
      const int size = group.GetNumberOfPoints();
      Lanes sum = {};
      if (size > 3)
      {
        const Vectors center = group.Gather([this](int face) { return this->FaceCenters[face]; });
        // A face without area has no orientation that triangles could be opposite to.
        const Vectors normal = group.Gather([this](int face)
          { return this->IsZeroArea(this->FaceAreas[face]) ? Vector() : this->FaceVectors[face]; });
        Vectors previous = group.GetCorner(points, size - 1) - center;
        for (int i = 0; i < size; ++i)
        {
          const Vectors next = group.GetCorner(points, i) - center;
          const Vectors triangle = Cross(previous, next);
          sum = sum + TurnSign(Sqrt(Dot(triangle, triangle)), Dot(triangle, normal));
          previous = next;
        }
      }
      for (int lane = 0; lane < Group::Size; ++lane)
      {
        const int face = group.GetFace(lane);
        this->FanAreas[face] = size > 3 ? 0.5 * sum[lane] : this->FaceAreas[face];
      }
    });
}

//------------------------------------------------------------------------------
CAMARON_WITH_QUADS void CellGeometry::ComputeFacesInQuads(bool withMoments)
{
  this->ComputeFacesIn<FaceGroup<Quad>>(withMoments);
}

//------------------------------------------------------------------------------
CAMARON_WITH_QUADS void CellGeometry::ComputeFanAreasInQuads() const
{
  this->ComputeFanAreasIn<FaceGroup<Quad>>();
}
}
