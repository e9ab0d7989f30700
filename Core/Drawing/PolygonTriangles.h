// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PolygonTriangles
 * @brief Triangulates a polygon for drawing, and knows which edges of the triangles belong to the
 * polygon.
 *
 * PolygonTriangulator triangulates it; if edges are curved, a triangle is first cut off at each
 * vertex. The triangles of a strip are kept. Holds scratch memory: use one object per thread.
 */
#ifndef camaron_PolygonTriangles_h
#define camaron_PolygonTriangles_h

#include "Geometry/PolygonTriangulator.h"
#include "Mesh/MeshView.h"

#include <algorithm> // for std::transform
#include <vector>    // for scratch

class vtkPolyData;

namespace camaron
{
class PolygonTriangles
{
public:
  /// Vertices of a triangle as positions in the polygon; bit i of Edges is set if vertices i, i + 1
  /// are an edge of the polygon.
  struct Triangle
  {
    int Corners[3];
    unsigned int Edges;
  };

  enum class Form
  {
    Straight,
    Curved,   ///< every second point is a node on a curved edge, as in CurvedFacets
    Strip,    ///< the points of a triangle strip, not an outline
    Triangles ///< three points each, with their edges
  };

  struct Outline
  {
    const vtkIdType* Points;
    vtkIdType Size;
    PolygonTriangles::Form Form;
    const unsigned char* Edges = nullptr; ///< of triangles

    vtkIdType GetNumberOfTriangles() const
    {
      return this->Form == PolygonTriangles::Form::Triangles
        ? this->Size / 3
        : std::max<vtkIdType>(this->Size - 2, 0);
    }
  };

  /// The bits of edges of a triangle whose last two vertices are swapped.
  static constexpr unsigned char ReverseEdges(unsigned edges)
  {
    return static_cast<unsigned char>((edges & 2) | (edges & 1) << 2 | (edges & 4) >> 2);
  }

  explicit PolygonTriangles(const MeshView& mesh)
    : Mesh(mesh)
  {
  }

  /// As in PolygonTriangulator.
  void SetKeepsFans(bool keeps) { this->Triangulator.SetKeepsFans(keeps); }

  /// Calls @a visit(triangle) exactly as often as the outline says.
  template <typename Visitor>
  void ForEach(const Outline& outline, Visitor&& visit)
  {
    const vtkIdType* points = outline.Points;
    const vtkIdType size = outline.Size;
    const int last = static_cast<int>(size) - 1;
    if (outline.Form == Form::Triangles)
    {
      for (int i = 0; i + 2 < size; i += 3)
      {
        visit(Triangle{ { i, i + 1, i + 2 }, outline.Edges[i / 3] });
      }
    }
    else if (size == 3)
    {
      visit(Triangle{ { 0, 1, 2 }, 7u });
    }
    else if (outline.Form == Form::Strip)
    {
      for (int i = 0; i + 1 < last; ++i)
      {
        const int turn = i & 1; // every second triangle has the opposite orientation
        visit(Triangle{ { i + turn, i + 1 - turn, i + 2 }, 7u });
      }
    }
    else if (outline.Form == Form::Curved)
    {
      for (int i = 0; i < last; i += 2)
      {
        visit(Triangle{ { i, i + 1, i ? i - 1 : last }, 1u | 4u });
      }
      for (int i = 3; i < last; i += 2)
      {
        visit(Triangle{ { 1, i, i + 2 }, 0u });
      }
    }
    else if (size > 3)
    {
      for (const PolygonTriangulator::Triangle& corners : this->Cut(points, size))
      {
        Triangle triangle{ { corners[0], corners[1], corners[2] }, 0 };
        for (int i = 0; i < 3; ++i)
        {
          const int step = corners[(i + 1) % 3] - corners[i];
          if (step == 1 || step == -1 || step == last || step == -last)
          {
            triangle.Edges |= 1u << i;
          }
        }
        visit(triangle);
      }
    }
  }

private:
  const std::vector<PolygonTriangulator::Triangle>& Cut(const vtkIdType* points, vtkIdType size)
  {
    this->Corners.resize(size);
    std::transform(points, points + size, this->Corners.begin(),
      [this](vtkIdType id) { return this->Mesh.GetPoint(id); });
    this->Triangulator.Cut(this->Corners.data(), static_cast<int>(size));
    return this->Triangulator.GetTriangles();
  }

  const MeshView& Mesh;
  std::vector<Vector> Corners;
  PolygonTriangulator Triangulator;
};

/// Uses PolygonTriangulator. Triangles have the data of their polygon; those with a repeated point,
/// from polygons that visit a point twice, are omitted.
void CutIntoTriangles(vtkPolyData* surface);
}

#endif
