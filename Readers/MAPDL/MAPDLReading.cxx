// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLReading.h"

#include "CellMesh/CellGrid.h"
#include "MAPDLComponents.h"
#include "Scan/ReadMappedFile.h"

#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
/// The text of a file with lines that end with line feeds.
class DeckText
{
public:
  DeckText(const char* begin, const char* end)
    : Begin(TextScanner("", begin, end).GetPosition()) // after a byte order mark
    , End(FindTextEnd(this->Begin, end))
  {
    const auto size = static_cast<std::size_t>(this->End - this->Begin);
    if (size > 0 && !std::memchr(this->Begin, '\n', size) && std::memchr(this->Begin, '\r', size))
    {
      this->Copy.assign(this->Begin, this->End);
      std::replace(this->Copy.begin(), this->Copy.end(), '\r', '\n');
      this->Begin = this->Copy.data();
      this->End = this->Begin + size;
    }
  }
  DeckText(const DeckText&) = delete;
  void operator=(const DeckText&) = delete;

  const char* Begin;
  const char* End;

private:
  std::string Copy;
};

//------------------------------------------------------------------------------
class MAPDLReading
{
public:
  MAPDLReading(const MappedFile& file, const MAPDLOptions& options, const PieceRequest& request,
    vtkUnstructuredGrid* grid, Warnings& warnings)
    : File(file)
    , Text(file.begin(), file.end())
    , Options(options)
    , Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  bool Read(vtkIdType chunk, ScanError& error, const Progress& progress);

private:
  /// Converts a fault to an error; returns false.
  bool Fail(const MAPDLFault& fault, ScanError& error) const;

  const MappedFile& File;
  DeckText Text;
  MAPDLOptions Options;
  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
};

//------------------------------------------------------------------------------
bool MAPDLReading::Fail(const MAPDLFault& fault, ScanError& error) const
{
  if (fault)
  {
    TextScanner scanner(this->File.GetName(), this->Text.Begin, this->Text.End);
    const char* const place = fault.Place;
    if (fault.Found.empty())
    {
      scanner.FailAt(place, fault.Kind, fault.Expected);
    }
    else
    {
      scanner.FailAt(place, fault.Kind, fault.Expected, fault.Found);
    }
    error = scanner.GetError();
  }
  return false;
}

//------------------------------------------------------------------------------
bool MAPDLReading::Read(vtkIdType chunk, ScanError& error, const Progress& progress)
{
  MAPDLDeck deck;
  MAPDLFault fault;
  if (!WalkMAPDL(this->Text.Begin, this->Text.End, chunk, progress.Part(0, 0.1), deck, fault))
  {
    return this->Fail(fault, error);
  }
  if (deck.NodeBlocks.empty())
  {
    error = { ErrorKind::NotThisFormat,
      this->File.GetName() + ": expected a Mechanical APDL deck with nodes (NBLOCK or N)" +
        (deck.NumberOfClearedRows > 0 ? " after the last /CLEAR" : "") +
        (!deck.SkippedNodes.empty()
            ? ", found none whose coordinates are numbers or known parameters"
            : LooksLikeAbaqus(this->Text.Begin, this->Text.End) ? ", found an Abaqus deck"
                                                                : ", found none") };
    return false;
  }
  MAPDLMesh mesh(deck, this->Options);
  CellMeshPiece piece;
  if (!mesh.Read(this->Request, piece, progress.Part(0.1, 0.65)))
  {
    return this->Fail(mesh.Fault, error);
  }
  Buffer<double> coordinates = mesh.ReadPoints(piece, progress.Part(0.65, 0.85));
  if (mesh.Fault || progress.IsStopped())
  {
    return this->Fail(mesh.Fault, error);
  }
  const auto points = coordinates.TakeArray<vtkDoubleArray>(3);
  if (!mesh.AddArrays(piece, this->Grid, progress.Part(0.85, 0.9)))
  {
    return false;
  }
  Warnings componentMessages;
  if (!AddMAPDLComponents(deck, mesh, piece, this->File.size(), this->Grid, componentMessages,
        fault, progress.Part(0.9, 0.95)))
  {
    return this->Fail(fault, error);
  }
  if (this->Request.Piece == 0)
  {
    mesh.Warn(this->Messages);
    for (const std::string& sentence : componentMessages.GetSentences())
    {
      this->Messages.Add(sentence);
    }
    piece.WarnOfRepeatedPoints(mesh.Cells, this->Messages, progress.Part(0.95, 1));
  }
  FillGrid(mesh.Cells, piece, points, this->Grid);
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsMAPDL(const std::string& path)
{
  MappedFile file;
  ScanError error;
  if (!file.Open(path, error))
  {
    return false;
  }
  const DeckText text(file.begin(), file.end());
  return LooksLikeMAPDL(text.Begin, text.End);
}

//------------------------------------------------------------------------------
bool ReadMAPDL(const std::string& path, const MAPDLOptions& options, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, ScanError& error, const Progress& progress,
  vtkIdType chunk)
{
  grid->Initialize();
  Warnings messages;
  const bool good = ReadMappedFile(path, error, [&](const MappedFile& file)
    { return MAPDLReading(file, options, request, grid, messages).Read(chunk, error, progress); });
  if (!good)
  {
    grid->Initialize();
    return false;
  }
  warnings = std::move(messages);
  return true;
}
}
