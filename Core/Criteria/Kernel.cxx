// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Criteria of the kernel of a cell, and of its inscribed and enclosing balls.
#include "Cell/CellKernel.h"
#include "Criteria/CriterionRows.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// measure() for a cell with a volume or an area, ifFlat for one without; NaN for a point, and if
// the cell is not closed.
template <typename Measure>
double OfSolid(const CellGeometry& cell, double ifFlat, Measure&& measure)
{
  const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
  if (!isPolygon && std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  if (cell.IsZeroLength(cell.GetDiameter()))
  {
    return Null(NullReason::Degenerate);
  }
  const bool isFlat =
    isPolygon ? cell.IsZeroArea(cell.GetPolygonArea()) : cell.IsZeroVolume(cell.GetVolume());
  return isFlat ? ifFlat : measure();
}
}

//------------------------------------------------------------------------------
double KernelRatio(const CellGeometry& cell)
{
  return OfSolid(
    cell, Null(NullReason::Degenerate), [&] { return cell.GetKernel().GetRatio(cell); });
}

//------------------------------------------------------------------------------
double IsStarShaped(const CellGeometry& cell)
{
  if (!cell.IsFinite())
  {
    return 0;
  }
  return OfSolid(cell, Null(NullReason::Degenerate),
    [&] { return cell.GetKernel().GetRadius(cell) > 0 ? 1.0 : 0.0; });
}

//------------------------------------------------------------------------------
double KernelInradiusRatio(const CellGeometry& cell)
{
  return OfSolid(cell, 0, [&] { return cell.GetKernel().GetRadius(cell) / cell.GetDiameter(); });
}

//------------------------------------------------------------------------------
double ShapeRegularity(const CellGeometry& cell)
{
  CellKernel& kernel = cell.GetKernel();
  return OfSolid(cell, 0, [&] { return kernel.GetRadius(cell) / kernel.GetEnclosingRadius(cell); });
}

//------------------------------------------------------------------------------
double InradiusCircumradiusRatio(const CellGeometry& cell)
{
  CellKernel& kernel = cell.GetKernel();
  return OfSolid(cell, 0,
    [&]
    {
      if (cell.GetShapes() & Polygons)
      {
        return kernel.GetInscribedRadius(cell) / kernel.GetEnclosingRadius(cell);
      }
      return kernel.GetRadius(cell) > 0 ? kernel.GetRadius(cell) / kernel.GetEnclosingRadius(cell)
                                        : Null(NullReason::NotApplicable);
    });
}

//------------------------------------------------------------------------------
double NormalizedRadiusRatio(const CellGeometry& cell)
{
  const double ratio = InradiusCircumradiusRatio(cell);
  return std::isnan(ratio) ? ratio : ratio / std::cos(Pi / cell.GetNumberOfPoints());
}

