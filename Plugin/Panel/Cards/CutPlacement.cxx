// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CutPlacement.h"

#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camaron
{
namespace
{
constexpr double LeastSize = 1e-6;  // of the diagonal of the bounds
constexpr double LeastShare = 1e-4; // of a box, whose proportions would get lost

using Triple = std::array<double, 3>;

//------------------------------------------------------------------------------
Triple ToTriple(const QVariant& value)
{
  const QVariantList numbers = value.toList();
  return { numbers.value(0).toDouble(), numbers.value(1).toDouble(), numbers.value(2).toDouble() };
}

//------------------------------------------------------------------------------
QVariantList ToList(const Triple& triple)
{
  return { triple[0], triple[1], triple[2] };
}

//------------------------------------------------------------------------------
double Dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

//------------------------------------------------------------------------------
Triple GetLengths(const CutBounds& bounds)
{
  return { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] };
}

//------------------------------------------------------------------------------
double GetDiagonal(const CutBounds& bounds)
{
  const Triple lengths = GetLengths(bounds);
  return std::hypot(lengths[0], lengths[1], lengths[2]);
}

//------------------------------------------------------------------------------
// The normal of a plane with length 1, or its opposite: toward larger coordinates.
Triple GetDirection(const CutValues& plane)
{
  Triple direction = ToTriple(plane["Normal"]);
  double length = std::hypot(direction[0], direction[1], direction[2]);
  const double largest = *std::max_element(direction.begin(), direction.end(),
    [](double a, double b) { return std::abs(a) < std::abs(b); });
  length = largest < 0 ? -length : length;
  for (double& component : direction)
  {
    component = length != 0 ? component / length : 0;
  }
  return direction;
}

//------------------------------------------------------------------------------
// Where the bounds begin and end along a direction.
std::array<double, 2> GetExtent(const CutBounds& bounds, const Triple& direction)
{
  std::array<double, 2> extent = {};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double a = direction[i] * bounds[2 * i], b = direction[i] * bounds[2 * i + 1];
    extent[0] += std::min(a, b);
    extent[1] += std::max(a, b);
  }
  return extent;
}

//------------------------------------------------------------------------------
double GetBoxShare(const CutBounds& bounds, const CutValues& values)
{
  const Triple scale = ToTriple(values["Scale"]), lengths = GetLengths(bounds);
  double share = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    share = std::max(share, lengths[i] > 0 ? scale[i] / lengths[i] : 0);
  }
  return share;
}
}

//------------------------------------------------------------------------------
CutValues MakeCut(const QString& shape, const CutBounds& bounds, int axis)
{
  const Triple lengths = GetLengths(bounds);
  const double least = LeastSize * GetDiagonal(bounds);
  const Triple center = { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
    (bounds[4] + bounds[5]) / 2 };
  if (shape == "Plane")
  {
    auto along = static_cast<std::size_t>(std::max(0, axis));
    if (axis < 0 || !(lengths[along] > 0))
    {
      along = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
    }
    Triple normal = {};
    normal[along] = 1;
    return { { "Origin", ToList(center) }, { "Normal", ToList(normal) } };
  }
  if (shape == "CuttingSphere")
  {
    return { { "Center", ToList(center) }, { "Radius", GetDiagonal(bounds) / 2 } };
  }
  Triple scale = lengths;
  std::transform(scale.begin(), scale.end(), scale.begin(),
    [least](double length) { return std::max(length, least); });
  return { { "Position", QVariantList{ bounds[0], bounds[2], bounds[4] } },
    { "Scale", ToList(scale) } };
}

//------------------------------------------------------------------------------
double GetCutShare(const QString& shape, const CutBounds& bounds, const CutValues& values)
{
  if (shape == "Plane")
  {
    const Triple direction = GetDirection(values);
    const std::array<double, 2> extent = GetExtent(bounds, direction);
    const double place = Dot(direction, ToTriple(values["Origin"]));
    return extent[1] > extent[0] ? (place - extent[0]) / (extent[1] - extent[0]) : 0;
  }
  if (shape == "CuttingSphere")
  {
    const double diagonal = GetDiagonal(bounds);
    return diagonal > 0 ? 2 * values["Radius"].toDouble() / diagonal : 0;
  }
  return GetBoxShare(bounds, values);
}

//------------------------------------------------------------------------------
CutValues MoveCut(
  const QString& shape, const CutBounds& bounds, const CutValues& values, double share)
{
  CutValues moved = values;
  const double diagonal = GetDiagonal(bounds);
  if (shape == "Plane")
  {
    const Triple direction = GetDirection(values);
    const std::array<double, 2> extent = GetExtent(bounds, direction);
    const double place = extent[0] + share * (extent[1] - extent[0]);
    Triple origin = ToTriple(values["Origin"]);
    const double way = place - Dot(direction, origin);
    for (std::size_t i = 0; i < 3; ++i)
    { // of an axis exactly, without rounding
      origin[i] = direction[i] == 1 ? place : origin[i] + way * direction[i];
    }
    moved["Origin"] = ToList(origin);
  }
  else if (shape == "CuttingSphere")
  {
    moved["Radius"] = std::max(share * diagonal / 2, LeastSize * diagonal);
  }
  else
  {
    const double before = GetBoxShare(bounds, values);
    const bool isEmpty = !(before > 0); // which has no proportions
    Triple scale = isEmpty ? GetLengths(bounds) : ToTriple(values["Scale"]);
    for (double& length : scale)
    {
      length = std::max(
        length * std::max(share, LeastShare) / (isEmpty ? 1 : before), LeastSize * diagonal);
    }
    moved["Scale"] = ToList(scale);
  }
  return moved;
}

//------------------------------------------------------------------------------
QString SpellCut(const QString& shape, const CutBounds& bounds, const CutValues& values)
{
  constexpr int digits = 3;
  if (shape == "Plane")
  {
    const std::array<double, 2> extent = GetExtent(bounds, GetDirection(values));
    const double place = Dot(GetDirection(values), ToTriple(values["Origin"]));
    const bool isRounding = std::abs(place) < 1e-12 * (extent[1] - extent[0]);
    return ShortNumber(isRounding ? 0 : place, digits);
  }
  return shape == "CuttingSphere" ? ShortNumber(values["Radius"].toDouble(), digits)
                                  : FormatPercent(GetBoxShare(bounds, values), 1);
}
}
