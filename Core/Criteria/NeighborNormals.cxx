// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/AngleRange.h"
#include "Criteria/CriterionRows.h"
#include "Mesh/CellFacets.h"
#include "Mesh/FacetLinks.h"
#include "Ranks/SurfaceSides.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// Additional findings at the edges of a polygon.
struct Findings
{
  bool HasNeighbor = false;
  bool IsMissing = false; // an edge may have a polygon in another piece
};

//------------------------------------------------------------------------------
// Calls visit(vector, isOpposite) for the vector area of every other polygon at an edge of a
// polygon, and whether it traverses the edge in the opposite direction.
template <typename Visitor>
void ForEachOther(const MeshContext& mesh, const std::vector<Vector>& vectors,
  const FacetTable& edges, vtkIdType cell, CellFacet edge, std::vector<Index>& cells,
  Findings& findings, Visitor&& visit)
{
  const EvaluationOptions& options = mesh.Options;
  const bool isLinked =
    options.Links && options.Links->Edges.Has(edge.Facet()) && !options.IsCopy(cell);
  bool any = false;
  edges.GetCells(edge.Facet(), cells);
  for (const Index other : cells)
  {
    if (other == cell || (isLinked && options.IsCopy(other)))
    {
      continue;
    }
    any = true;
    bool reversed = edge.IsReversed();
    for (const CellFacet theirs : edges.GetCellFacets(other))
    {
      if (theirs.Facet() == edge.Facet())
      {
        reversed = theirs.IsReversed();
      }
    }
    visit(vectors[other], reversed != edge.IsReversed());
  }
  if (isLinked)
  {
    options.Links->Edges.ForEach(edge.Facet(),
      [&](const LinkedCell& other, bool reversed)
      {
        any = true;
        visit(other.Area, reversed != edge.IsReversed());
      });
  }
  findings.HasNeighbor = findings.HasNeighbor || any;
  findings.IsMissing =
    findings.IsMissing || (!any && edges.IsBoundary(edge.Facet()) && options.MayHaveMore(cell));
}

//------------------------------------------------------------------------------
// Two polygons are consistent if they traverse the edge in opposite directions; otherwise one of
// them counts as flipped.
template <auto Choose>
void NeighborNormalAngle(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const FacetTable& edges = mesh.Topology.GetSurfaceEdges();
  const std::vector<Vector>& vectors = mesh.GetCellVectors();
  const double factor = GetAngleFactor(mesh.Options.Angles);
  std::vector<Index> cells;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    if (edges.GetCellFacets(cell).size() == 0)
    {
      values[cell - begin] = Null(NullReason::NotApplicable);
      continue;
    }
    const Vector& own = vectors[cell];
    Findings findings;
    double chosen = -1;
    for (const CellFacet edge : edges.GetCellFacets(cell))
    {
      ForEachOther(mesh, vectors, edges, cell, edge, cells, findings,
        [&](const Vector& other, bool isOpposite)
        {
          if (Norm2(own) > 0 && Norm2(other) > 0)
          {
            const double cosine = (isOpposite ? 1 : -1) * Dot(own, other);
            const double angle = std::atan2(Norm(Cross(own, other)), cosine);
            chosen = chosen < 0 ? angle : Choose(chosen, angle);
          }
        });
    }
    values[cell - begin] = findings.IsMissing ? Null(NullReason::MissingGhosts)
      : chosen >= 0                           ? factor * chosen
      : findings.HasNeighbor                  ? Null(NullReason::Degenerate)
                                              : Null(NullReason::NoNeighbor);
  }
}

