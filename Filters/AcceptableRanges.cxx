// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AcceptableRanges.h"

#include "Criteria/Criterion.h"

#include "vtkMath.h"

#include <cmath>
#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
bool IsRangesName(const std::string& name)
{
  return name == GetDefaultRangesName() || FindPreset(name);
}

//------------------------------------------------------------------------------
std::optional<ValueRange> FindAcceptableRange(
  const std::string& name, const std::string& ranges, const std::string& unit)
{
  const Criterion* criterion = FindCriterion(name);
  if (!criterion)
  {
    return std::nullopt;
  }
  ValueRange range;
  if (criterion->HasAcceptableRange())
  {
    range = { criterion->Acceptable[0], criterion->Acceptable[1] };
  }
  if (const Preset* preset = FindPreset(ranges))
  {
    for (const Preset::Rule& rule : preset->Rules)
    {
      if (name == rule.Criterion)
      {
        range = { rule.Acceptable[0], rule.Acceptable[1] };
      }
    }
  }
  if (std::isinf(range.Low) && std::isinf(range.High))
  {
    return std::nullopt;
  }
  if (criterion->Unit == Unit::Angle && unit == criterion->UnitLabel(AngleUnit::Radians))
  {
    range.Low = vtkMath::RadiansFromDegrees(range.Low);
    range.High = vtkMath::RadiansFromDegrees(range.High);
  }
  return range;
}

//------------------------------------------------------------------------------
std::optional<WorstEnd> FindWorstEnd(const std::string& name)
{
  const Criterion* criterion = FindCriterion(name);
  if (!criterion)
  {
    return std::nullopt;
  }
  if (criterion->Better == Better::Neither)
  {
    // A limit on one side tells as well: a volume must be above zero.
    const bool low = std::isfinite(criterion->Acceptable[0]);
    const bool high = std::isfinite(criterion->Acceptable[1]);
    return low == high ? std::nullopt
                       : std::optional<WorstEnd>(low ? WorstEnd::Smallest : WorstEnd::Largest);
  }
  return criterion->Better == Better::Smaller ? WorstEnd::Largest : WorstEnd::Smallest;
}

//------------------------------------------------------------------------------
std::optional<WorstEnd> FindWorstEnd(const std::string& name, const std::string& choice)
{
  if (choice == "By criterion")
  {
    return FindWorstEnd(name);
  }
  if (choice == "Largest" || choice == "Smallest")
  {
    return choice == "Largest" ? WorstEnd::Largest : WorstEnd::Smallest;
  }
  throw std::invalid_argument(
    "Worst Values is By criterion, Largest or Smallest, not '" + choice + "'");
}
}
