// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
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

constexpr double RegularVolume = 0.5132002392796673; // 8 sqrt(3) / 27, of circumradius 1

//------------------------------------------------------------------------------
// All points in one place: 0/0 for every ratio.
bool IsOnePoint(const CellGeometry& cell)
{
  return cell.IsZeroLength(cell.GetMaxEdgeLength());
}

//------------------------------------------------------------------------------
// Circumradius times twelve volumes: |a^2 (b x c) + b^2 (c x a) + c^2 (a x b)|, edges from the first
// point, which is the origin.
double CircumradiusTimes12Volumes(const CellGeometry& tetrahedron)
{
  const Vector &a = tetrahedron.GetPoint(1), &b = tetrahedron.GetPoint(2),
               &c = tetrahedron.GetPoint(3);
  return Norm(Norm2(a) * Cross(b, c) + Norm2(b) * Cross(c, a) + Norm2(c) * Cross(a, b));
}
}

//------------------------------------------------------------------------------
double TriangleRadiusRatio(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double area = cell.GetPolygonArea();
  if (cell.IsZeroArea(area))
  {
    return 0;
  }
  const double a = cell.GetEdgeLength(0), b = cell.GetEdgeLength(1), c = cell.GetEdgeLength(2);
  return 16 * area * area / (a * b * c * (a + b + c));
}

//------------------------------------------------------------------------------
double BhatiaLawrence(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double area = cell.GetPolygonArea();
  return cell.IsZeroArea(area) ? 0 : 4 * std::sqrt(3.0) * area / cell.GetSumOfSquaredLengths();
}

//------------------------------------------------------------------------------
double TriangleRadiusEdgeRatio(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double area = cell.GetPolygonArea();
  if (cell.IsZeroArea(area))
  {
    return Infinity;
  }
  const double a = cell.GetEdgeLength(0), b = cell.GetEdgeLength(1), c = cell.GetEdgeLength(2);
  return a * b * c / (4 * area * std::min({ a, b, c }));
}

//------------------------------------------------------------------------------
double TetRadiusEdgeRatio(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double volume = cell.GetVolume();
  if (std::isnan(volume))
  {
    return volume;
  }
  return cell.IsZeroVolume(volume)
    ? Infinity
    : CircumradiusTimes12Volumes(cell) / (12 * std::abs(volume)) / cell.GetMinEdgeLength();
}

//------------------------------------------------------------------------------
double TetRadiusRatio(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double volume = cell.GetVolume();
  if (std::isnan(volume) || cell.IsZeroVolume(volume))
  {
    return std::isnan(volume) ? volume : 0;
  }
  // 3 r / R with r = 3 V / S.
  return 108 * volume * volume / (cell.GetSurfaceArea() * CircumradiusTimes12Volumes(cell));
}

//------------------------------------------------------------------------------
double TetMeanRatio(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double volume = cell.GetVolume();
  if (std::isnan(volume) || cell.IsZeroVolume(volume))
  {
    return std::isnan(volume) ? volume : 0;
  }
  const double root = std::cbrt(3 * std::abs(volume));
  return std::copysign(12 * root * root / cell.GetSumOfSquaredLengths(), volume);
}

//------------------------------------------------------------------------------
double TetQualityFoam(const CellGeometry& cell)
{
  if (IsOnePoint(cell))
  {
    return Null(NullReason::Degenerate);
  }
  const double volume = cell.GetVolume();
  if (std::isnan(volume) || cell.IsZeroVolume(volume))
  {
    return std::isnan(volume) ? volume : 0;
  }
  const double circumradius = CircumradiusTimes12Volumes(cell) / (12 * std::abs(volume));
  return volume / (RegularVolume * circumradius * circumradius * circumradius);
}

//------------------------------------------------------------------------------
std::vector<Criterion> SimplexCriteria()
{
  // clang-format off
  return {
    { "TriangleRadiusRatio", "Triangle radius ratio", "Twice the inradius divided by the circumradius.",
      Triangles, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1.0 / 3, Infinity }, VerdictManual, Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CAMARON_CELLS(TriangleRadiusRatio) },
    { "BhatiaLawrence", "Bhatia-Lawrence measure",
      "4 sqrt(3) area / sum of squared edge lengths, the mean ratio of a triangle.",
      Triangles, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 0.25, Infinity }, "Verdict manual, rev. A, shape of triangles", Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CAMARON_CELLS(BhatiaLawrence) },
    { "TriangleRadiusEdgeRatio", "Triangle radius-edge ratio", "Circumradius divided by the shortest edge.",
      Triangles, Unit::None, { SquareRootOf1Over3, Infinity }, SquareRootOf1Over3, Better::Smaller,
      { -Infinity, SquareRootOf2 }, "Ruppert's bound, smallest angle above 20.7 degrees", Cited, Real,
      Cost::Faces, NeedsEdges | NeedsFaces, CAMARON_CELLS(TriangleRadiusEdgeRatio) },
    { "TetRadiusEdgeRatio", "Tetrahedron radius-edge ratio",
      "Circumradius divided by the shortest edge. Does not see slivers: read it together with the "
      "smallest dihedral angle.",
      Tetrahedra, Unit::None, { SquareRootOf3Over8, Infinity }, SquareRootOf3Over8, Better::Smaller,
      { -Infinity, 2 }, "TetGen's default bound", Cited, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CAMARON_CELLS(TetRadiusEdgeRatio) },
    { "TetRadiusRatio", "Tetrahedron radius ratio", "Three times the inradius divided by the circumradius.",
      Tetrahedra, Unit::None, { 0, 1 }, 1, Better::Bigger,
      { 1.0 / 3, Infinity }, VerdictManual, Cited, Real,
      Cost::Edges, NeedsEdges | NeedsFaces | NeedsVolume, CAMARON_CELLS(TetRadiusRatio) },
    { "TetMeanRatio", "Tetrahedron mean ratio",
      "12 (3 volume)^(2/3) / sum of squared edge lengths, negative when inverted.",
      Tetrahedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 0.3, Infinity }, "Verdict manual, rev. A, shape of tetrahedra", Cited, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CAMARON_CELLS(TetMeanRatio) },
    { "TetQualityFoam", "OpenFOAM's tetrahedron quality",
      "Volume divided by that of the regular tetrahedron with the same circumsphere.",
      Tetrahedra, Unit::None, { -1, 1 }, 1, Better::Bigger,
      { 1e-15, Infinity }, "OpenFOAM's minTetQuality", Hint, Real,
      Cost::Edges, NeedsEdges | NeedsVolume, CAMARON_CELLS(TetQualityFoam) },
  };
  // clang-format on
}
}
