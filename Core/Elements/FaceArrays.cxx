// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of faces.
#include "Base/Parallel.h"
#include "Cell/CellDefects.h"
#include "Elements/ElementArray.h"
#include "Elements/FacetValues.h"
#include "Elements/NeighborhoodPass.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;
using Facet = CellNeighborhood::Facet;

//------------------------------------------------------------------------------
// Calls fill(face) for all faces of 3D cells in parallel.
template <typename Fill>
void ForFacets(const ElementContext& context, Fill&& fill)
{
  ParallelFor(context.GetTopology().GetFaces().GetNumberOfFacets(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType face = begin; face < end; ++face)
      {
        fill(static_cast<Index>(face));
      }
    });
}

//------------------------------------------------------------------------------
void OwnerCell(const ElementContext& context, vtkIdType* values)
{
  if (!context.HasCells(3))
  {
    const std::vector<vtkIdType>& cells = context.GetPolygonCells();
    std::transform(cells.begin(), cells.end(), values,
      [&](vtkIdType cell) { return context.GetGlobalCell(cell); });
    return;
  }
  const FacetTable& table = context.GetTopology().GetFaces();
  ForFacets(
    context, [&](Index face) { values[face] = context.GetGlobalCell(table.GetCells(face).First); });
}

//------------------------------------------------------------------------------
void NeighborCell(const ElementContext& context, vtkIdType* values)
{
  const FacetTable& table = context.GetTopology().GetFaces();
  ForFacets(context,
    [&](Index face)
    {
      const Index cell = table.GetCells(face).Second;
      values[face] = cell < 0 ? -1 : context.GetGlobalCell(cell);
    });
}

//------------------------------------------------------------------------------
void FaceCellCount(const ElementContext& context, vtkIdType* values)
{
  const FacetTable& table = context.GetTopology().GetFaces();
  ForFacets(context, [&](Index face) { values[face] = table.GetNumberOfCells(face); });
}

//------------------------------------------------------------------------------
void IsBoundaryFace(const ElementContext& context, unsigned char* values)
{
  const FacetTable& table = context.GetTopology().GetFaces();
  ForFacets(context, [&](Index face) { values[face] = table.IsBoundary(face); });
}

//------------------------------------------------------------------------------
void FaceMismatch(const ElementContext& context, unsigned char* values)
{
  for (const Index face : context.GetMismatchedFaces())
  {
    values[face] = 1;
  }
}

//------------------------------------------------------------------------------
// A measure of a face that has an area.
template <double (*Measure)(const CellGeometry&, int)>
double OfShape(const CellGeometry& cell, int face)
{
  return cell.IsZeroArea(cell.GetFaceArea(face)) ? Null(NullReason::Degenerate)
                                                 : Measure(cell, face);
}

