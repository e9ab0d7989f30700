// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls visit(angle) for every polygon that shares an edge with a polygon cell. Two polygons agree when
// they run along the edge in opposite directions; where they do not, one of them counts as flipped.
template <typename Visitor>
void ForEachNeighborAngle(const std::vector<Vector>& vectors, const FacetTable& edges, vtkIdType cell,
  std::vector<Index>& cells, bool& hasNeighbor, Visitor&& visit)
{
  const Vector& own = vectors[cell];
  for (const CellFacet edge : edges.GetCellFacets(cell))
  {
    if (edges.IsBoundary(edge.Facet()))
    {
      continue;
    }
    edges.GetCells(edge.Facet(), cells);
    for (const Index neighbor : cells)
    {
      if (neighbor == cell)
      {
        continue;
      }
      hasNeighbor = true;
      bool reversed = edge.IsReversed();
      for (const CellFacet theirs : edges.GetCellFacets(neighbor))
      {
        if (theirs.Facet() == edge.Facet())
        {
          reversed = theirs.IsReversed();
        }
      }
      const Vector& other = vectors[neighbor];
      const double sign = reversed != edge.IsReversed() ? 1 : -1;
      if (Norm2(own) > 0 && Norm2(other) > 0)
      {
        visit(std::atan2(Norm(Cross(own, other)), sign * Dot(own, other)));
      }
    }
  }
}

//------------------------------------------------------------------------------
template <typename Choose>
void NeighborNormalAngle(
  const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values, Choose&& choose)
{
  const FacetTable& edges = mesh.Topology.GetSurfaceEdges();
  const std::vector<Vector>& vectors = mesh.GetCellVectors();
  const double factor = mesh.Options.Angles == AngleUnit::Degrees ? 180 / Pi : 1;
  std::vector<Index> cells;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    if (edges.GetCellFacets(cell).size() == 0)
    {
      values[cell - begin] = Null(NullReason::NotApplicable);
      continue;
    }
    bool hasNeighbor = false;
    double chosen = -1;
    ForEachNeighborAngle(vectors, edges, cell, cells, hasNeighbor,
      [&](double angle) { chosen = chosen < 0 ? angle : choose(chosen, angle); });
    values[cell - begin] = chosen >= 0 ? factor * chosen
                                       : Null(hasNeighbor ? NullReason::Degenerate
                                                          : NullReason::NoNeighbor);
  }
}
}

//------------------------------------------------------------------------------
void MinNeighborNormalAngle(
  const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  NeighborNormalAngle(
    mesh, begin, end, values, [](double a, double b) { return std::min(a, b); });
}

//------------------------------------------------------------------------------
void MaxNeighborNormalAngle(
  const MeshContext& mesh, vtkIdType begin, vtkIdType end, double* values)
{
  NeighborNormalAngle(
    mesh, begin, end, values, [](double a, double b) { return std::max(a, b); });
}

//------------------------------------------------------------------------------
std::vector<Criterion> NeighborNormalCriteria()
{
  // clang-format off
  return {
    { "MinNeighborNormalAngle", "Smallest angle to a neighbour",
      "Smallest angle between the normals of the polygon and of those that share an edge with it; 0 is "
      "flat.",
      Polygons, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Neighbors, NeedsFaces, CAMARON_MESH(MinNeighborNormalAngle),
      { "min of atan2(|S × S′|, ±S · S′) over the polygons S′ that share an edge with S, the sign "
        "making both run along the edge in opposite directions",
        "Null (no neighbour) without neighbours, null (degenerate) when the polygon or all its "
        "neighbours are collapsed. An edge of more than two polygons counts with each.",
        "Camarón's \"dihedral angle\" of polygons, without its dependence on which way the normals "
        "point." } },
    { "MaxNeighborNormalAngle", "Largest angle to a neighbour",
      "Largest angle between the normals of the polygon and of those that share an edge with it; 0 is "
      "flat.",
      Polygons, Unit::Angle, { 0, 180 }, 0, Better::Smaller,
      { -Infinity, Infinity }, NoRange, Cited, Real, Cost::Neighbors, NeedsFaces, CAMARON_MESH(MaxNeighborNormalAngle),
      { "the largest of the angles of `MinNeighborNormalAngle`",
        "As `MinNeighborNormalAngle`.",
        "As `MinNeighborNormalAngle`." } },
  };
  // clang-format on
}
}
