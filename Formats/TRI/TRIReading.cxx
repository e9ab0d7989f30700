// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TRIReading.h"

#include "CellMesh/CellGrid.h"
#include "CellMesh/PieceRows.h"
#include "CellMesh/PointRows.h"
#include "Scan/ReadMappedFile.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr char Coordinate[] = "a coordinate of a vertex";
constexpr char Vertex[] = "a vertex of a triangle";
constexpr int VertexBytes = 6; // "0 0 0" and a line end
constexpr int TriangleBytes = 6;

//------------------------------------------------------------------------------
// The first line: the number of vertices, or, in files of Cart3D, of vertices and triangles.
struct Header
{
  std::int64_t Vertices = 0;
  std::int64_t Triangles = -1;
  bool IsCart3D() const { return this->Triangles >= 0; }
};

//------------------------------------------------------------------------------
bool ReadHeader(TextScanner& scanner, Header& header)
{
  constexpr char Expected[] = "a TRI file, whose first line is the number of vertices";
  if (!scanner.SkipSpace())
  {
    scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat, Expected);
    return false;
  }
  const char* const begin = scanner.GetPosition();
  TextScanner counts = scanner; // how many there can be is asked when it is known what they count
  std::int64_t count;
  int numbers = 0;
  for (TextRow row(counts); row.HasMore() && numbers <= 2; ++numbers)
  {
    if (!counts.ReadInteger(count, Expected))
    {
      break;
    }
  }
  if (numbers > 2 || counts.HasFailed())
  {
    scanner.FailAt(begin, ErrorKind::NotThisFormat,
      "a TRI file, whose first line is one number, or two in files of Cart3D");
    return false;
  }
  if (!scanner.ReadCount(header.Vertices, VertexBytes, "the number of vertices") ||
    (numbers == 2 &&
      !scanner.ReadCount(header.Triangles, TriangleBytes, "the number of triangles")))
  {
    return false;
  }
  scanner.SkipLine();
  return true;
}

//------------------------------------------------------------------------------
class TRIReading
{
public:
  TRIReading(const PieceRequest& request, vtkUnstructuredGrid* grid)
    : Request(request)
    , Grid(grid)
  {
  }

