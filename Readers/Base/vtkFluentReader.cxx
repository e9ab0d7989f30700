// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFluentReader.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

//------------------------------------------------------------------------------
vtkFluentReader::vtkFluentReader(IsFormat is, ReadFormat read)
  : vtkMeshFileReader(is)
  , Read(read)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkFluentReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkMultiBlockDataSet");
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkFluentReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkInformation* info = outputVector->GetInformationObject(1))
  {
    info->Set(CAN_HANDLE_PIECE_REQUEST(), 1); // series readers may request the first output only
  }
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFluentReader::RequestData(
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
bool vtkFluentReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  vtkMultiBlockDataSet* const boundaries = this->Boundaries;
  if (boundaries)
  {
    boundaries->Initialize();
  }
  const bool good = this->ReadZones(path, request, output, boundaries, warnings, error, progress);
  if (!good && boundaries)
  {
    boundaries->Initialize();
  }
  return good;
}

//------------------------------------------------------------------------------
bool vtkFluentReader::ReadZones(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, camaron::Warnings& warnings,
  camaron::ScanError& error, const camaron::Progress& progress)
{
  return this->Read(path, request, grid, boundaries, warnings, error, progress);
}
