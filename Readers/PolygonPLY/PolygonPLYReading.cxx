// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonPLYReading.h"

#include "Intake/Pieces/ReadMappedFile.h"
#include "PLYMesh.h"

#include "vtkUnstructuredGrid.h"

#include <optional>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Reads one row per line or, if that fails, a sequence of numbers that must use up the file.
bool ReadRows(TableScanner& scanner, PLYMesh& mesh, const Progress& progress)
{
  const auto read = [&](TextScanner& text, RowLayout layout)
  {
    TableScanner rows{ text, scanner.Binary, scanner.Lines, {} };
    return mesh.Read(rows, layout, progress);
  };
  TextScanner rows = scanner.Text;
  if (read(rows, RowLayout::OneLine))
  {
    if (rows.SkipSpace()) // some programs also end binary files with a line end
    {
      mesh.Messages.Add("there is more data after the end of the mesh");
    }
    return true;
  }
  scanner.Error = mesh.Error;
  TextScanner numbers = scanner.Text;
  if (!scanner.Binary && !scanner.Lines && !progress.IsStopped() &&
    read(numbers, RowLayout::Free) && !numbers.SkipSpace())
  {
    mesh.Messages.Add("the file does not have one row per line");
    return true;
  }
  scanner.Text = rows;
  return false;
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
      std::optional<ByteOrder> order;
      if (header.Encoding != PLYEncoding::Text)
      {
        order = header.Encoding == PLYEncoding::BigEndian ? ByteOrder::Big : ByteOrder::Little;
      }
      PLYMesh mesh(header, request, grid);
      const bool isRead = ReadTextOrBinary(file, order, '#', chunk, error, rest,
        [&](TableScanner& rows, const Progress& part)
        {
          rows.Text.SetPosition(header.Body);
          return ReadRows(rows, mesh, part);
        });
      if (request.Piece == 0)
      {
        warnings = std::move(mesh.Messages);
      }
      return isRead;
    });
}
}
