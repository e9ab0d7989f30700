// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolygonTriangulator
 * @brief Cuts polygons in space into triangles, also concave ones and ones that touch themselves.
 *
 * All triangles of polygons are made here. A polygon that its first corner sees all of is a fan
 * around that corner, first by coordinates; any other is projected along its vector area and cut by
 * EarCutter. Only the places of the corners count, not where the list of them begins and which way
 * it runs: two cells cut the face between them in the same way. Holds scratch memory: use one per
 * thread.
 */
#ifndef camaron_PolygonTriangulator_h
#define camaron_PolygonTriangulator_h

#include "Geometry/EarCutter.h"

#include <vector> // for triangles

namespace camaron
{
class PolygonTriangulator
{
public:
  using Triangle = EarCutter::Triangle;

  /**
   * Whether to take a fan also if some of its triangles have no area. Then all polygons that are
   * convex fit the tetrahedra around their first corner, whose faces are fans. Default: false.
   */
  void SetKeepsFans(bool keeps) { this->KeepsFans = keeps; }

  /**
   * Makes max(size - 2, 0) triangles, of places in the list, that run as the polygon does. Some
   * have no area if the polygon comes to a corner twice. Any will do where coordinates are not
   * finite.
   */
  void Cut(const Vector* corners, int size);
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /**
   * The area of the triangles that run against the polygon, seen along its vector area: more than
   * rounding if and only if it crosses itself, as it is seen from there.
   */
  double GetOverlap() const { return this->Overlap; }
  /// The area that it has where it does not, less the overlap.
  double GetArea() const { return this->Area; }

private:
  void AddFan(int size, int first);
  void CutQuadrilateral(const Vector* corners);
  double GetLeastShare(int size) const;
  bool CutFan(const Vector* corners, int size);
  void CutEars(const Vector* corners, int size);
  bool Order(const Vector* corners, int size);
  bool Project();
  void Measure(const std::vector<Triangle>& triangles);

  bool KeepsFans = false;
  std::vector<Triangle> Triangles, Tried;
  double Overlap = 0, Area = 0;
  std::vector<Vector> Normals; ///< of the triangles of a fan
  std::vector<int> Sequence;   ///< places in the list, the same corners wherever that begins and
                               ///< whichever way it runs
  bool RunsBack = false;       ///< against the list
  std::vector<Vector> Places;  ///< in that sequence, from -1 to 1
  std::vector<Vector> Flat;    ///< projected
  double Unit = 1;             ///< length of 1
  double Slope = 1;            ///< area by projected area
  EarCutter Ears;
};
}

#endif
