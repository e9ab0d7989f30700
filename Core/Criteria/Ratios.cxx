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
