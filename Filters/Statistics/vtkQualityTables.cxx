// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQualityTables.h"

#include "AcceptableRanges.h"
#include "ControllerReducer.h"
#include "RequestFailure.h"
#include "TimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <sstream>

//------------------------------------------------------------------------------
vtkQualityTables::vtkQualityTables()
  : PresetNames(camaron::MakePresetNames(camaron::GetDefaultRangesName()))
  , Preset(camaron::GetDefaultRangesName())
  , Steps(std::make_unique<camaron::TimeSteps>())
  , Found(std::make_unique<camaron::ArraysOfSteps>())
{
}

//------------------------------------------------------------------------------
vtkQualityTables::~vtkQualityTables() = default;

//------------------------------------------------------------------------------
void vtkQualityTables::AddArray(const char* name)
{
  if (name && name[0])
  {
    this->Arrays.emplace_back(name);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkQualityTables::ClearArrays()
{
  this->Arrays.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkQualityTables::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityTables::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Steps->Find(this->AllTimeSteps, inputVector, this->GetNumberOfInputPorts(), outputVector);
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityTables::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->Steps->Request(inputVector, this->GetNumberOfInputPorts());
  return 1;
}

//------------------------------------------------------------------------------
int vtkQualityTables::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->Steps->IsFirst())
  {
    this->Found->Clear();
    this->MakeColumns(outputVector);
  }
  try
  {
    this->AddRows(inputVector, outputVector);
  }
  catch (...)
  {
    std::ostringstream failure;
    failure << this->GetFailure();
    if (!this->Steps->IsFirst() || !this->Steps->IsLast())
    {
      failure << " at time " << *this->Steps->GetTime();
    }
    this->Steps->Stop(request);
    return camaron::FailRequest(this, failure.str().c_str(), outputVector);
  }
  if (!this->Steps->CheckAbortOnAllRanks(request))
  {
    const bool isRoot = camaron::ControllerReducer().GetProcess() == 0;
    const std::string lacking = this->Found->Describe(this->GetKindOfArrays());
    if (!lacking.empty() && isRoot)
    {
      vtkWarningMacro(<< lacking);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkQualityTables::WarnOfNoGroups(
  const std::string& arrayName, std::size_t numberOfGroups, bool isRoot)
{
  if (this->GroupBy == "Cell array" && numberOfGroups == 1 && isRoot && this->Steps->IsFirst())
  {
    vtkWarningMacro("There are no groups: no one-component cell array named '"
      << arrayName << "' has integers or texts that are not blank.");
  }
}
