// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
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
}
