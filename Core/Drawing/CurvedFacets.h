// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CurvedFacets
 * @brief The facets of cells as drawn: those of quadratic cells pass through the nodes on their
 * edges, and strips are split into triangles.
 *
 * A facet with nodes on all its edges is split into a flat triangle at each vertex, between the
 * two adjacent nodes, and a flat polygon between all these nodes; nodes inside faces are ignored.
 * Facets of SubdividedFacets are the triangles there. Holds scratch memory: use one object per
 * thread.
 */
#ifndef camaron_CurvedFacets_h
#define camaron_CurvedFacets_h

#include "Drawing/PolygonTriangles.h"
#include "Drawing/SubdividedFacets.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshView.h"

#include <array>  // for the nodes
#include <vector> // for scratch

namespace camaron
{
class CurvedFacets
{
public:
  explicit CurvedFacets(const MeshView& mesh, const SubdividedFacets* subdivided = nullptr)
    : Mesh(mesh)
    , Facets(mesh)
    , Subdivided(subdivided)
  {
  }

  /// If false, the facets of the cell are those of CellFacets.
  bool IsCurved(vtkIdType cell) const
  {
    return this->IsSubdivided(cell) ||
      (!(this->Subdivided && this->Subdivided->AreStraight()) &&
        GetNodes(this->Mesh.GetCellType(cell)).HasNodes);
  }

  /// The outline of a facet of a curved 3D cell, or of a curved 2D cell itself. Points are valid
  /// until the next call.
  PolygonTriangles::Outline GetOutline(vtkIdType cell, vtkIdType local);

  /// The outline of any 2D cell. Points are valid until the next call.
  PolygonTriangles::Outline GetSurface(vtkIdType cell);

  /// Calls @a visit(const vtkIdType* points, vtkIdType size) for the flat parts of all facets of a
  /// 3D cell.
  template <typename Visitor>
  void ForEachPart(vtkIdType cell, Visitor&& visit)
  {
    this->Facets.ForEach(cell, [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      { this->ForEachPartOf(cell, local, points, size, visit); });
  }

  /// The same for one facet with known vertices.
  template <typename Visitor>
  void ForEachPartOf(
    vtkIdType cell, vtkIdType local, const vtkIdType* points, vtkIdType size, Visitor&& visit)
  {
    if (!this->IsCurved(cell))
    {
      visit(points, size);
      return;
    }
    if (this->IsSubdivided(cell))
    {
      const PolygonTriangles::Outline triangles = this->GetOutline(cell, local);
      for (vtkIdType i = 0; i < triangles.Size; i += 3)
      {
        visit(triangles.Points + i, vtkIdType(3));
      }
      return;
    }
    this->FindOutline(cell, local);
    const std::vector<vtkIdType>& outline = this->Outline;
    if (outline.empty())
    {
      return;
    }
    this->Middle.clear();
    for (std::size_t i = 0; i < outline.size(); i += 2)
    {
      const vtkIdType corner[3] = { outline[i], outline[i + 1],
        outline[i ? i - 1 : outline.size() - 1] };
      this->Middle.push_back(corner[1]);
      visit(static_cast<const vtkIdType*>(corner), vtkIdType(3));
    }
    visit(static_cast<const vtkIdType*>(this->Middle.data()),
      static_cast<vtkIdType>(this->Middle.size()));
  }

private:
  /// For each entry of CellShape::FacePoints, or each vertex of a 2D cell, the node on the edge
  /// that begins there.
  struct EdgeNodes
  {
    bool HasNodes = false;
    std::array<signed char, CellShape::MaxFacePoints> Nodes = {};
  };
  bool IsSubdivided(vtkIdType cell) const
  {
    return this->Subdivided && this->Subdivided->Has(cell);
  }
  /// Each vertex is followed by the node on the edge to the next vertex; collapsed edges are left
  /// out.
  void FindOutline(vtkIdType cell, vtkIdType local);
  static EdgeNodes MakeNodes(int cellType);
  static const EdgeNodes& GetNodes(unsigned char cellType);

  const MeshView& Mesh;
  CellFacets Facets;
  const SubdividedFacets* Subdivided;
  std::vector<vtkIdType> Outline;
  std::vector<vtkIdType> Middle;
  std::vector<unsigned char> Edges;
};
}

#endif
