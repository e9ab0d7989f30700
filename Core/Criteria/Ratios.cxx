// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CriterionRows.h"
#include "Geometry/PointPairs.h"
#include "Ranks/MeshFacts.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
//------------------------------------------------------------------------------
template <typename Cell>
auto GetEdgeLengthRatio(const Cell& cell)
{
  return Sqrt(cell.GetMinSquaredLength() / cell.GetMaxSquaredLength());
}
double EdgeLengthRatio(const CellGeometry& cell)
{
  if (cell.IsZeroLength(cell.GetMaxEdgeLength()))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(cell.GetMinEdgeLength()) ? 0 : GetEdgeLengthRatio(cell);
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetEdgeRatio(const Cell& cell)
{
  return Sqrt(cell.GetMaxSquaredLength() / cell.GetMinSquaredLength());
}
double EdgeRatio(const CellGeometry& cell)
{
  if (cell.IsZeroLength(cell.GetMaxEdgeLength()))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(cell.GetMinEdgeLength()) ? Infinity : GetEdgeRatio(cell);
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetEdgeDiameterRatio(const Cell& cell)
{
  return cell.GetMinEdgeLength() / cell.GetDiameter();
}
double EdgeDiameterRatio(const CellGeometry& cell)
{
  if (cell.IsZeroLength(cell.GetDiameter()))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(cell.GetMinEdgeLength()) ? 0 : GetEdgeDiameterRatio(cell);
}

//------------------------------------------------------------------------------
double MinPointDistanceRatio(const CellGeometry& cell)
{
  const double diameter = cell.GetDiameter();
  if (cell.IsZeroLength(diameter))
  {
    return Null(NullReason::Degenerate);
  }
  const double distance = std::min(
    diameter, std::sqrt(FindSmallestSquaredDistance(&cell.GetPoint(0), cell.GetNumberOfPoints())));
  return cell.IsZeroLength(distance) ? 0 : distance / diameter;
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetIsoperimetricQuotient(const Cell& cell)
{
  const auto volume = cell.GetVolume(), surface = cell.GetSurfaceArea();
  return 36 * Pi * volume * volume / (surface * surface * surface);
}
double IsoperimetricQuotient(const CellGeometry& cell)
{
  if (cell.GetShapes() & Polygons)
  {
    const double perimeter = cell.GetPerimeter();
    return cell.IsZeroLength(perimeter) ? Null(NullReason::Degenerate)
                                        : 4 * Pi * cell.GetPolygonArea() / (perimeter * perimeter);
  }
  const double volume = cell.GetVolume(), surface = cell.GetSurfaceArea();
  if (std::isnan(volume))
  {
    return volume;
  }
  return cell.IsZeroArea(surface) ? Null(NullReason::Degenerate) : GetIsoperimetricQuotient(cell);
}

//------------------------------------------------------------------------------
double Sphericity(const CellGeometry& cell)
{
  const double quotient = IsoperimetricQuotient(cell);
  return std::isnan(quotient) ? quotient : std::cbrt(quotient);
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetVolumeEdgeRatio(const Cell& cell)
{
  const auto length = Sqrt(cell.GetSumOfSquaredLengths() / cell.GetNumberOfEdges());
  return cell.GetVolume() / (length * length * length);
}
double VolumeEdgeRatio(const CellGeometry& cell)
{
  const double volume = cell.GetVolume();
  if (std::isnan(volume))
  {
    return volume;
  }
  if (cell.IsZeroLength(cell.GetMaxEdgeLength()))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroVolume(volume) ? 0 : GetVolumeEdgeRatio(cell);
}

//------------------------------------------------------------------------------
double CellAspectRatio(const CellGeometry& cell)
{
  const double volume = cell.GetVolume();
  if (std::isnan(volume))
  {
    return volume;
  }
  Vector sum;
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const Vector& area = cell.GetFaceVector(f);
    sum += { std::abs(area.X), std::abs(area.Y), std::abs(area.Z) };
  }
  const double smallest = std::min({ sum.X, sum.Y, sum.Z });
  const double largest = std::max({ sum.X, sum.Y, sum.Z });
  if (volume <= 0 || cell.IsZeroVolume(volume) || cell.IsZeroArea(smallest))
  {
    return Infinity;
  }
  return std::max(largest / smallest, (sum.X + sum.Y + sum.Z) / (6 * std::cbrt(volume * volume)));
}

//------------------------------------------------------------------------------
double RelativeSize(const CellGeometry& cell)
{
  const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
  const double size =
    isPolygon ? cell.ToMesh(cell.GetPolygonArea(), 2) : cell.ToMesh(cell.GetVolume(), 3);
  const double mean =
    cell.GetOptions().Means->Of[isPolygon ? MeanSizes::PolygonArea : MeanSizes::PolyhedronVolume];
  if (std::isnan(size))
  {
    return size;
  }
  if (!(size > 0))
  {
    return 0;
  }
  return mean > 0 ? std::min(size / mean, mean / size) : Null(NullReason::Degenerate);
}

//------------------------------------------------------------------------------
std::vector<Criterion> RatioCriteria()
{
  return {
    CriterionRow("EdgeLengthRatio", "Edge length ratio", "Shortest edge divided by longest edge.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1.0 / 3, Infinity,
        "Verdict manual, rev. A, edge ratio of tetrahedra; it gives 0.77 for triangles and "
        "quadrilaterals",
        Hint, Tetrahedra)
      .Needs(NeedsEdges)
      .Cells<EdgeLengthRatio>()
      .Tetrahedra<GetEdgeLengthRatio<TetrahedronPair>>()
      .Formula("min lᵢ / max lᵢ")
      .Degenerate("0 if an edge is collapsed, NaN (degenerate) if all edges are.")
      .Agreement("Same as the aspect ratio of the original Camarón. Reciprocal of Verdict's edge "
                 "ratio, except for hexahedra, where Verdict searches only six of the edges for "
                 "the longest (`VerdictEdgeRatio`).")
      .Consequence("stretched cells; intended in boundary layers"),
    CriterionRow("EdgeRatio", "Edge ratio",
      "Longest edge divided by shortest edge; infinite if an edge is collapsed.")
      .Range(1, Infinity)
      .Ideal(1, Better::Smaller)
      .Acceptable(-Infinity, 3,
        "Verdict manual, rev. A: 3 for tetrahedra; it gives 1.3 for triangles and quadrilaterals",
        Hint, Tetrahedra)
      .Needs(NeedsEdges)
      .Cells<EdgeRatio>()
      .Tetrahedra<GetEdgeRatio<TetrahedronPair>>()
      .Formula("max lᵢ / min lᵢ")
      .Degenerate("Infinite if an edge is collapsed, NaN (degenerate) if all edges are.")
      .Agreement("Same as Verdict for triangles, quadrilaterals, tetrahedra and wedges; for "
                 "hexahedra, Verdict searches only six of the edges for the longest.")
      .Consequence("stretched cells; intended in boundary layers"),
    CriterionRow("EdgeDiameterRatio", "Edge to diameter",
      "Shortest edge divided by the maximum distance of two vertices.")
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Needs(NeedsEdges)
      .Cells<EdgeDiameterRatio>()
      .Tetrahedra<GetEdgeDiameterRatio<TetrahedronPair>>()
      .Formula("min lᵢ / h")
      .Degenerate("0 if an edge is collapsed, NaN (degenerate) for a cell collapsed to a point.")
      .Agreement("Verdict's stretch divided by √2 for a quadrilateral and by √3 for a hexahedron, "
                 "if the maximum distance is a diagonal."),
    CriterionRow("MinPointDistanceRatio", "Minimum vertex distance ratio",
      "Minimum distance of two vertices divided by the maximum distance.")
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Cells<MinPointDistanceRatio>()
      .Formula("min |pᵢ − pⱼ| / h over all pairs of vertices")
      .Degenerate("0 if two points coincide, even without an edge between them; NaN (degenerate) "
                  "for a cell collapsed to a point.")
      .Agreement("PEMesh's \"minimum point to point distance\" is the same, but not divided by h."),
    CriterionRow("IsoperimetricQuotient", "Isoperimetric quotient",
      "Compactness: 4 pi area / perimeter^2 of a polygon, 36 pi volume^2 / surface area^3 of a "
      "polyhedron; 1 for a circle or ball, 0.5236 for a cube.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsFaces | NeedsVolume)
      .Cells<IsoperimetricQuotient>()
      .Tetrahedra<GetIsoperimetricQuotient<TetrahedronPair>>()
      .Formula("4πA/L² of a polygon, 36πV²/(surface area)³ of a polyhedron")
      .Degenerate("0 for a flat cell; NaN (degenerate) without perimeter or surface area, NaN "
                  "(invalid topology) for an open polyhedron.")
      .Agreement("Same as PEMesh's area–perimeter ratio for polygons."),
    CriterionRow("Sphericity", "Sphericity",
      "Wadell's sphericity: surface area of the ball of the same volume divided by the surface "
      "area of the cell; 0.806 for a cube.")
      .Shapes(Polyhedra)
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(NeedsFaces | NeedsVolume)
      .Cells<Sphericity>()
      .Formula("∛(36πV²) / surface area = ∛IsoperimetricQuotient")
      .Degenerate("As `IsoperimetricQuotient`.")
      .Agreement("Wadell's definition of 1935; none of the compared programs reports it."),
    CriterionRow("VolumeEdgeRatio", "Volume to edges",
      "Volume divided by the cube of the root mean square of the edge lengths; 1 for a cube.")
      .Shapes(Polyhedra)
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsVolume)
      .Cells<VolumeEdgeRatio>()
      .Tetrahedra<GetVolumeEdgeRatio<TetrahedronPair>>()
      .Formula("V / l³ with l² = Σ lᵢ² / number of edges")
      .Degenerate("0 for a flat cell, negative for an inverted cell; NaN (degenerate) for a cell "
                  "collapsed to a point, NaN (invalid topology) for an open cell.")
      .Agreement("For a tetrahedron, 1/(6√2) times the reciprocal of Verdict's aspect gamma "
                 "(`VerdictAspectGamma`)."),
    CriterionRow("CellAspectRatio", "Cell aspect ratio",
      "OpenFOAM's aspect ratio from the face areas projected along the axes; depends on the axes, "
      "so rotating a box changes its value.")
      .Shapes(Polyhedra)
      .Range(1, Infinity)
      .Ideal(1, Better::Smaller)
      .Acceptable(-Infinity, 1000, CheckMesh, Hint, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsFaces | NeedsVolume)
      .Cells<CellAspectRatio>()
      .Formula("max(max aᵢ / min aᵢ, (aₓ + a_y + a_z) / (6 V^⅔)) with aᵢ = Σ |S_f,i| over the "
               "faces, i = x, y, z")
      .Degenerate("Infinite for a flat or inverted cell; NaN (invalid topology) for an open cell.")
      .Agreement("checkMesh prints the same maximum. Fluent, Verdict and Gmsh define aspect ratio "
                 "differently.")
      .Consequence(
        "stretched cells; intended in boundary layers, although iterative solvers converge slowly"),
    CriterionRow("RelativeSize", "Relative size",
      "Volume (area) compared with the mean of all cells of the same dimension in all blocks and "
      "on all ranks: the smaller divided by the larger.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(NeedsFaces | NeedsVolume | NeedsMeanSizes)
      .Cells<RelativeSize>()
      .Formula("min(x/x̄, x̄/x) with x the volume (area) and x̄ its mean over all cells except "
               "ghosts; inverted cells count as negative")
      .Degenerate(
        "0 for a flat or inverted cell; NaN (degenerate) for other cells if the mean is not "
        "positive; NaN (invalid topology) for an open cell, which the mean also ignores.")
      .Agreement("Verdict's relative size squared is its square, but among cells of the same "
                 "shape: `VerdictRelativeSizeSquared`."),
  };
}
}
