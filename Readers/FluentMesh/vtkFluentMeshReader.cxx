// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentMeshReader.h"

#include "FluentMeshReading.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkFluentMeshReader);

//------------------------------------------------------------------------------
vtkFluentMeshReader::vtkFluentMeshReader()
  : vtkMeshFileReader(camaron::IsFluentMesh)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkFluentMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "JoinSplitFaces: " << this->JoinSplitFaces << '\n';
}

//------------------------------------------------------------------------------
int vtkFluentMeshReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkMultiBlockDataSet");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkFluentMeshReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkInformation* info = outputVector->GetInformationObject(1))
  {
    info->Set(CAN_HANDLE_PIECE_REQUEST(), 1); // series readers may request the first output only
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFluentMeshReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Both outputs show the piece that is requested of one of them.
  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  const bool fromBoundaries =
    request->Has(vtkSDDP::FROM_OUTPUT_PORT()) && request->Get(vtkSDDP::FROM_OUTPUT_PORT()) == 1;
  vtkInformation* const asked = outputVector->GetInformationObject(fromBoundaries ? 1 : 0);
  vtkInformation* const other = outputVector->GetInformationObject(fromBoundaries ? 0 : 1);
  for (vtkInformationIntegerKey* key : { vtkSDDP::UPDATE_PIECE_NUMBER(),
         vtkSDDP::UPDATE_NUMBER_OF_PIECES(), vtkSDDP::UPDATE_NUMBER_OF_GHOST_LEVELS() })
  {
    if (other)
    {
      other->CopyEntry(asked, key);
    }
  }
  this->Boundaries = vtkMultiBlockDataSet::GetData(outputVector, 1);
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  this->Boundaries = nullptr;
  return result;
}

//------------------------------------------------------------------------------
bool vtkFluentMeshReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  camaron::FluentOptions options;
  options.JoinSplitFaces = this->JoinSplitFaces;
  return camaron::ReadFluentMesh(
    path, request, output, this->Boundaries, warnings, error, progress, options);
}
