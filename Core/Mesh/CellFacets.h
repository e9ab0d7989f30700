// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellFacets
 * @brief Iterates over the facets of a cell: faces of 3D cells and edges of 2D cells, as point ids.
 *
 * The only class that knows the facets of each VTK cell type. Holds scratch memory: use one object
 * per thread.
 */
#ifndef camaron_CellFacets_h
#define camaron_CellFacets_h

#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"

#include <vector> // for scratch

namespace camaron
{
class CellFacets
{
public:
  explicit CellFacets(const MeshView& mesh)
    : Mesh(mesh)
    , Shapes(&GetCellShape(0))
  {
  }

  int GetDimension(vtkIdType cell) const
  {
    return this->Shapes[this->Mesh.GetCellType(cell)].Dimension;
  }

  /// Number of faces of a 3D cell or edges of a 2D cell; 0 for other cells.
  vtkIdType GetNumberOfFacets(vtkIdType cell) const
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    const CellShape& shape = this->Shapes[type];
    if (shape.Dimension == 3)
    {
      return shape.ListsFaces ? this->Mesh.GetPolyhedronFaces(cell).Size : shape.NumberOfFaces;
    }
    return shape.Dimension == 2 ? this->GetPolygonSize(type, shape, cell) : 0;
  }

  /// Calls @a visit(const vtkIdType* points, vtkIdType numberOfPoints, vtkIdType local) for each
  /// facet; @a local is its index in the cell.
  template <typename Visitor>
  void ForEach(vtkIdType cell, Visitor&& visit)
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    const CellShape& shape = this->Shapes[type];
    if (shape.Dimension == 3)
    {
      if (shape.ListsFaces)
      {
        const IndexRange faces = this->Mesh.GetPolyhedronFaces(cell);
        for (vtkIdType f = 0; f < faces.Size; ++f)
        {
          const IndexRange points = this->Mesh.GetPolyhedronFacePoints(faces[f]);
          if (this->Points.size() < static_cast<std::size_t>(points.Size))
          {
            this->Points.resize(points.Size);
          }
          Copy(points, this->Points.data());
          visit(this->Points.data(), points.Size, f);
        }
        return;
      }
      vtkIdType corners[12];
      vtkIdType face[CellShape::MaxFacePoints];
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      for (int i = 0; i < shape.NumberOfCorners; ++i)
      {
        corners[i] = points[i];
      }
      if (type == VTK_TETRA)
      {
        // As below, but with all sizes known at compile time, because most large meshes are
        // tetrahedral.
        for (int f = 0; f < 4; ++f)
        {
          const int* nodes = shape.FacePoints + 3 * f;
          const vtkIdType triangle[3] = { corners[nodes[0]], corners[nodes[1]], corners[nodes[2]] };
          visit(static_cast<const vtkIdType*>(triangle), vtkIdType(3), vtkIdType(f));
        }
        return;
      }
      for (int f = 0; f < shape.NumberOfFaces; ++f)
      {
        const int begin = shape.FaceOffsets[f], size = shape.FaceOffsets[f + 1] - begin;
        for (int i = 0; i < size; ++i)
        {
          face[i] = corners[shape.FacePoints[begin + i]];
        }
        visit(static_cast<const vtkIdType*>(face), vtkIdType(size), vtkIdType(f));
      }
    }
    else if (shape.Dimension == 2)
    {
      this->GetPolygon(cell, this->Points);
      const vtkIdType size = static_cast<vtkIdType>(this->Points.size());
      for (vtkIdType i = 0; i < size; ++i)
      {
        const vtkIdType edge[2] = { this->Points[i], this->Points[i + 1 < size ? i + 1 : 0] };
        visit(static_cast<const vtkIdType*>(edge), vtkIdType(2), i);
      }
    }
  }

  /// Calls @a visit(a, b) for the edges of a 2D or 3D cell; an edge between two faces is visited
  /// twice.
  template <typename Visitor>
  void ForEachEdge(vtkIdType cell, Visitor&& visit)
  {
    this->ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        const vtkIdType numberOfEdges = size == 2 ? 1 : size;
        for (vtkIdType i = 0; i < numberOfEdges; ++i)
        {
          visit(points[i], points[i + 1 < size ? i + 1 : 0]);
        }
      });
  }

  /// Whether the mesh stores the facets of the cell, as for a polyhedron; GetListedFacet then
  /// returns them without copying.
  bool ListsFacets(vtkIdType cell) const
  {
    return this->Shapes[this->Mesh.GetCellType(cell)].ListsFaces;
  }
  IndexRange GetListedFacet(vtkIdType cell, vtkIdType wanted) const
  {
    return this->Mesh.GetPolyhedronFacePoints(this->Mesh.GetPolyhedronFaces(cell)[wanted]);
  }

  /// Calls @a visit(const vtkIdType* points, vtkIdType numberOfPoints) for one facet.
  template <typename Visitor>
  void Visit(vtkIdType cell, vtkIdType wanted, Visitor&& visit)
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    const CellShape& shape = this->Shapes[type];
    if (shape.ListsFaces)
    {
      this->Points.clear();
      this->AppendListedFace(cell, wanted, this->Points);
      visit(static_cast<const vtkIdType*>(this->Points.data()),
        static_cast<vtkIdType>(this->Points.size()));
      return;
    }
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    if (type == VTK_TETRA)
    {
      const int* nodes = shape.FacePoints + 3 * wanted;
      const vtkIdType triangle[3] = { points[nodes[0]], points[nodes[1]], points[nodes[2]] };
      visit(static_cast<const vtkIdType*>(triangle), vtkIdType(3));
    }
    else if (shape.Dimension == 3)
    {
      vtkIdType face[CellShape::MaxFacePoints];
      const int begin = shape.FaceOffsets[wanted], size = shape.FaceOffsets[wanted + 1] - begin;
      for (int i = 0; i < size; ++i)
      {
        face[i] = points[shape.FacePoints[begin + i]];
      }
      visit(static_cast<const vtkIdType*>(face), vtkIdType(size));
    }
    else
    {
      const vtkIdType size = this->GetPolygonSize(type, shape, cell);
      const vtkIdType edge[2] = { points[GetPolygonNode(type, size, wanted)],
        points[GetPolygonNode(type, size, wanted + 1 < size ? wanted + 1 : 0)] };
      visit(static_cast<const vtkIdType*>(edge), vtkIdType(2));
    }
  }

  /// Appends the points of one facet.
  void GetFacet(vtkIdType cell, vtkIdType wanted, std::vector<vtkIdType>& facet)
  {
    if (this->Shapes[this->Mesh.GetCellType(cell)].ListsFaces)
    {
      this->AppendListedFace(cell, wanted, facet); // no scratch memory is needed
      return;
    }
    this->Visit(cell, wanted, [&facet](const vtkIdType* points, vtkIdType size)
      { facet.insert(facet.end(), points, points + size); });
  }

  /// The vertices of a 2D cell in order; for a triangle strip, its outline.
  void GetPolygon(vtkIdType cell, std::vector<vtkIdType>& polygon) const
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    const vtkIdType size = this->GetPolygonSize(type, this->Shapes[type], cell);
    polygon.resize(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      polygon[i] = points[GetPolygonNode(type, size, i)];
    }
  }

