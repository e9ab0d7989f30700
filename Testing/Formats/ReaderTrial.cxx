// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderTrial.h"

#include "AllocationMeter.h"
#include "Intake/Rows/TextLines.h"
#include "MeshChecks.h"
#include "ScopedValue.h"
#include "vtkMeshFileReader.h"
#include "vtkMeshFileWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <ctime>

namespace camaron
{
namespace testing
{
namespace
{
//------------------------------------------------------------------------------
// Removes "ERROR: In file, line 7\nvtkFooReader (0x1234): " and the line ends after the message.
void Collect(vtkObject*, unsigned long, void* messages, void* data)
{
  std::string text = static_cast<const char*>(data);
  const std::size_t line = text.find('\n');
  const std::size_t preamble = line == std::string::npos ? line : text.find("): ", line);
  text = preamble == std::string::npos ? text : text.substr(preamble + 3);
  while (!text.empty() && text.back() == '\n')
  {
    text.pop_back();
  }
  static_cast<std::vector<std::string>*>(messages)->push_back(text);
}

//------------------------------------------------------------------------------
void Observe(vtkObject* object, unsigned long event, std::vector<std::string>& messages)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Collect);
  command->SetClientData(&messages);
  object->AddObserver(event, command);
}

//------------------------------------------------------------------------------
/// Aborts a reader at its first or a later progress event.
struct Stopper
{
  int Wait;
  double Last = 0;
  double At = -1;
  bool GoesBack = false;
};

void Stop(vtkObject* object, unsigned long, void* stopper, void* fraction)
{
  auto* reader = static_cast<vtkMeshFileReader*>(object);
  auto& self = *static_cast<Stopper*>(stopper);
  const double now = *static_cast<double*>(fraction);
  self.GoesBack = self.GoesBack || !(now >= self.Last && now <= 1);
  self.Last = now;
  if (--self.Wait == 0 && now < 1)
  {
    self.At = now;
    reader->SetAbortExecuteAndUpdateTime();
  }
}

//------------------------------------------------------------------------------
std::string Quote(const std::string& text)
{
  std::string quoted;
  for (const char letter : text)
  {
    quoted += std::iscntrl(static_cast<unsigned char>(letter)) ? '?' : letter;
  }
  return "'" + quoted + "'";
}

//------------------------------------------------------------------------------
// A message must be one printable line of reasonable length that names a file of the mesh.
std::string FindFaultOfMessage(const std::string& message, const std::string& path)
{
  const std::string file = std::filesystem::path(path).stem().string() + ".";
  const std::size_t name = message.find(file);
  constexpr std::size_t MaxLength = 400; // a few lines of a terminal
  if (name == std::string::npos)
  {
    return "a message does not name the file: " + Quote(message);
  }
  if (message.size() < name + file.size() + 15 || message.size() > MaxLength)
  {
    return "a message is too short or too long: " + Quote(message);
  }
  for (const char letter : message)
  {
    if (std::iscntrl(static_cast<unsigned char>(letter)))
    {
      return "a message has unprintable characters: " + Quote(message);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool IsEmpty(vtkUnstructuredGrid* grid)
{
  return grid->GetNumberOfPoints() == 0 && grid->GetNumberOfCells() == 0 &&
    grid->GetPointData()->GetNumberOfArrays() == 0 && grid->GetCellData()->GetNumberOfArrays() == 0;
}

//------------------------------------------------------------------------------
// How often each byte occurs: the same for files that differ only in the order of points or faces
// of a cell. If a reader orients cells by their volume, the orientation of those without volume may
// change by rounding.
std::array<std::size_t, 256> CountBytes(const std::string& bytes)
{
  std::array<std::size_t, 256> counts{};
  for (const char byte : bytes)
  {
    ++counts[static_cast<unsigned char>(byte)];
  }
  return counts;
}

//------------------------------------------------------------------------------
std::string DescribeDifference(const std::string& before, const std::string& after)
{
  std::size_t at = 0;
  while (at < before.size() && at < after.size() && before[at] == after[at])
  {
    ++at;
  }
  const auto quote = [at](const std::string& bytes) { return Quote(bytes.substr(at, 30)); };
  return " of " + std::to_string(after.size()) + " instead of " + std::to_string(before.size()) +
    " bytes: " + (at < after.size() ? quote(after) : "its end") + " instead of " +
    (at < before.size() ? quote(before) : "its end") + " at byte " + std::to_string(at);
}

//------------------------------------------------------------------------------
vtkIdType CountOwnCells(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
  vtkIdType count = grid->GetNumberOfCells();
  for (vtkIdType cell = 0; ghosts && cell < grid->GetNumberOfCells(); ++cell)
  {
    count -= (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
ReaderTrial::ReaderTrial()
{
  for (const std::filesystem::path& seed : FindMeshFiles(GetFormat().SeedFolder, GetFormat()))
  {
    this->Try(LoadMeshFiles(seed, GetFormat()));
  }
}

//------------------------------------------------------------------------------
Reading ReaderTrial::Read(
  const std::string& path, std::size_t size, int piece, int pieces, int ghostLevels) const
{
  Reading reading;
  const auto fail = [&](const std::string& fault)
  {
    if (reading.Fault.empty())
    {
      reading.Fault = fault;
    }
  };

  const std::clock_t begin = std::clock();
  const AllocationMeter meter;
  const vtkSmartPointer<vtkMeshFileReader> reader = MakeReader();
  Observe(reader, vtkCommand::ErrorEvent, reading.Errors);
  Observe(reader, vtkCommand::WarningEvent, reading.Warnings);
  reader->CanReadFile(path.c_str());
  if (!reading.Errors.empty() || !reading.Warnings.empty())
  {
    fail("CanReadFile has something to say");
  }
  reader->SetFileName(path.c_str());
  reader->UpdatePiece(piece, pieces, ghostLevels);
  const std::size_t peak = meter.GetPeak(), largest = meter.GetLargestRequest();
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  reading.Grid = vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
  reading.ErrorCode = reader->GetErrorCode();

  if (seconds > MaxSeconds)
  {
    fail("reading took " + std::to_string(seconds) + " s");
  }
  const std::size_t allowed = MaxAllocation * size + BaseAllocation;
  if (peak > allowed || largest > allowed)
  {
    fail(std::to_string(peak) + " bytes in use, " + std::to_string(largest) +
      " at once, for files of " + std::to_string(size));
  }
  for (const std::string& message : reading.Errors)
  {
    fail(FindFaultOfMessage(message, path));
  }
  for (const std::string& message : reading.Warnings)
  {
    fail(FindFaultOfMessage(message, path));
  }
  if (!reading.Grid)
  {
    fail("there is no output");
    reading.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  if ((reading.ErrorCode != 0) != !reading.Errors.empty() || reading.Errors.size() > 1)
  {
    fail(std::to_string(reading.Errors.size()) + " messages and code " +
      std::to_string(reading.ErrorCode));
  }
  if (!reading.Errors.empty() && !IsEmpty(reading.Grid))
  {
    fail("the output is not empty after " + Quote(reading.Errors[0]));
  }
  for (int port = 0; port < reader->GetNumberOfOutputPorts(); ++port)
  {
    fail(FindFault(reader->GetOutputDataObject(port)));
  }
  return reading;
}

//------------------------------------------------------------------------------
Reading ReaderTrial::Try(const MeshFiles& files, int laws)
{
  this->Input.Clear();
  const std::string path = this->Input.Write(files);
  const std::size_t size = GetInflatedSize(files);
  Reading reading = this->Read(path, size);
  if (reading.Fault.empty() && (laws & Parallel))
  {
    reading.Fault = this->FindFaultInParallel(path, size, reading);
  }
  if (reading.Fault.empty() && reading.Errors.empty() && (laws & Pieces))
  {
    reading.Fault = this->FindFaultInPieces(path, size, reading);
  }
  if (reading.Fault.empty() && reading.Errors.empty() && (laws & Writing))
  {
    reading.Fault = this->FindFaultInWriting(reading);
  }
  if (reading.Fault.empty() && reading.Errors.empty() && (laws & Stopping))
  {
    reading.Fault = this->FindFaultInStopping(path);
  }
  return reading;
}

//------------------------------------------------------------------------------
std::string ReaderTrial::FindFaultInStopping(const std::string& path) const
{
  for (const int wait : { 1, 4, 16 })
  {
    Stopper stopper{ wait };
    std::vector<std::string> errors, warnings;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Stop);
    command->SetClientData(&stopper);
    const vtkSmartPointer<vtkMeshFileReader> reader = MakeReader();
    Observe(reader, vtkCommand::ErrorEvent, errors);
    Observe(reader, vtkCommand::WarningEvent, warnings);
    reader->AddObserver(vtkCommand::ProgressEvent, command);
    reader->SetFileName(path.c_str());
    reader->Update();
    if (stopper.GoesBack)
    {
      return "progress goes back, or beyond its end";
    }
    if (stopper.At >= 0 &&
      (!errors.empty() ||
        !IsEmpty(vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0)))))
    {
      return "stopped at " + std::to_string(stopper.At) +
        (errors.empty() ? ": there is an output" : ": " + Quote(errors[0]));
    }
  }
  return {};
}

//------------------------------------------------------------------------------
std::string ReaderTrial::FindFaultInParallel(
  const std::string& path, std::size_t size, const Reading& expected) const
{
  // Chunks of a line or two, but not more chunks than useful for finding faults. The memory of many
  // chunks is negligible for chunks of the usual size.
  const ScopedValue<vtkIdType> chunk(
    TextLines::DefaultChunk, std::max<vtkIdType>(16, static_cast<vtkIdType>(size / 1000)));
  const Reading reading = this->Read(path, 64 * size);
  if (!reading.Fault.empty())
  {
    return "in parallel: " + reading.Fault;
  }
  if (reading.Errors != expected.Errors)
  {
    return "in parallel: " + Quote(reading.Errors.empty() ? "no error" : reading.Errors[0]) +
      ", not " + Quote(expected.Errors.empty() ? "no error" : expected.Errors[0]);
  }
  if (reading.Warnings != expected.Warnings)
  {
    return "in parallel: other warnings";
  }
  const std::string difference = FindDifference(expected.Grid, reading.Grid);
  return difference.empty() ? difference : "in parallel: " + difference;
}

//------------------------------------------------------------------------------
std::string ReaderTrial::FindFaultInPieces(
  const std::string& path, std::size_t size, const Reading& whole) const
{
  constexpr int NumberOfPieces = 3;
  vtkIdType cells = 0;
  for (int piece = 0; piece < NumberOfPieces; ++piece)
  {
    const std::string where = "piece " + std::to_string(piece) + ": ";
    const Reading reading = this->Read(path, size, piece, NumberOfPieces, 1);
    if (!reading.Fault.empty() || !reading.Errors.empty())
    {
      return where + (reading.Fault.empty() ? Quote(reading.Errors[0]) : reading.Fault);
    }
    cells += CountOwnCells(reading.Grid);
  }
  return cells == whole.Grid->GetNumberOfCells() ? std::string()
                                                 : "pieces have " + std::to_string(cells) +
      " cells, the whole " + std::to_string(whole.Grid->GetNumberOfCells());
}

//------------------------------------------------------------------------------
std::string ReaderTrial::FindFaultInWriting(const Reading& reading) const
{
  // Writers may change precision or order once, but not again.
  Reading before = reading;
  MeshFiles files;
  for (int round = 0; round < 2; ++round)
  {
    const vtkSmartPointer<vtkMeshFileWriter> writer = MakeWriter();
    if (!writer)
    {
      return {};
    }
    this->Output.Clear();
    const std::filesystem::path path =
      this->Output.GetPath() / ("mesh." + GetFormat().Extensions[0]);
    std::vector<std::string> errors, warnings;
    Observe(writer, vtkCommand::ErrorEvent, errors);
    Observe(writer, vtkCommand::WarningEvent, warnings);
    writer->SetController(nullptr);
    writer->SetInputData(before.Grid);
    writer->SetFileName(path.c_str());
    const bool good = writer->Write() == 1 && errors.empty();
    if (!good)
    {
      // Data that a format cannot store is refused, but not if it was just read from it.
      const std::string fault = round > 0
        ? "the writer refuses what it wrote: " + Quote(errors.at(0))
        : errors.size() != 1 ? "the writer has " + std::to_string(errors.size()) + " errors"
        : !std::filesystem::is_empty(this->Output.GetPath())
        ? "the writer left a file after an error"
        : FindFaultOfMessage(errors[0], path);
      return fault;
    }
    if (!std::filesystem::exists(path))
    {
      return "the writer wrote no " + path.filename().string();
    }
    const MeshFiles written = LoadMeshFiles(path, GetFormat());
    if (round > 0)
    {
      for (std::size_t i = 0; i < files.size(); ++i)
      {
        const std::string again = i < written.size() ? written[i].Bytes : std::string();
        if (CountBytes(files[i].Bytes) != CountBytes(again))
        {
          return "what was written, read and written again is another ." + files[i].Extension +
            DescribeDifference(files[i].Bytes, again);
        }
      }
      return {};
    }
    files = written;
    Reading after = this->Read(path.string(), SIZE_MAX / MaxAllocation / 2);
    if (!after.Fault.empty() || !after.Errors.empty())
    {
      return "what was written: " + (after.Fault.empty() ? Quote(after.Errors[0]) : after.Fault);
    }
    if (before.Grid->GetNumberOfCells() == 0)
    {
      return {}; // points without cells are a cloud in many formats, and read as cells
    }
    if (warnings.empty() &&
      (after.Grid->GetNumberOfPoints() != before.Grid->GetNumberOfPoints() ||
        after.Grid->GetNumberOfCells() != before.Grid->GetNumberOfCells()))
    {
      return "written and read, " + std::to_string(before.Grid->GetNumberOfPoints()) +
        " points are " + std::to_string(after.Grid->GetNumberOfPoints()) + ", " +
        std::to_string(before.Grid->GetNumberOfCells()) + " cells are " +
        std::to_string(after.Grid->GetNumberOfCells());
    }
    before = after;
  }
  return {};
}
}
}
