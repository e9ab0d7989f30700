// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CoarseMesh.h"

#include "Drawing/CellTetrahedra.h"
#include "Drawing/CurvedFacets.h"
#include "Drawing/DrawableFaces.h"
#include "Drawing/PolygonTriangles.h"
#include "Geometry/FacetRing.h"
#include "Mesh/CellFacets.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace camaron
{
namespace
{
constexpr std::uint32_t None = CoarseMesh::NoPoint;

using Corners = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;

/// A part of a cell: a vertex, a segment or a triangle, of points of the mesh.
struct Part
{
  vtkIdType Points[3] = { -1, -1, -1 };
  int Size = 0;
  vtkIdType Cell = -1;
};

//------------------------------------------------------------------------------
/// The visible parts of a whole mesh.
class Outside
{
public:
  Outside(const MeshTopology& topology, const CellsToDraw& cells)
    : Topology(topology)
    , Mesh(topology.GetMesh())
    , Cells(cells)
    , HasPoint(Mesh.GetNumberOfPoints(), 0)
  {
    this->FindFaces();
    this->FindThinCells();
  }

  const std::vector<Part>& GetFaces() const { return this->Faces; }
  const std::vector<Part>& GetThinCells() const { return this->ThinCells; }
  bool Has(vtkIdType point) const { return this->HasPoint[point] != 0; }
  bool IsDrawn(vtkIdType cell) const
  {
    return !this->Cells.IsHidden(cell) && !this->Cells.IsGhost(cell);
  }

private:
  void Add(std::vector<Part>& parts, const Part& part)
  {
    for (int i = 0; i < part.Size; ++i)
    {
      this->HasPoint[part.Points[i]] = 1;
    }
    parts.push_back(part);
  }

  // Triangulated like the tetrahedra of MakeCellTetrahedra, so that they are faces of these.
  void FindFaces()
  {
    const FacetTable& table = this->Topology.GetFaces();
    CurvedFacets curved(this->Mesh);
    PolygonTriangles triangles(this->Mesh);
    triangles.SetKeepsFans(true);
    std::vector<vtkIdType> corners;
    for (Index face = 0; face < table.GetNumberOfFacets(); ++face)
    {
      const FacetTable::CellPair pair = table.GetCells(face);
      const bool isFirstHidden = this->Cells.IsHidden(pair.First);
      const vtkIdType cell = isFirstHidden ? pair.Second : pair.First;
      if (cell < 0 || !this->IsDrawn(cell) ||
        (!isFirstHidden && pair.Second >= 0 && !this->Cells.IsHidden(pair.Second)))
      {
        continue;
      }
      const auto add = [&](const vtkIdType* points, vtkIdType size)
      {
        triangles.ForEach({ points, size, PolygonTriangles::Form::Straight },
          [&](const PolygonTriangles::Triangle& t)
          {
            this->Add(this->Faces,
              { { points[t.Corners[0]], points[t.Corners[1]], points[t.Corners[2]] }, 3, cell });
          });
      };
      this->Topology.GetFacePoints(face, corners);
      const auto size = static_cast<vtkIdType>(corners.size());
      if (isFirstHidden)
      {
        add(corners.data(), size);
        continue;
      }
      const Index local = table.GetOwnerLocalFacet(face);
      if (this->Cells.IsOuter(cell, local)) // and not at another piece
      {
        curved.ForEachPartOf(cell, local, corners.data(), size, add);
      }
    }
  }

  // The cells of lower dimension.
  void FindThinCells()
  {
    CellFacets facets(this->Mesh);
    CurvedFacets curved(this->Mesh);
    PolygonTriangles triangles(this->Mesh);
    for (vtkIdType cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      const int dimension = facets.GetDimension(cell);
      if (dimension < 0 || dimension > 2 || !this->IsDrawn(cell))
      {
        continue;
      }
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      if (dimension == 2)
      {
        const PolygonTriangles::Outline outline = curved.GetSurface(cell);
        triangles.ForEach(outline,
          [&](const PolygonTriangles::Triangle& t)
          {
            const auto get = [&](int i) { return outline.Points[t.Corners[i]]; };
            this->Add(this->ThinCells, { { get(0), get(1), get(2) }, 3, cell });
          });
      }
      else if (dimension == 1)
      {
        // The ends of a curve are listed before the points between.
        const bool isPolyline = this->Mesh.GetCellType(cell) == VTK_POLY_LINE;
        for (vtkIdType i = 1; i < (isPolyline ? points.Size : std::min<vtkIdType>(points.Size, 2));
          ++i)
        {
          this->Add(this->ThinCells, { { points[i - 1], points[i], -1 }, 2, cell });
        }
      }
      else
      {
        for (vtkIdType i = 0; i < points.Size; ++i)
        {
          this->Add(this->ThinCells, { { points[i], -1, -1 }, 1, cell });
        }
      }
    }
  }

  const MeshTopology& Topology;
  const MeshView& Mesh;
  const CellsToDraw& Cells;
  std::vector<char> HasPoint;
  std::vector<Part> Faces, ThinCells;
};

//------------------------------------------------------------------------------
/// Which points are merged: boundary points into the one farthest from the center, so that convex
/// edges and corners are kept; interior points into the first.
class PointBoxes
{
public:
  PointBoxes(const MeshView& mesh, const Outside& outside, const CoarseBoxes& boxes)
    : BoxOfPoint(mesh.GetNumberOfPoints(), None)
  {
    std::vector<std::uint32_t> numbers[2]; // of a box among those that have points
    for (const bool isOuter : { false, true })
    {
      const std::size_t size = isOuter ? boxes.OfOutside : boxes.OfInside;
      numbers[isOuter].assign(size * size * size, None);
    }
    std::vector<double> farthest;
    for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
    {
      double x[3];
      mesh.GetPoint(point, x);
      if (!std::isfinite(x[0] + x[1] + x[2]))
      {
        continue;
      }
      const bool isOuter = outside.Has(point);
      const int size = isOuter ? boxes.OfOutside : boxes.OfInside;
      std::size_t box = 0;
      double distance = 0;
      for (int i = 0; i < 3; ++i)
      {
        const double length = boxes.Bounds[2 * i + 1] - boxes.Bounds[2 * i];
        const double part = length > 0 ? (x[i] - boxes.Bounds[2 * i]) / length : 0;
        box = box * size + static_cast<std::size_t>(std::clamp(part * size, 0.0, size - 1.0));
        distance += std::abs(part - 0.5);
      }
      std::uint32_t& number = numbers[isOuter][box];
      if (number == None)
      {
        number = static_cast<std::uint32_t>(this->Chosen.size());
        this->Chosen.push_back(point);
        farthest.push_back(distance);
      }
      else if (isOuter && distance > farthest[number])
      {
        this->Chosen[number] = point;
        farthest[number] = distance;
      }
      this->BoxOfPoint[point] = number;
    }
  }

  std::uint32_t GetBox(vtkIdType point) const { return point < 0 ? None : this->BoxOfPoint[point]; }
  const std::vector<vtkIdType>& GetPoints() const { return this->Chosen; }

private:
  std::vector<std::uint32_t> BoxOfPoint;
  std::vector<vtkIdType> Chosen;
};

//------------------------------------------------------------------------------
/// The cells with a number of remaining vertices.
class CellsLeft
{
public:
  explicit CellsLeft(int size)
    : Size(size)
  {
  }

  void Add(const Corners& corners, vtkIdType cell)
  {
    Entry entry{ corners, corners, cell, 1 };
    for (int i = 1; i < this->Size; ++i)
    {
      for (int k = i; k > 0 && entry.Sorted[k] < entry.Sorted[k - 1]; --k)
      {
        std::swap(entry.Sorted[k], entry.Sorted[k - 1]);
        entry.Turn = -entry.Turn;
      }
    }
    const auto end = entry.Sorted.begin() + this->Size;
    if (*(end - 1) != None && std::adjacent_find(entry.Sorted.begin(), end) == end)
    {
      this->Entries.push_back(entry);
    }
  }

  /// Calls visit(corners, cell) once for identical cells.
  template <typename Visitor>
  void ForEach(Visitor&& visit)
  {
    std::sort(this->Entries.begin(), this->Entries.end(), [](const Entry& a, const Entry& b)
      { return std::tie(a.Sorted, a.Cell, a.Own) < std::tie(b.Sorted, b.Cell, b.Own); });
    const bool isSolid = this->Size == 4;
    for (auto begin = this->Entries.begin(); begin != this->Entries.end();)
    {
      auto end = begin;
      int turns = 0;
      for (; end != this->Entries.end() && end->Sorted == begin->Sorted; ++end)
      {
        turns += end->Turn;
      }
      const auto kept = std::find_if(
        begin, end, [&](const Entry& entry) { return !isSolid || entry.Turn * turns > 0; });
      if (kept != end)
      {
        visit(kept->Own, kept->Cell);
      }
      begin = end;
    }
  }

private:
  struct Entry
  {
    Corners Sorted, Own;
    vtkIdType Cell;
    int Turn; ///< -1: sorting the vertices takes an odd number of swaps
  };
  int Size;
  std::vector<Entry> Entries;
};

//------------------------------------------------------------------------------
Triangle GetSorted(Triangle triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

//------------------------------------------------------------------------------
bool Has(const std::vector<Triangle>& sorted, const Triangle& triangle)
{
  return std::binary_search(sorted.begin(), sorted.end(), triangle);
}

//------------------------------------------------------------------------------
/// The faces of a tetrahedron in the order of VTK.
template <typename Visitor>
void ForEachFace(const Corners& tetrahedron, Visitor&& visit)
{
  const CellShape& shape = GetCellShape(VTK_TETRA);
  for (int face = 0; face < 4; ++face)
  {
    const int* nodes = shape.FacePoints + 3 * face;
    visit(
      face, GetSorted({ { tetrahedron[nodes[0]], tetrahedron[nodes[1]], tetrahedron[nodes[2]] } }));
  }
}

//------------------------------------------------------------------------------
/// Removes the unused points.
void UseFewerPoints(CoarseMesh& mesh)
{
  std::vector<std::uint32_t> places(mesh.Points.size(), None);
  std::vector<vtkIdType> used;
  for (Corners& cell : mesh.Cells)
  {
    for (std::uint32_t& corner : cell)
    {
      if (corner != None)
      {
        std::uint32_t& place = places[corner];
        if (place == None)
        {
          place = static_cast<std::uint32_t>(used.size());
          used.push_back(mesh.Points[corner]);
        }
        corner = place;
      }
    }
  }
  mesh.Points = std::move(used);
}
}

//------------------------------------------------------------------------------
CoarseMesh MakeCoarseMesh(
  const MeshTopology& topology, const CellsToDraw& cells, const CoarseBoxes& boxes)
{
  const MeshView& mesh = topology.GetMesh();
  const Outside outside(topology, cells);
  const PointBoxes points(mesh, outside, boxes);
  const auto getCorners = [&](const Part& part)
  {
    return Corners{ { points.GetBox(part.Points[0]), points.GetBox(part.Points[1]),
      points.GetBox(part.Points[2]), None } };
  };
  CoarseMesh coarse;
  coarse.Points = points.GetPoints();
  const auto add = [&](const Corners& corners, vtkIdType cell)
  {
    coarse.Cells.push_back(corners);
    coarse.Origins.push_back(cell);
  };

  CellsLeft solids(4);
  {
    const CellTetrahedra tetrahedra = MakeCellTetrahedra(mesh);
    for (std::size_t i = 0; i < tetrahedra.Points.size(); ++i)
    {
      const vtkIdType cell = tetrahedra.Cells[i] >> CellTetrahedra::OuterFaceBits;
      if (outside.IsDrawn(cell))
      {
        Corners corners;
        for (int k = 0; k < 4; ++k)
        {
          corners[k] = points.GetBox(tetrahedra.Points[i][k]);
        }
        solids.Add(corners, cell);
      }
    }
  }
  solids.ForEach(add);
  const std::size_t numberOfSolids = coarse.Cells.size();

  std::vector<Triangle> facesOfSolids, outerFaces;
  for (const Corners& tetrahedron : coarse.Cells)
  {
    ForEachFace(tetrahedron, [&](int, const Triangle& face) { facesOfSolids.push_back(face); });
  }
  SortDistinct(facesOfSolids);
  CellsLeft sheets(3);
  for (const Part& face : outside.GetFaces())
  {
    const Corners corners = getCorners(face);
    const Triangle sorted = GetSorted({ { corners[0], corners[1], corners[2] } });
    outerFaces.push_back(sorted);
    if (!Has(facesOfSolids, sorted))
    {
      sheets.Add(corners, face.Cell);
    }
  }
  SortDistinct(outerFaces);
  CellsLeft segments(2), vertices(1);
  for (const Part& part : outside.GetThinCells())
  {
    (part.Size == 3      ? sheets
        : part.Size == 2 ? segments
                         : vertices)
      .Add(getCorners(part), part.Cell);
  }
  for (CellsLeft* left : { &vertices, &segments, &sheets })
  {
    left->ForEach(add);
  }

  coarse.OuterFacets.assign(coarse.Cells.size(), std::numeric_limits<std::uint64_t>::max());
  for (std::size_t i = 0; i < numberOfSolids; ++i)
  {
    coarse.OuterFacets[i] = 0;
    ForEachFace(coarse.Cells[i], [&](int face, const Triangle& sorted)
      { coarse.OuterFacets[i] |= Has(outerFaces, sorted) ? GetFacetBit(face) : 0; });
  }
  UseFewerPoints(coarse);
  return coarse;
}
}
