// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Divides a cell at its centroid: into the pyramids of its faces, and into the tetrahedra formed by
// the centroid, the center of a face and an edge of that face; a polygon into the triangles formed
// by the centroid and its edges.
#include "Criteria/CriterionRows.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double RegularArea = 1.2990381056766580; // of a triangle of circumradius 1
constexpr double RootOfThree = 1.7320508075688772;

//------------------------------------------------------------------------------
// Whether the volume is only the roundoff of products. Tetrahedra at short edges of large cells are
// not flat, however small their fraction of the cell.
bool IsFlat(
  const CellGeometry& cell, const Vector& center, const Vector& a, const Vector& b, double volume)
{
  constexpr double tolerance = 1e-12;
  const double product = tolerance * tolerance * Norm2(center) * Norm2(a) * Norm2(b);
  return 36 * volume * volume <= product || cell.IsZeroLength(Norm(b - a));
}

//------------------------------------------------------------------------------
// The minimum of measure(a, b, c, volume) over the tetrahedra, with a to c relative to the
// centroid.
template <typename Measure>
double MinOfTetrahedra(const CellGeometry& cell, Measure&& measure)
{
  if (std::isnan(cell.GetVolume()))
  {
    return cell.GetVolume();
  }
  if (cell.IsZeroVolume(cell.GetVolume()))
  {
    return 0;
  }
  double smallest = Infinity;
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const FaceRing ring(cell, f);
    const Vector center = cell.GetFaceCenter(f) - cell.GetCentroid();
    for (int i = 0; i < ring.GetSize(); ++i)
    {
      const Vector a = ring.GetBegin(i) - cell.GetCentroid();
      const Vector b = ring.GetEnd(i) - cell.GetCentroid();
      const double volume = Dot(center, Cross(a, b)) / 6;
      smallest =
        std::min(smallest, IsFlat(cell, center, a, b, volume) ? 0 : measure(center, a, b, volume));
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
// Calls visit(a, b, area) for the triangles of a polygon with an area, with a and b relative to the
// centroid.
template <typename Visit>
void ForEachTriangle(const CellGeometry& cell, Visit&& visit)
{
  const FaceRing ring(cell, 0);
  const Vector normal = Unit(cell.GetFaceVector(0));
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector a = ring.GetBegin(i) - cell.GetCentroid();
    const Vector b = ring.GetEnd(i) - cell.GetCentroid();
    visit(a, b, 0.5 * Dot(normal, Cross(a, b)));
  }
}

//------------------------------------------------------------------------------
// The minimum of measure(a, b, area) over them; flat triangles and polygons without area have 0.
template <typename Measure>
double MinOfTriangles(const CellGeometry& cell, Measure&& measure)
{
  if (cell.IsZeroArea(cell.GetPolygonArea()))
  {
    return 0;
  }
  double smallest = Infinity;
  ForEachTriangle(cell,
    [&](const Vector& a, const Vector& b, double area)
    {
      constexpr double tolerance = 1e-12;
      const bool isFlat = 4 * area * area <= tolerance * tolerance * Norm2(a) * Norm2(b) ||
        cell.IsZeroLength(Norm(b - a));
      smallest = std::min(smallest, isFlat ? 0 : measure(a, b, area));
    });
  return smallest;
}

//------------------------------------------------------------------------------
bool IsPolygon(const CellGeometry& cell)
{
  return (cell.GetShapes() & Polygons) != 0;
}

//------------------------------------------------------------------------------
// The minimum or maximum volume of the pyramids of the faces; for a polygon with an area, area of
// its triangles.
template <auto Choose>
double ChoosePyramid(const CellGeometry& cell)
{
  double chosen = -Choose(-Infinity, Infinity);
  if (IsPolygon(cell))
  {
    ForEachTriangle(cell,
      [&chosen](const Vector&, const Vector&, double area) { chosen = Choose(chosen, area); });
    return chosen;
  }
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const Vector height = cell.GetFaceCenter(f) - cell.GetCentroid();
    chosen = Choose(chosen, Dot(cell.GetFaceVector(f), height) / 3);
  }
  return chosen;
}

//------------------------------------------------------------------------------
// The same; 0 for a polygon without area.
template <auto Choose>
double FacePyramidVolume(const CellGeometry& cell)
{
  if (IsPolygon(cell))
  {
    return cell.IsZeroArea(cell.GetPolygonArea()) ? 0 : ChoosePyramid<Choose>(cell);
  }
  return std::isnan(cell.GetVolume()) ? cell.GetVolume() : ChoosePyramid<Choose>(cell);
}
}

