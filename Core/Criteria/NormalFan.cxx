// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/NormalFan.h"

#include "Base/Number.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace camaron
{
namespace
{
constexpr double Tolerance = 1e-12; // in radians; above the rounding of azimuths

//------------------------------------------------------------------------------
std::tuple<double, double, double> GetComponents(const Vector& v)
{
  return { v.X, v.Y, v.Z };
}
}

//------------------------------------------------------------------------------
double GetAngle(const Vector& a, const Vector& b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b));
}

//------------------------------------------------------------------------------
NormalFan::NormalFan(const Vector& a, const Vector& b)
{
  const bool isUp = GetComponents(a) < GetComponents(b);
  this->Edge = Unit(isUp ? b - a : a - b); // zero if the points coincide
  const Vector e{ std::abs(this->Edge.X), std::abs(this->Edge.Y), std::abs(this->Edge.Z) };
  const Vector axis = e.X <= e.Y && e.X <= e.Z ? Vector{ 1, 0, 0 }
    : e.Y <= e.Z                               ? Vector{ 0, 1, 0 }
                                               : Vector{ 0, 0, 1 };
  this->X = Unit(axis - Dot(axis, this->Edge) * this->Edge);
  this->Y = Norm2(this->Edge) > 0 ? Cross(this->Edge, this->X) : Vector{ 0, 1, 0 };
}

//------------------------------------------------------------------------------
double NormalFan::GetTilt(const Vector& normal) const
{
  return std::abs(
    std::atan2(Dot(normal, this->Edge), std::hypot(Dot(normal, this->X), Dot(normal, this->Y))));
}

//------------------------------------------------------------------------------
NormalFan::Entry NormalFan::Place(const Vector& normal, Index cell) const
{
  return { std::atan2(Dot(normal, this->Y), Dot(normal, this->X)), normal, cell };
}

//------------------------------------------------------------------------------
void NormalFan::Add(const Vector& normal, Index cell)
{
  if (!(Norm2(normal) > 0))
  {
    return;
  }
  this->Entries.push_back(this->Place(normal, cell));
  this->MaxTilt = std::max(this->MaxTilt, this->GetTilt(normal));
}

//------------------------------------------------------------------------------
void NormalFan::Sort()
{
  std::sort(this->Entries.begin(), this->Entries.end(),
    [](const Entry& a, const Entry& b)
    {
      return a.Azimuth != b.Azimuth ? a.Azimuth < b.Azimuth
                                    : GetComponents(a.Normal) < GetComponents(b.Normal);
    });
}

//------------------------------------------------------------------------------
// Tries normals by their distance around the edge from the direction of the normal, or from the
// opposite one, until no further one can be better.
double NormalFan::Search(const Vector& normal, Index cell, bool isOpposite) const
{
  const std::size_t size = this->Entries.size();
  if (size == 0)
  {
    return -1;
  }
  const double azimuth = this->Place(isOpposite ? -normal : normal, cell).Azimuth,
               tilt = this->GetTilt(normal) + this->MaxTilt - Tolerance;
  const auto getDistance = [&](std::size_t i)
  {
    const double difference = std::abs(this->Entries[i].Azimuth - azimuth);
    return std::min(difference, 2 * Pi - difference);
  };
  const auto start = std::lower_bound(this->Entries.begin(), this->Entries.end(), azimuth,
    [](const Entry& entry, double wanted) { return entry.Azimuth < wanted; });
  auto up = static_cast<std::size_t>(start - this->Entries.begin()) % size;
  std::size_t down = (up + size - 1) % size;
  double chosen = -1, best = 2 * Pi;
  for (std::size_t tried = 0; tried < size; ++tried)
  {
    const double above = getDistance(up), below = getDistance(down);
    if (std::min(above, below) - tilt >= best)
    {
      break;
    }
    const Entry& entry = this->Entries[above <= below ? up : down];
    (above <= below ? up : down) = above <= below ? (up + 1) % size : (down + size - 1) % size;
    const double angle = GetAngle(normal, entry.Normal), score = isOpposite ? Pi - angle : angle;
    if (score < best && entry.Cell != cell)
    {
      chosen = angle;
      best = score;
    }
  }
  return chosen;
}
}
