// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CurvedFacets
 * @brief The facets of cells as they are drawn: those of quadratic cells go through the nodes on
 * their edges, and strips are their triangles.
 *
 * A facet with nodes on all its edges is flat at each corner, between the two nodes beside it, and
 * between all of these nodes. Nodes inside of faces, and cells of higher order (Lagrange, Bézier)
 * or with straight edges among the curved ones, are left at their corners. Holds scratch memory:
 * use one per thread.
 */
#ifndef camaron_CurvedFacets_h
#define camaron_CurvedFacets_h

#include "Drawing/PolygonTriangles.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"

#include <array>  // for the nodes
#include <vector> // for scratch

namespace camaron
{
class CurvedFacets
{
public:
  explicit CurvedFacets(const MeshView& mesh)
    : Mesh(mesh)
    , Facets(mesh)
  {
  }

  /// False: the facets of the cell are those of CellFacets.
  bool IsCurved(vtkIdType cell) const { return GetNodes(this->Mesh.GetCellType(cell)).HasNodes; }

  /**
   * The outline of a facet of a curved 3D cell, or of a curved 2D cell itself: corners and, after
   * each, the node on the edge to the next. Points stay valid until the next call.
   */
  const std::vector<vtkIdType>& GetOutline(vtkIdType cell, vtkIdType local);

  /// A 2D cell of any kind. Points stay valid until the next call.
  PolygonTriangles::Outline GetSurface(vtkIdType cell);

  /// Calls @a visit(const vtkIdType* points, vtkIdType size) for the flat parts of all facets of a
  /// 3D cell.
  template <typename Visitor>
  void ForEachPart(vtkIdType cell, Visitor&& visit)
  {
    this->Facets.ForEach(cell, [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      { this->ForEachPartOf(cell, local, points, size, visit); });
  }

  /// The same for one of them, whose corners are known.
  template <typename Visitor>
  void ForEachPartOf(
    vtkIdType cell, vtkIdType local, const vtkIdType* points, vtkIdType size, Visitor&& visit)
  {
    if (!this->IsCurved(cell))
    {
      visit(points, size);
      return;
    }
    const std::vector<vtkIdType>& outline = this->GetOutline(cell, local);
    this->Middle.clear();
    for (vtkIdType i = 0; i < 2 * size; i += 2)
    {
      const vtkIdType corner[3] = { outline[i], outline[i + 1], outline[i ? i - 1 : 2 * size - 1] };
      this->Middle.push_back(corner[1]);
      visit(static_cast<const vtkIdType*>(corner), vtkIdType(3));
    }
    visit(static_cast<const vtkIdType*>(this->Middle.data()), size);
  }

private:
  /// For each of the corners in CellShape::FacePoints, or each corner of a 2D cell, the node on the
  /// edge that begins there.
  struct EdgeNodes
  {
    bool HasNodes = false;
    std::array<signed char, CellShape::MaxFacePoints> Nodes = {};
  };
  static EdgeNodes MakeNodes(int cellType);
  static const EdgeNodes& GetNodes(unsigned char cellType);

  const MeshView& Mesh;
  CellFacets Facets;
  std::vector<vtkIdType> Outline;
  std::vector<vtkIdType> Middle;
};
}

#endif
