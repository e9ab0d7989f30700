// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/VectorPair.h"
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double SquareRootOf3Over8 = 0.61237243569579452; // of the regular tetrahedron
constexpr double SquareRootOf1Over3 = 0.57735026918962573; // of the equilateral triangle
constexpr double SquareRootOf2 = 1.4142135623730951;

//------------------------------------------------------------------------------
// If all points coincide, every ratio is 0/0.
bool IsOnePoint(const CellGeometry& cell)
{
  return cell.IsZeroLength(cell.GetMaxEdgeLength());
}

//------------------------------------------------------------------------------
// Circumradius times twelve volumes: |a^2 (b x c) + b^2 (c x a) + c^2 (a x b)|, with the edges from
// the first point, which is the origin.
template <typename Cell>
auto CircumradiusTimes12Volumes(const Cell& tetrahedron)
{
  const auto a = tetrahedron.GetPoint(1), b = tetrahedron.GetPoint(2), c = tetrahedron.GetPoint(3);
  return Norm(Norm2(a) * Cross(b, c) + Norm2(b) * Cross(c, a) + Norm2(c) * Cross(a, b));
}

//------------------------------------------------------------------------------
// A formula of a triangle with an area or a tetrahedron with a volume; NaN if it is one point or
// not closed.
template <auto Formula, bool IsInfiniteIfFlat = false>
double OfSimplex(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const bool isTriangle = (cell.GetShapes() & Triangles) != 0;
  const double size = isTriangle ? cell.GetPolygonArea() : cell.GetVolume();
  if (std::isnan(size))
  {
    return size;
  }
  const bool isFlat = isTriangle ? cell.IsZeroArea(size) : cell.IsZeroVolume(size);
  return !isFlat ? Formula(cell) : IsInfiniteIfFlat ? Infinity : 0;
}

//------------------------------------------------------------------------------
double GetTriangleRadiusRatio(const CellGeometry& cell)
{
  const double area = cell.GetPolygonArea();
  const double a = cell.GetEdgeLength(0), b = cell.GetEdgeLength(1), c = cell.GetEdgeLength(2);
  return 16 * area * area / (a * b * c * (a + b + c));
}

//------------------------------------------------------------------------------
double GetBhatiaLawrence(const CellGeometry& cell)
{
  return 4 * std::sqrt(3.0) * cell.GetPolygonArea() / cell.GetSumOfSquaredLengths();
}

