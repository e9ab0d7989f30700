// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArraysOfSteps.h"

#include <algorithm>
#include <sstream>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename Item>
std::string Join(const std::vector<Item>& items)
{
  constexpr std::size_t mostToList = 10;
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(items.size(), mostToList); ++i)
  {
    text << (i > 0 ? ", " : "") << items[i];
  }
  if (items.size() > mostToList)
  {
    text << " and " << items.size() - mostToList << " more";
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
void ArraysOfSteps::Clear()
{
  *this = {};
}

//------------------------------------------------------------------------------
void ArraysOfSteps::Add(const std::optional<double>& time,
  const std::vector<StatisticsArray>& arrays, const std::vector<std::string>& missing,
  bool hasElements)
{
  this->HasElements |= hasElements;
  this->Times.push_back(time.value_or(0));
  for (const StatisticsArray& array : arrays)
  {
    this->TimesOfArrays[array.Name].push_back(this->Times.back());
  }
  for (const std::string& name : missing)
  {
    if (std::find(this->Missing.begin(), this->Missing.end(), name) == this->Missing.end())
    {
      this->Missing.push_back(name);
    }
  }
}

//------------------------------------------------------------------------------
std::string ArraysOfSteps::Describe(const std::string& kind) const
{
  if (!this->HasElements) // nor any values
  {
    return "";
  }
  if (this->TimesOfArrays.empty() && this->Missing.empty())
  {
    return "There are no one-component " + kind +
      " arrays named like a quality criterion: evaluate criteria with Element Quality, or choose "
      "arrays.";
  }
  std::string text;
  std::vector<std::string> nowhere;
  std::copy_if(this->Missing.begin(), this->Missing.end(), std::back_inserter(nowhere),
    [&](const std::string& name) { return this->TimesOfArrays.count(name) == 0; });
  if (!nowhere.empty())
  {
    text = "There are no one-component " + kind + " arrays named: " + Join(nowhere) + ".";
  }
  for (const auto& array : this->TimesOfArrays)
  {
    std::vector<double> without;
    std::set_difference(this->Times.begin(), this->Times.end(), array.second.begin(),
      array.second.end(), std::back_inserter(without));
    if (!without.empty())
    {
      text +=
        (text.empty() ? "" : " ") + array.first + " is missing at time " + Join(without) + ".";
    }
  }
  return text;
}
}
