// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The points of a cell that see all of it, and balls in and around the cell.
#include "Cell/CellKernel.h"
#include "Criteria/CriterionRows.h"

#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// measure() of a cell with a volume or an area, ifFlat for one without; null for a point and where
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
  // clang-format off
  return {
    { "KernelRatio", "Kernel ratio",
      "Volume (area) of the kernel, which is the set of points that see all of the cell, divided by that of the "
      "cell; 1 for convex cells, 0 where there is no such point.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real, Cost::Clipping, needs, CAMARON_CELLS(KernelRatio),
      { "|K| / |E|, with K what the inner half-spaces of the faces of E have in common; of a warped face those of "
        "the triangles of its edges and its center. Of a polygon: half-planes of its edges, in its plane. Half-spaces "
        "cut the bounding box of the cell one after the other. Exactly 1 where no point of the cell lies outside of a "
        "half-space.",
        "0 if the largest ball in K counts as zero for the precision of the points; NaN (2) without volume or "
        "area, NaN (3) for open cells. An inverted cell has the value of the cell turned inside out.",
        "PEMesh's kernel-area ratio of planar polygons. Camarón has the kernel of a whole model only." } },
    { "IsStarShaped", "Star-shaped", "1 if some point sees all of the cell (KernelRatio above 0), else 0.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1, Infinity }, "star-shaped", Hint, PolygonsAndPolyhedra, Integer, Cost::Iterative, needs | NeedsStarShape, CAMARON_CELLS(IsStarShaped),
      { "1 if there is a ball within the half-spaces of KernelRatio: a linear program with the faces as constraints. "
        "Where it is evaluated, CellStatus has the bit 0x20000 for cells with the value 0.",
        "NaN (2) without volume or area, NaN (3) for open cells; 0 with a coordinate that is not finite.",
        "Star-shaped about some point; MinTetMeanRatio tells of the centroid.",
        "estimates of virtual elements do not hold; of no matter to others" } },
    { "KernelInradiusRatio", "Kernel inradius to diameter",
      "Radius of the largest ball in the kernel divided by the largest distance of two vertices.",
      PolygonsAndPolyhedra, Unit::None, { 0, 0.5 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real, Cost::Iterative, needs, CAMARON_CELLS(KernelInradiusRatio),
      { "ρ = r(K) / h, with r(K) the radius of the largest ball (of a polygon: circle in its plane) in the kernel, "
        "and h the diameter. Cube 0.5 / √3.",
        "0 for flat cells and an empty kernel; NaN (2) if all points coincide, NaN (3) for open cells.",
        "The constant of the usual star-shapedness assumption of virtual element and hybrid high-order methods." } },
    { "ShapeRegularity", "Shape regularity",
      "Radius of the largest ball in the kernel divided by that of the smallest ball around the cell.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real, Cost::Iterative, needs, CAMARON_CELLS(ShapeRegularity),
      { "r(K) / R, with R the radius of the smallest ball around all vertices.",
        "0 for flat cells and an empty kernel; NaN (2) if all points coincide, NaN (3) for open cells.",
        "PEMesh prints the reciprocal for planar polygons." } },
    { "InradiusCircumradiusRatio", "Inscribed to enclosing ball",
      "Radius of the largest ball inside divided by that of the smallest ball around; never 1: cube 0.5774, "
      "regular tetrahedron 1/3, square 0.7071, equilateral triangle 1/2. The ball in a polyhedron is "
      "the one in its kernel.",
      PolygonsAndPolyhedra, Unit::None, { 0, 1 }, None, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real, Cost::Iterative, needs, CAMARON_CELLS(InradiusCircumradiusRatio),
      { "r / R. Convex cells: r by a linear program over the faces. Non-convex polygon: the largest circle inside, found to "
        "1e-6 of the diameter or better by cutting squares into four. Non-convex polyhedron: the largest ball in "
        "the kernel, which may be smaller than the largest ball inside. R: the smallest ball around the vertices.",
        "0 for flat cells; NaN (1) for a polyhedron without a kernel; NaN (2) if all points coincide, NaN (3) for open "
        "cells.",
        "PEMesh's circle ratio, camaron-web's aspect ratio (which is inexact for small meshes). For triangles half of "
        "TriangleRadiusRatio only if no angle is obtuse: the circle around is then smaller than the circumcircle." } },
    { "NormalizedRadiusRatio", "Normalized radius ratio",
      "InradiusCircumradiusRatio of a polygon divided by that of the regular polygon with as many corners.",
      Polygons, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { -Infinity, Infinity }, NoRange, Cited, NoShapes, Real, Cost::Iterative, needs, CAMARON_CELLS(NormalizedRadiusRatio),
      { "(r / R) / cos(π/k) for k distinct points.",
        "As InradiusCircumradiusRatio.",
        "TriangleRadiusRatio for triangles without an obtuse angle." } },
  };
  // clang-format on
}
}
