// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellBoundary
 * @brief The triangulated boundary of a cell, for comparison with solids.
 *
 * PolygonTriangulator triangulates faces and polygons. A 1D cell is represented by its segments, a
 * 0D cell by its points. Memory is reused for the next cell: use one object per thread.
 */
#ifndef camaron_CellBoundary_h
#define camaron_CellBoundary_h

#include "Geometry/PolygonTriangulator.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"
#include "Selection/Simplex.h"

#include <vector> // for the triangles

namespace camaron
{
class CellBoundary
{
public:
  explicit CellBoundary(const MeshView& mesh)
    : Mesh(mesh)
    , Facets(mesh)
  {
  }

  void Load(vtkIdType cell);

  const std::vector<Simplex>& GetSimplices() const { return this->Simplices; }
  const Bounds& GetBounds() const { return this->Box; }
  /// The centroid of the segments of a 1D cell or of the points of a 0D cell.
  Vector GetMiddle() const;
  /// Whether a 3D cell contains a point; false for other cells.
  bool Contains(const Vector& point) const;

private:
  void AddPolygon(const vtkIdType* points, vtkIdType size);
  void AddSimplex(const Simplex& simplex);

  const MeshView& Mesh;
  CellFacets Facets;
  std::vector<vtkIdType> Polygon;
  std::vector<Vector> Corners;
  PolygonTriangulator Triangulator;
  std::vector<Simplex> Simplices;
  Bounds Box;
  bool IsSolid = false;
};
}

#endif
