// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TRIReading.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/PieceRows.h"
#include "Intake/CellMesh/PointRows.h"
#include "Intake/Pieces/ReadMappedFile.h"
#include "TRIMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
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
constexpr int NumberBytes = 2; // a digit and a blank

//------------------------------------------------------------------------------
// The first line: the number of vertices, or, in Cart3D files, the numbers of vertices, triangles,
// and scalars per vertex.
struct Header
{
  std::int64_t Vertices = 0;
  std::int64_t Triangles = -1;
  std::int64_t Scalars = 0;
  bool IsCart3D() const { return this->Triangles >= 0; }
};

//------------------------------------------------------------------------------
bool ReadHeader(TextScanner& scanner, Header& header)
{
  constexpr char Expected[] = "a TRI file, whose first line is the number of vertices";
  if (!scanner.SkipSpace())
  {
    return scanner.FailAt(scanner.GetPosition(), ErrorKind::NotThisFormat, Expected);
  }
  const char* const begin = scanner.GetPosition();
  TextScanner counts = scanner; // limits are checked below, when the meaning of the counts is known
  std::int64_t count = 0;       // the last
  int numbers = 0;
  for (TextRow row(counts); row.HasMore() && numbers <= 3; ++numbers)
  {
    if (!counts.ReadInteger(count, Expected))
    {
      break;
    }
  }
  // An OFF file without its keyword has three numbers, too, of which the last one is mostly 0.
  if (numbers > 3 || counts.HasFailed() || (numbers == 3 && count < 1))
  {
    return scanner.FailAt(begin, ErrorKind::NotThisFormat,
      "a TRI file, whose first line is one number, or two in Cart3D files, or three with "
      "scalars");
  }
  if (!scanner.ReadCount(header.Vertices, VertexBytes, "the number of vertices") ||
    (numbers >= 2 &&
      !scanner.ReadCount(header.Triangles, TriangleBytes, "the number of triangles")) ||
    (numbers == 3 && !scanner.ReadCount(header.Scalars, NumberBytes, "the number of scalars")))
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
  TRIReading(const PieceRequest& request, vtkUnstructuredGrid* grid, Warnings& warnings)
    : Request(request)
    , Grid(grid)
    , Messages(warnings)
  {
  }

  /// May be called repeatedly; every call starts anew.
  bool Read(TextScanner& scanner, const TextLines* lines, const Progress& progress);

private:
  bool ReadTriangles(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  bool ReadComponents(TextScanner& scanner, const TextLines* lines, const Progress& progress);
  bool ReadScalars(TextScanner& scanner, const Progress& progress);

  PieceRequest Request;
  vtkUnstructuredGrid* Grid;
  Warnings& Messages;
  Header Counts;
  TRIMesh Mesh;
};

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
    return MakeCloud(this->Counts.Vertices, this->Request, this->Mesh.Piece, this->Mesh.Cells);
  }
  const std::int64_t first = isCart3D ? 1 : 0, last = first + this->Counts.Vertices - 1;
  const auto read = [&](vtkIdType, TextRow& row, std::int32_t* points, vtkIdType = 0)
  { return row.ReadIds(points, 3, first, last, Vertex); };
  const PieceRows rows(scanner, lines, { this->Counts.Vertices, triangles, VTK_TRIANGLE, 3 });
  return rows.Find(this->Request, this->Mesh.Piece, progress.Part(0, 0.5), read) &&
    rows.Read(this->Mesh.Piece, this->Mesh.Cells, progress.Part(0.5, 1), read);
}