//------------------------------------------------------------------------------
double GetTriangleRadiusEdgeRatio(const CellGeometry& cell)
{
  const double a = cell.GetEdgeLength(0), b = cell.GetEdgeLength(1), c = cell.GetEdgeLength(2);
  return a * b * c / (4 * cell.GetPolygonArea() * std::min({ a, b, c }));
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetShortestEdge(const Cell& cell)
{
  return cell.GetMinEdgeLength();
}
// For the remainder of a collapsed cell of another type, with repeated points.
double GetShortestEdge(const CellGeometry& cell)
{
  if (!cell.HasRepeatedPoints())
  {
    return cell.GetMinEdgeLength();
  }
  double shortest = Infinity;
  for (int edge = 0; edge < cell.GetNumberOfEdges(); ++edge)
  {
    shortest = std::min(shortest, cell.GetEdgeLength(edge));
  }
  return shortest;
}
template <typename Cell>
auto GetTetRadiusEdgeRatio(const Cell& cell)
{
  return CircumradiusTimes12Volumes(cell) / (12 * Abs(cell.GetVolume()) * GetShortestEdge(cell));
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetTetRadiusRatio(const Cell& cell)
{
  // 3 r / R with r = 3 V / S.
  const auto volume = cell.GetVolume();
  return 108 * volume * volume / (cell.GetSurfaceArea() * CircumradiusTimes12Volumes(cell));
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetTetMeanRatio(const Cell& cell)
{
  const auto volume = cell.GetVolume();
  const auto root = CubeRoot(3 * Abs(volume));
  return TurnSign(12 * root * root / cell.GetSumOfSquaredLengths(), volume);
}

//------------------------------------------------------------------------------
template <typename Cell>
auto GetTetQualityFoam(const Cell& cell)
{
  const auto volume = cell.GetVolume();
  const auto circumradius = CircumradiusTimes12Volumes(cell) / (12 * Abs(volume));
  return volume / (RegularVolume * circumradius * circumradius * circumradius);
}
}

//------------------------------------------------------------------------------
std::vector<Criterion> SimplexCriteria()
{
  return {
    CriterionRow("TriangleRadiusRatio", "Triangle radius ratio",
      "Twice the inradius divided by the circumradius.")
      .Shapes(Triangles)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1.0 / 3, Infinity, VerdictManual, Hint, Triangles)
      .Needs(NeedsEdges | NeedsFaces)
      .Cells<OfSimplex<GetTriangleRadiusRatio>>()
      .Formula("2r/R = 16A² / (abc (a + b + c)), edges a, b, c")
      .Degenerate(
        "0 for a collinear triangle, NaN (degenerate) for a triangle collapsed to a point.")
      .Agreement("Reciprocal of Verdict's radius ratio, and equal to its normalized inradius. Same "
                 "as in the original Camarón.")
      .Consequence(
        "triangles far from equilateral; intended where a surface is stretched on purpose"),
    CriterionRow("BhatiaLawrence", "Bhatia-Lawrence measure",
      "4 sqrt(3) area / sum of squared edge lengths, the mean ratio of a triangle.")
      .Shapes(Triangles)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(0.25, Infinity, "Verdict manual, rev. A, shape of triangles", Hint, Triangles)
      .Needs(NeedsEdges | NeedsFaces)
      .Cells<OfSimplex<GetBhatiaLawrence>>()
      .Formula("4√3 A / (a² + b² + c²), edges a, b, c")
      .Degenerate(
        "0 for a collinear triangle, NaN (degenerate) for a triangle collapsed to a point.")
      .Agreement("For triangles, same as Verdict's shape, and the reciprocal of its aspect "
                 "Frobenius and of its condition. Same as in the original Camarón.")
      .Consequence(
        "triangles far from equilateral; intended where a surface is stretched on purpose"),
    CriterionRow("TriangleRadiusEdgeRatio", "Triangle radius-edge ratio",
      "Circumradius divided by the shortest edge.")
      .Shapes(Triangles)
      .Range(SquareRootOf1Over3, Infinity)
      .Ideal(SquareRootOf1Over3, Better::Smaller)
      .Acceptable(-Infinity, SquareRootOf2, "Ruppert's bound, smallest angle above 20.7 degrees",
        Hint, Triangles)
      .Needs(NeedsEdges | NeedsFaces)
      .Cells<OfSimplex<GetTriangleRadiusEdgeRatio, true>>()
      .Formula("R / min l = abc / (4A min(a, b, c)), edges a, b, c")
      .Degenerate(
        "Infinite for a collinear triangle, NaN (degenerate) for a triangle collapsed to a point.")
      .Agreement("The value that Triangle limits: R/l = 1/(2 sin θmin).")
      .Consequence(
        "triangles far from equilateral; intended where a surface is stretched on purpose"),
    CriterionRow("TetRadiusEdgeRatio", "Tetrahedron radius-edge ratio",
      "Circumradius divided by the shortest edge. Does not detect slivers: combine it with the "
      "minimum dihedral angle.")
      .Shapes(Tetrahedra)
      .Range(SquareRootOf3Over8, Infinity)
      .Ideal(SquareRootOf3Over8, Better::Smaller)
      .Acceptable(-Infinity, 2, "TetGen's default bound", Hint, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsVolume)
      .Cells<OfSimplex<GetTetRadiusEdgeRatio<CellGeometry>, true>>()
      .Tetrahedra<GetTetRadiusEdgeRatio<TetrahedronPair>>()
      .Formula("R / min l with R = |a²(b × c) + b²(c × a) + c²(a × b)| / (12|V|), edge vectors a, "
               "b, c at one vertex")
      .Degenerate("Infinite for a flat tetrahedron, NaN (degenerate) for a tetrahedron collapsed "
                  "to a point; inverted tetrahedra have the same value.")
      .Agreement(
        "Same as TetGen's radius-edge ratio. The original Camarón reads uninitialized memory here.")
      .Consequence("tetrahedra far from regular; intended in boundary layers"),
    CriterionRow("TetRadiusRatio", "Tetrahedron radius ratio",
      "Three times the inradius divided by the circumradius.")
      .Shapes(Tetrahedra)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1.0 / 3, Infinity, VerdictManual, Hint, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsFaces | NeedsVolume)
      .Cells<OfSimplex<GetTetRadiusRatio<CellGeometry>>>()
      .Tetrahedra<GetTetRadiusRatio<TetrahedronPair>>()
      .Formula("3r/R with r = 3|V| / surface area and R as for `TetRadiusEdgeRatio`")
      .Degenerate("0 for a flat tetrahedron, NaN (degenerate) for a tetrahedron collapsed to a "
                  "point; inverted tetrahedra have the same value.")
      .Agreement("Reciprocal of Verdict's radius ratio (`VerdictRadiusRatio`).")
      .Consequence("tetrahedra far from regular; intended in boundary layers"),
    CriterionRow("TetMeanRatio", "Tetrahedron mean ratio",
      "12 (3 volume)^(2/3) / sum of squared edge lengths; negative for inverted tetrahedra.")
      .Shapes(Tetrahedra)
      .Range(-1, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(0.3, Infinity, "Verdict manual, rev. A, shape of tetrahedra", Hint, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsVolume)
      .Cells<OfSimplex<GetTetMeanRatio<CellGeometry>>>()
      .Tetrahedra<GetTetMeanRatio<TetrahedronPair>>()
      .Formula("± 12 (3|V|)^⅔ / Σ lᵢ² with the sign of V")
      .Degenerate("0 for a flat tetrahedron, negative for an inverted one, NaN (degenerate) for a "
                  "tetrahedron collapsed to a point.")
      .Agreement("Same as Verdict's mean ratio (newer VTK raises it to the power 3/2) and, except "
                 "for inverted tetrahedra where that is 0, Verdict's shape.")
      .Consequence("tetrahedra far from regular; intended in boundary layers"),
    CriterionRow("TetQualityFoam", "OpenFOAM's tetrahedron quality",
      "Volume divided by that of the regular tetrahedron with the same circumsphere.")
      .Shapes(Tetrahedra)
      .Range(-1, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1e-15, Infinity, "OpenFOAM's minTetQuality", Cited, Tetrahedra)
      .Cost(Cost::Edges)
      .Needs(NeedsEdges | NeedsVolume)
      .Cells<OfSimplex<GetTetQualityFoam<CellGeometry>>>()
      .Tetrahedra<GetTetQualityFoam<TetrahedronPair>>()
      .Formula("V / (8√3/27 · R³) with R as for `TetRadiusEdgeRatio`")
      .Degenerate("0 for a flat tetrahedron, negative for an inverted one, NaN (degenerate) for a "
                  "tetrahedron collapsed to a point.")
      .Agreement(
        "The value that OpenFOAM's minTetQuality limits. 1 minus Verdict's equivolume skew.")
      .Consequence(
        "flat or inverted tetrahedra: finite-volume schemes cannot interpolate or track particles"),
  };
}
}
