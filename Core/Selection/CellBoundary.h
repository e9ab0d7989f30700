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

#include "Base/Vector.h"
#include "Geometry/Bounds.h"
#include "Geometry/PolygonTriangulator.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"

#include <vector> // for the triangles

namespace camaron
{
/// A point, a segment or a triangle.
struct Simplex
{
  Vector Points[3];
  int Size = 0;

  Bounds GetBounds() const
  {
    Bounds bounds;
    for (int i = 0; i < this->Size; ++i)
    {
      bounds.Add(this->Points[i]);
    }
    return bounds;
  }
};

/// Squared distance of a point from a simplex.
double GetSquaredDistance(const Vector& point, const Simplex& simplex);
/// Squared distance of two segments.
double GetSquaredDistance(const Vector& a, const Vector& b, const Vector& c, const Vector& d);

/// Whether two simplices intersect or are no further apart than @a tolerance.
bool Touch(const Simplex& a, const Simplex& b, double tolerance);

/// Whether a segment, or an edge of one, passes through the interior of the other, a triangle;
/// touching does not count.
bool Pierce(const Simplex& a, const Simplex& b);

/**
 * Whether the ray from a point upwards (along Z) crosses a triangle. From inside a closed surface,
 * it crosses an odd number of triangles, even if it passes through edges and vertices.
 */
bool IsAbove(const Simplex& triangle, const Vector& point);

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