  /// Starts anew with every call.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  Warnings Messages;

private:
  bool ReadTriangles(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  bool ReadComponents(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  bool LooksOneBased(TextScanner scanner) const;

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Header Counts;
  CellPiece Piece;
  CellMesh Mesh;
  bool HasComponents = false;
  Buffer<int> Components; // of triangles of the piece, in files of Cart3D that have them
};

//------------------------------------------------------------------------------
bool TRIReading::LooksOneBased(TextScanner scanner) const
{
  std::int64_t least = INT64_MAX, greatest = -1;
  const bool good = ReadRows(scanner, nullptr, this->Counts.Triangles, Progress(),
    [&](vtkIdType, TextRow& row)
    {
      bool isGood = true;
      for (int i = 0; i < 3 && isGood; ++i)
      {
        std::int64_t id = 0;
        isGood = row.ReadInteger(id, Vertex);
        least = std::min(least, id);
        greatest = std::max(greatest, id);
      }
      return isGood;
    });
  return good && least >= 1 && greatest == this->Counts.Vertices;
}

//------------------------------------------------------------------------------
bool TRIReading::ReadTriangles(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  std::int64_t& triangles = this->Counts.Triangles;
  const bool isCart3D = this->Counts.IsCart3D();
  if (!isCart3D && scanner.SkipSpace())
  {
    if (!scanner.ReadCount(triangles, TriangleBytes, "the number of triangles"))
    {
      return false;
    }
    scanner.SkipLine();
  }
  if (triangles <= 0)
  {
    this->Mesh = MakeCloud(this->Counts.Vertices, this->Request, this->Piece);
    return true;
  }
  const TextScanner start = scanner;
  const std::int64_t first = isCart3D ? 1 : 0, last = first + this->Counts.Vertices - 1;
  const auto read = [&](vtkIdType, TextRow& row, std::int32_t* points, vtkIdType = 0)
  {
    return row.ReadId(points[0], first, last, Vertex) &&
      row.ReadId(points[1], first, last, Vertex) && row.ReadId(points[2], first, last, Vertex);
  };
  CellMesh shape;
  shape.NumberOfPoints = this->Counts.Vertices;
  shape.NumberOfCells = triangles;
  shape.CommonType = VTK_TRIANGLE;
  shape.CommonSize = 3;
  const PieceRows rows(scanner, lines, shape);
  if (rows.Find(scanner, this->Request, this->Piece, progress.Part(0, 0.5), read) &&
    rows.Read(scanner, this->Piece, this->Mesh, progress.Part(0.5, 1), read))
  {
    return true;
  }
  if (scanner.GetError().Kind == ErrorKind::Index && !isCart3D && this->LooksOneBased(start))
  {
    scanner.AddToError(" (the file seems to count vertices from 1, TRI counts from 0)");
  }
  return false;
}

//------------------------------------------------------------------------------
// One number per triangle, of which each line may have any number.
bool TRIReading::ReadComponents(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  constexpr char Component[] = "the component of a triangle";
  if (!scanner.SkipSpace())
  {
    return true;
  }
  const vtkIdType count = this->Counts.Triangles;
  this->HasComponents = count > 0;
  this->Components = Buffer<int>(this->Mesh.NumberOfCells);
  const auto set = [&](vtkIdType i, std::int64_t component)
  {
    if (const vtkIdType cell = this->Piece.FindCell(i); cell >= 0)
    {
      this->Components[cell] = static_cast<int>(component);
    }
    return component >= INT32_MIN && component <= INT32_MAX;
  };
  const TextLines::Section section =
    lines ? lines->Find(scanner.GetPosition(), count) : TextLines::Section();
  if (section &&
    VisitRows(*lines, section, scanner.GetComment(), progress,
      [&](vtkIdType i, vtkIdType, TextRow& row)
      {
        std::int64_t component;
        return row.ReadInteger(component, Component) && !row.HasMore() && set(i, component);
      }))
  {
    scanner.SetPosition(section.End);
    return true;
  }
  for (vtkIdType i = 0; i < count && !progress.IsStopped(); ++i)
  {
    std::int64_t component;
    if (!scanner.ReadInteger(component, INT32_MIN, INT32_MAX, ErrorKind::Syntax, Component))
    {
      return false;
    }
    set(i, component);
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool TRIReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Counts = Header();
  this->HasComponents = false;
  if (!ReadHeader(scanner, this->Counts))
  {
    return false;
  }
  const bool isCart3D = this->Counts.IsCart3D();
  // The vertices come first, but which of them a piece needs is known from its triangles.
  PointRows vertices(scanner, lines, this->Counts.Vertices, Coordinate);
  if (!vertices.Skip(scanner, progress.Part(0, 0.1)) ||
    !this->ReadTriangles(scanner, lines, progress.Part(0.1, 0.4)) ||
    (isCart3D && !this->ReadComponents(scanner, lines, progress.Part(0.4, 0.5))))
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
      this->Mesh, this->Messages, progress.Part(0.95, 1), "triangle", "triangles");
    if (scanner.SkipSpace())
    {
      this->Messages.Add("there is more data after the end of the mesh");
    }
  }
  FillGrid(this->Mesh, this->Piece, points, this->Grid);
  if (this->HasComponents)
  {
    const auto array = this->Components.TakeArray<vtkIntArray>();
    array->SetName("Component");
    this->Grid->GetCellData()->AddArray(array);
  }
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool IsTRI(const std::string& path)
{
  MappedFile file;
  ScanError error;
  if (!file.Open(path, error))
  {
    return false;
  }
  TextScanner scanner("", file.begin(), file.end(), '#');
  Header header;
  double x[3];
  TextRow row(scanner);
  return ReadHeader(scanner, header) && (header.Vertices == 0 || row.ReadPoint(x, Coordinate));
}

//------------------------------------------------------------------------------
bool ReadTRI(const std::string& path, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  TRIReading reading(request, grid);
  const bool good = ReadMappedFile(path, error,
    [&](const MappedFile& file)
    {
      return ReadText(file, '#', chunk, error, progress,
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return reading.Read(scanner, lines, part); });
    });
  if (!good)
  {
    grid->Initialize();
    return false;
  }
  warnings = std::move(reading.Messages);
  return true;
}
}
