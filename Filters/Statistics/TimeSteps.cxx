// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>

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
}
