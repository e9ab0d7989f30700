// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria about the connectivity of the mesh and duplicate cells.
#include "Criteria/CriterionRows.h"
#include "Mesh/CellFacets.h"
#include "Mesh/FacetLinks.h"
#include "Ranks/MeshFacts.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls getValue(cell, its dimension) for the 2D and 3D cells, after building the facet tables.
template <typename GetValue>
void ForFacetCells(
  const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values, GetValue&& getValue)
{
  mesh.Topology.GetFaces();
  mesh.Topology.GetSurfaceEdges();
  const CellFacets facets(mesh.Topology.GetMesh());
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const int dimension = facets.GetDimension(cell);
    values[cell - begin] =
      dimension >= 2 ? getValue(cell, dimension) : Null(NullReason::NotApplicable);
  }
}

//------------------------------------------------------------------------------
// The cells of other pieces that have all facets of a cell, except collapsed ones.
void FindLinkedDuplicates(
  const FacetTable& table, vtkIdType id, const FacetLinks& links, std::vector<LinkedCell>& found)
{
  found.clear();
  bool isFirst = true;
  for (const CellFacet use : table.GetCellFacets(id))
  {
    if (table.IsCollapsed(use.Facet()))
    {
      continue;
    }
    const auto hasFacet = [&](const LinkedCell& cell)
    {
      bool result = false;
      links.ForEach(use.Facet(),
        [&](const LinkedCell& other, bool)
        {
          result = result ||
            (other.Process == cell.Process && other.Piece == cell.Piece && other.Cell == cell.Cell);
        });
      return result;
    };
    if (isFirst)
    {
      links.ForEach(use.Facet(), [&](const LinkedCell& other, bool) { found.push_back(other); });
    }
    else
    {
      found.erase(std::remove_if(found.begin(), found.end(), std::not_fn(hasFacet)), found.end());
    }
    isFirst = false;
    if (found.empty())
    {
      return;
    }
  }
}
}

//------------------------------------------------------------------------------
void RegionId(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const std::vector<std::int64_t>& regions = mesh.Options.Regions->OfCells;
  ForFacetCells(mesh, begin, end, values,
    [&](vtkIdType cell, int)
    {
      const std::int64_t region = regions[cell];
      // A polyhedron without faces is connected to nothing.
      return region == MeshRegions::None                  ? Null(NullReason::InvalidTopology)
        : region < 0 || mesh.Options.IsPieceWithoutGhosts ? Null(NullReason::MissingGhosts)
                                                          : static_cast<double>(region);
    });
}

//------------------------------------------------------------------------------
void IsBoundary(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const EvaluationOptions& options = mesh.Options;
  ForFacetCells(mesh, begin, end, values,
    [&](vtkIdType cell, int dimension)
    {
      const FacetTable& table = mesh.Topology.GetFacets(dimension);
      const FacetTable::Range uses = table.GetCellFacets(cell);
      const FacetLinks* links = options.Links ? &options.Links->GetFacets(dimension) : nullptr;
      const bool isAlone = std::any_of(uses.begin(), uses.end(), [&](CellFacet use)
        { return table.IsBoundary(use.Facet()) && !(links && links->Has(use.Facet())); });
      return isAlone && options.MayHaveMore(cell) ? Null(NullReason::MissingGhosts)
                                                  : double(isAlone);
    });
}

//------------------------------------------------------------------------------
void DuplicateCell(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const std::vector<double>& ids = mesh.GetDuplicateIds();
  const EvaluationOptions& options = mesh.Options;
  std::vector<LinkedCell> linked;
  ForFacetCells(mesh, begin, end, values,
    [&](vtkIdType cell, int dimension)
    {
      double lowest = ids[cell];
      if (options.Links)
      {
        FindLinkedDuplicates(
          mesh.Topology.GetFacets(dimension), cell, options.Links->GetFacets(dimension), linked);
        for (const LinkedCell& other : linked)
        {
          lowest = std::min(lowest < 0 ? mesh.GetId(cell) : lowest, static_cast<double>(other.Id));
        }
      }
      return lowest;
    });
}

//------------------------------------------------------------------------------
void PointRegionCount(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const std::vector<Index>& counts = mesh.Options.PointGroups
    ? mesh.Options.PointGroups->Counts
    : mesh.Topology.GetPointRegionCounts();
  const MeshView& view = mesh.Topology.GetMesh();
  ForFacetCells(mesh, begin, end, values,
    [&](vtkIdType cell, int)
    {
      Index largest = 0;
      const IndexRange points = view.GetCellPoints(cell);
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        largest = std::max(largest, counts[points[i]]);
      }
      return double(largest);
    });
}

