// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of the map from the parametric domain of a finite element to the cell, curved or not.
#include "Criteria/CriterionRows.h"

#include <cmath>
#include <functional>
#include <optional>

namespace camaron
{
namespace
{
constexpr unsigned NeedsMap = NeedsFaces | NeedsVolume;
constexpr unsigned SimpleShapes = SimplePolygons | SimplePolyhedra;
constexpr const char* Positiveness = "not folded";

//------------------------------------------------------------------------------
template <auto Measure>
double OfMap(const CellGeometry& cell)
{
  const CellMap* map = cell.GetMap();
  return map ? std::invoke(Measure, *map, cell.GetNormal()) : Null(NullReason::InvalidTopology);
}

//------------------------------------------------------------------------------
// The map of a straight tetrahedron is affine.
std::optional<PolynomialBounds> FindJacobian(const CellGeometry& cell)
{
  if ((cell.GetShapes() & Tetrahedra) && !cell.GetCurvedMap())
  {
    const double volume = cell.GetVolume();
    return PolynomialBounds{ volume, volume, volume, volume };
  }
  const CellMap* const map = cell.GetMap();
  return map ? std::make_optional(map->GetJacobian(cell.GetNormal())) : std::nullopt;
}

//------------------------------------------------------------------------------
double MinJacobian(const CellGeometry& cell)
{
  const auto bounds = FindJacobian(cell);
  return bounds ? bounds->Least : Null(NullReason::InvalidTopology);
}
double MaxJacobian(const CellGeometry& cell)
{
  const auto bounds = FindJacobian(cell);
  return bounds ? bounds->Greatest : Null(NullReason::InvalidTopology);
}
double JacobianRatio(const CellGeometry& cell)
{
  const auto bounds = FindJacobian(cell);
  return !bounds || std::isnan(bounds->Least) ? Null(NullReason::InvalidTopology)
    : bounds->Greatest > 0                    ? bounds->Least / bounds->Greatest
    : bounds->Least < 0                       ? -bounds->Greatest / bounds->Least
                                              : Null(NullReason::Degenerate);
}

//------------------------------------------------------------------------------
Pair RatioOfTetrahedra(const TetrahedronPair& pair)
{
  double volumes[2];
  StorePair(pair.GetVolume(), volumes);
  return MakePair(std::copysign(1, volumes[0]), std::copysign(1, volumes[1]));
}

//------------------------------------------------------------------------------
double MidsideNodeOffsetAlongEdge(const CellGeometry& cell)
{
  const CellMap* map = cell.GetCurvedMap();
  return map ? map->GetMaxOffsetAlongEdge() : 0;
}
double MidsideNodeOffsetFromEdge(const CellGeometry& cell)
{
  const CellMap* map = cell.GetCurvedMap();
  return map ? map->GetMaxOffsetFromEdge() : 0;
}

//------------------------------------------------------------------------------
CriterionRow MapRow(const char* name, const char* label, const char* description)
{
  return CriterionRow(name, label, description).Shapes(SimpleShapes).Needs(NeedsMap).Curved();
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> JacobianCriteria()
{
  return {
    MapRow("MinJacobian", "Minimum Jacobian",
      "Lower bound of the Jacobian determinant of the map from the parametric domain, anywhere in "
      "the cell, times the measure of that domain: the volume or area where the map is affine.")
      .Unit(Unit::Volume)
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Bigger)
      .Acceptable(Positive, Infinity, Positiveness, Cited, SimpleShapes)
      .Cost(Cost::Edges)
      .Cells<MinJacobian>()
      .Tetrahedra<&TetrahedronPair::GetVolume>()
      .Formula("min det ∂x/∂ξ · |parametric domain| over the whole cell; on a surface, "
               "(∂x/∂ξ × ∂x/∂η) · n with the unit normal n of the polygon of its vertices")
      .Degenerate("The bound is below the minimum by at most 0.001 of the greatest value, and has "
                  "its sign; 0 if the determinant is zero somewhere and nowhere negative, as at "
                  "the tip of a quarter-point element or at the corner of a quadrilateral with an "
                  "angle of 180°. NaN (invalid topology) without a map.")
      .Agreement(
        "Gmsh's minDetJac times the measure of its parametric domain, except for pyramids, "
        "of which Gmsh leaves out the apex. Verdict's and Ansys' values are the minimum "
        "over some points, and miss cells that fold between them.")
      .Consequence("the map folds: finite element solvers stop or are wrong"),
    MapRow("MaxJacobian", "Maximum Jacobian",
      "Upper bound of the Jacobian determinant of the map from the parametric domain, anywhere in "
      "the cell, times the measure of that domain.")
      .Unit(Unit::Volume)
      .Range(-Infinity, Infinity)
      .Cost(Cost::Edges)
      .Cells<MaxJacobian>()
      .Tetrahedra<&TetrahedronPair::GetVolume>()
      .Formula("max det ∂x/∂ξ · |parametric domain| over the whole cell")
      .Degenerate("The bound is above the maximum by at most 0.001 of the greatest value. NaN "
                  "(invalid topology) without a map.")
      .Agreement("Gmsh's maxDetJac, as for `MinJacobian`."),
    MapRow("JacobianRatio", "Jacobian ratio",
      "`MinJacobian` divided by `MaxJacobian`: 1 for an affine map, negative where it folds.")
      .Range(-Infinity, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(Positive, Infinity, Positiveness, Cited, SimpleShapes)
      .Cost(Cost::Edges)
      .Cells<JacobianRatio>()
      .Tetrahedra<RatioOfTetrahedra>()
      .Formula("min det ∂x/∂ξ / max det ∂x/∂ξ")
      .Degenerate(
        "0 where the determinant is zero somewhere and nowhere negative. −max/min of "
        "the magnitudes, which is −1 for an affine map, if it is negative everywhere. NaN "
        "(degenerate) if it is zero everywhere.")
      .Agreement(
        "Ansys' Jacobian ratios are of some points of the cell; that of Mechanical APDL is "
        "the reciprocal of this quotient.")
      .Consequence("the map folds: finite element solvers stop or are wrong"),
    MapRow("MinInverseConditionNumber", "Minimum inverse condition number",
      "Minimum over some points of the inverse condition number of the map from the ideal cell; "
      "negative where the map is inverted.")
      .Range(-1, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(Positive, Infinity, "not inverted", Cited, SimpleShapes)
      .Cost(Cost::Edges)
      .Cells<OfMap<&CellMap::GetMinInverseCondition>>()
      .Formula("min of d / (‖K‖ ‖K⁻¹‖) with the sign of det K, d the dimension, Frobenius norms, "
               "K = ∂x/∂ξ W⁻¹, W the Jacobian matrix of the equilateral triangle, square, regular "
               "tetrahedron, cube, wedge or pyramid with equal edges; over the points of the "
               "regular lattice of the cell's degree")
      .Degenerate("0 for a flat cell. Sampled: may be positive for a cell that folds between the "
                  "points; see `MinJacobian`.")
      .Agreement("Gmsh's minSICN.")
      .Consequence("inverted: finite element solvers stop or are wrong"),
    MapRow("MinScaledJacobian", "Minimum scaled Jacobian",
      "Minimum over some points of the Jacobian determinant divided by the lengths of the tangents "
      "of three edges, relative to the ideal cell; negative where the map is inverted.")
      .Range(-1, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(Positive, Infinity, "not inverted", Cited, SimpleShapes)
      .Cost(Cost::Edges)
      .Cells<OfMap<&CellMap::GetMinScaledJacobian>>()
      .Formula(
        "min of c det ∂x/∂ξ / max of |t₁| |t₂| |t₃|, the tangents along the parametric edges "
        "that meet at a corner, with c = 2/√3 for triangles and wedges, √2 for tetrahedra "
        "and pyramids, 1 for quadrilaterals and hexahedra; over the points of the regular "
        "lattice of the cell's degree")
      .Degenerate("0 if a tangent is zero; at most 1, also for a pyramid that is higher than the "
                  "ideal one. Sampled, as `MinInverseConditionNumber`.")
      .Agreement(
        "For linear triangles, tetrahedra and hexahedra as Verdict's scaled Jacobian, "
        "except that Verdict samples a hexahedron at its center, too. Gmsh's minSJ is "
        "another number: a bound of the determinant, divided by that of the straight cell.")
      .Consequence("inverted: finite element solvers stop or are wrong"),
    MapRow("MidsideNodeOffsetAlongEdge", "Midside node offset along the edge",
      "Maximum distance along an edge of its middle node from the middle of its ends, relative to "
      "the distance of the ends; from 0.25 on, the edge folds.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 0.2, "Altair OptiStruct, warning of the tangent offset", Cited, SimpleShapes)
      .Cells<MidsideNodeOffsetAlongEdge>()
      .Formula("max |(m − p₀) · (p₁ − p₀) / |p₁ − p₀|² − ½| over the edges, m the point of the "
               "edge halfway in its parameter")
      .Degenerate("0 for linear and straight cells; 0.25 at a quarter-point node; infinite if the "
                  "ends of a curved edge coincide.")
      .Agreement("OptiStruct's tangent offset, FEMGV's NODOFF.")
      .Consequence("the Jacobian determinant is small at a corner, and negative from 0.25 on"),
    MapRow("MidsideNodeOffsetFromEdge", "Midside node offset from the edge",
      "Maximum distance of the middle node of an edge from the line between its ends, relative to "
      "their distance: the sagitta of an arc.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 0.3, "Altair OptiStruct, warning of the normal offset", Cited, SimpleShapes)
      .Cells<MidsideNodeOffsetFromEdge>()
      .Formula("max |m − p₀ − ((m − p₀) · e) e| / |p₁ − p₀| over the edges, e the unit vector "
               "between the ends")
      .Degenerate("0 for linear and straight cells; tan(α/4)/2 for an arc of an angle α; infinite "
                  "if the ends of a curved edge coincide.")
      .Agreement("OptiStruct's normal offset, FEMGV's BULGE.")
      .Consequence("strongly curved: the cell may fold if it is thin"),
  };
}
}