//------------------------------------------------------------------------------
std::vector<Criterion> KernelCriteria()
{
  constexpr unsigned needs = NeedsFaces | NeedsVolume;
  return {
    CriterionRow("KernelRatio", "Kernel ratio",
      "Volume (area) of the kernel divided by that of the cell; the kernel is the set of points "
      "from which the whole cell is visible. 1 for convex cells, 0 for an empty kernel.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Clipping)
      .Needs(needs)
      .Cells<KernelRatio>()
      .Formula(
        "|K| / |E|, with K the intersection of the inner half-spaces of the faces of E; for a "
        "warped face, the half-spaces of the triangles about its center; for a polygon, the "
        "half-planes of its edges, in its plane. The half-spaces clip the bounding box of the cell "
        "one by one. Exactly 1 if no point of the cell lies outside a half-space.")
      .Degenerate("0 if the largest ball in K has zero radius within the precision of the points; "
                  "NaN (degenerate) without volume or area, NaN (invalid topology) for open cells. "
                  "An inverted cell has the value of the cell with correct orientation.")
      .Agreement("Same as PEMesh's kernel-area ratio of planar polygons. The original Camarón "
                 "computes the kernel of a whole model only."),
    CriterionRow("IsStarShaped", "Star-shaped",
      "1 if the whole cell is visible from some point (KernelRatio above 0), else 0.")
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(1, Infinity, "star-shaped", Hint, PolygonsAndPolyhedra)
      .Kind(ValueKind::Integer)
      .Cost(Cost::Iterative)
      .Needs(needs | NeedsStarShape)
      .Cells<IsStarShaped>()
      .Formula("1 if a ball fits into the half-spaces of KernelRatio: a linear program with the "
               "faces as constraints. If this criterion is evaluated, CellStatus sets bit 0x20000 "
               "for cells with the value 0.")
      .Degenerate("NaN (degenerate) without volume or area, NaN (invalid topology) for open cells; "
                  "0 with a nonfinite coordinate.")
      .Agreement("Star-shaped about any point; MinTetMeanRatio tests the centroid.")
      .Consequence(
        "error estimates of virtual elements do not apply; irrelevant for other methods"),
    CriterionRow("KernelInradiusRatio", "Kernel inradius to diameter",
      "Radius of the largest ball in the kernel divided by the maximum distance of two vertices.")
      .Range(0, 0.5)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(needs)
      .Cells<KernelInradiusRatio>()
      .Formula("ρ = r(K) / h, with r(K) the radius of the largest ball (for a polygon: circle in "
               "its plane) in the kernel, and h the diameter. 0.5 / √3 for a cube.")
      .Degenerate("0 for flat cells and an empty kernel; NaN (degenerate) if all points coincide, "
                  "NaN (invalid topology) for open cells.")
      .Agreement("The constant of the usual star-shapedness assumption of virtual element and "
                 "hybrid high-order methods."),
    CriterionRow("ShapeRegularity", "Shape regularity",
      "Radius of the largest ball in the kernel divided by that of the smallest enclosing ball of "
      "the cell.")
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(needs)
      .Cells<ShapeRegularity>()
      .Formula("r(K) / R, with R the radius of the smallest enclosing ball of all vertices.")
      .Degenerate("0 for flat cells and an empty kernel; NaN (degenerate) if all points coincide, "
                  "NaN (invalid topology) for open cells.")
      .Agreement("PEMesh prints the reciprocal for planar polygons."),
    CriterionRow("InradiusCircumradiusRatio", "Inscribed to enclosing ball",
      "Radius of the largest inscribed ball divided by that of the smallest enclosing ball; always "
      "below 1: cube 0.5774, regular tetrahedron 1/3, square 0.7071, equilateral triangle 1/2. For "
      "polyhedra, the inscribed ball is the largest ball in the kernel.")
      .Range(0, 1)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(needs)
      .Cells<InradiusCircumradiusRatio>()
      .Formula(
        "r / R. Convex cells: r by a linear program over the faces. Non-convex polygons: the "
        "largest inscribed circle, found to 1e-6 of the diameter or better by a quadtree search. "
        "Non-convex polyhedra: the largest ball in the kernel, which may be smaller than the "
        "largest inscribed ball. R: the smallest enclosing ball of the vertices.")
      .Degenerate("0 for flat cells; NaN (not applicable) for a polyhedron without a kernel; NaN "
                  "(degenerate) if all points coincide, NaN (invalid topology) for open cells.")
      .Agreement("Same as PEMesh's circle ratio and camaron-web's aspect ratio (which is inexact "
                 "for small meshes). For triangles, half of TriangleRadiusRatio only if no angle "
                 "is obtuse: otherwise the enclosing circle is smaller than the circumcircle."),
    CriterionRow("NormalizedRadiusRatio", "Normalized radius ratio",
      "InradiusCircumradiusRatio of a polygon divided by that of the regular polygon with the same "
      "number of vertices.")
      .Shapes(Polygons)
      .Range(0, 1)
      .Ideal(1, Better::Bigger)
      .Cost(Cost::Iterative)
      .Needs(needs)
      .Cells<NormalizedRadiusRatio>()
      .Formula("(r / R) / cos(π/k) for k distinct points.")
      .Degenerate("As InradiusCircumradiusRatio.")
      .Agreement("Same as TriangleRadiusRatio for triangles without an obtuse angle."),
  };
}
}