private:
  void AppendListedFace(vtkIdType cell, vtkIdType wanted, std::vector<vtkIdType>& face) const
  {
    const IndexRange points = this->GetListedFacet(cell, wanted);
    const std::size_t begin = face.size();
    face.resize(begin + points.Size);
    Copy(points, face.data() + begin);
  }

  static void Copy(const IndexRange& points, vtkIdType* to)
  {
    const auto copy = [&](const auto* from)
    {
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        to[i] = from[i];
      }
    };
    points.Values.Values32 ? copy(points.Values.Values32 + points.Begin)
                           : copy(points.Values.Values64 + points.Begin);
  }

  /// The index in the cell of the @a i-th vertex of its outline.
  static vtkIdType GetPolygonNode(unsigned char type, vtkIdType size, vtkIdType i)
  {
    if (type == VTK_PIXEL && i > 1)
    {
      return 5 - i;
    }
    if (type == VTK_TRIANGLE_STRIP && i > 0)
    {
      // p0, then the odd points ascending, then the even ones descending.
      const vtkIdType odd = size / 2;
      return i <= odd ? 2 * i - 1 : 2 * (size - i);
    }
    return i;
  }

  vtkIdType GetPolygonSize(unsigned char type, const CellShape& shape, vtkIdType cell) const
  {
    if (shape.NumberOfCorners)
    {
      return shape.NumberOfCorners;
    }
    const vtkIdType size = this->Mesh.GetCellPoints(cell).Size;
    return type == VTK_QUADRATIC_POLYGON ? size / 2 : size;
  }

  const MeshView& Mesh;
  const CellShape* Shapes;
  std::vector<vtkIdType> Points;
};
}

#endif
