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
// Lines may end with a lone CR; it is replaced by LF, so every byte keeps its position.
bool ReplaceLoneReturns(const MappedFile& file, std::string& copy)
{
  for (const char* text = file.begin(); text < file.end();)
  {
    const void* const found = std::memchr(text, '\r', file.end() - text);
    const char* const at = found ? static_cast<const char*>(found) : file.end();
    if (at < file.end() && (at + 1 == file.end() || at[1] != '\n'))
    {
      if (copy.empty())
      {
        copy.assign(file.begin(), file.end());
      }
      copy[at - file.begin()] = '\n';
    }
    text = at + (at < file.end());
  }
  return !copy.empty();
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
        const TSurfRecords::Chunk& chunk = records.GetChunks()[i];
        vtkIdType triangle = chunk.Triangles, face = chunk.Faces;
        TSurfRecords::ForEachLine(chunk,
          [&](TSurfLine what, TextRow&, const char*)
          {
            face += what == TSurfLine::Face;
            if (what == TSurfLine::Triangle)
            {
              if (const vtkIdType cell = piece.FindCell(triangle++); cell >= 0)
              {
                parts[cell] = static_cast<int>(chunk.Object);
                // Triangles before the first TFACE belong to the same face as those after it.
                faces[cell] = static_cast<int>(std::max<vtkIdType>(face - 1, 0));
              }
            }
            return true;
          });
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
    values.Warn(warnings);
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
  std::string copy;
  const bool isCopy = ReplaceLoneReturns(file, copy);
  const char* const begin = isCopy ? copy.data() : file.begin();
  const char* const end = FindTextEnd(begin, begin + (file.end() - file.begin()));
  TextScanner scanner(file.GetName(), begin, end, '#');
  const bool good = Read(scanner, request, grid, warnings, progress, chunk);
  error = progress.IsStopped() ? ScanError() : scanner.GetError();
  return good && !error && !progress.IsStopped();
}
}
