// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSReading.h"

#include "Base/Text.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/PieceRows.h"
#include "Intake/CellMesh/PointRows.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "TSurf.h"

#include "vtkUnstructuredGrid.h"

namespace camaron
{
namespace
{
constexpr int VertexBytes = 6; // "0 0 0" and a line end

//------------------------------------------------------------------------------
// The first line: the numbers of vertices and tetrahedra. The file may contain fewer tetrahedra.
struct Header
{
  std::int64_t Vertices = 0;
  std::int64_t Tetrahedra = 0;
};

//------------------------------------------------------------------------------
bool ReadHeader(TextScanner& scanner, Header& header)
{
  TextScanner attempt = scanner;
  TextRow row(attempt, RowLayout::OneLine);
  std::int64_t count;
  if (!row.ReadInteger(count, "") || !row.ReadInteger(count, ""))
  {
    scanner.SkipSpace();
    scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat,
      "a TS file, which begins with the numbers of vertices and tetrahedra, or with 'GOCAD TSurf'");
    scanner.AddToError(
      " (TypeScript programs, Qt translations and MPEG streams have this extension, too)");
    return false;
  }
  const bool good = scanner.ReadCount(header.Vertices, VertexBytes, "the number of vertices") &&
    scanner.ReadInteger(
      header.Tetrahedra, 0, INT32_MAX, ErrorKind::Count, "the number of tetrahedra");
  scanner.SkipLine();
  return good;
}

//------------------------------------------------------------------------------
// Camarón counts all polyhedra but writes only the tetrahedra, and a remark at the end.
void CountTetrahedra(TextScanner scanner, Header& header, Warnings& warnings)
{
  const std::int64_t promised = header.Tetrahedra;
  std::int64_t found = 0;
  while (found < promised && scanner.SkipSpace())
  {
    ++found;
    scanner.SkipLine();
  }
  header.Tetrahedra = found;
  if (found < promised)
  {
    warnings.Add("the file has " + CountOf(found, "tetrahedron", "tetrahedra") + ", not " +
      std::to_string(promised) +
      " as it declares; Camarón also counts polyhedra that it does not write");
  }
}

//------------------------------------------------------------------------------
// May be called again without lines; every call starts anew.
bool ReadTetrahedra(TextScanner& scanner, const TextLines* lines, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  grid->Initialize();
  warnings = Warnings();
  Header header;
  if (!ReadHeader(scanner, header))
  {
    return false;
  }
  // The vertices come first, but the tetrahedra determine which of them a piece needs.
  PointRows vertices(scanner, lines, header.Vertices, Coordinate);
  CellMeshPiece piece;
  piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit) { return vertices.ForEach(visit, Progress()); });
  if (!vertices.Skip(progress.Part(0, 0.1)) ||
    (lines && !lines->Find(scanner.GetPosition(), header.Tetrahedra)))
  {
    return false;
  }
  if (!lines)
  {
    CountTetrahedra(scanner, header, warnings);
  }
  CellMesh cells;
  const PieceRows rows(scanner, lines, { header.Vertices, header.Tetrahedra, VTK_TETRA, 4 });
  const auto readCell = [&](vtkIdType, TextRow& row, std::int32_t* ids, vtkIdType = 0)
  { return row.ReadIds(ids, 4, 0, header.Vertices - 1, "a vertex of a tetrahedron"); };
  const bool good = header.Tetrahedra == 0
    ? MakeCloud(header.Vertices, request, piece, cells)
    : rows.Find(request, piece, progress.Part(0.1, 0.3), readCell) &&
      rows.Read(piece, cells, progress.Part(0.3, 0.5), readCell);
  const vtkSmartPointer<vtkDataArray> points =
    good ? vertices.Read(piece, progress.Part(0.5, 0.95)) : nullptr;
  if (!points)
  {
    return false;
  }
  piece.WarnOfRepeatedPoints(cells, warnings, progress.Part(0.95, 1), "tetrahedron", "tetrahedra");
  if (scanner.SkipSpace())
  {
    warnings.Add("there is more data after the end of the mesh");
  }
  if (request.Piece > 0) // the first piece has warned
  {
    warnings = Warnings();
  }
  FillGrid(cells, piece, points, grid);
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsTS(const std::string& path)
{
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), '#');
  if (const std::string_view type = GetGOCADType(scanner); !type.empty())
  {
    return IsTSurf(type);
  }
  Header header;
  double x[3];
  TextRow row(scanner, RowLayout::OneLine);
  return ReadHeader(scanner, header) && (header.Vertices == 0 || row.ReadPoint(x, Coordinate));
}

//------------------------------------------------------------------------------
bool ReadTS(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      if (!GetGOCADType(TextScanner("", file.begin(), file.end(), '#')).empty())
      {
        return ReadTSurf(file, request, grid, warnings, error, rest, chunk);
      }
      return ReadText(file, '#', chunk, error, rest,
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return ReadTetrahedra(scanner, lines, request, grid, warnings, part); });
    });
}
}
