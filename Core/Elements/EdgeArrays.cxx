// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of edges.
#include "Base/Parallel.h"
#include "Base/Vector.h"
#include "Cell/AngleRange.h"
#include "Elements/Counters.h"
#include "Elements/CurvedEdges.h"
#include "Elements/ElementArray.h"
#include "Elements/NeighborhoodPass.h"
#include "Mesh/CellFacets.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls fill(edge) for all edges in parallel.
template <typename Fill>
void ForEdges(const ElementContext& context, Fill&& fill)
{
  ParallelForEach(
    static_cast<vtkIdType>(context.GetTopology().GetEdges().size()), HeavyGrain, fill);
}

//------------------------------------------------------------------------------
// An edge of polygons.
struct SurfaceEdge
{
  vtkIdType Edge;
  vtkIdType Points[2]; ///< in the direction in which the first polygon traverses it
  Index Facet;
};

// Calls fill(edge, facets of the mesh) for all edges of polygons that are not collapsed, in
// parallel.
template <typename Fill>
void ForSurfaceEdges(const ElementContext& context, Fill&& fill)
{
  const EdgeFinder& finder = context.GetEdgeFinder();
  const FacetTable& table = context.GetTopology().GetSurfaceEdges();
  ParallelFor(context.GetMesh().GetNumberOfCells(), HeavyGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(context.GetMesh());
      std::vector<vtkIdType> polygon;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const FacetTable::Range uses = table.GetCellFacets(cell);
        if (uses.size() == 0)
        {
          continue;
        }
        facets.GetPolygon(cell, polygon);
        for (Index local = 0; local < uses.size(); ++local)
        {
          const Index facet = uses[local].Facet();
          const vtkIdType a = polygon[local], b = polygon[local + 1 < uses.size() ? local + 1 : 0];
          if (!table.IsCollapsed(facet) && table.IsOwner(facet, cell, local))
          {
            fill(SurfaceEdge{ finder.Find(a, b), { a, b }, facet }, table);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
// Whether the second polygon of an edge traverses it opposite to the first one.
bool IsReversedInSecond(const FacetTable& table, Index facet)
{
  const FacetTable::Range uses = table.GetCellFacets(table.GetCells(facet).Second);
  return std::any_of(uses.begin(), uses.end(),
    [=](CellFacet use) { return use.Facet() == facet && use.IsReversed(); });
}

//------------------------------------------------------------------------------
Vector GetNormal(const MeshView& mesh, vtkIdType cell)
{
  std::vector<vtkIdType> polygon;
  CellFacets(mesh).GetPolygon(cell, polygon);
  const Vector origin = mesh.GetPoint(polygon[0]);
  double largest = 0;
  for (const vtkIdType point : polygon)
  {
    largest = std::max(largest, GetLargestComponent(mesh.GetPoint(point) - origin));
  }
  const int exponent = GetUnitExponent(largest);
  const auto getOffset = [&](std::size_t i)
  {
    const Vector offset = mesh.GetPoint(polygon[i]) - origin;
    return exponent == 0 ? offset : TimesPowerOfTwo(offset, -exponent);
  };
  Vector sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    sum += Cross(getOffset(i), getOffset(i + 1));
  }
  return Unit(sum);
}

//------------------------------------------------------------------------------
// The offset from one point to another, with the exponent of its unit.
Vector GetOffset(const MeshView& mesh, vtkIdType from, vtkIdType to, int& exponent)
{
  const Vector offset = mesh.GetPoint(to) - mesh.GetPoint(from);
  exponent = GetUnitExponent(GetLargestComponent(offset));
  return exponent == 0 ? offset : TimesPowerOfTwo(offset, -exponent);
}

//------------------------------------------------------------------------------
void EdgeLength(const ElementContext& context, double* values)
{
  const EdgeList& edges = context.GetTopology().GetEdges();
  const MeshView& mesh = context.GetMesh();
  ForEdges(context,
    [&](vtkIdType edge)
    {
      int exponent;
      const double length = Norm(GetOffset(mesh, edges[edge][0], edges[edge][1], exponent));
      values[edge] = exponent == 0 ? length : std::ldexp(length, exponent);
    });
  if (MayHaveCurvedEdges(mesh))
  {
    MeasureCurvedEdges(mesh, context.GetEdgeFinder(), values);
  }
}

//------------------------------------------------------------------------------
void IsBoundaryEdge(const ElementContext& context, unsigned char* values)
{
  const ElementUses& uses = context.GetEdgeUses();
  ForEdges(context,
    [&](vtkIdType edge)
    {
      values[edge] =
        uses.BoundaryFaces[edge] > 0 || (uses.Polygons[edge] == 1 && uses.Cells[edge] == 1);
    });
}

//------------------------------------------------------------------------------
void BoundaryEdge(const ElementContext& context, unsigned char* values)
{
  ForSurfaceEdges(context, [&](const SurfaceEdge& edge, const FacetTable& table)
    { values[edge.Edge] = table.IsBoundary(edge.Facet); });
}

//------------------------------------------------------------------------------
void IsNonManifoldEdge(const ElementContext& context, unsigned char* values)
{
  ForSurfaceEdges(context, [&](const SurfaceEdge& edge, const FacetTable& table)
    { values[edge.Edge] = table.GetNumberOfCells(edge.Facet) > 2; });
}

//------------------------------------------------------------------------------
void InconsistentEdge(const ElementContext& context, unsigned char* values)
{
  ForSurfaceEdges(context,
    [&](const SurfaceEdge& edge, const FacetTable& table)
    {
      const FacetTable::CellPair cells = table.GetCells(edge.Facet);
      values[edge.Edge] = table.GetNumberOfCells(edge.Facet) == 2 && cells.First != cells.Second &&
        !IsReversedInSecond(table, edge.Facet);
    });
}

//------------------------------------------------------------------------------
void EdgeDihedralAngle(const ElementContext& context, double* values)
{
  const MeshView& mesh = context.GetMesh();
  std::fill_n(values, context.GetTopology().GetEdges().size(), Null(NullReason::NotApplicable));
  ForSurfaceEdges(context,
    [&](const SurfaceEdge& edge, const FacetTable& table)
    {
      const FacetTable::CellPair cells = table.GetCells(edge.Facet);
      if (cells.Second < 0)
      {
        return;
      }
      if (cells.First == cells.Second || table.GetNumberOfCells(edge.Facet) > 2)
      {
        values[edge.Edge] = Null(NullReason::InvalidTopology);
        return;
      }
      const double sign = IsReversedInSecond(table, edge.Facet) ? 1 : -1;
      const Vector n0 = GetNormal(mesh, cells.First), n1 = sign * GetNormal(mesh, cells.Second);
      int exponent;
      const Vector along = Unit(GetOffset(mesh, edge.Points[0], edge.Points[1], exponent));
      values[edge.Edge] = Norm2(n0) == 0 || Norm2(n1) == 0 || Norm2(along) == 0
        ? Null(NullReason::Degenerate)
        : GetDihedralAngle(along, n0, n1);
    });
}

//------------------------------------------------------------------------------
// For edges between polygons, the worse of both values, each in the plane of its polygon: the
// maximum (Sign -1) or minimum (1). If both are NaN, that of the first polygon.
template <int Sign, double (*Value)(const CellNeighborhood&, const CellNeighborhood::Facet&)>
void OfFacets(const ElementContext& context, double* values)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  const MeshTopology& topology = context.GetTopology();
  const FacetTable& table = topology.GetSurfaceEdges();
  const EdgeFinder& finder = context.GetEdgeFinder();
  const std::size_t size = topology.GetEdges().size();
  std::fill_n(values, size, Null(NullReason::NotApplicable));
  Minima<double> worst(size, none);
  ForEachNeighborhood(context, table, 0,
    [&](vtkIdType id, const FacetTable::Range& uses, const CellGeometry& cell,
      const CellNeighborhood& neighborhood)
    {
      for (const CellNeighborhood::Facet& facet : neighborhood.GetFacets())
      {
        const Index number = uses[facet.Use].Facet();
        const int* ring = cell.GetTopology().GetFace(0);
        const int next =
          facet.Number + 1 < cell.GetTopology().GetFaceSize(0) ? facet.Number + 1 : 0;
        const vtkIdType edge =
          finder.Find(cell.GetPointId(ring[facet.Number]), cell.GetPointId(ring[next]));
        const double value = Value(neighborhood, facet);
        if (!std::isnan(value))
        {
          worst.Add(edge, Sign * value);
        }
        else if (table.IsOwner(number, id, facet.Use))
        {
          values[edge] = value;
        }
      }
    });
  for (vtkIdType edge = 0; edge < static_cast<vtkIdType>(size); ++edge)
  {
    const double value = worst.Get(edge);
    values[edge] = value < none ? Sign * value : values[edge];
  }
}
}

//------------------------------------------------------------------------------
const std::vector<ElementArray>& GetEdgeArrays()
{
  using Context = ElementContext;
  // clang-format off
  static const std::vector<ElementArray> arrays = {
    { "EdgeLength", "Edge length",
      "Distance of the two points, of edges of cells of higher order along the curve.",
      OfAnyCells, Unit::Length, true, CAMARON_REALS(EdgeLength) },
    { "EdgeCellCount", "Cells at the edge",
      "Number of 2D and 3D cells that have the edge.",
      OfAnyCells, Unit::None, true, CAMARON_IDS((CopyOf<&Context::GetEdgeUses, &ElementUses::Cells>)) },
    { "EdgeFaceCount", "Faces at the edge",
      "Number of faces of 3D cells, each counted once, and of 2D cells that have "
      "the edge.",
      OfAnyCells, Unit::None, true, CAMARON_IDS((CopyOf<&Context::GetEdgeUses, &ElementUses::Faces>)) },
    { "IsBoundary", "At the boundary",
      "1 if the edge belongs to a face with one 3D cell, or to a 2D cell and no "
      "other cell; else 0.",
      OfAnyCells, Unit::None, true, CAMARON_FLAGS(IsBoundaryEdge) },
    { "EdgeDihedralAngle", "Dihedral angle of the surface",
      "Angle between the two polygons at the edge, on the side opposite to their normals; 180 "
      "degrees if flat, undefined (NaN) unless the edge has two polygons.",
      OfPolygons, Unit::Angle, true, CAMARON_REALS(EdgeDihedralAngle) },
    { "BoundaryEdge", "Boundary edge",
      "1 if the edge has one polygon, else 0.",
      OfPolygons, Unit::None, false, CAMARON_FLAGS(BoundaryEdge) },
    { "NonManifoldEdge", "Non-manifold edge",
      "1 if the edge has more than two polygons, else 0.",
      OfPolygons, Unit::None, true, CAMARON_FLAGS(IsNonManifoldEdge),
      "", Better::Smaller, 0 },
    { "InconsistentEdge", "Inconsistent orientation",
      "1 if the two polygons at the edge traverse it in the same direction, "
      "which means opposite orientations; else 0.",
      OfPolygons, Unit::None, true, CAMARON_FLAGS(InconsistentEdge),
      "", Better::Smaller, 0 },
    { "EdgeMinDihedralAngle", "Minimum dihedral angle",
      "Minimum dihedral angle of the cells at the edge.",
      OfPolyhedra, Unit::Angle, false, CAMARON_REALS((CopyOf<&Context::GetEdgeAngles, &EdgeAngles::Min>)),
      "MinDihedralAngle" },
    { "EdgeMaxDihedralAngle", "Maximum dihedral angle",
      "Maximum dihedral angle of the cells at the edge.",
      OfPolyhedra, Unit::Angle, false, CAMARON_REALS((CopyOf<&Context::GetEdgeAngles, &EdgeAngles::Max>)),
      "MaxDihedralAngle" },
    { "EdgeAngleSum", "Sum of dihedral angles",
      "Sum of the dihedral angles of the cells at the edge; 360 degrees inside a mesh with planar "
      "faces, unless cells overlap or leave a gap (at warped faces, whose angles use a mean "
      "normal, only approximately). Undefined (NaN) if one of the angles is.",
      OfPolyhedra, Unit::Angle, false, CAMARON_REALS((CopyOf<&Context::GetEdgeAngles, &EdgeAngles::Sum>)) },
    { "NonOrthogonality", "Non-orthogonality",
      "Angle between the line through the centroids of the two polygons and the normal of the edge "
      "in the plane of a polygon; the larger of the two. Undefined (NaN) at the boundary.",
      OfPolygons, Unit::Angle, false, CAMARON_REALS((OfFacets<-1, Inside<GetNonOrthogonality>>)),
      "MaxNonOrthogonality" },
    { "BoundaryNonOrthogonality", "Non-orthogonality at the boundary",
      "Angle between the line from the centroid of the polygon to the midpoint of the edge and the "
      "normal of the edge; undefined (NaN) inside.",
      OfPolygons, Unit::Angle, false, CAMARON_REALS((OfFacets<-1, Boundary<GetBoundaryNonOrthogonality>>)),
      "MaxBoundaryNonOrthogonality" },
    { "FaceSkewness", "Edge skewness",
      "Distance of the midpoint of the edge from the line through the centroids, relative to the "
      "size of the edge in that direction.",
      OfPolygons, Unit::None, false, CAMARON_REALS((OfFacets<-1, InsideOrBoundary<GetFaceSkewness>>)),
      "MaxFaceSkewness" },
    { "FaceWeight", "Edge weight",
      "The smaller of the distances of the edge from the two centroids, along its normal, divided "
      "by their sum; undefined (NaN) at the boundary.",
      OfPolygons, Unit::None, false, CAMARON_REALS((OfFacets<1, Inside<GetFaceWeight>>)),
      "MinFaceWeight" },
    { "VolumeRatio", "Area ratio",
      "Ratio of the smaller to the larger area of the two polygons; undefined (NaN) "
      "at the boundary.",
      OfPolygons, Unit::None, false, CAMARON_REALS((OfFacets<1, Inside<GetVolumeRatio>>)),
      "MinVolumeRatio" },
    { "FacePyramidVolume", "Edge triangle area",
      "Area of the triangle formed by the edge and the centroid of a polygon; the smaller of the "
      "two.",
      OfPolygons, Unit::Area, false, CAMARON_REALS((OfFacets<1, PyramidSize<2>>)),
      "MinFacePyramidVolume" },
  };
  // clang-format on
  return arrays;
}
}
