// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearColors.h"

#include "vtkQualityColors.h"

#include "vtkColorTransferFunction.h"

#include <algorithm>
#include <cmath>

namespace camaron
{
namespace
{
// A point of a map: value, red, green, blue, midpoint and sharpness.
std::array<double, 6> GetPoint(vtkColorTransferFunction* map, int point)
{
  std::array<double, 6> values;
  map->GetNodeValue(point, values.data());
  return values;
}
}

//------------------------------------------------------------------------------
Range FindAcceptableRange(vtkColorTransferFunction* map)
{
  Range inside = { { Unlimited[1], Unlimited[0] } };
  bool isBeyondLow = false, isBeyondHigh = false;
  for (int i = 0; map && i < map->GetSize(); ++i)
  {
    const auto point = GetPoint(map, i);
    const bool isBeyond = vtkQualityColors::IsBeyond(point.data() + 1);
    isBeyondLow = isBeyondLow || (isBeyond && inside[0] > inside[1]);
    isBeyondHigh = isBeyond;
    if (!isBeyond)
    {
      inside = { { std::min(inside[0], point[0]), point[0] } };
    }
  }
  return { { isBeyondLow ? inside[0] : Unlimited[0], isBeyondHigh ? inside[1] : Unlimited[1] } };
}

//------------------------------------------------------------------------------
bool LinearColors::IsLinear(vtkColorTransferFunction* map)
{
  bool isLinear = map->GetSize() > 0 && map->GetColorSpace() == VTK_CTF_RGB &&
    map->GetScale() == VTK_CTF_LINEAR && map->GetClamping() && !map->GetUseAboveRangeColor();
  for (int i = 0; isLinear && i < map->GetSize(); ++i)
  {
    const auto point = GetPoint(map, i);
    isLinear = point[4] == 0.5 && point[5] == 0;
  }
  return isLinear;
}

//------------------------------------------------------------------------------
LinearColors::LinearColors(vtkColorTransferFunction* map)
{
  for (int i = 0; i < map->GetSize(); ++i)
  {
    const auto point = GetPoint(map, i);
    this->Values.push_back(point[0]);
    this->Colors.push_back({ { point[1], point[2], point[3] } });
  }
  map->GetNanColor(this->Undefined.data());
  this->Below = this->Colors.front();
  if (map->GetUseBelowRangeColor())
  {
    map->GetBelowRangeColor(this->Below.data());
  }
}

//------------------------------------------------------------------------------
void LinearColors::Map(double value, unsigned char rgba[4]) const
{
  // The first point that is not below the value.
  const auto next = std::lower_bound(this->Values.begin(), this->Values.end(), value);
  const auto last = static_cast<std::size_t>(next - this->Values.begin());
  Color color = this->Undefined;
  if (!std::isnan(value) && (next == this->Values.begin() || next == this->Values.end()))
  {
    color = next == this->Values.end() ? this->Colors[last - 1]
      : value < this->Values.front()   ? this->Below
                                       : this->Colors.front();
  }
  else if (!std::isnan(value))
  {
    const Color &from = this->Colors[last - 1], &to = this->Colors[last];
    const double share = (value - *(next - 1)) / (*next - *(next - 1));
    for (int channel = 0; channel < 3; ++channel)
    {
      color[channel] = (1 - share) * from[channel] + share * to[channel];
    }
  }
  constexpr double rounding = 0.5, most = 255;
  for (int channel = 0; channel < 3; ++channel)
  {
    rgba[channel] = static_cast<unsigned char>(color[channel] * most + rounding);
  }
  rgba[3] = static_cast<unsigned char>(most);
}
}