//------------------------------------------------------------------------------
void EvaluatePolygonCells(const ElementContext& context,
  const std::vector<const ElementArray*>& rows, const std::vector<double*>& values)
{
  const std::vector<vtkIdType>& cells = context.GetPolygonCells();
  ParallelFor(static_cast<vtkIdType>(cells.size()), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      for (vtkIdType face = begin; face < end; ++face)
      {
        cell.Load(context.GetMesh(), cells[face], context.GetOptions());
        cell.Normalize();
        cell.Compute(NeedsEdges | NeedsFaces | NeedsCorners);
        const bool hasFace = cell.IsFinite() && cell.GetTopology().GetNumberOfFaces() > 0;
        for (std::size_t row = 0; row < rows.size(); ++row)
        {
          values[row][face] =
            hasFace ? rows[row]->ShapeFunction(cell, 0) : Null(NullReason::Degenerate);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Each face as its first cell sees it.
void EvaluateFacets(const ElementContext& context, const std::vector<const ElementArray*>& rows,
  const std::vector<double*>& values)
{
  const MeshTopology& topology = context.GetTopology();
  const FacetTable& table = topology.GetFaces();
  for (double* array : values)
  {
    std::fill_n(array, table.GetNumberOfFacets(), Null(NullReason::Degenerate));
  }
  const bool needsCorners = std::any_of(rows.begin(), rows.end(),
    [](const ElementArray* row) { return row->ShapeFunction != nullptr; });
  ForEachNeighborhood(context, table, needsCorners ? NeedsEdges | NeedsCorners : 0u,
    [&](vtkIdType id, const FacetTable::Range& uses, const CellGeometry& cell,
      const CellNeighborhood& neighborhood)
    {
      for (const Facet& facet : neighborhood.GetFacets())
      {
        const Index face = uses[facet.Use].Facet();
        if (table.GetCells(face).First != id || table.GetOwnerLocalFacet(face) != facet.Use)
        {
          continue;
        }
        for (std::size_t row = 0; row < rows.size(); ++row)
        {
          values[row][face] = rows[row]->FacetFunction
            ? rows[row]->FacetFunction(neighborhood, facet)
            : rows[row]->ShapeFunction(cell, facet.Number);
        }
      }
    });
}
}

//------------------------------------------------------------------------------
void EvaluateFaces(const ElementContext& context, const std::vector<const ElementArray*>& rows,
  const std::vector<double*>& values)
{
  context.HasCells(3) ? EvaluateFacets(context, rows, values)
                      : EvaluatePolygonCells(context, rows, values);
}

//------------------------------------------------------------------------------
const std::vector<ElementArray>& GetFaceArrays()
{
  // clang-format off
  static const std::vector<ElementArray> arrays = {
    { "OwnerCell",
      "Id of the cell of the face that has the smallest one; the face runs out of it.",
      OfAnyCells, Unit::None, true, CAMARON_IDS(OwnerCell) },
    { "NeighborCell", "Id of the cell on the other side; -1 for none.",
      OfPolyhedra, Unit::None, true, CAMARON_IDS(NeighborCell) },
    { "FaceCellCount", "Number of cells that have the face: 1 at the boundary, 2 inside, more where cells overlap.",
      OfPolyhedra, Unit::None, true, CAMARON_IDS(FaceCellCount) },
    { "IsBoundary", "1 for a face with one cell, else 0.",
      OfPolyhedra, Unit::None, true, CAMARON_FLAGS(IsBoundaryFace) },
    { "NonOrthogonality",
      "Angle between the line of the centroids of both cells and the normal of the face; null at the boundary.",
      OfPolyhedra, Unit::Angle, true, CAMARON_FACETS(Inside<GetNonOrthogonality>) },
    { "BoundaryNonOrthogonality",
      "Angle between the line from the centroid of the cell to the center of the face and its normal; null inside.",
      OfPolyhedra, Unit::Angle, true, CAMARON_FACETS(Boundary<GetBoundaryNonOrthogonality>) },
    { "FaceSkewness",
      "Distance of the center of the face from the line of the centroids, relative to its size in that direction.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(InsideOrBoundary<GetFaceSkewness>) },
    { "FaceWeight",
      "Smaller distance of the face from the two centroids, along its normal, divided by the sum of both; null at "
      "the boundary.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(Inside<GetFaceWeight>) },
    { "VolumeRatio", "Smaller divided by larger volume of the two cells; null at the boundary.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(Inside<GetVolumeRatio>) },
    { "FacePyramidVolume",
      "Volume of the pyramid over the face with the centroid of a cell as apex, the smaller one of both sides.",
      OfPolyhedra, Unit::Volume, true, CAMARON_FACETS((PyramidSize<3>)) },
    { "FaceTwist",
      "Minimum cosine between the triangles about the center of the face and the line of the centroids, at the "
      "boundary the line to the center of the face.",
      OfPolyhedra, Unit::None, false, CAMARON_FACETS(InsideOrBoundary<GetFaceTwist>) },
    { "FaceFlatness", "Area of the face projected along its normal, divided by that of the triangles about its center.",
      OfAnyCells, Unit::None, false, CAMARON_SHAPES(OfShape<GetFaceFlatness>) },
    { "Warpage",
      "Maximum distance of a point of the face from its plane, divided by the largest one from its center.",
      OfAnyCells, Unit::None, false, CAMARON_SHAPES(OfShape<GetFaceWarpage>) },
    { "FaceConcavity", "By how much the largest angle of the face exceeds 180 degrees; 0 for a convex one.",
      OfAnyCells, Unit::Angle, false, CAMARON_SHAPES(OfShape<GetFaceConcavity>) },
    { "FaceMismatch",
      "1 for a boundary face all of whose points are within MergeTolerance of those of another boundary face: cells "
      "that should be connected, or a baffle. Else 0.",
      OfPolyhedra, Unit::None, false, CAMARON_FLAGS(FaceMismatch) },
  };
  // clang-format on
  return arrays;
}
}
