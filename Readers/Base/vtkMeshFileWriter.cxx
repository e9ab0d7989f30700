// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshFileWriter.h"

#include "Base/Parallel.h"
#include "Base/Progress.h"
#include "Base/Text.h"
#include "Intake/CellMesh/OutputWarnings.h"
#include "PieceGathering.h"
#include "Scan/MappedFile.h"
#include "Scan/ScanError.h"
#include "UpstreamFiles.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMetaReader.h"
#include "vtkMultiProcessController.h"
#include "vtkPartitionedDataSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLPUnstructuredDataReader.h"

#include <algorithm>
#include <new>
#include <stdexcept>

using vtkSDDP = vtkStreamingDemandDrivenPipeline;

vtkCxxSetObjectMacro(vtkMeshFileWriter, Controller, vtkMultiProcessController);

namespace
{
//------------------------------------------------------------------------------
// The name of a file of a series: the number is inserted before the extension.
std::string AddNumber(const std::string& path, int number)
{
  const std::size_t name = path.size() - camaron::GetFileName(path).size();
  const std::size_t dot = path.find_last_of('.');
  const std::size_t at = dot == std::string::npos || dot < name ? path.size() : dot;
  return path.substr(0, at) + "_" + std::to_string(number) + path.substr(at);
}

//------------------------------------------------------------------------------
// Number of pieces if the input comes directly from a parallel XML file; else 1.
int CountFilePieces(vtkAlgorithm* writer)
{
  vtkAlgorithm* input = writer->GetInputAlgorithm();
  while (input && input->IsA("vtkPVPostFilter")) // ParaView adds this after every source
  {
    input = input->GetNumberOfInputConnections(0) > 0 ? input->GetInputAlgorithm() : nullptr;
  }
  auto* const series = vtkMetaReader::SafeDownCast(input);
  auto* const reader =
    vtkXMLPUnstructuredDataReader::SafeDownCast(series ? series->GetReader() : input);
  return reader ? std::max(1, reader->GetNumberOfPieces()) : 1;
}

//------------------------------------------------------------------------------
// The error code of the nearest upstream algorithm that has one.
unsigned long FindErrorUpstream(vtkAlgorithm* algorithm)
{
  unsigned long code = vtkErrorCode::NoError;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port) && !code; ++i)
    {
      vtkAlgorithm* const input = algorithm->GetInputAlgorithm(port, i);
      auto* const series = vtkMetaReader::SafeDownCast(input);
      code =
        series && series->GetReader() ? series->GetReader()->GetErrorCode() : input->GetErrorCode();
      code = code ? code : FindErrorUpstream(input);
    }
  }
  return code;
}
}

