// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshSeriesReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkMeshSeriesReader);

using vtkSDDP = vtkStreamingDemandDrivenPipeline;

namespace
{
//------------------------------------------------------------------------------
// Information of the output that a request comes from; of the first if it comes from none.
vtkInformation* GetAsked(vtkInformation* request, vtkInformationVector* outputs)
{
  return outputs->GetInformationObject(
    request->Has(vtkSDDP::FROM_OUTPUT_PORT()) ? request->Get(vtkSDDP::FROM_OUTPUT_PORT()) : 0);
}
}

//------------------------------------------------------------------------------
vtkMeshSeriesReader::vtkMeshSeriesReader()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkMeshSeriesReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestInformation(request, inputVector, outputVector);
  vtkInformation* const asked = GetAsked(request, outputVector);
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* const info = outputVector->GetInformationObject(port);
    if (info != asked)
    {
      info->CopyEntry(asked, vtkSDDP::TIME_STEPS());
      info->CopyEntry(asked, vtkSDDP::TIME_RANGE());
    }
  }
  return result;
}

//------------------------------------------------------------------------------
int vtkMeshSeriesReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  // The executive would set the time last requested of each output, not that of its mesh.
  vtkInformation* const asked = GetAsked(request, outputVector);
  const bool hasTime = asked->Has(vtkSDDP::TIME_RANGE()) && asked->Has(vtkSDDP::UPDATE_TIME_STEP());
  for (int port = 0; hasTime && port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)
      ->GetInformation()
      ->Set(vtkDataObject::DATA_TIME_STEP(), asked->Get(vtkSDDP::UPDATE_TIME_STEP()));
  }
  return result;
}