//------------------------------------------------------------------------------
// Reads one number per triangle, with any number of them per line.
bool TRIReading::ReadComponents(
  TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  constexpr char Component[] = "the component of a triangle";
  const vtkIdType count = this->Counts.Triangles;
  if (count == 0 || (!scanner.SkipSpace() && this->Counts.Scalars == 0))
  {
    return true;
  }
  const auto components = MakeLargeArray<vtkIntArray>(this->Mesh.Cells.NumberOfCells);
  this->Mesh.Components = components;
  const auto set = [&](vtkIdType i, std::int64_t component)
  {
    if (const vtkIdType cell = this->Mesh.Piece.FindCell(i); cell >= 0)
    {
      components->SetValue(cell, static_cast<int>(component));
    }
    return component >= INT32_MIN && component <= INT32_MAX;
  };
  TextScanner attempt = scanner;
  if (lines &&
    RowSequence(attempt, lines, count)
      .ForEach(progress,
        [&](vtkIdType i, vtkIdType, TextRow& row)
        {
          std::int64_t component;
          return row.ReadInteger(component, Component) && !row.HasMore() && set(i, component);
        }))
  {
    scanner = attempt;
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
// Reads the scalars of all vertices, over any number of lines. Programs count them with or without
// the pressure coefficient.
bool TRIReading::ReadScalars(TextScanner& scanner, const Progress& progress)
{
  constexpr char Scalar[] = "a scalar of a vertex";
  const vtkIdType vertices = this->Counts.Vertices;
  if (vertices == 0 || this->Counts.Scalars == 0)
  {
    return true;
  }
  scanner.SkipSpace();
  const char* const begin = scanner.GetPosition();
  std::int64_t found = 0;
  std::string_view word;
  for (TextScanner words = scanner; words.SkipSpace(); ++found)
  {
    words.ReadWord(word, Scalar);
  }
  const std::int64_t size = found / vertices;
  if (found % vertices != 0 || (size != this->Counts.Scalars && size != this->Counts.Scalars + 1))
  {
    return scanner.FailAt(begin,
      found < vertices * this->Counts.Scalars ? ErrorKind::Truncated : ErrorKind::Count,
      "the " + std::to_string(this->Counts.Scalars) + " scalars of each of the " +
        std::to_string(vertices) + " vertices",
      std::to_string(found) + " numbers");
  }
  Buffer<double> scalars(size * this->Mesh.Piece.GetNumberOfPoints());
  for (vtkIdType i = 0; i < vertices && progress.Report(static_cast<double>(i) / vertices); ++i)
  {
    const vtkIdType point = this->Mesh.Piece.FindPoint(i);
    for (std::int64_t k = 0; k < size; ++k)
    {
      double value;
      if (!scanner.ReadReal(value, Scalar))
      {
        return false;
      }
      if (point >= 0)
      {
        scalars[point * size + k] = value;
      }
    }
  }
  this->Mesh.Scalars = scalars.TakeArray<vtkDoubleArray>(static_cast<int>(size));
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool TRIReading::Read(TextScanner& scanner, const TextLines* lines, const Progress& progress)
{
  this->Grid->Initialize();
  this->Messages = Warnings();
  this->Counts = Header();
  this->Mesh.Components = this->Mesh.Scalars = nullptr;
  if (!ReadHeader(scanner, this->Counts))
  {
    return false;
  }
  const bool isCart3D = this->Counts.IsCart3D();
  // The vertices come first, but the triangles determine which of them a piece needs.
  PointRows vertices(scanner, lines, this->Counts.Vertices, Coordinate);
  this->Mesh.Piece.SetPoints(
    [&](const PieceOfSpace::Visit& visit) { return vertices.ForEach(visit, Progress()); });
  if (!vertices.Skip(progress.Part(0, 0.1)) ||
    !this->ReadTriangles(scanner, lines, progress.Part(0.1, 0.4)) ||
    (isCart3D && !this->ReadComponents(scanner, lines, progress.Part(0.4, 0.5))) ||
    !this->ReadScalars(scanner, progress.Part(0.5, 0.6)))
  {
    return false;
  }

  this->Mesh.Points = vertices.Read(this->Mesh.Piece, progress.Part(0.6, 0.95));
  if (!this->Mesh.Points)
  {
    return false;
  }
  this->Mesh.Finish(
    this->Request, scanner.SkipSpace(), this->Grid, this->Messages, progress.Part(0.95, 1));
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
void TRIMesh::Finish(const PieceRequest& request, bool hasMore, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  if (request.Piece == 0)
  {
    this->Piece.WarnOfRepeatedPoints(this->Cells, warnings, progress, "triangle", "triangles");
    if (hasMore)
    {
      warnings.Add("there is more data after the end of the mesh");
    }
  }
  FillGrid(this->Cells, this->Piece, this->Points, grid);
  if (this->Components)
  {
    this->Components->SetName("Component");
    grid->GetCellData()->AddArray(this->Components);
  }
  if (this->Scalars)
  {
    this->Scalars->SetName("Scalars");
    grid->GetPointData()->AddArray(this->Scalars);
  }
}

//------------------------------------------------------------------------------
bool IsTRI(const std::string& path)
{
  const MappedFile file(path);
  if (IsBinaryTRI(file))
  {
    return true;
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
  return ReadMappedFile(path, request, grid, warnings, error, progress,
    [&](const MappedFile& file, const Progress& rest)
    {
      if (IsBinaryTRI(file))
      {
        return ReadBinaryTRI(file, request, grid, warnings, error, rest);
      }
      TRIReading reading(request, grid, warnings);
      return ReadText(file, '#', chunk, error, rest,
        [&](TextScanner& scanner, const TextLines* lines, const Progress& part)
        { return reading.Read(scanner, lines, part); });
    });
}
}
