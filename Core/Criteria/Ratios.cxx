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
constexpr double Pi = 3.141592653589793238462643383279502884;
}

//------------------------------------------------------------------------------
double EdgeLengthRatio(const CellGeometry& cell)
{
  const double shortest = cell.GetMinEdgeLength(), longest = cell.GetMaxEdgeLength();
  if (cell.IsZeroLength(longest))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(shortest) ? 0 : shortest / longest;
}

//------------------------------------------------------------------------------
double EdgeRatio(const CellGeometry& cell)
{
  const double shortest = cell.GetMinEdgeLength(), longest = cell.GetMaxEdgeLength();
  if (cell.IsZeroLength(longest))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(shortest) ? std::numeric_limits<double>::infinity() : longest / shortest;
}

//------------------------------------------------------------------------------
double EdgeDiameterRatio(const CellGeometry& cell)
{
  const double shortest = cell.GetMinEdgeLength(), diameter = cell.GetDiameter();
  if (cell.IsZeroLength(diameter))
  {
    return Null(NullReason::Degenerate);
  }
  return cell.IsZeroLength(shortest) ? 0 : shortest / diameter;
}

//------------------------------------------------------------------------------
double MinPointDistanceRatio(const CellGeometry& cell)
{
  const double diameter = cell.GetDiameter();
  if (cell.IsZeroLength(diameter))
  {
    return Null(NullReason::Degenerate);
  }
  double smallest = diameter * diameter;
  for (int i = 1; i < cell.GetNumberOfPoints(); ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      smallest = std::min(smallest, Norm2(cell.GetPoint(i) - cell.GetPoint(j)));
    }
  }
  const double distance = std::sqrt(smallest);
  return cell.IsZeroLength(distance) ? 0 : distance / diameter;
}

//------------------------------------------------------------------------------
double IsoperimetricQuotient(const CellGeometry& cell)
{
  if (cell.GetShapes() & Polygons)
  {
    const double perimeter = cell.GetTotalEdgeLength();
    return cell.IsZeroLength(perimeter) ? Null(NullReason::Degenerate)
                                        : 4 * Pi * cell.GetPolygonArea() / (perimeter * perimeter);
  }
  const double volume = cell.GetVolume(), surface = cell.GetSurfaceArea();
  if (std::isnan(volume))
  {
    return volume;
  }
  return cell.IsZeroArea(surface) ? Null(NullReason::Degenerate)
                                  : 36 * Pi * volume * volume / (surface * surface * surface);
}

//------------------------------------------------------------------------------
double Sphericity(const CellGeometry& cell)
{
  const double quotient = IsoperimetricQuotient(cell);
  return std::isnan(quotient) ? quotient : std::cbrt(quotient);
}

//------------------------------------------------------------------------------
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
  const double edges = static_cast<double>(cell.GetTopology().Edges.size());
  const double length = std::sqrt(cell.GetSumOfSquaredLengths() / edges);
  return cell.IsZeroVolume(volume) ? 0 : volume / (length * length * length);
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
    return std::numeric_limits<double>::infinity();
  }
  return std::max(largest / smallest, (sum.X + sum.Y + sum.Z) / (6 * std::cbrt(volume * volume)));
}
}
