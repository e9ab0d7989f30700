// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/PointGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camaron
{
namespace
{
constexpr double RoundingUnits = 8; // in machine epsilons
/// Few points have neighbors of their cube within reach, and the indices of cubes are exact.
constexpr double CubesPerReach = 8;
}

//------------------------------------------------------------------------------
PointGrid::PointGrid(double tolerance, bool hasFloats, double largest)
  : Tolerance(tolerance)
  , Rounding(RoundingUnits *
      (hasFloats ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon()))
  , Reach(std::max(tolerance, this->Rounding * largest))
  , Cube(this->Reach > 0 ? CubesPerReach * this->Reach : 1)
{
}

//------------------------------------------------------------------------------
double PointGrid::GetSize(const Vector& place)
{
  const double sum = std::abs(place.X) + std::abs(place.Y) + std::abs(place.Z); // NaN if one is
  return std::isfinite(sum) ? std::max({ std::abs(place.X), std::abs(place.Y), std::abs(place.Z) })
                            : sum;
}

//------------------------------------------------------------------------------
bool PointGrid::AreNear(const Vector& a, const Vector& b) const
{
  const double reach =
    this->Tolerance > 0 ? this->Tolerance : this->Rounding * std::max(GetSize(a), GetSize(b));
  return !(Norm(b - a) > reach);
}

//------------------------------------------------------------------------------
Vector PointGrid::GetCube(const Vector& place) const
{
  return { std::floor(place.X / this->Cube), std::floor(place.Y / this->Cube),
    std::floor(place.Z / this->Cube) };
}

//------------------------------------------------------------------------------
std::uint64_t PointGrid::Hash(const Vector& cube)
{
  std::uint64_t hash = 0;
  for (const double number : { cube.X, cube.Y, cube.Z })
  {
    // The multiplier of Knuth's linear congruential generator MMIX.
    hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(number))) *
      6364136223846793005ull;
    hash ^= hash >> 32;
  }
  return hash;
}
}
