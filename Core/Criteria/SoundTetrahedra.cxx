// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/SoundTetrahedra.h"
#include "Criteria/AnglePairs.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
// Squares, for which no root has to be taken, and products of which are numbers.
constexpr double LargestLength = 1e40, LargestVolume = 1e120, SmallestVolume = 1e-120;
constexpr double Margin = 4; // CellGeometry may round otherwise
}

//------------------------------------------------------------------------------
int SoundTetrahedra::Load(
  const MeshView& mesh, vtkIdType first, int numberOfCells, const EvaluationOptions& options, unsigned needs)
{
  int numberOfTetrahedra = 0;
  mesh.VisitCoordinates([&](const auto* points)
    { numberOfTetrahedra = this->LoadPoints(mesh, points, first, numberOfCells); });
  if (numberOfTetrahedra == 0)
  {
    return 0;
  }
  this->FindSound(mesh, options);
  if (needs & (NeedsCorners | NeedsDihedral | NeedsSolidAngle))
  {
    this->Block.AngleFactor = GetAngleFactor(options.Angles);
    this->ComputeAngles(needs);
  }
  return static_cast<int>(std::count_if(this->AreSound, this->AreSound + Size, [](double is) { return is != 0; }));
}

//------------------------------------------------------------------------------
template <typename Coordinate>
int SoundTetrahedra::LoadPoints(
  const MeshView& mesh, const Coordinate* points, vtkIdType first, int numberOfCells)
{
  if (numberOfCells == Size && mesh.AreOfType(VTK_TETRA, first, Size))
  {
    const IndexRange ids = mesh.GetCellPoints(first);
    if (mesh.GetCellPoints(first + Size - 1).Begin == ids.Begin + 4 * (Size - 1))
    {
      // One after the other, as in nearly all of most meshes.
      ids.Values.Values32 ? this->LoadCells(points, ids.Values.Values32 + ids.Begin)
                          : this->LoadCells(points, ids.Values.Values64 + ids.Begin);
      return Size;
    }
  }
  vtkIdType corners[4 * Size] = {}; // of other cells the first point, which is there if there is a tetrahedron
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
void SoundTetrahedra::LoadCells(const Coordinate* points, const Id* corners)
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
// A volume well above zero leaves no room for an edge or a face that is zero.
void SoundTetrahedra::FindSound(const MeshView& mesh, const EvaluationOptions& options)
{
  // The zero length is the larger of two that grow with the diameter, and with it and the place; here they are squared,
  // and (a + b)^2 <= 2 (a^2 + b^2).
  const double tolerance = camaron::GetZeroLength(options, 1, 0);
  const double precision =
    options.DegeneracyTolerance > 0 ? 0 : GetAbsoluteTolerance(1, mesh.HasFloatPoints());
  const auto both = [](double value) { return MakePair(value, value); };
  const Pair relative = both(Margin * tolerance * tolerance), absolute = both(2 * Margin * precision * precision);
  const Pair none = both(0), six = both(6);
  for (int cell = 0; cell < Size; cell += 2)
  {
    const TetrahedronPair pair(this->Block, cell);
    const VectorPair a = pair.GetPoint(1), b = pair.GetPoint(2), c = pair.GetPoint(3);
    const Pair signedVolume = Dot(a, Cross(b, c)) / six;
    StorePair(signedVolume, this->Block.Volumes + cell);
    // No edge is longer than two from the first point.
    const Pair length = both(4) * Max(Max(Norm2(a), Norm2(b)), Norm2(c)), place = LoadPair(this->Places + cell);
    const Pair zero = Max(relative * length, absolute * (place * place + length));
    const Pair volume = signedVolume * signedVolume;
    // Above zero where all is well. A volume is no number or infinite where a coordinate is; where one of two
    // values is no number, Min and Max are the second one.
    const Pair room = Min(Min(both(LargestLength) - length, both(LargestVolume) - volume),
      volume - Max(both(SmallestVolume), zero * length * length));
    StorePair(SelectLess(none, room, both(1), none), this->AreSound + cell);
  }
}

//------------------------------------------------------------------------------
// Faces, edges and points in the order in which CellGeometry takes them: of angles that are the same but for rounding the
// first one counts.
void SoundTetrahedra::ComputeAngles(unsigned needs)
{
  constexpr int edges[] = { 0, 2, 4, 1, 3, 5 }, points[] = { 0, 2, 1, 3 };
  const CellTopology& topology = CellGeometry::GetTopologyOfType(VTK_TETRA);
  const auto keep = [](const AngleRangePair& angles, AngleRange* to)
  {
    to[0] = angles[0];
    to[1] = angles[1];
  };
  for (int cell = 0; cell < Size; cell += 2)
  {
    const TetrahedronPair pair(this->Block, cell);
    const VectorPair places[] = { VectorPair(), pair.GetPoint(1), pair.GetPoint(2), pair.GetPoint(3) };
    if (needs & NeedsCorners)
    {
      AngleRangePair angles;
      for (int f = 3; f >= 0; --f)
      {
        const int* const face = topology.GetFace(f);
        AddTriangleAngles(places[face[0]], places[face[1]], places[face[2]], angles);
      }
      keep(angles, &this->Block.FaceAngles[cell]);
    }
    if (!(needs & (NeedsDihedral | NeedsSolidAngle)))
    {
      continue;
    }
    const Pair zero = MakePair(0, 0), one = MakePair(1, 1);
    const Pair sign = SelectLess(pair.GetVolume(), zero, zero - one, one);
    VectorPair vectors[4];
    Pair areas[4];
    for (int f = 0; f < 4; ++f)
    {
      const int* const face = topology.GetFace(f);
      vectors[f] = 0.5 * Cross(places[face[1]] - places[face[0]], places[face[2]] - places[face[0]]);
      areas[f] = Norm(vectors[f]);
    }
    VectorPair along[6];
    Pair lengths[6];
    for (int e = 0; e < 6; ++e)
    {
      const CellTopology::Edge& edge = topology.Edges[e];
      along[e] = places[edge.Points[1]] - places[edge.Points[0]];
      lengths[e] = Norm(along[e]);
    }
    if (needs & NeedsDihedral)
    {
      AngleRangePair angles;
      for (const int e : edges)
      {
        const int *const faces = topology.Edges[e].Faces;
        const AnglePair angle = GetDihedralAngles(along[e], lengths[e], vectors[faces[0]], vectors[faces[1]],
          areas[faces[0]], areas[faces[1]], sign);
        angles.Add(angle.Sine, angle.Cosine);
      }
      keep(angles, &this->Block.DihedralAngles[cell]);
    }
    if (needs & NeedsSolidAngle)
    {
      AngleRangePair angles;
      Pair areSound = LoadPair(this->AreSound + cell);
      for (const int point : points)
      {
        const CellTopology::Spoke* const spokes = &topology.Spokes[topology.SpokeOffsets[point]];
        const auto getDirection = [&](int i)
        {
          const int e = spokes[i].Edge;
          return (topology.Edges[e].Points[0] == point ? one : zero - one) * ((one / lengths[e]) * along[e]);
        };
        const VectorPair directions[] = { getDirection(0), getDirection(1), getDirection(2) };
        const VectorPair between[] = { vectors[spokes[0].Face], vectors[spokes[1].Face], vectors[spokes[2].Face] };
        const Pair sizes[] = { areas[spokes[0].Face], areas[spokes[1].Face], areas[spokes[2].Face] };
        Pair isSimple;
        const AnglePair half = GetHalfSolidAngles(directions, between, sizes, sign, isSimple);
        angles.Add(half.Sine, half.Cosine);
        areSound = areSound * isSimple;
      }
      StorePair(areSound, this->AreSound + cell);
      keep(angles, &this->Block.HalfSolidAngles[cell]);
    }
  }
}
}
