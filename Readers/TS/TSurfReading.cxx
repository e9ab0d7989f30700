// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The grid of the objects of a file.
#include "Base/Parallel.h"
#include "Intake/CellMesh/CellGrid.h"
#include "TSurfRecords.h"
#include "TSurfValues.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The first CR that is not followed by LF, or the end.
const char* FindLoneReturn(const char* begin, const char* end)
{
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  std::size_t at = text.find('\r');
  while (at != text.npos && at + 1 < text.size() && text[at + 1] == '\n')
  {
    at = text.find('\r', at + 1);
  }
  return at == text.npos ? end : begin + at;
}

//------------------------------------------------------------------------------
// Adds the object, and the face in it, to which each triangle belongs.
void AddParts(const TSurfRecords& records, const CellMeshPiece& piece, vtkUnstructuredGrid* grid)
{
  Buffer<int> parts(piece.GetNumberOfCells()), faces(piece.GetNumberOfCells());
  ParallelFor(records.GetNumberOfChunks(), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const TSurfRecords::Chunk* const chunk = records.GetChunks().data() + i;
        std::size_t face = 0; // in the chunk
        for (vtkIdType triangle = chunk->Triangles; triangle < chunk[1].Triangles; ++triangle)
        {
          while (face < chunk->FaceStarts.size() &&
            chunk->FaceStarts[face] <= triangle - chunk->Triangles)
          {
            ++face;
          }
          if (const vtkIdType cell = piece.FindCell(triangle); cell >= 0)
          {
            // Triangles before the first TFACE belong to the same face as those after it.
            const vtkIdType faceOfObject = chunk->Faces + static_cast<vtkIdType>(face) - 1;
            parts[cell] = static_cast<int>(chunk->Object);
            faces[cell] = static_cast<int>(std::max<vtkIdType>(faceOfObject, 0));
          }
        }
      }
    });
  grid->GetCellData()->AddArray(parts.TakeArray<vtkIntArray>(1, "Part"));
  grid->GetCellData()->AddArray(faces.TakeArray<vtkIntArray>(1, "TFace"));
}

//------------------------------------------------------------------------------
// Adds a text that the file has for each object.
void AddTexts(const std::vector<TSurfObject>& objects, std::string TSurfObject::* text,
  const char* name, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  bool isEmpty = true;
  for (const TSurfObject& object : objects)
  {
    array->InsertNextValue(object.*text);
    isEmpty = isEmpty && (object.*text).empty();
  }
  if (!isEmpty)
  {
    grid->GetFieldData()->AddArray(array);
  }
}

//------------------------------------------------------------------------------
bool Read(TextScanner& scanner, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress, vtkIdType chunkSize)
{
  if (const char* const lone = FindLoneReturn(scanner.GetBegin(), scanner.GetEnd());
    lone < scanner.GetEnd())
  {
    return scanner.FailAt(lone, ErrorKind::Unsupported, "lines that end with LF or CRLF", "CR");
  }
  std::vector<TSurfObject> objects;
  if (!FindObjects(scanner, objects, warnings))
  {
    return false;
  }
  TSurfRecords records(scanner, objects, chunkSize);
  CellMesh mesh;
  if (!records.Read(mesh, warnings, progress.Part(0.1, 0.5)))
  {
    return false;
  }
  const bool hasTriangles = mesh.NumberOfCells > 0;
  if (!hasTriangles)
  {
    mesh = MakeCloud(mesh.NumberOfPoints);
  }
  CellMeshPiece piece;
  if (!piece.Select(mesh, request, progress.Part(0.5, 0.55)))
  {
    return false;
  }
  KeepPiece(mesh, piece); // before there is memory for values
  TSurfValues values(scanner, objects);
  if (!values.Read(records, piece, progress.Part(0.55, 0.9)))
  {
    return false;
  }

  const vtkSmartPointer<vtkDataArray> points = values.TakePoints();
  if (request.Piece == 0)
  {
    piece.WarnOfRepeatedPoints(mesh, warnings, progress.Part(0.9, 1), "triangle", "triangles");
  }
  else
  {
    warnings = Warnings();
  }
  FillGrid(mesh, piece, points, grid);
  values.AddArrays(grid->GetPointData());
  if (hasTriangles)
  {
    AddParts(records, piece, grid);
  }
  AddTexts(objects, &TSurfObject::Name, "PartName", grid);
  AddTexts(objects, &TSurfObject::ZPositive, "ZPositive", grid);
  AddTexts(objects, &TSurfObject::AxisUnit, "AxisUnit", grid);
  return !progress.IsStopped();
}
}

//------------------------------------------------------------------------------
bool ReadTSurf(const MappedFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress, vtkIdType chunk)
{
  const char* const end = FindTextEnd(file.begin(), file.end());
  TextScanner scanner(file.GetName(), file.begin(), end, '#');
  const bool good = Read(scanner, request, grid, warnings, progress, chunk);
  error = progress.IsStopped() ? ScanError() : scanner.GetError();
  return good && !error && !progress.IsStopped();
}
}
