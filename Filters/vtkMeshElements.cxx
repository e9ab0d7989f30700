// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshElements.h"

#include "Elements/MeshEdges.h"
#include "Elements/MeshFaces.h"
#include "MeshInput.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkMeshElements);

//------------------------------------------------------------------------------
vtkMeshElements::vtkMeshElements()
{
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
void vtkMeshElements::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FaceCriteria: " << this->FaceCriteria << '\n';
  os << indent << "AngleUnits: " << (this->AngleUnits == DEGREES ? "degrees" : "radians") << '\n';
}

//------------------------------------------------------------------------------
int vtkMeshElements::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshElements::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  if (outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshElements::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* outputs[3];
  for (int port = 0; port < 3; ++port)
  {
    outputs[port] = vtkPolyData::GetData(outputVector, port);
  }
  camaron::EvaluationOptions options;
  options.Angles =
    this->AngleUnits == DEGREES ? camaron::AngleUnit::Degrees : camaron::AngleUnit::Radians;
  try
  {
    const vtkSmartPointer<vtkDataSet> mesh = camaron::AsMesh(vtkDataSet::GetData(inputVector[0]));
    if (vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray())
    {
      options.Ghosts = ghosts->GetPointer(0);
    }
    const camaron::MeshTopology topology(mesh);
    const auto goesOn = [this](double done)
    {
      this->UpdateProgress(done);
      return !this->CheckAbort();
    };
    camaron::MakeFaces(mesh, topology, options, this->FaceCriteria, outputs[0]);
    if (goesOn(0.5))
    {
      camaron::MakeEdges(mesh, topology, options, outputs[1]);
    }
    if (goesOn(0.8))
    {
      camaron::MakeVertices(mesh, topology, options, outputs[2]);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The elements of the mesh cannot be taken: " << error.what() << '.');
    for (vtkPolyData* output : outputs)
    {
      output->Initialize();
    }
    return 0;
  }
  return 1;
}
