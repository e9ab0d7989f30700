// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonPLYReading.h"

#include "Intake/Pieces/ReadMappedFile.h"
#include "PLYMesh.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <optional>

namespace camaron
{
namespace
{
constexpr char TrailingData[] = "there is more data after the end of the mesh";

//------------------------------------------------------------------------------
bool ReadBinaryRows(
  BinaryScanner& scanner, const MappedFile& file, PLYMesh& mesh, const Progress& progress)
{
  const auto makeRows = [&](const PLYElement& element) { return MakeBinaryRows(element, scanner); };
  if (!mesh.Read(makeRows, progress))
  {
    return false;
  }
  // Some programs also end binary files with a line end.
  if (!std::all_of(scanner.GetPosition(), file.end(), IsSpace))
  {
    mesh.Messages.Add(TrailingData);
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads one row per line or, if that fails, a sequence of numbers that must use up the file.
bool ReadRowsOfText(
  TextScanner& scanner, const TextLines* lines, PLYMesh& mesh, const Progress& progress)
{
  const auto read = [&](TextScanner& rows, RowLayout layout)
  {
    const auto makeRows = [&](const PLYElement& element)
    { return MakeTextRows(element, rows, lines, layout); };
    return mesh.Read(makeRows, progress);
  };
  TextScanner rows = scanner;
  if (read(rows, RowLayout::OneLine))
  {
    if (rows.SkipSpace())
    {
      mesh.Messages.Add(TrailingData);
    }
    return true;
  }
  const ScanError error = mesh.Error;
  TextScanner numbers = scanner;
  if (!lines && !progress.IsStopped() && read(numbers, RowLayout::Free) && !numbers.SkipSpace())
  {
    mesh.Messages.Add("the file does not have one row per line");
    return true;
  }
  mesh.Error = error;
  scanner = rows;
  return false;
}

//------------------------------------------------------------------------------
bool ReadMesh(const MappedFile& file, const PLYHeader& header, PLYMesh& mesh, vtkIdType chunk,
  const Progress& progress)
{
  std::optional<ByteOrder> order;
  if (header.Encoding != PLYEncoding::Text)
  {
    order = header.Encoding == PLYEncoding::BigEndian ? ByteOrder::Big : ByteOrder::Little;
  }
  ScanError error;
  const bool good = ReadTextOrBinary(file, order, '#', chunk, error, progress,
    [&](TextScanner& text, BinaryScanner* binary, const TextLines* lines, const Progress& part)
    {
      if (binary)
      {
        binary->SetPosition(header.Body);
        return ReadBinaryRows(*binary, file, mesh, part);
      }
      text.SetPosition(header.Body);
      return ReadRowsOfText(text, lines, mesh, part);
    });
  if (!good)
  {
    mesh.Error = mesh.Error ? mesh.Error : error;
  }
  return good;
}
}

//------------------------------------------------------------------------------
bool IsPolygonPLY(const std::string& path)
{
  const MappedFile file(path);
  return IsPLYStart(file.begin(), file.end());
}

//------------------------------------------------------------------------------
bool ReadPolygonPLY(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      TextScanner scanner(file.GetName(), file.begin(), file.end());
      PLYHeader header;
      if (!ReadPLYHeader(scanner, header))
      {
        error = scanner.GetError();
        return false;
      }
      PLYMesh mesh(file.GetName(), header, request, grid);
      const bool isRead = ReadMesh(file, header, mesh, chunk, rest);
      error = isRead ? ScanError() : mesh.Error;
      if (request.Piece == 0)
      {
        warnings = std::move(mesh.Messages);
      }
      return isRead;
    });
}
}
