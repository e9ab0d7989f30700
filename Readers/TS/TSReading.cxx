// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TSReading.h"

#include "Base/Text.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/PieceRows.h"
#include "Intake/CellMesh/PointRows.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "TSurfObjects.h"

#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
constexpr char Vertex[] = "a vertex of a tetrahedron";
constexpr int VertexBytes = 6;      // "0 0 0" and a line end
constexpr int TetrahedronBytes = 8; // "0 0 0 0" and a line end

//------------------------------------------------------------------------------
// Sets an error that names the format of the file if it is a known one.
bool FailAsOtherFormat(TextScanner& scanner)
{
  constexpr char Expected[] =
    "a TS file, which begins with the numbers of vertices and tetrahedra, or with 'GOCAD TSurf'";
  const char* const text = scanner.GetPosition();
  constexpr vtkIdType PacketSize = 188; // of MPEG, each begins with a G
  if (scanner.GetBytesLeft() > PacketSize && text[0] == 'G' && text[PacketSize] == 'G')
  {
    return scanner.FailAt(text, ErrorKind::NotThisFormat, Expected, "an MPEG transport stream");
  }
  scanner.SkipSpace();
  scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat, Expected);
  scanner.AddToError(" (TypeScript programs and Qt translations have this extension, too)");
  return false;
}

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
    return FailAsOtherFormat(scanner);
  }
  const bool good = scanner.ReadCount(header.Vertices, VertexBytes, "the number of vertices") &&
    scanner.ReadInteger(
      header.Tetrahedra, 0, INT32_MAX, ErrorKind::Count, "the number of tetrahedra");
  scanner.SkipLine();
  return good;
}

//------------------------------------------------------------------------------
// Reads a TS file of Camarón.
class TSReading
{
public:
  TSReading(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
    : Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// May be called repeatedly; every call starts anew.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);

private:
  bool ReadTetrahedra(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  vtkIdType CountTetrahedra(TextScanner scanner);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
  Header Counts;
  CellMeshPiece Piece;
  CellMesh Mesh;
};

//------------------------------------------------------------------------------
// Camarón counts all polyhedra but writes only the tetrahedra, and a remark at the end.
vtkIdType TSReading::CountTetrahedra(TextScanner scanner)
{
  const std::int64_t promised = this->Counts.Tetrahedra;
  std::int64_t found = 0;
  while (found < promised && scanner.SkipSpace())
  {
    ++found;
    scanner.SkipLine();
  }
  if (found < promised)
  {
    this->Messages.Add("the file has " + CountOf(found, "tetrahedron", "tetrahedra") + ", not " +
      std::to_string(promised) +
      " as it declares; Camarón also counts polyhedra that it does not write");
  }
  return found;
}

//------------------------------------------------------------------------------
bool TSReading::ReadTetrahedra(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  if (lines && !lines->Find(scanner.GetPosition(), this->Counts.Tetrahedra))
  {
    return false;
  }
  const vtkIdType vertices = this->Counts.Vertices;
  const vtkIdType cells = lines ? this->Counts.Tetrahedra : this->CountTetrahedra(scanner);
  if (cells == 0)
  {
    return MakeCloud(vertices, this->Request, this->Piece, this->Mesh);
  }
  const auto read = [vertices](vtkIdType, TextRow& row, std::int32_t* points, vtkIdType = 0)
  { return row.ReadIds(points, 4, 0, vertices - 1, Vertex); };
  const PieceRows rows(scanner, lines, { vertices, cells, VTK_TETRA, 4 });
  return rows.Find(scanner, this->Request, this->Piece, progress.Part(0, 0.5), read) &&
    rows.Read(scanner, this->Piece, this->Mesh, progress.Part(0.5, 1), read);
}

//------------------------------------------------------------------------------
bool TSReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  if (!ReadHeader(scanner, this->Counts))
  {
    return false;
  }
  // The vertices come first, but the tetrahedra determine which of them a piece needs.
  PointRows vertices(scanner, lines, this->Counts.Vertices, Coordinate);
  this->Piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit) { return vertices.ForEach(visit, Progress()); });
  if (!vertices.Skip(scanner, progress.Part(0, 0.1)) ||
    !this->ReadTetrahedra(scanner, lines, progress.Part(0.1, 0.5)))
  {
    return false;
  }

  const auto points = vertices.Read(this->Piece, progress.Part(0.5, 0.95));
  if (!points)
  {
    return false;
  }

  if (this->Request.Piece == 0)
  {
    this->Piece.WarnOfRepeatedPoints(
      this->Mesh, this->Messages, progress.Part(0.95, 1), "tetrahedron", "tetrahedra");
    if (scanner.SkipSpace())
    {
      this->Messages.Add("there is more data after the end of the mesh");
    }
  }
  else
  {
    this->Messages = Warnings();
  }
  FillGrid(this->Mesh, this->Piece, points, this->Grid);
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsTS(const std::string& path)
{
  const MappedFile file(path);
  TextScanner scanner("", file.begin(), file.end(), '#');
  if (std::string_view type; IsGOCAD(scanner, type))
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
      std::string_view type;
      if (IsGOCAD(TextScanner("", file.begin(), file.end(), '#'), type))
      {
        return ReadTSurf(file, request, grid, warnings, error, rest, chunk);
      }
      TSReading reading(request, grid, warnings);
      return ReadText(file, '#', chunk, error, rest,
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return reading.Read(scanner, lines, part); });
    });
}
}