//------------------------------------------------------------------------------
void MaxFaceCellCount(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const EvaluationOptions& options = mesh.Options;
  std::vector<Index> scratch;
  ForFacetCells(mesh, begin, end, values,
    [&](vtkIdType cell, int dimension)
    {
      const FacetTable& table = mesh.Topology.GetFacets(dimension);
      const FacetLinks* links = options.Links ? &options.Links->GetFacets(dimension) : nullptr;
      Index largest = 0;
      for (const CellFacet use : table.GetCellFacets(cell))
      {
        const Index facet = use.Facet();
        const bool isLinked = links && links->Has(facet) && !options.IsCopy(cell);
        if (!isLinked && table.IsBoundary(facet) && options.MayHaveMore(cell))
        {
          return Null(NullReason::MissingGhosts);
        }
        largest = std::max(largest,
          isLinked ? CountCellsOfAllPieces(facet, table, *links, options, scratch)
                   : table.GetNumberOfCells(facet));
      }
      return largest > 0 ? double(largest) : Null(NullReason::InvalidTopology);
    });
}

//------------------------------------------------------------------------------
std::vector<Criterion> ConnectivityCriteria()
{
  return {
    CriterionRow("RegionId", "Region",
      "Index of the component that contains the cell. Cells are connected over common faces "
      "(polygons: common edges); points or edges alone do not connect polyhedra. Components are "
      "numbered from 0 in the order of their first cells (by global ids if the mesh has them).")
      .Range(0, Infinity)
      .Kind(ValueKind::Integer)
      .Needs(NeedsRegions)
      .Mesh(RegionId)
      .Formula("connected component of the graph of the cells and their common facets")
      .Degenerate("NaN (invalid topology) for a polyhedron without faces; NaN (unknown piece) for "
                  "a ghost cell that no cell of its piece is connected to.")
      .Agreement("ParaView's Connectivity connects cells over common points and numbers components "
                 "in another order."),
    CriterionRow("PointRegionCount", "Groups of cells at a point",
      "At each point of the cell, the cells around it form groups connected over common faces "
      "(polygons: edges) with this point; the value is the maximum number of groups. More than 1 "
      "where the mesh is pinched.")
      .Range(0, Infinity)
      .Ideal(1, Better::Smaller)
      .Acceptable(-Infinity, 1, "no pinched points", Cited, PolygonsAndPolyhedra)
      .Kind(ValueKind::Integer)
      .Needs(NeedsPointRegions)
      .Mesh(PointRegionCount)
      .Formula("max over the points of the cell of the number of connected components of the graph "
               "of the cells around the point and their common facets with that point")
      .Degenerate("0 for a polyhedron without faces. At a point with both polygons and polyhedra, "
                  "the larger number of groups counts.")
      .Agreement("OpenFOAM's checkMesh calls such points multiply connected and reports them at "
                 "the boundary only.")
      .Consequence("cells that touch in a point only: the domain is pinched there"),
    CriterionRow("DuplicateCell", "Cell with the same points",
      "Lowest id of all cells with exactly the same points as this cell, if there is another one; "
      "else -1. Uses global ids if the mesh has them.")
      .Range(-1, Infinity)
      .Ideal(-1, Better::Neither)
      .Acceptable(-Infinity, -1, "no duplicate cells", Cited, PolygonsAndPolyhedra)
      .Kind(ValueKind::Integer)
      .Mesh(DuplicateCell)
      .Formula(
        "min over the ids of the cells with the same dimension and the same set of point ids")
      .Degenerate("Cells are compared by point ids: duplicates on coincident but distinct points "
                  "are not found; see DuplicatePoint of Mesh Elements.")
      .Agreement("ParaView's Clean to Grid merges points, not cells.")
      .Consequence("duplicate cells: the domain overlaps itself"),
    CriterionRow("MaxFaceCellCount", "Maximum cells at a face",
      "Maximum number of cells that share a face of the cell (polygons: an edge), including the "
      "cell itself; more than 2 where cells overlap or surfaces meet.")
      .Range(1, Infinity)
      .Ideal(None, Better::Smaller)
      .Acceptable(-Infinity, 2, "the cell and one neighbor", Cited, Polyhedra)
      .Kind(ValueKind::Integer)
      .Mesh(MaxFaceCellCount)
      .Formula("max over the faces of the number of cells that have a face with the same points")
      .Degenerate("1 for an isolated cell. Duplicate cells all count, and a cell that has the face "
                  "twice counts twice. NaN (unknown piece) as for `IsBoundary`, NaN (invalid "
                  "topology) for a cell without faces.")
      .Agreement("checkMesh rejects meshes with such faces; `FaceCellCount` of Mesh Elements "
                 "identifies them.")
      .Consequence("faces with more than two cells: the domain overlaps itself"),
    CriterionRow("IsBoundary", "At the boundary",
      "1 if a face of the cell (polygons: an edge) belongs to no other cell, else 0.")
      .Range(0, 1)
      .Kind(ValueKind::Integer)
      .Mesh(IsBoundary)
      .Formula("1 if a facet of the cell belongs to no other cell")
      .Degenerate("NaN (unknown piece) if the neighbor may be in another piece.")
      .Agreement("checkMesh reads boundary faces from a file; here they follow from the cells."),
  };
}
}
