// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolygonTriangulator
 * @brief Triangulates polygons in 3D, even if they are concave or touch themselves.
 *
 * The only triangulation of polygons in the plugin. A polygon that is completely visible from its
 * first vertex by coordinates is a fan around this vertex; any other is projected along its vector
 * area and triangulated by EarCutter. The result only depends on the positions of the vertices,
 * not on the start and direction of their list: two cells triangulate their common face
 * identically. Holds scratch memory: use one object per thread.
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
   * Whether to accept fans that contain triangles without area. All convex polygons then match the
   * tetrahedra around their first vertex, whose faces are fans. Default: false.
   */
  void SetKeepsFans(bool keeps) { this->KeepsFans = keeps; }

  /**
   * Creates max(size - 2, 0) triangles of positions in the list, with the orientation of the
   * polygon. Some have no area if the polygon visits a vertex twice. The triangles are arbitrary
   * if coordinates are nonfinite.
   */
  void Cut(const Vector* corners, int size);
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /**
   * The area of the triangles with reversed orientation, seen along the vector area of the
   * polygon; it exceeds roundoff if and only if the polygon intersects itself in this projection.
   */
  double GetOverlap() const { return this->Overlap; }
  /// The area of the triangles with the orientation of the polygon, minus the overlap.
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
  std::vector<int> Sequence;   ///< positions in the list, for the same sequence of vertices
                               ///< regardless of start and direction of the list
  bool RunsBack = false;       ///< whether this sequence reverses the list
  std::vector<Vector> Places;  ///< in this sequence, from -1 to 1
  std::vector<Vector> Flat;    ///< projected
  double Unit = 1;             ///< unit of length
  double Slope = 1;            ///< ratio of area to projected area
  EarCutter Ears;
};
}

#endif
