// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshElements.h"

#include "Elements/MeshElements.h"
#include "MeshInput.h"

#include "vtkDataArraySelection.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkMeshElements);

namespace
{
//------------------------------------------------------------------------------
void AddRows(vtkDataArraySelection* selection, const std::vector<camaron::ElementArray>& rows)
{
  for (const camaron::ElementArray& row : rows)
  {
    selection->AddArray(row.Name, row.IsDefault);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> GetTicked(vtkDataArraySelection* selection)
{
  std::vector<std::string> names;
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    if (selection->GetArraySetting(i))
    {
      names.emplace_back(selection->GetArrayName(i));
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
vtkMeshElements::vtkMeshElements()
{
  this->SetNumberOfOutputPorts(3);
  AddRows(this->FaceArrays, camaron::GetFaceArrays());
  AddRows(this->EdgeArrays, camaron::GetEdgeArrays());
  AddRows(this->VertexArrays, camaron::GetVertexArrays());
}

//------------------------------------------------------------------------------
vtkMeshElements::~vtkMeshElements() = default;

//------------------------------------------------------------------------------
void vtkMeshElements::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const std::pair<const char*, vtkDataArraySelection*> selections[] = {
    { "FaceArrays", this->FaceArrays }, { "EdgeArrays", this->EdgeArrays },
    { "VertexArrays", this->VertexArrays }
  };
  for (const auto& selection : selections)
  {
    os << indent << selection.first << ":\n";
    selection.second->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "WorstOfCells: " << this->WorstOfCells << '\n';
  os << indent << "MergeTolerance: " << this->MergeTolerance << '\n';
  os << indent << "AngleUnits: " << (this->AngleUnits == DEGREES ? "degrees" : "radians") << '\n';
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMeshElements::GetFaceArrays()
{
  return this->FaceArrays;
}

//------------------------------------------------------------------------------
void vtkMeshElements::ClearFaceArrays()
{
  this->FaceArrays->DisableAllArrays();
}

//------------------------------------------------------------------------------
void vtkMeshElements::SetFaceArrayStatus(const char* name, int status)
{
  this->FaceArrays->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMeshElements::GetEdgeArrays()
{
  return this->EdgeArrays;
}

//------------------------------------------------------------------------------
void vtkMeshElements::ClearEdgeArrays()
{
  this->EdgeArrays->DisableAllArrays();
}

//------------------------------------------------------------------------------
void vtkMeshElements::SetEdgeArrayStatus(const char* name, int status)
{
  this->EdgeArrays->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMeshElements::GetVertexArrays()
{
  return this->VertexArrays;
}

//------------------------------------------------------------------------------
void vtkMeshElements::ClearVertexArrays()
{
  this->VertexArrays->DisableAllArrays();
}

//------------------------------------------------------------------------------
void vtkMeshElements::SetVertexArrayStatus(const char* name, int status)
{
  this->VertexArrays->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMeshElements::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->FaceArrays->GetMTime(),
    this->EdgeArrays->GetMTime(), this->VertexArrays->GetMTime() });
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
    const camaron::MeshTopology topology(mesh);
    const camaron::ElementContext context(mesh, topology, options, this->MergeTolerance);
    const auto goesOn = [this](double done)
    {
      this->UpdateProgress(done);
      return !this->CheckAbort();
    };
    camaron::MakeFaces(context, GetTicked(this->FaceArrays), outputs[0]);
    if (goesOn(0.5))
    {
      camaron::MakeEdges(context, GetTicked(this->EdgeArrays), outputs[1]);
    }
    if (goesOn(0.8))
    {
      camaron::MakeVertices(context, GetTicked(this->VertexArrays), outputs[2]);
      if (this->WorstOfCells)
      {
        camaron::AddWorstOfCells(context, outputs[2]);
      }
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
