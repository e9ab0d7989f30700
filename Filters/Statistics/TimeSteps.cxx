// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace camaron
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
void TimeSteps::Find(
  bool isOn, vtkInformationVector** inputs, int numberOfInputs, vtkInformationVector* outputs)
{
  this->IsOn = isOn;
  this->Times.clear();
  this->Step = 0;
  vtkInformation* source = nullptr;
  for (int port = 0; port < numberOfInputs && !source; ++port)
  {
    vtkInformation* info = inputs[port]->GetInformationObject(0);
    source = info && info->Length(Pipeline::TIME_STEPS()) > 0 ? info : nullptr;
  }
  if (isOn && source)
  {
    this->Times.resize(source->Length(Pipeline::TIME_STEPS()));
    source->Get(Pipeline::TIME_STEPS(), this->Times.data());
  }
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    if (isOn)
    {
      info->Remove(Pipeline::TIME_STEPS());
      info->Remove(Pipeline::TIME_RANGE());
    }
    else if (source)
    {
      info->CopyEntry(source, Pipeline::TIME_STEPS());
      info->CopyEntry(source, Pipeline::TIME_RANGE());
    }
  }
}

//------------------------------------------------------------------------------
void TimeSteps::Request(vtkInformationVector** inputs, int numberOfInputs) const
{
  for (int port = 0; port < numberOfInputs && !this->Times.empty(); ++port)
  {
    if (vtkInformation* info = inputs[port]->GetInformationObject(0))
    {
      info->Set(Pipeline::UPDATE_TIME_STEP(), this->Times[this->Step]);
    }
  }
}

//------------------------------------------------------------------------------
std::optional<double> TimeSteps::GetTime() const
{
  if (!this->IsOn)
  {
    return std::nullopt;
  }
  return this->Times.empty() ? std::numeric_limits<double>::quiet_NaN() : this->Times[this->Step];
}

//------------------------------------------------------------------------------
double TimeSteps::GetProgress(double share) const
{
  const auto size = static_cast<double>(std::max<std::size_t>(this->Times.size(), 1));
  return (static_cast<double>(this->Step) + share) / size;
}

//------------------------------------------------------------------------------
bool TimeSteps::CheckAbortOnAllRanks(vtkInformation* request)
{
  if (this->IsLast())
  {
    this->Stop(request);
    return false;
  }
  ++this->Step;
  request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
  return true;
}

//------------------------------------------------------------------------------
void TimeSteps::Stop(vtkInformation* request)
{
  request->Remove(Pipeline::CONTINUE_EXECUTING());
  this->Step = 0;
}

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
