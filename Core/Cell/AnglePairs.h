// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AnglePairs.h
 * @brief Computes two angles at a time, of faces, edges and points without collapsed edges and
 * straight corners. Shared by CellGeometry and NondegenerateTetrahedra, so that both return
 * identical values.
 */
#ifndef camaron_AnglePairs_h
#define camaron_AnglePairs_h

#include "Base/VectorPair.h"
#include "Cell/AngleRange.h"

namespace camaron
{
constexpr double StraightCorner = 1e-9; // limit of the sine of a face's corner
// A triangle with one vertex opposite to another, seen from the point, or on its other side, has no
// area of its own on the unit sphere.
constexpr double DegenerateFan = 1e-6;
// Prevents roundoff from turning an angle of 0 into a full sphere.
constexpr double SolidRounding = 1e-13;

/// Sine and cosine of two angles, both scaled by the same positive factor.
struct AnglePair
{
  Pair Sine, Cosine;
};

/// The three angles of two triangles. All three have the same sine scaled by the lengths of their
/// sides: twice the area.
inline void AddTriangleAngles(
  const VectorPair& p0, const VectorPair& p1, const VectorPair& p2, AngleRangePair& angles)
{
  const VectorPair a = p1 - p0, b = p2 - p1, c = p0 - p2, normal = Cross(a, b);
  const Pair sine = Sqrt(Dot(normal, normal)), zero = MakePair(0, 0);
  angles.Add(sine, zero - Dot(a, b));
  angles.Add(sine, zero - Dot(b, c));
  angles.Add(sine, zero - Dot(c, a));
}

/**
 * Dihedral angles of two pairs of faces at their common edges: pi - atan2(e (n0 x n1), n0 n1),
 * scaled by the edge length and both areas.
 * @param along the edge, in the direction in which the first face traverses it
 * @param sign of the orientation of the cells
 */
inline AnglePair GetDihedralAngles(const VectorPair& along, Pair length, const VectorPair& vector0,
  const VectorPair& vector1, Pair area0, Pair area1, Pair sign)
{
  const Pair zero = MakePair(0, 0), rounding = MakePair(DihedralRounding, DihedralRounding);
  const Pair sine = sign * Dot(along, Cross(vector0, vector1));
  const Pair limit = rounding * length * area0 * area1;
  // Roundoff must not turn an angle of 0 into 2 pi.
  return { SelectLess(limit, Abs(sine), sine, zero), (zero - length) * Dot(vector0, vector1) };
}

/**
 * Halves of the solid angles at points with three edges, by the formula of Van Oosterom and
 * Strackee.
 * @param spokes unit vectors along the edges
 * @param vectors and @a areas of the faces between consecutive edges
 * @param isSimple set to 1, or 0 if a corner of a face is straight or reflex, or the formula loses
 * its significant digits
 */
inline AnglePair GetHalfSolidAngles(const VectorPair spokes[3], const VectorPair vectors[3],
  const Pair areas[3], Pair sign, Pair& isSimple)
{
  const Pair zero = MakePair(0, 0), one = MakePair(1, 1),
             straight = MakePair(StraightCorner, StraightCorner),
             degenerate = MakePair(DegenerateFan, DegenerateFan),
             rounding = MakePair(-SolidRounding, -SolidRounding);
  const auto isTurning = [&](int i, int next)
  {
    return SelectLess(
      straight * areas[i], Dot(Cross(spokes[next], spokes[i]), vectors[i]), one, zero);
  };
  const Pair y = Dot(spokes[0], Cross(spokes[1], spokes[2]));
  const Pair x =
    one + Dot(spokes[0], spokes[1]) + Dot(spokes[1], spokes[2]) + Dot(spokes[2], spokes[0]);
  isSimple = isTurning(0, 1) * isTurning(1, 2) * isTurning(2, 0) *
    SelectLess(x * x + y * y, degenerate, zero, one);
  const Pair sine = sign * y;
  return { SelectLess(sine, zero, SelectLess(sine, rounding * x, sine, zero), sine), x };
}
}

#endif
