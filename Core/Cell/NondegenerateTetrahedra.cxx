// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/NondegenerateTetrahedra.h"

#include "Cell/AnglePairs.h"
#include "Mesh/CellTopology.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
// Squared limits, so no square root is needed and products stay in range.
constexpr double LargestLength = 1e40, LargestVolume = 1e120, SmallestVolume = 1e-120;
constexpr double Margin = 4; // CellGeometry may round differently

//------------------------------------------------------------------------------
// The angles of two tetrahedra. Visits faces, edges and points in the same order as CellGeometry,
// because the first of several angles that differ only by roundoff counts.
class TetrahedronAngles
{
public:
  explicit TetrahedronAngles(const TetrahedronPair& pair)
    : Topology(CellGeometry::GetTopologyOfType(VTK_TETRA))
    , Sign(SelectLess(pair.GetVolume(), MakePair(0, 0), MakePair(-1, -1), MakePair(1, 1)))
    , Places{ VectorPair(), pair.GetPoint(1), pair.GetPoint(2), pair.GetPoint(3) }
  {
  }

  AngleRangePair GetFaceAngles() const
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

  // Call this before the other methods.
  void MeasureSides()
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

  AngleRangePair GetDihedralAngles() const
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

  // Sets areSimple to 1, or 0 where CellGeometry uses another method.
  AngleRangePair GetHalfSolidAngles(Pair& areSimple) const
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

private:
  const CellTopology& Topology;
  const Pair Sign; // of the volume
  const VectorPair Places[4];
  VectorPair FaceVectors[4];
  Pair FaceAreas[4];
  VectorPair Edges[6];
  Pair Lengths[6];
};
}

//------------------------------------------------------------------------------
int NondegenerateTetrahedra::Load(const MeshView& mesh, vtkIdType first, int numberOfCells,
  const EvaluationOptions& options, unsigned needs)
{
  int numberOfTetrahedra = 0;
  mesh.VisitCoordinates([&](const auto* points)
    { numberOfTetrahedra = this->LoadPoints(mesh, points, first, numberOfCells); });
  if (numberOfTetrahedra == 0)
  {
    return 0;
  }
  this->FindSound(options);
  if (needs & NeedsAngles)
  {
    this->Block.AngleFactor = GetAngleFactor(options.Angles);
    this->ComputeAngles(needs);
  }
  return static_cast<int>(
    std::count_if(this->AreSound, this->AreSound + Size, [](double is) { return is != 0; }));
}

//------------------------------------------------------------------------------
template <typename Coordinate>
int NondegenerateTetrahedra::LoadPoints(
  const MeshView& mesh, const Coordinate* points, vtkIdType first, int numberOfCells)
{
  if (numberOfCells == Size && mesh.AreOfType(VTK_TETRA, first, Size))
  {
    const IndexRange ids = mesh.GetCellPoints(first);
    if (mesh.GetCellPoints(first + Size - 1).Begin == ids.Begin + 4 * (Size - 1))
    {
      // Contiguous ids, as in most meshes.
      ids.Values.Values32 ? this->LoadCells(points, ids.Values.Values32 + ids.Begin)
                          : this->LoadCells(points, ids.Values.Values64 + ids.Begin);
      return Size;
    }
  }
  // Other cells use the first point, which exists if there is a tetrahedron.
  vtkIdType corners[4 * Size] = {};
  bool areTetrahedra[Size] = {};
  int numberOfTetrahedra = 0;
  for (int cell = 0; cell < numberOfCells; ++cell)
  {
    if (mesh.GetCellType(first + cell) == VTK_TETRA)
    {
      const IndexRange ids = mesh.GetCellPoints(first + cell);
      for (int i = 0; i < 4; ++i)
      {
        corners[4 * cell + i] = ids[i];
      }
      areTetrahedra[cell] = true;
      ++numberOfTetrahedra;
    }
  }
  if (numberOfTetrahedra > 0)
  {
    this->LoadCells(points, corners);
  }
  for (int cell = 0; cell < Size; ++cell)
  {
    this->Places[cell] =
      areTetrahedra[cell] ? this->Places[cell] : std::numeric_limits<double>::quiet_NaN();
    this->AreSound[cell] = 0;
  }
  return numberOfTetrahedra;
}