//------------------------------------------------------------------------------
double MinFacePyramidRatio(const CellGeometry& cell)
{
  if (IsPolygon(cell))
  {
    const double area = cell.GetPolygonArea();
    return cell.IsZeroArea(area)
      ? Null(NullReason::Degenerate)
      : ChoosePyramid<GetSmaller>(cell) * cell.GetTopology().GetFaceSize(0) / area;
  }
  const double volume = cell.GetVolume();
  if (std::isnan(volume))
  {
    return volume;
  }
  return cell.IsZeroVolume(volume)
    ? Null(NullReason::Degenerate)
    : ChoosePyramid<GetSmaller>(cell) * cell.GetTopology().GetNumberOfFaces() / std::abs(volume);
}

//------------------------------------------------------------------------------
double MinTetVolume(const CellGeometry& cell)
{
  if (IsPolygon(cell))
  {
    return MinOfTriangles(cell, [](const Vector&, const Vector&, double area) { return area; });
  }
  return MinOfTetrahedra(
    cell, [](const Vector&, const Vector&, const Vector&, double volume) { return volume; });
}

//------------------------------------------------------------------------------
double MinTetMeanRatio(const CellGeometry& cell)
{
  if (IsPolygon(cell))
  {
    return MinOfTriangles(cell, [](const Vector& a, const Vector& b, double area)
      { return 4 * RootOfThree * area / (Norm2(a) + Norm2(b) + Norm2(b - a)); });
  }
  // The same tetrahedron minimizes the volume divided by the power 3/2 of the squared edges, so a
  // single cube root is enough.
  const double smallest = MinOfTetrahedra(cell,
    [](const Vector& a, const Vector& b, const Vector& c, double volume)
    {
      const double squares =
        Norm2(a) + Norm2(b) + Norm2(c) + Norm2(a - b) + Norm2(b - c) + Norm2(c - a);
      return volume / (squares * std::sqrt(squares));
    });
  if (std::isnan(smallest))
  {
    return smallest;
  }
  const double root = std::cbrt(3 * std::abs(smallest));
  return std::copysign(12 * root * root, smallest);
}

//------------------------------------------------------------------------------
double MinTetQuality(const CellGeometry& cell)
{
  if (IsPolygon(cell))
  {
    return MinOfTriangles(cell,
      [](const Vector& a, const Vector& b, double area)
      {
        const double radius = Norm(a) * Norm(b) * Norm(b - a) / (2 * Norm(Cross(a, b)));
        return area / (RegularArea * radius * radius);
      });
  }
  return MinOfTetrahedra(cell,
    [](const Vector& a, const Vector& b, const Vector& c, double volume)
    {
      const double radius =
        Norm(Norm2(a) * Cross(b, c) + Norm2(b) * Cross(c, a) + Norm2(c) * Cross(a, b)) /
        (12 * std::abs(volume));
      return volume / (RegularVolume * radius * radius * radius);
    });
}

