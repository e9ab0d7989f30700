// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConvexHull
 * @brief The smallest convex polyhedron around points.
 *
 * Faces are whole polygons, outward; points inside of the hull, of a face or of an edge are no
 * corners. The polyhedron that is polar to it is cut out of half-spaces, one for each point: where
 * several of them meet in a corner, up to the precision of the points, these lie in one face.
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
  /// Of finite points; flat sets have no faces. Takes a time of n log n for n points on average.
  void Compute(const std::vector<Vector>& points);

  /// Lists of points.
  const std::vector<std::vector<int>>& GetFaces() const { return this->Faces; }

private:
  bool MakeRound(const std::vector<Vector>& points);
  void AddHalfSpaces();
  void CollectFaces();

  std::vector<Vector> Round; // the points, turned and scaled
  double Radius = 0;         // of a ball around them
  double Tolerance = 0;
  std::vector<HalfSpace> HalfSpaces;
  std::vector<int> Sources; // points of the half-spaces
  ConvexPolyhedron Polar;
  std::vector<unsigned char> IsDone; // points of the polar
  std::vector<std::vector<int>> Faces;
};
}

#endif
