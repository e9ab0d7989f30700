// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/TetrahedronAngles.h"
#include "Cell/AnglePairs.h"
#include "Cell/CellGeometry.h"

namespace camaron
{
//------------------------------------------------------------------------------
TetrahedronAngles::TetrahedronAngles(const TetrahedronPair& pair)
  : Topology(CellGeometry::GetTopologyOfType(VTK_TETRA))
  , Sign(SelectLess(pair.GetVolume(), MakePair(0, 0), MakePair(-1, -1), MakePair(1, 1)))
  , Places{ VectorPair(), pair.GetPoint(1), pair.GetPoint(2), pair.GetPoint(3) }
{
}

//------------------------------------------------------------------------------
AngleRangePair TetrahedronAngles::GetFaceAngles() const
{
  AngleRangePair angles;
  for (const CellTopology::FacePair& faces : this->Topology.FacePairs)
  {
    for (const int f : { faces.First, faces.Second })
    {
      const int* const ring = this->Topology.GetFace(f);
      AddTriangleAngles(
        this->Places[ring[0]], this->Places[ring[1]], this->Places[ring[2]], angles);
    }
  }
  return angles;
}

//------------------------------------------------------------------------------
void TetrahedronAngles::MeasureSides()
{
  for (int f = 0; f < 4; ++f)
  {
    const int* const ring = this->Topology.GetFace(f);
    const VectorPair& origin = this->Places[ring[0]];
    this->FaceVectors[f] =
      0.5 * Cross(this->Places[ring[1]] - origin, this->Places[ring[2]] - origin);
    this->FaceAreas[f] = Norm(this->FaceVectors[f]);
  }
  for (int e = 0; e < 6; ++e)
  {
    const int* const ends = this->Topology.Edges[e].Points;
    this->Edges[e] = this->Places[ends[1]] - this->Places[ends[0]];
    this->Lengths[e] = Norm(this->Edges[e]);
  }
}

//------------------------------------------------------------------------------
AngleRangePair TetrahedronAngles::GetDihedralAngles() const
{
  AngleRangePair angles;
  for (const int e : { 0, 2, 4, 1, 3, 5 })
  {
    const int* const faces = this->Topology.Edges[e].Faces;
    const AnglePair angle = camaron::GetDihedralAngles(this->Edges[e], this->Lengths[e],
      this->FaceVectors[faces[0]], this->FaceVectors[faces[1]], this->FaceAreas[faces[0]],
      this->FaceAreas[faces[1]], this->Sign);
    angles.Add(angle.Sine, angle.Cosine);
  }
  return angles;
}

//------------------------------------------------------------------------------
AngleRangePair TetrahedronAngles::GetHalfSolidAngles(Pair& areSimple) const
{
  const Pair one = MakePair(1, 1);
  AngleRangePair angles;
  areSimple = one;
  for (const int point : { 0, 2, 1, 3 })
  {
    const CellTopology::Spoke* const spokes =
      &this->Topology.Spokes[this->Topology.SpokeOffsets[point]];
    const auto getDirection = [&](int i)
    {
      const int e = spokes[i].Edge;
      const double sign = this->Topology.Edges[e].Points[0] == point ? 1 : -1;
      return sign * ((one / this->Lengths[e]) * this->Edges[e]);
    };
    const VectorPair directions[] = { getDirection(0), getDirection(1), getDirection(2) };
    const VectorPair vectors[] = { this->FaceVectors[spokes[0].Face],
      this->FaceVectors[spokes[1].Face], this->FaceVectors[spokes[2].Face] };
    const Pair areas[] = { this->FaceAreas[spokes[0].Face], this->FaceAreas[spokes[1].Face],
      this->FaceAreas[spokes[2].Face] };
    Pair isSimple;
    const AnglePair half =
      camaron::GetHalfSolidAngles(directions, vectors, areas, this->Sign, isSimple);
    angles.Add(half.Sine, half.Cosine);
    areSimple = areSimple * isSimple;
  }
  return angles;
}
}
