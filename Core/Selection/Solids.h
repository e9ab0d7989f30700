// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Solids.h
 * @brief Closed convex parts of space, and what cells have to do with them.
 *
 * Every solid, SurfaceSolid among them, has
 * - `Contains(point)`: points on its surface, up to the tolerance, are in it;
 * - `MayMeet(bounds)`: false only if it has no point in the box;
 * - `Meets(cell)`: whether it has a point in common with a cell none of whose corners is in it;
 * - `Crosses(cell)`: whether its surface goes through a cell all of whose corners are in it; never
 * does it where `IsConvex`.
 *
 * Tolerances are lengths.
 */
#ifndef camaron_Solids_h
#define camaron_Solids_h

#include "Geometry/HalfSpace.h"
#include "Selection/CellBoundary.h"

#include <vector> // for half-spaces

namespace camaron
{
/// A ball.
class BallSolid
{
public:
  BallSolid(const Vector& center, double radius, double tolerance);
  bool Contains(const Vector& point) const
  {
    return Norm2(point - this->Center) <= this->SquaredRadius;
  }
  bool MayMeet(const Bounds& box) const;
  bool Meets(const CellBoundary& cell) const;
  static constexpr bool IsConvex = true;
  bool Crosses(const CellBoundary&) const { return false; }

private:
  Vector Center;
  double SquaredRadius; // with the tolerance
};

/// What lies around an axis without ends.
class CylinderSolid
{
public:
  CylinderSolid(const Vector& center, const Vector& axis, double radius, double tolerance);
  bool Contains(const Vector& point) const
  {
    return Norm2(this->Project(point)) <= this->SquaredRadius;
  }
  bool MayMeet(const Bounds& box) const;
  bool Meets(const CellBoundary& cell) const;
  static constexpr bool IsConvex = true;
  bool Crosses(const CellBoundary&) const { return false; }

private:
  /// In the plane across the axis, with no Z.
  Vector Project(const Vector& point) const
  {
    const Vector x = point - this->Center;
    return { Dot(x, this->Across[0]), Dot(x, this->Across[1]), 0 };
  }
  Vector Center, Across[2];
  double SquaredRadius;
};

/// What lies within all half-spaces: a convex polyhedron, or something without end.
class HalfSpaceSolid
{
public:
  /// @a around holds all cells that there will be.
  HalfSpaceSolid(const std::vector<HalfSpace>& halfSpaces, const Bounds& around, double tolerance);
  bool Contains(const Vector& point) const
  {
    for (const HalfSpace& halfSpace : this->HalfSpaces)
    {
      if (!(halfSpace.GetDistance(point) <= this->Tolerance))
      {
        return false;
      }
    }
    return true;
  }
  bool MayMeet(const Bounds& box) const;
  bool Meets(const CellBoundary& cell) const;
  static constexpr bool IsConvex = true;
  bool Crosses(const CellBoundary&) const { return false; }

private:
  bool Meets(const Simplex& simplex) const;

  std::vector<HalfSpace> HalfSpaces;
  double Tolerance;
  bool HasInside; // Inside is a point of it
  Vector Inside;
};
}

#endif
