// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of faces.
#include "Base/Parallel.h"
#include "Cell/CellDefects.h"
#include "Elements/ElementArray.h"
#include "Elements/NeighborhoodPass.h"

#include <algorithm>

namespace camaron
{
namespace
{
using Facet = CellNeighborhood::Facet;

//------------------------------------------------------------------------------
// Calls fill(face, facets of the mesh) for all faces of 3D cells in parallel.
template <typename Fill>
void ForFacets(const ElementContext& context, Fill&& fill)
{
  const FacetTable& table = context.GetTopology().GetFaces();
  ParallelForEach(table.GetNumberOfFacets(), HeavyGrain,
    [&](vtkIdType face) { fill(static_cast<Index>(face), table); });
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
  ForFacets(context, [&](Index face, const FacetTable& table)
    { values[face] = context.GetGlobalCell(table.GetCells(face).First); });
}

//------------------------------------------------------------------------------
void NeighborCell(const ElementContext& context, vtkIdType* values)
{
  ForFacets(context,
    [&](Index face, const FacetTable& table)
    {
      const Index cell = table.GetCells(face).Second;
      values[face] = cell < 0 ? -1 : context.GetGlobalCell(cell);
    });
}

//------------------------------------------------------------------------------
void FaceCellCount(const ElementContext& context, vtkIdType* values)
{
  ForFacets(context,
    [&](Index face, const FacetTable& table) { values[face] = table.GetNumberOfCells(face); });
}

//------------------------------------------------------------------------------
void IsBoundaryFace(const ElementContext& context, unsigned char* values)
{
  ForFacets(
    context, [&](Index face, const FacetTable& table) { values[face] = table.IsBoundary(face); });
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
// A measure of a face with an area.
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
  ParallelFor(static_cast<vtkIdType>(cells.size()), HeavyGrain,
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
// Each face with the orientation and values of its first cell.
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
        if (!table.IsOwner(face, id, facet.Use))
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
    { "OwnerCell", "Owner cell",
      "Smallest id of the cells of the face; the face is oriented out of this cell.",
      OfAnyCells, Unit::None, true, CAMARON_IDS(OwnerCell) },
    { "NeighborCell", "Neighbor cell",
      "Id of the cell on the other side, or -1.",
      OfPolyhedra, Unit::None, true, CAMARON_IDS(NeighborCell) },
    { "FaceCellCount", "Cells at the face",
      "Number of cells that have the face: 1 at the boundary, 2 inside, more "
      "where cells overlap.",
      OfPolyhedra, Unit::None, true, CAMARON_IDS(FaceCellCount) },
    { "IsBoundary", "At the boundary",
      "1 if the face has one cell, else 0.",
      OfPolyhedra, Unit::None, true, CAMARON_FLAGS(IsBoundaryFace) },
    { "NonOrthogonality", "Non-orthogonality",
      "Angle between the line through the centroids of both cells and the normal of the face; "
      "undefined (NaN) at the boundary.",
      OfPolyhedra, Unit::Angle, true, CAMARON_FACETS(Inside<GetNonOrthogonality>),
      "MaxNonOrthogonality" },
    { "BoundaryNonOrthogonality", "Non-orthogonality at the boundary",
      "Angle between the line from the centroid of the cell to the center of the face and the "
      "normal of the face; undefined (NaN) inside.",
      OfPolyhedra, Unit::Angle, true, CAMARON_FACETS(Boundary<GetBoundaryNonOrthogonality>),
      "MaxBoundaryNonOrthogonality" },
    { "FaceSkewness", "Face skewness",
      "Distance of the center of the face from the line through the centroids, relative to the "
      "size of the face in that direction.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(InsideOrBoundary<GetFaceSkewness>),
      "MaxFaceSkewness" },
    { "FaceWeight", "Face weight",
      "The smaller of the distances of the face from the two centroids, along its normal, divided "
      "by their sum; undefined (NaN) at the boundary.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(Inside<GetFaceWeight>),
      "MinFaceWeight" },
    { "VolumeRatio", "Volume ratio",
      "Ratio of the smaller to the larger volume of the two cells; undefined (NaN) "
      "at the boundary.",
      OfPolyhedra, Unit::None, true, CAMARON_FACETS(Inside<GetVolumeRatio>),
      "MinVolumeRatio" },
    { "FacePyramidVolume", "Face pyramid volume",
      "Volume of the pyramid formed by the face and the centroid of a cell; the smaller of the "
      "two.",
      OfPolyhedra, Unit::Volume, true, CAMARON_FACETS((PyramidSize<3>)),
      "MinFacePyramidVolume" },
    { "FaceTwist", "Face twist",
      "Minimum cosine of the angles between the normals of the triangles about the center of the "
      "face and the line through the centroids; at the boundary, the line to the center of the "
      "face.",
      OfPolyhedra, Unit::None, false, CAMARON_FACETS(InsideOrBoundary<GetFaceTwist>),
      "", Better::Bigger, 1 },
    { "FaceFlatness", "Face flatness",
      "Projected area of the face along its normal divided by the area of the "
      "triangles about its center.",
      OfAnyCells, Unit::None, false, CAMARON_SHAPES(OfShape<GetFaceFlatness>),
      "MinFaceFlatness" },
    { "Warpage", "Warpage",
      "Maximum distance of a point of the face from its mean plane divided by the maximum distance "
      "from its center.",
      OfAnyCells, Unit::None, false, CAMARON_SHAPES(OfShape<GetFaceWarpage>),
      "MaxWarpage" },
    { "FaceConcavity", "Face concavity",
      "How far the maximum angle of the face exceeds 180 degrees; 0 for a convex "
      "face.",
      OfAnyCells, Unit::Angle, false, CAMARON_SHAPES(OfShape<GetFaceConcavity>),
      "MaxFaceConcavity" },
    { "FaceMismatch", "Mismatched face",
      "1 if all points of a boundary face are within MergeTolerance of those of another boundary "
      "face, because cells are not connected or the faces form a baffle; else 0.",
      OfPolyhedra, Unit::None, false, CAMARON_FLAGS(FaceMismatch),
      "", Better::Smaller, 0 },
  };
  // clang-format on
  return arrays;
}
}
