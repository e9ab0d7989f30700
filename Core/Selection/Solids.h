// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Solids.h
 * @brief Closed convex solids, and tests of cells against them.
 *
 * Every solid, including SurfaceSolid, has
 * - `Contains(point)`: whether a point is inside, or on the surface up to the tolerance;
 * - `MayMeet(bounds)`: false only if no point of the solid is in the box;
 * - `Meets(cell)`: whether it intersects a cell that has no vertex inside it;
 * - `Crosses(cell)`: whether its surface passes through a cell that has all vertices inside it;
 * never true if `IsConvex`.
 *
 * Tolerances are lengths.
 */
#ifndef camaron_Solids_h
#define camaron_Solids_h

#include "Geometry/BoxTree.h"
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
  double SquaredRadius; // includes the tolerance
};

/// An infinite cylinder around an axis.
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
  /// In the plane normal to the axis; Z is not used.
  Vector Project(const Vector& point) const
  {
    const Vector x = point - this->Center;
    return { Dot(x, this->Across[0]), Dot(x, this->Across[1]), 0 };
  }
  Vector Center, Across[2];
  double SquaredRadius;
};

/// Intersection of half-spaces: a convex polyhedron, or an unbounded solid.
class HalfSpaceSolid
{
public:
  /// @a around must contain all cells to be tested.
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
  bool HasInside; // whether Inside is a point in it
  Vector Inside;
};

/**
 * The volume enclosed by a closed triangulated surface, convex or not, with any number of
 * parts and holes.
 *
 * A point is inside if a ray upwards crosses the surface an odd number of times, so the
 * orientation of the triangles does not matter. See Solids.h for the methods.
 */
class SurfaceSolid
{
public:
  /// @param tolerance distance up to which a point counts as on the surface
  SurfaceSolid(std::vector<Simplex>&& triangles, double tolerance);

  /// Number of edges, identified by the coordinates of their ends, with an odd number of triangles;
  /// 0 for a closed surface.
  static std::size_t CountOpenEdges(const std::vector<Simplex>& triangles);

  bool Contains(const Vector& point) const;
  bool MayMeet(const Bounds& box) const;
  bool Meets(const CellBoundary& cell) const;
  static constexpr bool IsConvex = false;
  bool Crosses(const CellBoundary& cell) const;

private:
  /// Calls visit(triangle) for the triangles whose bounding boxes intersect a box, until it returns
  /// true.
  template <typename Visit>
  bool FindAny(const Bounds& box, Visit&& visit) const;

  std::vector<Simplex> Triangles; ///< in the order of the tree
  BoxTree Tree;
  double Tolerance;
};
}

#endif
