// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::SurfaceSolid
 * @brief The volume enclosed by a closed triangulated surface, convex or not, with any number of
 * parts and holes.
 *
 * A point is inside if a ray upwards crosses the surface an odd number of times, so the
 * orientation of the triangles does not matter. See Solids.h for the methods.
 */
#ifndef camaron_SurfaceSolid_h
#define camaron_SurfaceSolid_h

#include "Geometry/BoxTree.h"
#include "Selection/CellBoundary.h"

#include <vector> // for triangles

namespace camaron
{
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
