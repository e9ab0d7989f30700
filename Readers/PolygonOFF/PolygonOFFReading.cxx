// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFReading.h"

#include "Base/Text.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "Intake/Rows/TextRows.h"
#include "PolygonOFFMesh.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Comment = '#';

//------------------------------------------------------------------------------
// Files with the right extension may lack the keyword.
bool MayLackKeyword(const std::string& path)
{
  const std::string name = WithoutGz(path);
  return ToLower(name.substr(name.size() - std::min<std::size_t>(name.size(), 3))) == "off";
}
}

//------------------------------------------------------------------------------
bool IsPolygonOFF(const std::string& path)
{
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), Comment);
  OFFHeader header;
  if (!ReadOFFKeyword(scanner, MayLackKeyword(path), header))
  {
    return false;
  }
  // If there is a keyword, errors in the rest are for the reader to report.
  std::int64_t count;
  if (header.IsBinary || header.HasKeyword)
  {
    return header.IsBinary || scanner.ReadInteger(count, "");
  }
  double x;
  return ReadOFFCounts(scanner, header) &&
    (header.Vertices == 0 ||
      (scanner.ReadReal(x, "") && scanner.ReadReal(x, "") && scanner.ReadReal(x, "")));
}

//------------------------------------------------------------------------------
bool ReadPolygonOFF(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      TextScanner scanner(file.GetName(), file.begin(), file.end(), Comment);
      OFFHeader header;
      if (ReadOFFKeyword(scanner, MayLackKeyword(path), header) && header.IsBinary)
      {
        return ReadBinaryOFF(
          file, scanner.GetPosition(), header, request, grid, warnings, error, rest);
      }
      return ReadText(file, Comment, chunk, error, rest,
        [&](TextScanner& text, const TextLines* lines, const Progress& part)
        { return ReadTextOFF(text, lines, MayLackKeyword(path), request, grid, warnings, part); });
    });
}
}
