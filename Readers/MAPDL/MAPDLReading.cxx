// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "MAPDLMesh.h"
#include "MAPDLWalker.h"

#include "vtkDoubleArray.h"
#include "vtkUnstructuredGrid.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool Read(const MappedFile& file, const MAPDLOptions& options, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, vtkIdType chunk, ScanError& error,
  const Progress& progress)
{
  const char* const begin = SkipByteOrderMark(file.begin(), file.end());
  const char* const end = FindTextEnd(begin, file.end());
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  if (text.find('\n') == text.npos && text.find('\r') != text.npos)
  {
    error = { ErrorKind::Unsupported,
      file.GetName() + ": expected lines that end with LF or CRLF, found CR" };
    return false;
  }
  MAPDLDeck deck;
  MAPDLFault fault;
  const auto fail = [&](const MAPDLFault& reason)
  {
    if (reason)
    {
      TextScanner scanner(file.GetName(), begin, end);
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
  if (!MAPDLWalker(begin, end, chunk, progress.Part(0, 0.1), deck, fault).Walk())
  {
    return fail(fault);
  }
  if (deck.NodeBlocks.empty())
  {
    error = { ErrorKind::NotThisFormat,
      file.GetName() + ": expected a Mechanical APDL deck with nodes (NBLOCK or N)" +
        (!deck.SkippedNodes.empty()
            ? ", found none whose coordinates are numbers or known parameters"
            : GuessMAPDL(begin, end) == MAPDLGuess::Abaqus ? ", found an Abaqus deck"
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
  mesh.AddArrays(piece, grid);
  Warnings ofComponents;
  if (!mesh.AddComponents(piece, file.size(), grid, ofComponents, progress.Part(0.9, 0.95)))
  {
    return fail(mesh.Fault);
  }
  if (request.Piece == 0)
  {
    mesh.Warn(warnings);
    for (const Warning& warning : ofComponents.Get())
    {
      warnings.Add(warning);
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
  const char* const begin = SkipByteOrderMark(file.begin(), file.end());
  return GuessMAPDL(begin, FindTextEnd(begin, file.end())) == MAPDLGuess::Deck;
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
