// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetrahedronPair
 * @brief Two adjacent tetrahedra of a block; see NondegenerateTetrahedra.
 *
 * Has those members of CellGeometry that only depend on the points, with identical values, so a
 * formula that is a template of its cell type evaluates both at once.
 */
#ifndef camaron_TetrahedronPair_h
#define camaron_TetrahedronPair_h

#include "Base/VectorPair.h"
#include "Cell/AngleRange.h"

#include <array> // for the edges

namespace camaron
{
/// Data of a block of tetrahedra, indexed by their position in the block.
struct TetrahedronBlock
{
  static constexpr int Size = 32; // fits into the first-level cache

  double X[3][Size], Y[3][Size], Z[3][Size]; // edges from the first point to the others
  double Volumes[Size];
  double AngleFactor; // converts radians to the unit chosen by the user
  using Angles = std::array<AngleRange, Size>;
  Angles FaceAngles, DihedralAngles, HalfSolidAngles; // if requested
};

class TetrahedronPair
{
public:
  TetrahedronPair(const TetrahedronBlock& block, int place)
    : Block(block)
    , Place(place)
  {
  }

  /// Position of point 1, 2 or 3 relative to point 0.
  VectorPair GetPoint(int point) const
  {
    const TetrahedronBlock& block = this->Block;
    return { this->Load(block.X[point - 1]), this->Load(block.Y[point - 1]),
      this->Load(block.Z[point - 1]) };
  }
  Pair GetVolume() const { return this->Load(this->Block.Volumes); }

  double GetNumberOfEdges() const { return 6; }
  /// In the order of the edges of CellTopology.
  std::array<Pair, 6> GetSquaredLengths() const
  {
    const VectorPair a = this->GetPoint(1), b = this->GetPoint(2), c = this->GetPoint(3);
    return { Norm2(a), Norm2(c - a), Norm2(c), Norm2(b - a), Norm2(c - b), Norm2(b) };
  }
  Pair GetMinSquaredLength() const
  {
    const std::array<Pair, 6> all = this->GetSquaredLengths();
    return Min(Min(Min(all[0], all[1]), Min(all[2], all[3])), Min(all[4], all[5]));
  }
  Pair GetMaxSquaredLength() const
  {
    const std::array<Pair, 6> all = this->GetSquaredLengths();
    return Max(Max(Max(all[0], all[1]), Max(all[2], all[3])), Max(all[4], all[5]));
  }
  Pair GetMinEdgeLength() const { return Sqrt(this->GetMinSquaredLength()); }
  Pair GetMaxEdgeLength() const { return Sqrt(this->GetMaxSquaredLength()); }
  Pair GetDiameter() const { return this->GetMaxEdgeLength(); }
  Pair GetSumOfSquaredLengths() const
  {
    const std::array<Pair, 6> all = this->GetSquaredLengths();
    return all[0] + all[1] + all[2] + all[3] + all[4] + all[5];
  }
  Pair GetTotalEdgeLength() const
  {
    const std::array<Pair, 6> all = this->GetSquaredLengths();
    return Sqrt(all[0]) + Sqrt(all[1]) + Sqrt(all[2]) + Sqrt(all[3]) + Sqrt(all[4]) + Sqrt(all[5]);
  }
  Pair GetSurfaceArea() const
  {
    const VectorPair a = this->GetPoint(1), b = this->GetPoint(2), c = this->GetPoint(3);
    return GetArea(a, c) + GetArea(b - a, c - a) + GetArea(-1 * b, c - b) + GetArea(b, a);
  }

  ///@{
  /// In radians and steradians.
  Pair GetMinFaceAngle() const { return this->GetMin(this->Block.FaceAngles); }
  Pair GetMaxFaceAngle() const { return this->GetMax(this->Block.FaceAngles); }
  Pair GetMinDihedralAngle() const { return this->GetMin(this->Block.DihedralAngles); }
  Pair GetMaxDihedralAngle() const { return this->GetMax(this->Block.DihedralAngles); }
  Pair GetMinSolidAngle() const { return 2.0 * this->GetMin(this->Block.HalfSolidAngles); }
  Pair GetMaxSolidAngle() const { return 2.0 * this->GetMax(this->Block.HalfSolidAngles); }
  ///@}
  Pair ToAngleUnit(Pair radian) const { return this->Block.AngleFactor * radian; }

private:
  Pair Load(const double* values) const { return LoadPair(values + this->Place); }
  Pair GetMin(const TetrahedronBlock::Angles& angles) const
  {
    return MakePair(angles[this->Place].GetMin(), angles[this->Place + 1].GetMin());
  }
  Pair GetMax(const TetrahedronBlock::Angles& angles) const
  {
    return MakePair(angles[this->Place].GetMax(), angles[this->Place + 1].GetMax());
  }

  static Pair GetArea(const VectorPair& a, const VectorPair& b) { return Norm(0.5 * Cross(a, b)); }

  const TetrahedronBlock& Block;
  int Place;
};
}

#endif
