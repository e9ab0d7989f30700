// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of vertices.
#include "Elements/Counters.h"
#include "Elements/ElementArray.h"
#include "Mesh/CellFacets.h"

#include <algorithm>
#include <functional>

namespace camaron
{
namespace
{
constexpr double Turn = 6.283185307179586476925286766559;

//------------------------------------------------------------------------------
void VertexCellCount(const ElementContext& context, vtkIdType* values)
{
  const std::vector<vtkIdType>& offsets = context.GetTopology().GetPointCells().Offsets;
  std::transform(
    offsets.begin() + 1, offsets.end(), offsets.begin(), values, std::minus<vtkIdType>());
}

//------------------------------------------------------------------------------
void VertexEdgeCount(const ElementContext& context, vtkIdType* values)
{
  for (const auto& edge : context.GetTopology().GetEdges())
  {
    ++values[edge[0]];
    ++values[edge[1]];
  }
}

//------------------------------------------------------------------------------
void IsBoundaryVertex(const ElementContext& context, unsigned char* values)
{
  const LargeVector<Index>& outer = context.GetVertexUses().BoundaryFaces;
  std::transform(outer.begin(), outer.end(), values, [](Index count) { return count > 0; });
  const MeshView& mesh = context.GetMesh();
  const FacetTable& table = context.GetTopology().GetSurfaceEdges();
  CellFacets facets(mesh);
  for (Index facet = 0; facet < table.GetNumberOfFacets(); ++facet)
  {
    if (table.IsBoundary(facet))
    {
      std::vector<vtkIdType> ends;
      facets.GetFacet(table.GetCells(facet).First, table.GetOwnerLocalFacet(facet), ends);
      for (const vtkIdType point : ends)
      {
        values[point] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
void UnusedPoint(const ElementContext& context, unsigned char* values)
{
  const std::vector<vtkIdType>& offsets = context.GetTopology().GetPointCells().Offsets;
  std::transform(
    offsets.begin() + 1, offsets.end(), offsets.begin(), values, std::equal_to<vtkIdType>());
}

//------------------------------------------------------------------------------
void PointRegionCount(const ElementContext& context, vtkIdType* values)
{
  const std::vector<Index>& counts = context.GetTopology().GetPointRegionCounts();
  std::copy(counts.begin(), counts.end(), values);
}

//------------------------------------------------------------------------------
void DuplicatePoint(const ElementContext& context, vtkIdType* values)
{
  const std::vector<vtkIdType>& points = context.GetCoincidentPoints();
  std::copy(points.begin(), points.end(), values);
}

//------------------------------------------------------------------------------
// For every vertex, the sum of the angles that addAngles(cell, sums) adds for cells of some shapes.
template <typename AddAngles>
void SumAngles(const ElementContext& context, unsigned shapes, unsigned needs, double* values,
  AddAngles&& addAngles)
{
  const MeshView& mesh = context.GetMesh();
  AngleSums sums(static_cast<std::size_t>(mesh.GetNumberOfPoints()));
  context.ForCells(
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      for (vtkIdType id = begin; id < end; ++id)
      {
        cell.Load(mesh, id, context.GetOptions());
        cell.Normalize();
        if (cell.GetShapes() & shapes)
        {
          cell.Compute(needs);
          addAngles(cell, sums);
        }
      }
    });
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    values[point] = sums.Get(point);
  }
}

//------------------------------------------------------------------------------
void SolidAngleSum(const ElementContext& context, double* values)
{
  SumAngles(context, Polyhedra, NeedsEdges | NeedsFaces | NeedsVolume | NeedsSolidAngle, values,
    [](CellGeometry& cell, AngleSums& sums)
    {
      for (int point = 0; point < cell.GetNumberOfPoints(); ++point)
      {
        sums.Add(cell.GetPointId(point), cell.GetSolidAngle(point));
      }
    });
}

//------------------------------------------------------------------------------
// Interior angle of a polygon at its i-th point.
double GetCornerAngle(const CellGeometry& cell, int i)
{
  const CellTopology& topology = cell.GetTopology();
  const int* ring = topology.GetFace(0);
  const int size = topology.GetFaceSize(0);
  const Vector& point = cell.GetPoint(ring[i]);
  const Vector next = cell.GetPoint(ring[i + 1 < size ? i + 1 : 0]) - point;
  const Vector previous = cell.GetPoint(ring[i > 0 ? i - 1 : size - 1]) - point;
  if (cell.IsZeroLength(Norm(next)) || cell.IsZeroLength(Norm(previous)))
  {
    return Null(NullReason::Degenerate);
  }
  const Vector normal = Cross(next, previous);
  const double angle = std::atan2(Norm(normal), Dot(next, previous));
  return Dot(normal, cell.GetFaceVector(0)) < 0 ? Turn - angle : angle;
}

//------------------------------------------------------------------------------
void PlaneAngleSum(const ElementContext& context, double* values)
{
  SumAngles(context, Polygons, NeedsFaces, values,
    [](CellGeometry& cell, AngleSums& sums)
    {
      const CellTopology& topology = cell.GetTopology();
      for (int i = 0; topology.GetNumberOfFaces() > 0 && i < topology.GetFaceSize(0); ++i)
      {
        sums.Add(cell.GetPointId(topology.GetFace(0)[i]), GetCornerAngle(cell, i));
      }
    });
}
}

//------------------------------------------------------------------------------
const std::vector<ElementArray>& GetVertexArrays()
{
  // clang-format off
  static const std::vector<ElementArray> arrays = {
    { "VertexCellCount", "Cells at the vertex",
      "Number of cells that have the point.",
      OfAnyCells, Unit::None, true, CAMARON_IDS(VertexCellCount) },
    { "VertexFaceCount", "Faces at the vertex",
      "Number of faces of 3D cells, each counted once, and of 2D cells that "
      "have the point.",
      OfAnyCells, Unit::None, true, CAMARON_IDS((CopyOf<&ElementContext::GetVertexUses, &ElementUses::Faces>)) },
    { "VertexEdgeCount", "Edges at the vertex",
      "Number of edges of 2D and 3D cells that end at the point.",
      OfAnyCells, Unit::None, true, CAMARON_IDS(VertexEdgeCount) },
    { "IsBoundary", "At the boundary",
      "1 if the point belongs to a face with one 3D cell, or to an edge with one 2D "
      "cell; else 0.",
      OfAnyCells, Unit::None, true, CAMARON_FLAGS(IsBoundaryVertex) },
    { "UnusedPoint", "Unused point",
      "1 if the point belongs to no cell, else 0.",
      OfAnyCells, Unit::None, true, CAMARON_FLAGS(UnusedPoint),
      "", Better::Smaller, 0 },
    { "PointRegionCount", "Groups of cells at the point",
      "Number of groups of cells around the point that are connected over common faces (polygons: "
      "edges) with this point; more than 1 where the mesh is pinched. With polygons and "
      "polyhedra, the larger number counts.",
      OfAnyCells, Unit::None, false, CAMARON_IDS(PointRegionCount),
      "", Better::Smaller, 1 },
    { "DuplicatePoint", "Duplicate point",
      "Lowest id of all points within MergeTolerance of the point, if there is another one; else "
      "-1. Uses global ids if the mesh has them, otherwise ids counted over the pieces of the "
      "block, in order. Without global ids, points of two pieces at exactly the same position are "
      "the same point.",
      OfAnyCells, Unit::None, false, CAMARON_IDS(DuplicatePoint) },
    { "VertexAngleSum", "Sum of solid angles",
      "Sum of the solid angles of the 3D cells at the point, 4 pi inside the mesh. Undefined "
      "(NaN) if one of the angles is.",
      OfPolyhedra, Unit::SolidAngle, false, CAMARON_REALS(SolidAngleSum) },
    { "VertexAngleSum", "Sum of plane angles",
      "Without 3D cells: sum of the plane angles of the polygons at the point, 360 degrees on a "
      "flat surface. Undefined (NaN) if one of the angles is.",
      OfPolygons, Unit::Angle, false, CAMARON_REALS(PlaneAngleSum) },
  };
  // clang-format on
  return arrays;
}
}
