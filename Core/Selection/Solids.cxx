// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/Solids.h"

#include "Geometry/Ball.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
double Square(double value)
{
  return value * value;
}

//------------------------------------------------------------------------------
double GetDistanceToInterval(double x, double low, double high)
{
  return std::max({ low - x, 0.0, x - high });
}
}

//------------------------------------------------------------------------------
BallSolid::BallSolid(const Vector& center, double radius, double tolerance)
  : Center(center)
  , SquaredRadius(radius >= 0 ? Square(radius + tolerance) : -1)
{
}

//------------------------------------------------------------------------------
bool BallSolid::MayMeet(const Bounds& box) const
{
  const Vector nearest = { GetDistanceToInterval(this->Center.X, box.Low.X, box.High.X),
    GetDistanceToInterval(this->Center.Y, box.Low.Y, box.High.Y),
    GetDistanceToInterval(this->Center.Z, box.Low.Z, box.High.Z) };
  return Norm2(nearest) <= this->SquaredRadius;
}

//------------------------------------------------------------------------------
bool BallSolid::Meets(const CellBoundary& cell) const
{
  const std::vector<Simplex>& simplices = cell.GetSimplices();
  return std::any_of(simplices.begin(), simplices.end(), [this](const Simplex& simplex)
           { return GetSquaredDistance(this->Center, simplex) <= this->SquaredRadius; }) ||
    (this->SquaredRadius >= 0 && cell.Contains(this->Center));
}

//------------------------------------------------------------------------------
CylinderSolid::CylinderSolid(
  const Vector& center, const Vector& axis, double radius, double tolerance)
  : Center(center)
  , SquaredRadius(radius >= 0 ? Square(radius + tolerance) : -1)
{
  const Vector unit = Unit(axis);
  const Vector other = std::abs(unit.X) < 0.5 ? Vector{ 1, 0, 0 } : Vector{ 0, 1, 0 };
  this->Across[0] = Unit(Cross(unit, other));
  this->Across[1] = Cross(unit, this->Across[0]);
}

//------------------------------------------------------------------------------
bool CylinderSolid::MayMeet(const Bounds& box) const
{
  const double reach = std::sqrt(std::max(0.0, this->SquaredRadius)) + 0.5 * box.GetDiagonal();
  return Norm2(this->Project(box.GetCenter())) <= reach * reach;
}

//------------------------------------------------------------------------------
bool CylinderSolid::Meets(const CellBoundary& cell) const
{
  // An infinite cylinder does not fit into a cell.
  return std::any_of(cell.GetSimplices().begin(), cell.GetSimplices().end(),
    [this](const Simplex& simplex)
    {
      Simplex projected = simplex;
      for (int i = 0; i < simplex.Size; ++i)
      {
        projected.Points[i] = this->Project(simplex.Points[i]);
      }
      return GetSquaredDistance({ 0, 0, 0 }, projected) <= this->SquaredRadius;
    });
}

//------------------------------------------------------------------------------
HalfSpaceSolid::HalfSpaceSolid(
  const std::vector<HalfSpace>& halfSpaces, const Bounds& around, double tolerance)
  : HalfSpaces(halfSpaces)
  , Tolerance(tolerance)
{
  // If it is inside a cell, so is its largest ball.
  const Ball largest =
    FindLargestBall(this->HalfSpaces, 3, { around.GetCenter(), 0.5 * around.GetDiagonal() });
  this->Inside = largest.Center;
  this->HasInside = this->Contains(this->Inside);
}

//------------------------------------------------------------------------------
bool HalfSpaceSolid::MayMeet(const Bounds& box) const
{
  const Vector center = box.GetCenter(), half = 0.5 * (box.High - box.Low);
  return std::all_of(this->HalfSpaces.begin(), this->HalfSpaces.end(),
    [&](const HalfSpace& halfSpace)
    {
      const Vector& n = halfSpace.Normal;
      const double reach = std::abs(n.X) * half.X + std::abs(n.Y) * half.Y + std::abs(n.Z) * half.Z;
      return halfSpace.GetDistance(center) - reach <= this->Tolerance;
    });
}

//------------------------------------------------------------------------------
// Clips the simplex by one half-space after the other.
bool HalfSpaceSolid::Meets(const Simplex& simplex) const
{
  std::vector<Vector> polygon(simplex.Points, simplex.Points + simplex.Size), kept;
  for (const HalfSpace& halfSpace : this->HalfSpaces)
  {
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Vector& point = polygon[i];
      const Vector& next = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      const double distance = halfSpace.GetDistance(point);
      const double nextDistance = halfSpace.GetDistance(next);
      if (distance <= this->Tolerance)
      {
        kept.push_back(point);
      }
      if ((distance < -this->Tolerance && nextDistance > this->Tolerance) ||
        (distance > this->Tolerance && nextDistance < -this->Tolerance))
      {
        kept.push_back(point + (distance / (distance - nextDistance)) * (next - point));
      }
    }
    polygon.swap(kept);
  }
  return !polygon.empty();
}

//------------------------------------------------------------------------------
bool HalfSpaceSolid::Meets(const CellBoundary& cell) const
{
  const std::vector<Simplex>& simplices = cell.GetSimplices();
  return std::any_of(simplices.begin(), simplices.end(),
           [this](const Simplex& simplex) { return this->Meets(simplex); }) ||
    (this->HasInside && cell.Contains(this->Inside));
}
}