//------------------------------------------------------------------------------
vtkMeshFileWriter::vtkMeshFileWriter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkMeshFileWriter::~vtkMeshFileWriter()
{
  this->SetController(nullptr);
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkMeshFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkMeshFileWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (info && request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    this->NumberOfTimeSteps =
      info->Has(vtkSDDP::TIME_STEPS()) ? info->Length(vtkSDDP::TIME_STEPS()) : 0;
    const int processes = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
    this->NumberOfPieces = (CountFilePieces(this) + processes - 1) / processes;
    this->Pieces->Initialize();
    return 1;
  }
  if (info && request->Has(vtkSDDP::REQUEST_UPDATE_EXTENT()))
  {
    if (this->Controller || this->NumberOfPieces > 1)
    {
      const int process = this->Controller ? this->Controller->GetLocalProcessId() : 0;
      const int processes = this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
      const int piece = static_cast<int>(this->Pieces->GetNumberOfPartitions());
      info->Set(vtkSDDP::UPDATE_PIECE_NUMBER(), process * this->NumberOfPieces + piece);
      info->Set(vtkSDDP::UPDATE_NUMBER_OF_PIECES(), processes * this->NumberOfPieces);
      info->Set(vtkSDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
    if (this->WriteTimeSteps && this->TimeStep < this->NumberOfTimeSteps)
    {
      info->Set(vtkSDDP::UPDATE_TIME_STEP(), info->Get(vtkSDDP::TIME_STEPS())[this->TimeStep]);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkMeshFileWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector*)
{
  if (this->TimeStep == 0)
  {
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    vtkErrorMacro("There is no input to write.");
    return 0;
  }
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("The name of the file to write is not set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 1;
  }

  if (this->NumberOfPieces > 1)
  {
    // The reader puts the next piece into the same object.
    const auto piece = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
    piece->ShallowCopy(input);
    const unsigned int size = this->Pieces->GetNumberOfPartitions();
    this->Pieces->SetPartition(size, piece);
    if (static_cast<int>(size) + 1 < this->NumberOfPieces)
    {
      request->Set(vtkSDDP::CONTINUE_EXECUTING(), 1);
      return 1;
    }
    input = this->Pieces;
  }

  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  const bool isSeries = this->WriteTimeSteps && this->NumberOfTimeSteps > 0;
  const std::string path = isSeries ? AddNumber(this->FileName, this->TimeStep) : this->FileName;
  camaron::Warnings warnings;
  try
  {
    if (const auto mesh = camaron::Gather(input, this->Controller, this->HasZones(), warnings))
    {
      this->WriteTo(path, mesh, warnings);
    }
  }
  catch (const std::runtime_error& error)
  {
    vtkErrorMacro(<< camaron::GetFileName(path) << " is not written: " << error.what() << '.');
    this->SetErrorCode(vtkErrorCode::FileFormatError);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< camaron::GetFileName(path)
                  << " is not written: not enough memory to gather the mesh.");
    this->SetErrorCode(camaron::GetVTKErrorCode(camaron::ErrorKind::Memory));
  }
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    // When the other processes continue, the file exists, or they know the error.
    int code = static_cast<int>(this->GetErrorCode());
    this->Controller->Broadcast(&code, 1, 0);
    this->SetErrorCode(static_cast<unsigned long>(code));
  }
  this->Pieces->Initialize();
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  this->WriteTime.Modified();

  const bool isLast = !isSeries || this->TimeStep + 1 >= this->NumberOfTimeSteps ||
    this->GetErrorCode() != vtkErrorCode::NoError;
  this->TimeStep = isLast ? 0 : this->TimeStep + 1;
  if (isLast)
  {
    request->Remove(vtkSDDP::CONTINUE_EXECUTING());
  }
  else
  {
    request->Set(vtkSDDP::CONTINUE_EXECUTING(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkMeshFileWriter::WriteTo(
  const std::string& path, vtkDataSet* mesh, camaron::Warnings& warnings)
{
  const camaron::Progress progress(
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->CheckAbort();
    });
  camaron::ScanError error;
  const std::string name = camaron::GetFileName(path);
  if (mesh->GetNumberOfPoints() == 0 && mesh->GetNumberOfCells() == 0)
  {
    if (const unsigned long code = FindErrorUpstream(this))
    {
      vtkErrorMacro(<< camaron::MakePrintable(name)
                    << " is not written: the upstream filter failed.");
      this->SetErrorCode(code);
      return;
    }
  }
  bool isWritten = false;
  try
  {
    const camaron::InputFiles inputs = camaron::FindUpstreamFiles(this);
    const camaron::InputFiles::Protection protection(inputs);
    camaron::WithThreads(
      [&]
      {
        isWritten =
          (this->AllowRounding ||
            camaron::CheckRoundedCells(mesh, this->GetDigitsOfCoordinates(), path, error)) &&
          this->WriteMesh(path, mesh, warnings, error, progress);
      });
  }
  catch (const std::bad_alloc&)
  {
    error = { camaron::ErrorKind::Memory, name + ": not enough memory to write the mesh" };
  }
  catch (const std::length_error& reason)
  {
    error = { camaron::ErrorKind::Unsupported, name + ": " + reason.what() };
  }
  if (!isWritten && !error)
  {
    this->SetErrorCode(vtkErrorCode::UserError); // aborted
  }
  if (error)
  {
    vtkErrorMacro(<< camaron::MakePrintable(error.Message));
    this->SetErrorCode(camaron::GetVTKErrorCode(error.Kind));
    return;
  }
  for (const std::string& sentence : warnings.GetSentences())
  {
    vtkWarningMacro(<< camaron::MakePrintable(name + ": " + sentence));
  }
}

//------------------------------------------------------------------------------
void vtkMeshFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteTimeSteps: " << this->WriteTimeSteps << "\n";
  os << indent << "AllowRounding: " << this->AllowRounding << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
