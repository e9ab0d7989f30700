// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/FacetMeasures.h"

#include "Base/Number.h"
#include "Cell/FaceRing.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
using Facet = CellNeighborhood::Facet;
using Side = CellNeighborhood::Side;

namespace
{
//------------------------------------------------------------------------------
double GetAngle(const Vector& a, const Vector& b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b));
}
}

//------------------------------------------------------------------------------
double GetLean(const CellNeighborhood& cell, const Facet& facet)
{
  // The length is NaN if the other cell has no centroid.
  if (facet.IsZero || std::isnan(facet.LineLength) ||
    cell.GetGeometry().IsZeroLength(facet.LineLength))
  {
    return Null(NullReason::Degenerate);
  }
  return -facet.AreaByLine / Norm(Cross(facet.Line, facet.Area));
}

//------------------------------------------------------------------------------
double GetAngleOfLean(double lean)
{
  return std::isnan(lean) ? lean : std::atan2(1, -lean);
}

//------------------------------------------------------------------------------
double GetNonOrthogonality(const CellNeighborhood& cell, const Facet& facet)
{
  return GetAngleOfLean(GetLean(cell, facet));
}

//------------------------------------------------------------------------------
double GetBoundaryNonOrthogonality(const CellNeighborhood& cell, const Facet& facet)
{
  const Vector& way = facet.Way;
  return facet.IsZero || cell.GetGeometry().IsZeroLength(facet.WayLength)
    ? Null(NullReason::Degenerate)
    : GetAngle(way, facet.Area);
}

//------------------------------------------------------------------------------
double GetFaceSkewness(const CellNeighborhood& cell, const Facet& facet)
{
  if (facet.IsZero)
  {
    return Null(NullReason::Degenerate);
  }
  // At the boundary, a mirrored cell is assumed beyond the facet.
  const bool isBoundary = facet.Other == Side::Boundary;
  const double across = isBoundary ? facet.AreaByWay : facet.AreaByLine;
  const double height = std::abs(across) / facet.Size;
  if (cell.GetGeometry().IsZeroLength(height))
  {
    return Infinity;
  }
  const Vector offset = isBoundary ? facet.Way - (across / (facet.Size * facet.Size)) * facet.Area
                                   : facet.Way - (facet.AreaByWay / across) * facet.Line;
  const double square = Norm2(offset);
  if (square == 0)
  {
    return 0;
  }
  // All lengths are scaled by that of the offset.
  double reach = (isBoundary ? 0.4 * height : 0.2 * facet.LineLength) * std::sqrt(square);
  cell.ForEachPoint(facet, [&](const Vector& point)
    { reach = std::max(reach, std::abs(Dot(offset, point - facet.Center))); });
  return square / reach;
}

//------------------------------------------------------------------------------
double GetFaceWeight(const CellNeighborhood& cell, const Facet& facet)
{
  const double own = std::abs(facet.AreaByWay);
  const double other = std::abs(Dot(facet.Area, facet.OtherCentroid - facet.Center));
  const double distance = own + other;
  return facet.IsZero || cell.GetGeometry().IsZeroLength(distance / facet.Size)
    ? Null(NullReason::Degenerate)
    : std::min(own, other) / distance;
}

//------------------------------------------------------------------------------
double GetVolumeRatio(const CellNeighborhood& cell, const Facet& facet)
{
  if (std::isnan(cell.GetSize()) || std::isnan(facet.OtherSize))
  {
    return std::isnan(cell.GetSize()) ? cell.GetSize() : facet.OtherSize;
  }
  const double smaller = std::min(cell.GetSize(), facet.OtherSize);
  return smaller <= 0 ? 0 : smaller / std::max(cell.GetSize(), facet.OtherSize);
}

//------------------------------------------------------------------------------
double GetFacePyramidVolume(const CellNeighborhood& cell, const Facet& facet)
{
  if (cell.GetGeometry().GetShapes() & Polygons)
  {
    return facet.AreaByWay / 2; // that of the other one is in another plane
  }
  const double own = facet.AreaByWay / 3;
  return facet.Other == Side::Cell
    ? std::min(own, Dot(facet.Area, facet.OtherCentroid - facet.Center) / 3)
    : own;
}

//------------------------------------------------------------------------------
double GetFaceTwist(const CellNeighborhood& cell, const Facet& facet)
{
  const Vector& line = facet.Other == Side::Cell ? facet.Line : facet.Way;
  const CellGeometry& geometry = cell.GetGeometry();
  double smallest = Null(NullReason::Degenerate);
  if (geometry.IsZeroLength(facet.Other == Side::Cell ? facet.LineLength : facet.WayLength))
  {
    return smallest;
  }
  const FaceRing ring(geometry, facet.Number);
  for (int i = 0; i < ring.GetSize(); ++i)
  {
    const Vector triangle =
      0.5 * Cross(ring.GetBegin(i) - facet.Center, ring.GetEnd(i) - facet.Center);
    if (!geometry.IsZeroArea(Norm(triangle)))
    {
      const double cosine = Dot(Unit(triangle), Unit(line));
      smallest = std::isnan(smallest) ? cosine : std::min(smallest, cosine);
    }
  }
  return smallest;
}
}
