// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "MAPDLComponents.h"
#include "MAPDLWalker.h"

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
bool Read(const MappedFile& file, const MAPDLOptions& options, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, vtkIdType chunk, ScanError& error,
  const Progress& progress)
{
  const DeckText text(file.begin(), file.end());
  MAPDLDeck deck;
  MAPDLFault fault;
  const auto fail = [&](const MAPDLFault& reason)
  {
    if (reason)
    {
      TextScanner scanner(file.GetName(), text.Begin, text.End);
      if (reason.Found.empty())
      {
        scanner.FailAt(reason.Place, reason.Kind, reason.Expected);
      }
      else
      {
        scanner.FailAt(reason.Place, reason.Kind, reason.Expected, reason.Found);
      }
      error = scanner.GetError();
    }
    return false;
  };
  if (!MAPDLWalker(text.Begin, text.End, chunk, progress.Part(0, 0.1), deck, fault).Walk())
  {
    return fail(fault);
  }
  if (deck.NodeBlocks.empty())
  {
    error = { ErrorKind::NotThisFormat,
      file.GetName() + ": expected a Mechanical APDL deck with nodes (NBLOCK or N)" +
        (deck.NumberOfClearedRows > 0 ? " after the last /CLEAR" : "") +
        (!deck.SkippedNodes.empty()
            ? ", found none whose coordinates are numbers or known parameters"
            : LooksLikeAbaqus(text.Begin, text.End) ? ", found an Abaqus deck"
                                                    : ", found none") };
    return false;
  }
  MAPDLMesh mesh(deck, options);
  CellMeshPiece piece;
  if (!mesh.Read(request, piece, progress.Part(0.1, 0.65)))
  {
    return fail(mesh.Fault);
  }
  Buffer<double> coordinates = mesh.ReadPoints(piece, progress.Part(0.65, 0.85));
  if (mesh.Fault || progress.IsStopped())
  {
    return fail(mesh.Fault);
  }
  const auto points = coordinates.TakeArray<vtkDoubleArray>(3);
  if (!mesh.AddArrays(piece, grid, progress.Part(0.85, 0.9)))
  {
    return false;
  }
  Warnings ofComponents;
  if (!AddMAPDLComponents(
        deck, mesh, piece, file.size(), grid, ofComponents, fault, progress.Part(0.9, 0.95)))
  {
    return fail(fault);
  }
  if (request.Piece == 0)
  {
    mesh.Warn(warnings);
    for (const std::string& sentence : ofComponents.GetSentences())
    {
      warnings.Add(sentence);
    }
    piece.WarnOfRepeatedPoints(mesh.Cells, warnings, progress.Part(0.95, 1));
  }
  FillGrid(mesh.Cells, piece, points, grid);
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
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    { return Read(file, options, request, grid, warnings, chunk, error, rest); });
}
}
