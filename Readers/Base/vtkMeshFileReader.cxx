// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeshFileReader.h"

#include "Base/Text.h"
#include "Intake/FaceMesh/FaceMesh.h"
#include "Intake/Pieces/PieceExchange.h"
#include "Intake/Write/InputFiles.h"
#include "MergedWarnings.h"
#include "PointRanges.h"
#include "Scan/FileStates.h"
#include "Scan/MappedFile.h"

#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <new>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// Makes all processes fail if one has, with the error of the first, which may be empty.
void ShareFailure(vtkMultiProcessController* processes, bool& hasFailed, camaron::ScanError& error)
{
  const int none = processes->GetNumberOfProcesses();
  const int mine = hasFailed ? processes->GetLocalProcessId() : none;
  int first = none;
  processes->AllReduce(&mine, &first, 1, vtkCommunicator::MIN_OP);
  hasFailed = first < none;
  if (!hasFailed)
  {
    return;
  }
  vtkMultiProcessStream stream;
  stream << static_cast<int>(error.Kind) << error.Message;
  processes->Broadcast(stream, first);
  if (first != mine)
  {
    int kind;
    stream >> kind >> error.Message;
    error.Kind = static_cast<camaron::ErrorKind>(kind);
  }
}

//------------------------------------------------------------------------------
// Collects the warnings of all processes on process 0 and clears them on the others.
void ShareWarnings(vtkMultiProcessController* processes, camaron::Warnings& warnings)
{
  vtkMultiProcessStream stream;
  stream << static_cast<int>(warnings.Get().size());
  for (const camaron::Warning& one : warnings.Get())
  {
    stream << one.What << static_cast<vtkTypeInt64>(one.Found.Count)
           << static_cast<vtkTypeInt64>(one.Found.First) << one.One << one.Many << one.Note;
  }
  std::vector<vtkMultiProcessStream> all;
  processes->Gather(stream, all, 0);
  std::vector<camaron::Warnings> ofProcesses;
  for (vtkMultiProcessStream& process : all)
  {
    int size = 0;
    process >> size;
    ofProcesses.emplace_back();
    for (int i = 0; i < size; ++i)
    {
      camaron::Warning one;
      vtkTypeInt64 count = 0, first = 0;
      process >> one.What >> count >> first >> one.One >> one.Many >> one.Note;
      one.Found = { static_cast<vtkIdType>(count), static_cast<vtkIdType>(first) };
      ofProcesses.back().Add(std::move(one));
    }
  }
  warnings = camaron::MergeWarnings(ofProcesses);
}

//------------------------------------------------------------------------------
// Whether all processes saw the files in the same state as this one.
bool HaveReadTheSame(vtkMultiProcessController* processes, const camaron::FileStates::State& mine)
{
  constexpr int Size = 3;
  const long long own[Size] = { mine.Place, mine.Size, mine.Identity };
  const auto count = static_cast<std::size_t>(processes->GetNumberOfProcesses());
  std::vector<long long> all(Size * count);
  processes->AllGather(own, all.data(), Size);
  std::vector<camaron::FileStates::State> states;
  for (std::size_t i = 0; i < all.size(); i += Size)
  {
    states.push_back({ all[i], all[i + 1], all[i + 2] });
  }
  return camaron::FileStates::AreSame(states);
}

//------------------------------------------------------------------------------
// Process 0 warns about points with non-finite coordinates in all pieces.
void WarnOfPoints(vtkUnstructuredGrid* piece, bool areFinite, vtkMultiProcessController* processes,
  camaron::Warnings& warnings)
{
  camaron::Tally bad = areFinite ? camaron::Tally() : camaron::FindNotFinitePoints(piece);
  if (processes)
  {
    const camaron::Tally mine = bad;
    const vtkIdType first = mine.Count > 0 ? mine.First : VTK_ID_MAX;
    processes->Reduce(&mine.Count, &bad.Count, 1, vtkCommunicator::SUM_OP, 0);
    processes->Reduce(&first, &bad.First, 1, vtkCommunicator::MIN_OP, 0);
  }
  if (!processes || processes->GetLocalProcessId() == 0)
  {
    warnings.Add(bad, "point", "points", "with a coordinate that is not finite",
      processes ? " (counted from 0; points on several processes are counted by each)"
                : camaron::FromZero);
  }
}
}