//------------------------------------------------------------------------------
// Angles between a polygon and its neighbors, inside a closed surface.
template <auto Choose>
void SurfaceDihedralAngle(const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  const MeshView& view = mesh.Topology.GetMesh();
  const FacetTable& edges = mesh.Topology.GetSurfaceEdges();
  const std::vector<Vector>& vectors = mesh.GetCellVectors();
  const double factor = GetAngleFactor(mesh.Options.Angles);
  CellFacets facets(view);
  std::vector<Index> cells;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const FacetTable::Range uses = edges.GetCellFacets(cell);
    const SurfaceSide side = mesh.Options.Sides->OfCells[cell];
    if (uses.size() == 0 || side == SurfaceSide::None || side == SurfaceSide::Unknown)
    {
      values[cell - begin] = Null(uses.size() == 0 ? NullReason::NotApplicable
          : side == SurfaceSide::None              ? NullReason::InvalidTopology
                                                   : NullReason::MissingGhosts);
      continue;
    }
    const Vector& own = vectors[cell];
    double chosen = -1;
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType, vtkIdType local)
      {
        const Vector along = view.GetPoint(points[1]) - view.GetPoint(points[0]);
        const Vector edge = Unit(side == SurfaceSide::Outward ? along : -along);
        Findings findings;
        ForEachOther(mesh, vectors, edges, cell, uses[static_cast<Index>(local)], cells, findings,
          [&](const Vector& other, bool)
          {
            if (Norm2(edge) > 0 && Norm2(own) > 0 && Norm2(other) > 0)
            {
              const double angle = GetDihedralAngle(edge, own, other);
              chosen = chosen < 0 ? angle : Choose(chosen, angle);
            }
          });
      });
    values[cell - begin] = chosen >= 0 ? factor * chosen : Null(NullReason::Degenerate);
  }
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> NeighborNormalCriteria()
{
  return {
    CriterionRow("MinNeighborNormalAngle", "Minimum angle to a neighbor",
      "Minimum angle between the normal of the polygon and those of the polygons that share an "
      "edge with it; 0 is flat.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Needs(NeedsFaces)
      .Mesh(NeighborNormalAngle<GetSmaller>)
      .Formula(
        "min of atan2(|S × S′|, ±S · S′) over the polygons S′ that share an edge with S; the sign "
        "corrects for orientation, as if both traversed the edge in opposite directions")
      .Degenerate(
        "NaN (no neighbor) without neighbors, NaN (degenerate) if the polygon or all its neighbors "
        "are collapsed. At an edge with more than two polygons, each neighbor counts.")
      .Agreement("The \"dihedral angle\" of polygons in the original Camarón, but independent of "
                 "the orientation of the normals."),
    CriterionRow("MaxNeighborNormalAngle", "Maximum angle to a neighbor",
      "Maximum angle between the normal of the polygon and those of the polygons that share an "
      "edge with it; 0 is flat.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 180)
      .Ideal(0, Better::Smaller)
      .Needs(NeedsFaces)
      .Mesh(NeighborNormalAngle<GetLarger>)
      .Formula("maximum of the angles of `MinNeighborNormalAngle`")
      .Degenerate("As `MinNeighborNormalAngle`.")
      .Agreement("As `MinNeighborNormalAngle`."),
    CriterionRow("MinSurfaceDihedralAngle", "Minimum dihedral angle of the surface",
      "Minimum angle between a polygon of a closed surface and its neighbors, measured inside the "
      "enclosed volume; 180 is flat, less is a ridge, more a valley.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Bigger)
      .Needs(NeedsFaces | NeedsSurfaceSides)
      .Mesh(SurfaceDihedralAngle<GetSmaller>)
      .Formula("min θ with θ = 180° − atan2(e · (n₁ × n₂), n₁ · n₂) over the edges, with n₁ and n₂ "
               "the outward normals of the polygon and its neighbor, and e the direction in which "
               "the polygon traverses the edge")
      .Degenerate(
        "NaN (invalid topology) if the edge-connected surface of the polygon is open, has an edge "
        "with more than two polygons, or is not consistently oriented. Edges without length and "
        "neighbors without area are skipped; NaN (degenerate) if nothing remains.")
      .Agreement(
        "The dihedral angle of the original Camarón is a different one: `MaxNeighborNormalAngle`."),
    CriterionRow("MaxSurfaceDihedralAngle", "Maximum dihedral angle of the surface",
      "Maximum angle between a polygon of a closed surface and its neighbors, measured inside the "
      "enclosed volume; 180 is flat, less is a ridge, more a valley.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Smaller)
      .Needs(NeedsFaces | NeedsSurfaceSides)
      .Mesh(SurfaceDihedralAngle<GetLarger>)
      .Formula("maximum of the angles of `MinSurfaceDihedralAngle`")
      .Degenerate("As `MinSurfaceDihedralAngle`.")
      .Agreement("As `MinSurfaceDihedralAngle`."),
  };
}
}
