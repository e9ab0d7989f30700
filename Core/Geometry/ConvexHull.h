// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexHull
 * @brief The convex hull of points.
 *
 * Faces are complete polygons with outward orientation; points inside the hull, a face or an edge
 * are not vertices. The hull is computed as the polar polyhedron of half-spaces, one for each
 * point: several half-spaces that meet in a vertex within the precision of the points form one
 * face.
 *
 * F. P. Preparata, M. I. Shamos, Computational Geometry, 1985, section 7.3.
 */
#ifndef camaron_ConvexHull_h
#define camaron_ConvexHull_h

#include "Geometry/ConvexPolyhedron.h"

#include <vector> // for points and faces

namespace camaron
{
class ConvexHull
{
public:
  /// Points must be finite; flat sets have no faces. Average time is O(n log n) for n points.
  void Compute(const std::vector<Vector>& points);

  /// Lists of points.
  const std::vector<std::vector<int>>& GetFaces() const { return this->Faces; }

private:
  bool MakeRound(const std::vector<Vector>& points);
  void AddHalfSpaces();
  void CollectFaces();

  std::vector<Vector> Round; // the points, rotated and scaled
  double Radius = 0;         // of a ball around them
  double Tolerance = 0;
  std::vector<HalfSpace> HalfSpaces;
  std::vector<int> Sources; // points of the half-spaces
  ConvexPolyhedron Polar;
  std::vector<unsigned char> IsDone; // points of the polar polyhedron
  std::vector<std::vector<int>> Faces;
};
}

#endif