//------------------------------------------------------------------------------
std::vector<Criterion> DecompositionCriteria()
{
  return {
    CriterionRow("MinFacePyramidVolume", "Minimum face pyramid volume",
      "Minimum volume of the pyramids between the centroid of the cell and its faces; for a "
      "polygon, minimum area of the triangles between the centroid and its edges.")
      .Unit(Unit::Volume)
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Bigger)
      .Acceptable(Positive, Infinity, CheckMesh, Cited, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<FacePyramidVolume<GetSmaller>>()
      .Formula("min over the faces of ⅓ S_f · (c_f − C); for a polygon with normal n, min over the "
               "edges of ½ n · ((pᵢ − C) × (pᵢ₊₁ − C))")
      .Degenerate("0 for a flat cell; negative for an inverted cell or if C is outside a face; NaN "
                  "(invalid topology) for an open cell.")
      .Agreement("checkMesh counts the faces whose pyramid in either cell is not positive.")
      .Consequence("centroid outside a face: finite-volume fluxes point the wrong way"),
    CriterionRow("MaxFacePyramidVolume", "Maximum face pyramid volume",
      "Maximum volume of the pyramids between the centroid of the cell and its faces; for a "
      "polygon, maximum area of the triangles between the centroid and its edges.")
      .Unit(Unit::Volume)
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Bigger)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<FacePyramidVolume<GetLarger>>()
      .Formula("as `MinFacePyramidVolume`, the maximum over the faces or edges")
      .Degenerate("0 for a flat cell; NaN (invalid topology) for an open cell.")
      .Agreement("None of the compared programs reports it."),
    CriterionRow("MinFacePyramidRatio", "Minimum face pyramid ratio",
      "Minimum volume of the pyramids between the centroid and the faces, times the number of "
      "faces, divided by the volume of the cell (for a polygon: triangles, edges and area); 1 if "
      "all are equal.")
      .Range(-Infinity, 1)
      .Ideal(1, Better::Bigger)
      .Acceptable(Positive, Infinity, CheckMesh, Cited, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<MinFacePyramidRatio>()
      .Formula("`MinFacePyramidVolume` × number of faces / |V|")
      .Degenerate("Negative for an inverted cell; NaN (degenerate) for a flat cell, NaN (invalid "
                  "topology) for an open cell.")
      .Agreement("None of the compared programs reports it.")
      .Consequence("centroid outside a face: finite-volume fluxes point the wrong way"),
    CriterionRow("MinTetVolume", "Minimum tetrahedron volume of the decomposition",
      "Minimum volume of the tetrahedra formed by the centroid of the cell, the center of a face "
      "and an edge of that face; for a polygon, minimum area of the triangles formed by the "
      "centroid and an edge.")
      .Unit(Unit::Volume)
      .Range(-Infinity, Infinity)
      .Ideal(None, Better::Bigger)
      .Acceptable(Positive, Infinity, "star-shaped about its centroid", Cited, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<MinTetVolume>()
      .Formula("min over faces and their edges of (c_f − C) · ((pᵢ − C) × (pᵢ₊₁ − C)) / 6; for a "
               "polygon as `MinFacePyramidVolume`")
      .Degenerate("0 if an edge or a face is collapsed, negative for an inverted cell; NaN "
                  "(invalid topology) for an open cell.")
      .Agreement("OpenFOAM divides faces at one of their vertices, which it chooses, instead of "
                 "their center where necessary.")
      .Consequence("not star-shaped about the centroid: finite-volume interpolation and particle "
                   "tracking meet inverted tetrahedra"),
    CriterionRow("MinTetMeanRatio", "Minimum mean ratio of the decomposition",
      "Minimum mean ratio of the tetrahedra formed by the centroid, the center of a face and an "
      "edge of that face (for a polygon: triangles formed by the centroid and an edge); positive "
      "if the cell is star-shaped about its centroid. Not 1 for the cube.")
      .Range(-1, 1)
      .Ideal(None, Better::Bigger)
      .Acceptable(Positive, Infinity, "star-shaped about its centroid", Cited, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<MinTetMeanRatio>()
      .Formula("min of `TetMeanRatio` over the tetrahedra (C, c_f, pᵢ, pᵢ₊₁); for a polygon min of "
               "4√3 A / Σl² over the triangles (C, pᵢ, pᵢ₊₁)")
      .Degenerate("0 if an edge or a face is collapsed, negative for an inverted cell; NaN "
                  "(invalid topology) for an open cell.")
      .Agreement("None of the compared programs reports it.")
      .Consequence("not star-shaped about the centroid: finite-volume interpolation and particle "
                   "tracking meet inverted tetrahedra"),
    CriterionRow("MinTetQuality", "Minimum OpenFOAM tetrahedron quality",
      "Volume divided by that of the regular tetrahedron with the same circumsphere, for the worst "
      "tetrahedron formed by the centroid, the center of a face and an edge of that face; for a "
      "polygon, area and circumcircle of the worst triangle formed by the centroid and an edge.")
      .Range(-1, 1)
      .Ideal(None, Better::Bigger)
      .Acceptable(1e-15, Infinity, "OpenFOAM's minTetQuality", Hint, Polyhedra)
      .Cost(Cost::Edges)
      .Needs(NeedsCentroid)
      .Cells<MinTetQuality>()
      .Formula("min of `TetQualityFoam` over the tetrahedra (C, c_f, pᵢ, pᵢ₊₁); for a polygon min "
               "of A / (¾√3 R²) over the triangles (C, pᵢ, pᵢ₊₁)")
      .Degenerate("0 if an edge or a face is collapsed, negative for an inverted cell; NaN "
                  "(invalid topology) for an open cell.")
      .Agreement("The value that OpenFOAM's minTetQuality limits, except that OpenFOAM divides a "
                 "face at one of its vertices.")
      .Consequence("nearly flat or inverted tetrahedra in the cell, for example at tiny edges of "
                   "Voronoi cells"),
  };
}
}
