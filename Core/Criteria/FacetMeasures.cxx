// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/FacetMeasures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
using Facet = CellNeighborhood::Facet;
using Side = CellNeighborhood::Side;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
double GetAngle(const Vector& a, const Vector& b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b));
}
}

//------------------------------------------------------------------------------
bool AddNonOrthogonality(const CellNeighborhood& cell, const Facet& facet, AngleRange& angles)
{
  const Vector& line = facet.Line;
  const double length = Norm(line); // NaN where the other cell has no centroid
  if (facet.IsZero || std::isnan(length) || cell.GetGeometry().IsZeroLength(length))
  {
    return false;
  }
  angles.Add(Norm(Cross(line, facet.Area)), Dot(line, facet.Area));
  return true;
}

//------------------------------------------------------------------------------
double GetNonOrthogonality(const CellNeighborhood& cell, const Facet& facet)
{
  AngleRange angle;
  AddNonOrthogonality(cell, facet, angle);
  return angle.GetMax();
}

//------------------------------------------------------------------------------
double GetBoundaryNonOrthogonality(const CellNeighborhood& cell, const Facet& facet)
{
  const Vector& way = facet.Way;
  return facet.IsZero || cell.GetGeometry().IsZeroLength(Norm(way))
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
  const bool isBoundary = facet.Other == Side::Boundary;
  const Vector& way = facet.Way;
  Vector line = facet.Line;
  if (isBoundary)
  {
    // As if a mirrored cell lay beyond.
    const Vector normal = Unit(facet.Area);
    line = Dot(normal, way) * normal;
  }
  const double across = Dot(facet.Area, line);
  if (cell.GetGeometry().IsZeroLength(std::abs(across) / facet.Size))
  {
    return Infinity;
  }
  const Vector offset = way - (Dot(facet.Area, way) / across) * line;
  const double distance = Norm(offset);
  const Vector direction = Unit(offset);
  double reach = (isBoundary ? 0.4 : 0.2) * Norm(line);
  cell.ForEachPoint(facet,
    [&](const Vector& point)
    { reach = std::max(reach, std::abs(Dot(direction, point - facet.Center))); });
  return distance / reach;
}

//------------------------------------------------------------------------------
double GetFaceWeight(const CellNeighborhood& cell, const Facet& facet)
{
  const double own = std::abs(Dot(facet.Area, facet.Way));
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
    return Dot(facet.Area, facet.Way) / 2; // that of the other one lies in another plane
  }
  const double own = Dot(facet.Area, facet.Way) / 3;
  return facet.Other == Side::Cell
    ? std::min(own, Dot(facet.Area, facet.OtherCentroid - facet.Center) / 3)
    : own;
}

//------------------------------------------------------------------------------
double GetFaceTwist(const CellNeighborhood& cell, const Facet& facet)
{
  const Vector end = facet.Other == Side::Cell ? facet.OtherCentroid : facet.Center;
  const Vector line = end - cell.GetCentroid();
  const CellGeometry& geometry = cell.GetGeometry();
  double smallest = Null(NullReason::Degenerate);
  if (geometry.IsZeroLength(Norm(line)))
  {
    return smallest;
  }
  const CellTopology& topology = geometry.GetTopology();
  const int* ring = topology.GetFace(facet.Number);
  const int size = topology.GetFaceSize(facet.Number);
  for (int i = 0; i < size; ++i)
  {
    const Vector& next = geometry.GetPoint(ring[i + 1 < size ? i + 1 : 0]);
    const Vector triangle = 0.5 * Cross(geometry.GetPoint(ring[i]) - facet.Center, next - facet.Center);
    if (!geometry.IsZeroArea(Norm(triangle)))
    {
      const double cosine = Dot(Unit(triangle), Unit(line));
      smallest = std::isnan(smallest) ? cosine : std::min(smallest, cosine);
    }
  }
  return smallest;
}
}