//------------------------------------------------------------------------------
vtkMeshFileReader::vtkMeshFileReader(IsFormat is, ReadFormat read)
  : Is(is)
  , Read(read)
  , FilesRead(std::make_unique<camaron::InputFiles>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkMeshFileReader::~vtkMeshFileReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkMeshFileReader::CanReadFile(const char* fileName)
{
  try
  {
    return fileName && this->Is(fileName) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 1; // reading it reports the lack of memory; ParaView would only say that it knows no
              // reader
  }
}

//------------------------------------------------------------------------------
bool vtkMeshFileReader::ReadMesh(const std::string& path, const camaron::PieceRequest& request,
  vtkUnstructuredGrid* output, camaron::Warnings& warnings, camaron::ScanError& error,
  const camaron::Progress& progress)
{
  return this->Read(
    path, request, output, warnings, error, progress, camaron::TextLines::DefaultChunk);
}

//------------------------------------------------------------------------------
int vtkMeshFileReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(info);
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("The name of the file to read is not set.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 1;
  }

  using vtkSDDP = vtkStreamingDemandDrivenPipeline;
  camaron::PieceRequest request;
  if (info->Has(vtkSDDP::UPDATE_NUMBER_OF_PIECES()))
  {
    request.Piece = info->Get(vtkSDDP::UPDATE_PIECE_NUMBER());
    request.NumberOfPieces = info->Get(vtkSDDP::UPDATE_NUMBER_OF_PIECES());
    request.GhostLevels = info->Get(vtkSDDP::UPDATE_NUMBER_OF_GHOST_LEVELS());
  }
  const camaron::Progress progress(
    [this](double fraction)
    {
      // Data read from a file that has changed is useless.
      const bool isOfUse = !camaron::MappedFile::HasAnyChanged();
      this->UpdateProgress(fraction);
      return isOfUse && !this->CheckAbort();
    });

  camaron::Warnings warnings;
  camaron::ScanError error;
  this->SetErrorCode(vtkErrorCode::NoError);
  const camaron::FileStates states;
  this->ReadMesh(this->FileName, request, output, warnings, error, progress);
  for (const std::string& path : states.GetPaths())
  {
    this->FilesRead->Add(path);
  }
  if (!error)
  {
    progress.Report(1); // small files may not have reported any progress
  }
  if (progress.IsStopped() && error.Kind != camaron::ErrorKind::Changed)
  {
    // An error of an earlier attempt, such as another dialect, is not the reason.
    error = camaron::ScanError();
  }
  bool hasFailed = error || progress.IsStopped();
  vtkMultiProcessController* const processes = camaron::FindProcesses(request);
  if (processes)
  {
    ShareFailure(processes, hasFailed, error);
    if (!hasFailed && !HaveReadTheSame(processes, states.Get()))
    {
      hasFailed = true;
      error = { camaron::ErrorKind::Changed,
        camaron::GetFileName(this->FileName) +
          ": cannot read the file: another program changed it before all processes had opened it; "
          "read it again "
          "when it is complete" };
    }
  }
  if (!hasFailed)
  {
    if (processes)
    {
      ShareWarnings(processes, warnings);
    }
    WarnOfPoints(output, camaron::FindPointRanges(output), processes, warnings);
    const std::string name = camaron::GetFileName(this->FileName);
    for (const std::string& sentence : warnings.GetSentences())
    {
      vtkWarningMacro(<< camaron::MakePrintable(name + ": " + sentence));
    }
    return 1;
  }
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
  if (error && (!processes || request.Piece == 0))
  {
    vtkErrorMacro(<< camaron::MakePrintable(error.Message));
  }
  this->SetErrorCode(camaron::GetVTKErrorCode(error.Kind));
  return 1;
}

//------------------------------------------------------------------------------
void vtkMeshFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
