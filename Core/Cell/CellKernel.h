// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellKernel
 * @brief Kernel of a cell, and balls in and around the cell.
 *
 * The kernel is the set of points that see all of the cell: what the inner half-spaces of its faces
 * have in common; of a warped face those of the triangles about its center. Of a polygon it is made
 * of the half-planes of its edges, in its plane: through its center, along its vector area.
 *
 * Everything is computed when first asked for, for a polyhedron with a volume or a polygon with an
 * area, with NeedsFaces and NeedsVolume. Holds its memory for the next cell.
 */
#ifndef camaron_CellKernel_h
#define camaron_CellKernel_h

#include "Geometry/ConvexPolygon.h"
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
  /// To be called for every new cell.
  void Clear();

  /// Radius of the largest ball within the kernel (of a polygon: circle in its plane); 0 for an
  /// empty kernel, which is one whose largest ball counts as zero for the precision of the points.
  double GetRadius(const CellGeometry& cell);
  /// Volume or area of the kernel divided by that of the cell; 1 for convex cells, whose
  /// points lie outside of no half-space, 0 for an empty kernel.
  double GetRatio(const CellGeometry& cell);
  /// Radius of the largest circle within a polygon, convex or not.
  double GetInscribedRadius(const CellGeometry& polygon);
  /// Radius of the smallest ball around the points, in space also for a polygon.
  double GetEnclosingRadius(const CellGeometry& cell);
  /// GetRatio of one face of a polyhedron, in its own plane; 0 for a face without an area.
  double GetFaceRatio(const CellGeometry& cell, int face);

  ///@{
  /**
   * Makes the kernel itself, of convex cells, too. It is empty for an empty kernel.
   * Called up to a hundred times, @a goesOn stops it by returning false: the answer is false then.
   */
  bool MakePolyhedron(const CellGeometry& cell, const std::function<bool(double)>& goesOn);
  const ConvexPolyhedron& GetPolyhedron() const { return this->Polyhedron; }
  ///@}
  /// Corners of the kernel of a polygon, in space; none for an empty kernel.
  void MakePolygon(const CellGeometry& cell, std::vector<Vector>& corners);

private:
  /// A face in its plane.
  struct Sheet
  {
    Vector Center, U, V;         ///< origin and axes
    std::vector<Vector> Corners; ///< without Z
    std::vector<HalfSpace> HalfPlanes;
    Vector Low, High;
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

  Vector Low, High; // of the box of a polyhedron
  std::vector<HalfSpace> HalfSpaces;
  ConvexPolyhedron Polyhedron;
  Sheet Polygon, Face;
  ConvexPolygon Clipped;
  LargestCircle Circle;
  std::vector<Vector> Points;
};
}

#endif
