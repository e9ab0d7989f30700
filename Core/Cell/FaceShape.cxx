// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/FaceShape.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double HalfTurn = 3.141592653589793238462643383279502884;
}

//------------------------------------------------------------------------------
double GetFaceFlatness(const CellGeometry& cell, int face)
{
  // Of a face that crosses itself the triangles may have a sum below zero.
  const double fan = cell.GetFanArea(face);
  return fan > 0 ? std::min(1.0, cell.GetFaceArea(face) / fan) : 0;
}

//------------------------------------------------------------------------------
double GetFaceWarpage(const CellGeometry& cell, int face)
{
  const CellTopology& topology = cell.GetTopology();
  if (topology.GetFaceSize(face) == 3)
  {
    return 0;
  }
  const Vector normal = Unit(cell.GetFaceVector(face));
  double height = 0, radius = 0;
  for (int i = 0; i < topology.GetFaceSize(face); ++i)
  {
    const Vector offset = cell.GetPoint(topology.GetFace(face)[i]) - cell.GetFaceCenter(face);
    height = std::max(height, std::abs(Dot(normal, offset)));
    radius = std::max(radius, Norm2(offset));
  }
  return height / std::sqrt(radius);
}

//------------------------------------------------------------------------------
double GetFaceConcavity(const CellGeometry& cell, int face)
{
  const AngleRange& angles = cell.GetFaceAngles(face);
  return angles.IsEmpty() ? angles.GetMax() : std::max(0.0, angles.GetMax() - HalfTurn);
}
}
