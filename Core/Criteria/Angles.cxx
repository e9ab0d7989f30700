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
// The best of one value per face, in user units; null when no face has one.
template <typename FaceValue, typename IsBetter>
double OverFaces(const CellGeometry& cell, FaceValue&& faceValue, IsBetter&& isBetter)
{
  double best = Null(NullReason::Degenerate);
  for (int f = 0; f < cell.GetTopology().GetNumberOfFaces(); ++f)
  {
    const double value = faceValue(f);
    if (!std::isnan(value) && (std::isnan(best) || isBetter(value, best)))
    {
      best = value;
    }
  }
  return best;
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
  return InUserUnit(cell,
    OverFaces(
      cell, [&](int f) { return cell.GetFaceAngles(f).Min; }, std::less<double>()));
}

//------------------------------------------------------------------------------
double MaxFaceAngle(const CellGeometry& cell)
{
  return InUserUnit(cell,
    OverFaces(
      cell, [&](int f) { return cell.GetFaceAngles(f).Max; }, std::greater<double>()));
}

//------------------------------------------------------------------------------
double MinDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetDihedralAngles().Min);
}

//------------------------------------------------------------------------------
double MaxDihedralAngle(const CellGeometry& cell)
{
  return InUserUnit(cell, cell.GetDihedralAngles().Max);
}

//------------------------------------------------------------------------------
double MinSolidAngle(const CellGeometry& cell)
{
  return cell.GetSolidAngles().Min;
}

//------------------------------------------------------------------------------
double MaxSolidAngle(const CellGeometry& cell)
{
  return cell.GetSolidAngles().Max;
}

//------------------------------------------------------------------------------
double EquiangleSkewness(const CellGeometry& cell)
{
  const auto ofFace = [&](int f)
  {
    const double size = cell.GetTopology().GetFaceSize(f);
    const double ideal = Pi * (size - 2) / size;
    const AngleRange& angles = cell.GetFaceAngles(f);
    return std::max((angles.Max - ideal) / (Pi - ideal), (ideal - angles.Min) / ideal);
  };
  return OverFaces(cell, ofFace, std::greater<double>());
}
}
