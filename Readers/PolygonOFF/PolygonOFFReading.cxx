// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolygonOFFReading.h"

#include "Base/Text.h"
#include "PolygonOFFBinaryReading.h"
#include "PolygonOFFText.h"
#include "Scan/ReadMappedFile.h"

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
  return ToLower(path.substr(path.size() - std::min<std::size_t>(path.size(), 3))) == "off";
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
  return ReadMappedFile(path, grid, warnings, error,
    [&](const MappedFile& file)
    {
      TextScanner scanner(file.GetName(), file.begin(), file.end(), Comment);
      OFFHeader header;
      if (ReadOFFKeyword(scanner, MayLackKeyword(path), header) && header.IsBinary)
      {
        return ReadBinaryOFF(
          file, scanner.GetPosition(), header, request, grid, warnings, error, progress);
      }
      OFFTextReading reading(MayLackKeyword(path), request, grid, warnings);
      return ReadText(file, Comment, chunk, error, progress,
        [&](TextScanner& text, const TextLines* lines, const Progress& part)
        { return reading.Read(text, lines, part); });
    });
}
}
