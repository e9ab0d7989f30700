// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellElements
 * @brief Numbers the elements over which cells of a mesh are neighbors: facets, edges or vertices.
 *
 * Facets are the faces of 3D cells, followed by the edges of 2D cells.
 */
#ifndef camaron_CellElements_h
#define camaron_CellElements_h

#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"

#include <vector> // for the edges

namespace camaron
{
/// What two neighboring cells share.
enum class Adjacency
{
  Facet, ///< a face of 3D cells, an edge of 2D cells
  Edge,
  Vertex
};

class CellElements
{
public:
  /// Keeps a reference to the topology, and builds the required tables.
  CellElements(const MeshTopology& topology, Adjacency adjacency);

  vtkIdType GetSize() const { return this->Size; }

  /// Whether an element is a facet that is collapsed, see FacetTable.
  bool IsCollapsed(vtkIdType element) const
  {
    return this->Kind == Adjacency::Facet &&
      (element < this->NumberOfFaces
          ? this->Faces->IsCollapsed(static_cast<Index>(element))
          : this->SurfaceEdges->IsCollapsed(static_cast<Index>(element - this->NumberOfFaces)));
  }

  /// Calls @a visit(element) for the elements of a cell, in the order of the other overload.
  template <typename Visit>
  void ForEach(vtkIdType cell, Visit&& visit) const
  {
    if (this->Kind == Adjacency::Vertex)
    {
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      const vtkIdType size = GetNumberOfCorners(this->Mesh.GetCellType(cell), points.Size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        visit(points[i]);
      }
    }
    else if (this->Kind == Adjacency::Edge)
    {
      for (vtkIdType i = this->EdgeOffsets[cell]; i < this->EdgeOffsets[cell + 1]; ++i)
      {
        visit(this->Edges[i]);
      }
    }
    else
    {
      this->ForEachFacet(this->Faces, 0, cell, visit);
      this->ForEachFacet(this->SurfaceEdges, this->NumberOfFaces, cell, visit);
    }
  }

  /// Calls @a visit(element, points, numberOfPoints) for the elements of a cell; @a facets must
  /// belong to the same mesh.
  template <typename Visit>
  void ForEach(vtkIdType cell, CellFacets& facets, Visit&& visit) const
  {
    if (this->Kind == Adjacency::Vertex)
    {
      this->ForEach(cell, [&](vtkIdType point) { visit(point, &point, vtkIdType(1)); });
    }
    else if (this->Kind == Adjacency::Edge)
    {
      vtkIdType next =
        cell < static_cast<vtkIdType>(this->EdgeOffsets.size()) - 1 ? this->EdgeOffsets[cell] : 0;
      facets.ForEachEdge(cell,
        [&](vtkIdType a, vtkIdType b)
        {
          if (a != b)
          {
            const vtkIdType ends[2] = { a, b };
            visit(this->Edges[next++], ends, vtkIdType(2));
          }
        });
    }
    else
    {
      const bool isSolid = facets.GetDimension(cell) == 3;
      const FacetTable* table = isSolid ? this->Faces : this->SurfaceEdges;
      const vtkIdType first = isSolid ? 0 : this->NumberOfFaces;
      facets.ForEach(cell,
        [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
        {
          const Index facet = table->GetCellFacets(cell)[static_cast<Index>(local)].Facet();
          visit(first + facet, points, size);
        });
    }
  }

private:
  template <typename Visit>
  static void ForEachFacet(const FacetTable* table, vtkIdType first, vtkIdType cell, Visit&& visit)
  {
    if (table)
    {
      for (const CellFacet use : table->GetCellFacets(cell))
      {
        visit(first + use.Facet());
      }
    }
  }
  void FindEdges(const MeshTopology& topology);

  const MeshView& Mesh;
  Adjacency Kind;
  const FacetTable* Faces = nullptr;
  const FacetTable* SurfaceEdges = nullptr;
  vtkIdType NumberOfFaces = 0, Size = 0;
  std::vector<vtkIdType> EdgeOffsets; ///< of the cells; an edge between two faces occurs twice
  std::vector<Index> Edges;
};
}

#endif
