// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::NormalFan
 * @brief The normals of the many polygons at one edge, by their direction around it, so that the
 * extreme angle of one to all others is found without trying all of them.
 *
 * Normals of planar polygons are perpendicular to the edge, so the nearest and the farthest are
 * neighbors around it, and n polygons take n log n steps. The less planar the polygons, the more
 * normals are tried. The result is within 1e-12 of that of trying all, and depends neither on the
 * order of the polygons nor on the direction of the edge.
 */
#ifndef camaron_NormalFan_h
#define camaron_NormalFan_h

#include "Base/Vector.h"
#include "Mesh/FacetTable.h"

#include <vector> // for the normals

namespace camaron
{
/// The angle between two vectors in radians.
double GetAngle(const Vector& a, const Vector& b);

class NormalFan
{
public:
  static constexpr Index Unknown = -1; ///< a cell of another piece

  /// For an edge between two points.
  NormalFan(const Vector& a, const Vector& b);

  /// Adds the normal of a cell, of any length; one of length 0 has no direction and is left out.
  void Add(const Vector& normal, Index cell);
  /// Call it once, after all normals are there.
  void Sort();

  /// The extreme angle in radians, GetSmaller or GetLarger, to the normals of other cells than
  /// @a cell; negative if there are none.
  template <auto Choose>
  double Find(const Vector& normal, Index cell) const
  {
    return this->Search(normal, cell, Choose(0.0, 1.0) > 0);
  }

private:
  struct Entry
  {
    double Azimuth; ///< around the edge
    Vector Normal;
    Index Cell;
  };
  Entry Place(const Vector& normal, Index cell) const;
  double GetTilt(const Vector& normal) const;
  double Search(const Vector& normal, Index cell, bool isOpposite) const;

  Vector Edge, X, Y;  // orthonormal
  double MaxTilt = 0; // of a normal out of the plane perpendicular to the edge, in radians
  std::vector<Entry> Entries;
};
}

#endif
