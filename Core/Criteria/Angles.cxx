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
template <typename Cell, auto GetAngle>
auto InUserUnit(const Cell& cell)
{
  return cell.ToAngleUnit((cell.*GetAngle)());
}

//------------------------------------------------------------------------------
double EquiangleSkewness(const CellGeometry& cell)
{
  // Faces with the same number of vertices share their ideal angle, and therefore their extremes.
  const CellTopology& topology = cell.GetTopology();
  double worst = Null(NullReason::Degenerate);
  AngleRange angles;
  int size = 0; // of the faces in angles
  const auto close = [&]
  {
    if (!angles.IsEmpty())
    {
      const double ideal = Pi * (size - 2) / size;
      const double skewness =
        std::max((angles.GetMax() - ideal) / (Pi - ideal), (ideal - angles.GetMin()) / ideal);
      worst = std::isnan(worst) ? skewness : std::max(worst, skewness);
    }
    angles.Clear();
  };
  for (const CellTopology::FacePair& pair : topology.FacePairs) // by size
  {
    if (topology.GetFaceSize(pair.First) != size)
    {
      close();
      size = topology.GetFaceSize(pair.First);
    }
    angles.Add(cell.GetFaceAngles(pair.First));
    angles.Add(cell.GetFaceAngles(pair.Second));
  }
  close();
  return worst;
}
Pair EquiangleSkewnessOfPair(const TetrahedronPair& pair)
{
  const double ideal = Pi / 3;
  return Max((pair.GetMaxFaceAngle() - MakePair(ideal, ideal)) / (Pi - ideal),
    (MakePair(ideal, ideal) - pair.GetMinFaceAngle()) / ideal);
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> AngleCriteria()
{
  return {
    CriterionRow("MinInteriorAngle", "Minimum interior angle",
      "Minimum interior angle of the polygon; ideal is 180 (k - 2) / k for k vertices.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Bigger)
      .Acceptable(30, Infinity,
        "Verdict manual, rev. A: 30 for triangles; it gives 45 for quadrilaterals", Hint,
        SimplePolygons)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMinFaceAngle>>()
      .Formula("θᵢ = ∠(pᵢ₊₁ − pᵢ, pᵢ₋₁ − pᵢ), and 360° − θᵢ where the corner is reflex: ((pᵢ₊₁ − "
               "pᵢ) × (pᵢ₋₁ − pᵢ)) · S < 0; the value is min θᵢ")
      .Degenerate("At a vertex next to a collapsed edge, the angle is taken to the next vertex at "
                  "a different position. A collinear triangle has 0. NaN (degenerate) with fewer "
                  "than three distinct positions and for larger polygons without area.")
      .Agreement("Same as Verdict for triangles and convex quadrilaterals (`VerdictMinAngle`). The "
                 "original Camarón and camaron-web do not recognize all reflex corners.")
      .Consequence("pointed corners; intended where a surface is stretched on purpose"),
    CriterionRow("MaxInteriorAngle", "Maximum interior angle",
      "Maximum interior angle of the polygon; above 180 at a reflex corner.")
      .Shapes(Polygons)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Smaller)
      .Acceptable(-Infinity, 135,
        "Verdict manual, rev. A: 135 for quadrilaterals; it gives 90 for triangles", Cited,
        SimplePolygons)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMaxFaceAngle>>()
      .Formula("max θᵢ, with θᵢ as for `MinInteriorAngle`")
      .Degenerate("A collinear triangle has 180. NaN (degenerate) with fewer than three distinct "
                  "positions and for larger polygons without area.")
      .Agreement(
        "Same as Verdict for triangles and convex quadrilaterals (`VerdictMaxAngle`). The original "
        "Camarón returns 360 for a degenerate polygon, although its unit is the radian.")
      .Consequence("nearly flat corners: gradients and normals lose accuracy"),
    CriterionRow(
      "MinFaceAngle", "Minimum face angle", "Minimum interior angle of all faces of the cell.")
      .Shapes(Polyhedra)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Bigger)
      .Acceptable(30, Infinity,
        "Verdict manual, rev. A: 30 for triangles; it gives 45 for quadrilaterals", Hint,
        SimplePolyhedra)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMinFaceAngle>>()
      .Tetrahedra<InUserUnit<TetrahedronPair, &TetrahedronPair::GetMinFaceAngle>>()
      .Formula("min over all faces of θᵢ, as for `MinInteriorAngle`")
      .Degenerate("Collapsed faces are skipped; NaN (degenerate) if no face has an angle. Open "
                  "cells have a value.")
      .Agreement("Gmsh, Verdict and Fluent evaluate standard cells only.")
      .Consequence("pointed faces; intended where cells are stretched on purpose"),
    CriterionRow("MaxFaceAngle", "Maximum face angle",
      "Maximum interior angle of all faces of the cell; above 180 at a reflex corner.")
      .Shapes(Polyhedra)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Smaller)
      .Acceptable(-Infinity, 135,
        "Verdict manual, rev. A: 135 for quadrilaterals; it gives 90 for triangles", Hint,
        SimplePolyhedra)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMaxFaceAngle>>()
      .Tetrahedra<InUserUnit<TetrahedronPair, &TetrahedronPair::GetMaxFaceAngle>>()
      .Formula("max over all faces of θᵢ, as for `MinInteriorAngle`")
      .Degenerate("Collapsed faces are skipped; NaN (degenerate) if no face has an angle. Open "
                  "cells have a value.")
      .Agreement("Gmsh, Verdict and Fluent evaluate standard cells only.")
      .Consequence("faces with a nearly flat corner: gradients lose accuracy"),
    CriterionRow("MinDihedralAngle", "Minimum dihedral angle",
      "Minimum interior angle between two faces of the cell at their common edge; 70.53 for a "
      "regular tetrahedron, 90 for a cube.")
      .Shapes(Polyhedra)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Bigger)
      .Acceptable(
        20, Infinity, "common practice for tetrahedra; 40 in the Verdict manual", Hint, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsDihedral)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMinDihedralAngle>>()
      .Tetrahedra<InUserUnit<TetrahedronPair, &TetrahedronPair::GetMinDihedralAngle>>()
      .Formula("at an edge with direction e and its faces' outward normals n₁, n₂: θ = 180° − "
               "atan2(e · (n₁ × n₂), n₁ · n₂); the value is min θ")
      .Degenerate("0 for a flat tetrahedron. Edges of collapsed faces are skipped; NaN "
                  "(degenerate) if none remains, NaN (invalid topology) if an edge has one face or "
                  "more than two. Inverted cells have the same value.")
      .Agreement(
        "Same as TetGen's dihedral angles. Verdict's minimum angle of a tetrahedron replaces some "
        "angles by their supplements, depending on the order of the vertices (`VerdictMinAngle`, "
        "off "
        "by 24° in a valid cell). The dihedral angle of the original Camarón is the angle between "
        "the normals of two polygons: see `MaxNeighborNormalAngle`.")
      .Consequence("sharp tetrahedra: finite element matrices are badly conditioned; intended in "
                   "boundary layers"),
    CriterionRow("MaxDihedralAngle", "Maximum dihedral angle",
      "Maximum interior angle between two faces of the cell at their common edge; above 180, the "
      "cell is not convex.")
      .Shapes(Polyhedra)
      .Unit(Unit::Angle)
      .Range(0, 360)
      .Ideal(None, Better::Smaller)
      .Acceptable(-Infinity, 165, "TetGen's default target, for tetrahedra", Cited, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsDihedral)
      .Cells<InUserUnit<CellGeometry, &CellGeometry::GetMaxDihedralAngle>>()
      .Tetrahedra<InUserUnit<TetrahedronPair, &TetrahedronPair::GetMaxDihedralAngle>>()
      .Formula("max θ, with θ as for `MinDihedralAngle`")
      .Degenerate("180 for a flat tetrahedron. NaN as for `MinDihedralAngle`.")
      .Agreement("Same as TetGen's dihedral angles. Exceeds 180° where a cell is not convex; that "
                 "of the original Camarón cannot.")
      .Consequence(
        "nearly flat tetrahedra (slivers, caps): finite element gradients lose accuracy"),
    CriterionRow("MinSolidAngle", "Minimum solid angle",
      "Minimum solid angle of the cell at a vertex, in steradians; 1.5708 for a cube, 0.5513 for a "
      "regular tetrahedron.")
      .Shapes(Polyhedra)
      .Unit(Unit::SolidAngle)
      .Range(0, 4 * Pi)
      .Ideal(None, Better::Bigger)
      .Acceptable(0.1, Infinity, "common practice for tetrahedra", Hint, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsSolidAngle)
      .Cells<&CellGeometry::GetMinSolidAngle>()
      .Tetrahedra<&TetrahedronPair::GetMinSolidAngle>()
      .Formula("area that the cell covers on the unit sphere around a vertex; the spherical "
               "polygon of its edges is divided into triangles a, b, c with tan(Ω/2) = a · (b × c) "
               "/ (1 + a · b + b · c + c · a); the value is the minimum over the vertices")
      .Degenerate("0 for a flat cell; the ends of a collapsed edge count as one vertex. A vertex "
                  "where a face without area has a straight corner is skipped. NaN (degenerate) "
                  "for a cell collapsed to a point, NaN (invalid topology) for an open cell or if "
                  "the faces at a vertex form more than one group.")
      .Agreement("For a tetrahedron, Σ Ω = 2 Σ θ − 4π with TetGen's dihedral angles. The original "
                 "Camarón returns the fraction of the sphere and is wrong beyond 90°; camaron-web "
                 "has no value where more than three edges meet.")
      .Consequence("sharp tetrahedra; intended in boundary layers"),
    CriterionRow("MaxSolidAngle", "Maximum solid angle",
      "Maximum solid angle of the cell at a vertex, in steradians; a full sphere is 12.566.")
      .Shapes(Polyhedra)
      .Unit(Unit::SolidAngle)
      .Range(0, 4 * Pi)
      .Ideal(None, Better::Smaller)
      .Cost(Cost::Edges)
      .Needs(NeedsSolidAngle)
      .Cells<&CellGeometry::GetMaxSolidAngle>()
      .Tetrahedra<&TetrahedronPair::GetMaxSolidAngle>()
      .Formula("maximum of the angles Ω of `MinSolidAngle`")
      .Degenerate("As `MinSolidAngle`.")
      .Agreement("As `MinSolidAngle`."),
    CriterionRow("EquiangleSkewness", "Equiangle skewness",
      "Maximum relative deviation of an interior angle from that of the regular polygon, over all "
      "faces; above 1 at reflex corners.")
      .Range(0, Infinity)
      .Ideal(0, Better::Smaller)
      .Acceptable(
        -Infinity, 0.9, "common finite-volume practice", Hint, SimplePolygons | SimplePolyhedra)
      .Needs(NeedsFaces | NeedsCorners)
      .Cells<EquiangleSkewness>()
      .Tetrahedra<EquiangleSkewnessOfPair>()
      .Formula("max((θmax − θₑ) / (180° − θₑ), (θₑ − θmin) / θₑ) with θₑ = 180° (k − 2)/k for a "
               "face with k vertices; the maximum over the faces")
      .Degenerate("1 for a collinear triangle, above 1 at reflex corners. NaN (degenerate) if no "
                  "face has an angle.")
      .Agreement("Same as Verdict for triangles, quadrilaterals, pyramids, wedges and hexahedra; "
                 "differs for tetrahedra (`VerdictEquiangleSkew`, by 0.07 in a valid cell). Fluent "
                 "uses the same definition.")
      .Consequence("skewed cells: fluxes and gradients lose accuracy; intended where cells are "
                   "stretched on purpose"),
  };
}
}
