// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SelectBySolid.h
 * @brief Finds the cells that are inside a closed solid, partly or completely.
 */
#ifndef camaron_SelectBySolid_h
#define camaron_SelectBySolid_h

#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
#include "Mesh/CellShape.h"
#include "Mesh/MeshView.h"
#include "Selection/Solids.h"

#include <algorithm> // for all and any
#include <optional>  // for centroids
#include <vector>    // for marks

namespace camaron
{
/// The condition to select a cell.
enum class Placement
{
  AnyVertexInside,
  AllVerticesInside,
  CentroidInside,
  Intersects,   ///< it intersects the solid
  CutByBoundary ///< it intersects both the solid and the space outside
};

/// For every point, whether it is inside the solid.
template <typename Solid>
std::vector<unsigned char> FindPointsInside(const MeshView& mesh, const Solid& solid)
{
  std::vector<unsigned char> inside(mesh.GetNumberOfPoints());
  ParallelForEach(mesh.GetNumberOfPoints(), 1 << 14,
    [&](vtkIdType point) { inside[point] = solid.Contains(mesh.GetPoint(point)); });
  return inside;
}

/// Evaluates the condition for cells; use one object per thread.
template <typename Solid>
class CellPlacement
{
public:
  CellPlacement(const MeshView& mesh, const Solid& solid, const std::vector<unsigned char>& inside)
    : Mesh(mesh)
    , Space(solid)
    , Inside(inside)
    , Boundary(mesh)
  {
  }

  bool Has(vtkIdType cell, Placement placement)
  {
    if (placement == Placement::CentroidInside)
    {
      return this->HasCentroid(cell);
    }
    vtkIdType size = 0, count = 0;
    this->CountVertices(cell, size, count);
    switch (placement)
    {
      case Placement::AnyVertexInside:
        return count > 0;
      case Placement::AllVerticesInside:
        return size > 0 && count == size;
      case Placement::Intersects:
        return count > 0 || this->MeetsWithoutVertex(cell);
      default:
        return count == 0 ? this->MeetsWithoutVertex(cell) : count < size || this->IsCrossed(cell);
    }
  }

private:
  void CountVertices(vtkIdType cell, vtkIdType& size, vtkIdType& count) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    size = GetNumberOfCorners(this->Mesh.GetCellType(cell), points.Size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      count += this->Inside[points[i]];
    }
  }
  bool HasCentroid(vtkIdType cell)
  {
    const unsigned char type = this->Mesh.GetCellType(cell);
    if (type == VTK_TETRA || type == VTK_TRIANGLE)
    {
      return this->Space.Contains(this->GetMeanPoint(cell)); // same result, and much faster
    }
    if (GetCellShape(type).Dimension < 2)
    {
      this->Boundary.Load(cell);
      return !this->Boundary.GetSimplices().empty() &&
        this->Space.Contains(this->Boundary.GetMiddle());
    }
    const EvaluationOptions options;
    this->Geometry.Load(this->Mesh, cell, options);
    if (!this->Geometry.IsFinite() || this->Geometry.GetNumberOfPoints() == 0)
    {
      return false;
    }
    this->Geometry.Compute(NeedsCentroid);
    const CellMap* const map = this->Geometry.GetCurvedMap();
    const Vector centroid = (map ? map->GetCentroid(this->Geometry.GetNormal()) : std::nullopt)
                              .value_or(this->Geometry.GetCentroid());
    return this->Space.Contains(this->Geometry.GetOrigin() + centroid);
  }
  Vector GetMeanPoint(vtkIdType cell) const
  {
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    const Vector origin = this->Mesh.GetPoint(points[0]);
    Vector sum;
    for (vtkIdType i = 1; i < points.Size; ++i)
    {
      sum += this->Mesh.GetPoint(points[i]) - origin;
    }
    return origin + (1.0 / static_cast<double>(points.Size)) * sum;
  }
  bool MeetsWithoutVertex(vtkIdType cell)
  {
    Bounds box;
    for (const vtkIdType point : this->Mesh.GetCellPoints(cell))
    {
      box.Add(this->Mesh.GetPoint(point));
    }
    if (box.IsEmpty() || !this->Space.MayMeet(box))
    {
      return false;
    }
    this->Boundary.Load(cell);
    return this->Space.Meets(this->Boundary);
  }
  bool IsCrossed(vtkIdType cell)
  {
    if (Solid::IsConvex)
    {
      return false;
    }
    this->Boundary.Load(cell);
    return this->Space.Crosses(this->Boundary);
  }

  const MeshView& Mesh;
  const Solid& Space;
  const std::vector<unsigned char>& Inside;
  CellBoundary Boundary;
  CellGeometry Geometry;
};

/// Sets the marks, one per cell, to 1 for the cells that satisfy the condition, else to 0.
template <typename Solid>
void MarkCells(
  const MeshView& mesh, const Solid& solid, Placement placement, std::vector<unsigned char>& marks)
{
  std::vector<unsigned char> inside;
  if (placement != Placement::CentroidInside)
  {
    inside = FindPointsInside(mesh, solid);
  }
  ParallelFor(mesh.GetNumberOfCells(), 1 << 12,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellPlacement<Solid> cells(mesh, solid, inside);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        marks[cell] = cells.Has(cell, placement);
      }
    });
}
}

#endif
