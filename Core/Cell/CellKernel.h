// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellKernel
 * @brief The kernel of a cell, and its inscribed and enclosing balls.
 *
 * The kernel is the set of points from which the whole cell is visible: the intersection of the
 * inner half-spaces of its faces; for a warped face, of the triangles about its center. For a
 * polygon it is the intersection of the half-planes of its edges in its mean plane, through its
 * center and normal to its vector area.
 *
 * Everything is computed on demand, for a polyhedron with a volume or a polygon with an area, with
 * NeedsFaces and NeedsVolume. Memory is reused for the next cell.
 */
#ifndef camaron_CellKernel_h
#define camaron_CellKernel_h

#include "Geometry/Bounds.h"
#include "Geometry/ConvexPolyhedron.h"
#include "Geometry/LargestCircle.h"

#include <functional> // for std::function
#include <vector>     // for half-spaces and points

namespace camaron
{
class CellGeometry;

class CellKernel
{
public:
  /// Call this for every new cell.
  void Clear();

  /// Radius of the largest ball (for a polygon: circle in its plane) in the kernel; 0 for an empty
  /// kernel. A kernel is empty if the radius is zero within the precision of the points.
  double GetRadius(const CellGeometry& cell);
  /// Volume or area of the kernel divided by that of the cell; 1 for convex cells, which have no
  /// point outside a half-space; 0 for an empty kernel.
  double GetRatio(const CellGeometry& cell);
  /// Radius of the largest circle inside a polygon, convex or not.
  double GetInscribedRadius(const CellGeometry& polygon);
  /// Radius of the smallest enclosing ball of the points; a 3D ball also for a polygon.
  double GetEnclosingRadius(const CellGeometry& cell);
  /// GetRatio of one face of a polyhedron, in its own plane; 0 for a face without area.
  double GetFaceRatio(const CellGeometry& cell, int face);

  ///@{
  /**
   * Computes the kernel as a polyhedron, also for convex cells; empty for an empty kernel. Calls
   * @a goesOn up to a hundred times; if it returns false, the computation stops.
   * @return false if stopped
   */
  bool MakePolyhedron(const CellGeometry& cell, const std::function<bool(double)>& goesOn);
  const ConvexPolyhedron& GetPolyhedron() const { return this->Polyhedron; }
  ///@}
  /// Computes the vertices of the kernel of a polygon, in 3D; none for an empty kernel.
  void MakePolygon(const CellGeometry& cell, std::vector<Vector>& corners);

private:
  /// A face in its mean plane.
  struct Sheet
  {
    Vector Center, U, V;         ///< origin and axes
    std::vector<Vector> Corners; ///< Z is not used
    std::vector<HalfSpace> HalfPlanes;
    Bounds Box;
    bool IsConvex;
  };
  void FindSheet(const CellGeometry& cell, int face, Sheet& sheet) const;
  double ClipSheet(const CellGeometry& cell, const Sheet& sheet);
  void FindHalfSpaces(const CellGeometry& cell);
  void AddHalfSpaces(const CellGeometry& cell, int face, double sign);
  void Prepare(const CellGeometry& cell);

  bool IsPrepared = false, HasRatio = false, HasInscribedRadius = false, HasEnclosingRadius = false;
  bool Convex = false;
  double Radius = 0, Ratio = 0, InscribedRadius = 0, EnclosingRadius = 0;

  Bounds Box; // of a polyhedron
  std::vector<HalfSpace> HalfSpaces;
  ConvexPolyhedron Polyhedron;
  Sheet Polygon, Face;
  ConvexPolygon Clipped;
  LargestCircle Circle;
  std::vector<Vector> Points;
};
}

#endif
