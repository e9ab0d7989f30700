// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellCutter
 * @brief Divides polygons into triangles and 3D cells into tetrahedra, without new points.
 *
 * Holds scratch memory: use one object per thread.
 */
#ifndef camaron_CellCutter_h
#define camaron_CellCutter_h

#include "Base/Vector.h"
#include "Geometry/PolygonTriangulator.h"
#include "Mesh/CellFacets.h"

#include <array>   // for simplices
#include <utility> // for edges
#include <vector>  // for scratch

namespace camaron
{
class CellCutter
{
public:
  using Triangle = std::array<vtkIdType, 3>;
  using Tetrahedron = std::array<vtkIdType, 4>;

  explicit CellCutter(const MeshView& mesh);

  /// Triangles of a polygon, with its orientation. Returns false if it is self-intersecting or has
  /// no area; the triangles are arbitrary then.
  bool CutPolygon(const vtkIdType* points, vtkIdType size);
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /**
   * Tetrahedra between the first point of a 3D cell (MeshView::FindFirstPoint) and the triangles of
   * the faces without this point, which are fans if the faces are convex. If the faces are oriented
   * outward, tetrahedra of a convex cell are positive. If the faces are not consistently oriented,
   * all tetrahedra are made positive.
   */
  void CutCell(vtkIdType cell);
  const std::vector<Tetrahedron>& GetTetrahedra() const { return this->Tetrahedra; }

  /// Six times the volume.
  double GetVolume(const Tetrahedron& tetrahedron) const;

  /**
   * Recognizes a polyhedron that is a tetrahedron, pyramid, wedge or hexahedron, and finds its
   * nodes in VTK's order; returns VTK_POLYHEDRON for all others.
   */
  unsigned char MatchPolyhedron(vtkIdType cell, vtkIdType nodes[8]);

private:
  Vector GetPlace(vtkIdType point) const
  {
    double x[3];
    this->Mesh.GetPoint(point, x);
    return { x[0], x[1], x[2] };
  }
  bool IsConsistent();

  const MeshView& Mesh;
  CellFacets Facets;
  std::vector<Triangle> Triangles;
  std::vector<Tetrahedron> Tetrahedra;
  std::vector<vtkIdType> Points;
  std::vector<Vector> Corners;
  std::vector<std::pair<vtkIdType, vtkIdType>> Edges; ///< of all faces, with their orientation
  PolygonTriangulator Triangulator;
};
}

#endif
