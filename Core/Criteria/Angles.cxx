// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellGeometry.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
constexpr double Pi = 3.141592653589793238462643383279502884;

//------------------------------------------------------------------------------
AngleRange OverFaces(const CellGeometry& cell)
{
  AngleRange range;
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    range.Add(cell.GetFaceAngles(f));
  }
  return range;
}

//------------------------------------------------------------------------------
double InUserUnit(const CellGeometry& cell, double radian)
{
  return std::isnan(radian) ? radian : cell.ToAngleUnit(radian);
}
}

//------------------------------------------------------------------------------
double MinFaceAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, OverFaces(cell).GetMin());
}

//------------------------------------------------------------------------------
double MaxFaceAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, OverFaces(cell).GetMax());
}

//------------------------------------------------------------------------------
double MinDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetMinDihedralAngle());
}

//------------------------------------------------------------------------------
double MaxDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetMaxDihedralAngle());
}

//------------------------------------------------------------------------------
double MinSolidAngle(const CellGeometry& cell)
{
  return cell.GetMinSolidAngle();
}

//------------------------------------------------------------------------------
double MaxSolidAngle(const CellGeometry& cell)
{
  return cell.GetMaxSolidAngle();
}

//------------------------------------------------------------------------------
double EquiangleSkewness(const CellGeometry& cell)
{
  // Faces with the same number of corners share their ideal angle and so their extremes.
  constexpr int manyCorners = 12;
  AngleRange ranges[manyCorners];
  double worst = Null(NullReason::Degenerate);
  const auto add = [&](const AngleRange& angles, int size)
  {
    if (!angles.IsEmpty())
    {
      const double ideal = Pi * (size - 2) / size;
      const double skewness =
        std::max((angles.GetMax() - ideal) / (Pi - ideal), (ideal - angles.GetMin()) / ideal);
      worst = std::isnan(worst) ? skewness : std::max(worst, skewness);
    }
  };
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const int size = cell.GetTopology().GetFaceSize(f);
    size < manyCorners ? ranges[size].Add(cell.GetFaceAngles(f)) : add(cell.GetFaceAngles(f), size);
  }
  for (int size = 3; size < manyCorners; ++size)
  {
    add(ranges[size], size);
  }
  return worst;
}
}
