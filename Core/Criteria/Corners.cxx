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
// The unit vector along an edge, away from one of its points.
Vector GetDirection(const CellGeometry& cell, const CellTopology::Edge& edge, int point)
{
  const int other = edge.Points[edge.Points[0] == point ? 1 : 0];
  return Unit(cell.GetPoint(other) - cell.GetPoint(point));
}

//------------------------------------------------------------------------------
// Whether a face traverses an edge from one point to the next.
bool RunsTo(const CellTopology& topology, int face, int from, int to)
{
  const int* points = topology.GetFace(face);
  const int size = topology.GetFaceSize(face);
  const auto at = static_cast<int>(std::find(points, points + size, from) - points);
  return points[at + 1 < size ? at + 1 : 0] == to;
}
}

//------------------------------------------------------------------------------
double CornerScaledJacobian(const CellGeometry& cell)
{
  const CellTopology& topology = cell.GetTopology();
  if (std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  if (!topology.HasVertexFigures)
  {
    return Null(NullReason::InvalidTopology);
  }
  double smallest = Infinity;
  for (int point = 0; point < topology.NumberOfPoints; ++point)
  {
    const int first = topology.SpokeOffsets[point];
    const int valence = topology.SpokeOffsets[point + 1] - first;
    if (valence != 3)
    {
      return Null(valence == 0 ? NullReason::InvalidTopology : NullReason::NotApplicable);
    }
    const CellTopology::Edge* edges[3];
    for (int i = 0; i < 3; ++i)
    {
      edges[i] = &topology.Edges[topology.Spokes[first + i].Edge];
    }
    // The first face is between the first two edges. With its next edge first, the third edge is on
    // the side opposite to their cross product, which points outward.
    const int end = edges[0]->Points[edges[0]->Points[0] == point ? 1 : 0];
    const bool isNext = RunsTo(topology, topology.Spokes[first].Face, point, end);
    const Vector next = GetDirection(cell, *edges[isNext ? 0 : 1], point);
    const Vector previous = GetDirection(cell, *edges[isNext ? 1 : 0], point);
    smallest =
      std::min(smallest, -Dot(Cross(next, previous), GetDirection(cell, *edges[2], point)));
  }
  if (cell.IsZeroLength(cell.GetMinEdgeLength()))
  {
    return cell.IsZeroLength(cell.GetMaxEdgeLength()) ? Null(NullReason::Degenerate) : 0;
  }
  return smallest;
}

//------------------------------------------------------------------------------
std::vector<Criterion> CornerCriteria()
{
  return {
    CriterionRow("CornerScaledJacobian", "Corner scaled Jacobian",
      "Minimum over the vertices of the determinant of the unit vectors along the three edges; 1 "
      "for right angles, negative at an inverted corner. Undefined (NaN) for cells with more than "
      "three edges at a vertex.")
      .Shapes(Polyhedra)
      .Range(-1, 1)
      .Ideal(None, Better::Bigger)
      .Acceptable(Positive, Infinity,
        "not inverted; 0.5 for hexahedra in the Verdict manual, rev. A", Cited,
        Tetrahedra | Wedges | Hexahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsFaces | NeedsVolume | NeedsSolidAngle)
      .Cells<CornerScaledJacobian>()
      .Formula(
        "min over the vertices of û₁ · (û₂ × û₃), unit vectors along the three edges of a vertex")
      .Degenerate(
        "0 if an edge is collapsed, negative for an inverted standard cell and at reflex corners. "
        "NaN (not applicable) if a vertex does not have three edges, NaN (degenerate) for a cell "
        "collapsed to a point, NaN (invalid topology) for an open cell.")
      .Agreement("Same as Verdict's scaled Jacobian of a hexahedron if its minimum is at a corner; "
                 "1/√2 times it for tetrahedra, √3/2 times for wedges with the minimum at a "
                 "corner. Gmsh normalizes its scaled Jacobians differently.")
      .Consequence("the finite element map is inverted at a corner: solvers stop"),
  };
}
}
