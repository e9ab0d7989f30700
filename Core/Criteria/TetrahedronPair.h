// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TetrahedronPair
 * @brief Two neighbouring places of a block of tetrahedra; see SoundTetrahedra.
 *
 * Has those members of CellGeometry that need the points only, with the same values to the last bit: a formula
 * that is a template of its cell is evaluated for both at once.
 */
#ifndef camaron_TetrahedronPair_h
#define camaron_TetrahedronPair_h

#include "Mesh/VectorPair.h"

namespace camaron
{
/// What is kept of a block of tetrahedra, of each by its place.
struct TetrahedronBlock
{
  static constexpr int Size = 32; // what stays in the nearest cache

  double X[3][Size], Y[3][Size], Z[3][Size]; // edges from the first point to the others
  double SquaredLengths[6][Size];            // in the order of the edges of CellTopology
  double MaxSquaredLengths[Size];            // of which every tetrahedron has need
  double Volumes[Size];
};

class TetrahedronPair
{
public:
  TetrahedronPair(const TetrahedronBlock& block, int place)
    : Block(block)
    , Place(place)
  {
  }

  /// Relative to the first point, of the others.
  VectorPair GetPoint(int point) const
  {
    const TetrahedronBlock& block = this->Block;
    return { this->Load(block.X[point - 1]), this->Load(block.Y[point - 1]), this->Load(block.Z[point - 1]) };
  }
  Pair GetVolume() const { return this->Load(this->Block.Volumes); }

  double GetNumberOfEdges() const { return 6; }
  Pair GetSquaredLength(int edge) const { return this->Load(this->Block.SquaredLengths[edge]); }
  Pair GetMinSquaredLength() const
  {
    const auto ofTwo = [&](int edge)
    { return Min(this->GetSquaredLength(edge), this->GetSquaredLength(edge + 1)); };
    return Min(Min(ofTwo(0), ofTwo(2)), ofTwo(4));
  }
  Pair GetMaxSquaredLength() const { return this->Load(this->Block.MaxSquaredLengths); }
  Pair GetMinEdgeLength() const { return Sqrt(this->GetMinSquaredLength()); }
  Pair GetMaxEdgeLength() const { return Sqrt(this->GetMaxSquaredLength()); }
  Pair GetDiameter() const { return this->GetMaxEdgeLength(); }
  Pair GetSumOfSquaredLengths() const
  {
    Pair sum = this->GetSquaredLength(0);
    for (int edge = 1; edge < 6; ++edge)
    {
      sum = sum + this->GetSquaredLength(edge);
    }
    return sum;
  }
  Pair GetTotalEdgeLength() const
  {
    Pair sum = Sqrt(this->GetSquaredLength(0));
    for (int edge = 1; edge < 6; ++edge)
    {
      sum = sum + Sqrt(this->GetSquaredLength(edge));
    }
    return sum;
  }
  Pair GetSurfaceArea() const
  {
    const VectorPair a = this->GetPoint(1), b = this->GetPoint(2), c = this->GetPoint(3);
    return GetArea(a, c) + GetArea(b - a, c - a) + GetArea(-1 * b, c - b) + GetArea(b, a);
  }

private:
  Pair Load(const double* values) const { return LoadPair(values + this->Place); }

  static Pair GetArea(const VectorPair& a, const VectorPair& b) { return Norm(0.5 * Cross(a, b)); }

  const TetrahedronBlock& Block;
  int Place;
};
}

#endif