//------------------------------------------------------------------------------
template <typename Coordinate, typename Id>
void NondegenerateTetrahedra::LoadCells(const Coordinate* points, const Id* corners)
{
  for (int cell = 0; cell < Size; cell += 2)
  {
    const Id *const first = corners + 4 * cell, *const second = first + 4;
    const auto load = [&](int corner)
    {
      const Coordinate *const a = points + 3 * static_cast<vtkIdType>(first[corner]),
                              *const b = points + 3 * static_cast<vtkIdType>(second[corner]);
      return VectorPair(GatherPair(a, b), GatherPair(a + 1, b + 1), GatherPair(a + 2, b + 2));
    };
    const VectorPair origin = load(0);
    StorePair(Abs(origin.X) + Abs(origin.Y) + Abs(origin.Z), this->Places + cell);
    for (int i = 0; i < 3; ++i)
    {
      const VectorPair edge = load(i + 1) - origin;
      StorePair(edge.X, this->Block.X[i] + cell);
      StorePair(edge.Y, this->Block.Y[i] + cell);
      StorePair(edge.Z, this->Block.Z[i] + cell);
    }
  }
}

//------------------------------------------------------------------------------
// A volume well above zero excludes edges or faces of zero size.
void NondegenerateTetrahedra::FindSound(const EvaluationOptions& options)
{
  // The zero length is the maximum of one that grows with the diameter, and one that grows with the
  // diameter and the coordinates; both are squared here, with (a + b)^2 <= 2 (a^2 + b^2).
  const double tolerance = camaron::GetZeroLength(options, 1, 0);
  const double precision = options.DegeneracyTolerance > 0 ? 0 : GetAbsoluteTolerance(1);
  const auto both = [](double value) { return MakePair(value, value); };
  const Pair relative = both(Margin * tolerance * tolerance),
             absolute = both(2 * Margin * precision * precision);
  const Pair none = both(0), six = both(6);
  for (int cell = 0; cell < Size; cell += 2)
  {
    const TetrahedronPair pair(this->Block, cell);
    const VectorPair a = pair.GetPoint(1), b = pair.GetPoint(2), c = pair.GetPoint(3);
    const Pair signedVolume = Dot(a, Cross(b, c)) / six;
    StorePair(signedVolume, this->Block.Volumes + cell);
    // No edge is longer than the sum of two edges from the first point.
    const Pair length = both(4) * Max(Max(Norm2(a), Norm2(b)), Norm2(c)),
               place = LoadPair(this->Places + cell);
    const Pair zero = Max(relative * length, absolute * (place * place + length));
    const Pair volume = signedVolume * signedVolume;
    // Positive if the tetrahedron is sound. The volume is NaN or infinite if a coordinate is; if
    // one of two values is NaN, Min and Max return the second one.
    const Pair room = Min(Min(both(LargestLength) - length, both(LargestVolume) - volume),
      volume - Max(both(SmallestVolume), zero * length * length));
    StorePair(SelectLess(none, room, both(1), none), this->AreSound + cell);
  }
}

//------------------------------------------------------------------------------
void NondegenerateTetrahedra::ComputeAngles(unsigned needs)
{
  for (int cell = 0; cell < Size; cell += 2)
  {
    const auto keep = [cell](const AngleRangePair& angles, TetrahedronBlock::Angles& all)
    {
      all[cell] = angles[0];
      all[cell + 1] = angles[1];
    };
    TetrahedronAngles angles(TetrahedronPair(this->Block, cell));
    if (needs & NeedsCorners)
    {
      keep(angles.GetFaceAngles(), this->Block.FaceAngles);
    }
    if (needs & (NeedsDihedral | NeedsSolidAngle))
    {
      angles.MeasureSides();
    }
    if (needs & NeedsDihedral)
    {
      keep(angles.GetDihedralAngles(), this->Block.DihedralAngles);
    }
    if (needs & NeedsSolidAngle)
    {
      Pair areSimple;
      keep(angles.GetHalfSolidAngles(areSimple), this->Block.HalfSolidAngles);
      StorePair(LoadPair(this->AreSound + cell) * areSimple, this->AreSound + cell);
    }
  }
}
}
