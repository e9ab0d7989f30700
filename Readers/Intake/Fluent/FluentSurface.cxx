// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/CellMeshPiece.h"
#include "Intake/Fluent/FluentNodes.h"
#include "Mesh/CellShape.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool ReadFaces(FluentFile& file, const FluentFaces& faces, CellMesh& mesh, const Progress& progress)
{
  mesh.NumberOfCells = faces.GetCount();
  mesh.Types = Buffer<unsigned char>(mesh.NumberOfCells);
  mesh.Offsets = Buffer<std::int32_t>(mesh.NumberOfCells + 1);
  std::fill_n(mesh.Offsets.data(), mesh.NumberOfCells + 1, 0);
  if (!faces.ForEach(progress.Part(0, 0.5),
        [&](const FluentFaces::Run&, vtkIdType position, const FluentFace& face)
        { mesh.Offsets[position + 1] = face.Nodes.Size; }))
  {
    return false;
  }
  std::int64_t total = 0;
  for (vtkIdType cell = 0; cell < mesh.NumberOfCells; ++cell)
  {
    const std::int32_t size = mesh.Offsets[cell + 1];
    mesh.Types[cell] = file.GetDimension() == 2 ? VTK_LINE : GetPolygonType(size);
    mesh.Types[cell] = size == 0 ? VTK_EMPTY_CELL : mesh.Types[cell];
    total += size;
    if (total > INT32_MAX)
    {
      file.Fail(ErrorKind::Unsupported, "faces with fewer than 2147483648 nodes", "more");
      return false;
    }
    mesh.Offsets[cell + 1] = static_cast<std::int32_t>(total);
  }
  mesh.Connectivity = Buffer<std::int32_t>(total);
  return faces.ForEach(progress.Part(0.5, 1),
    [&](const FluentFaces::Run&, vtkIdType position, const FluentFace& face)
    {
      std::int32_t* const points = mesh.Connectivity.data() + mesh.Offsets[position];
      // It is the same, unless the file has just changed.
      const auto size = std::min<vtkIdType>(face.Nodes.Size, mesh.GetSize(position));
      for (std::int32_t i = 0; i < size; ++i)
      {
        points[i] = face.Nodes[i] - 1;
      }
    });
}

//------------------------------------------------------------------------------
// Finds the piece of the faces in zones that are not left out.
bool Select(const FluentFile& file, const FluentFaces& faces, const CellMesh& mesh,
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  constexpr vtkIdType Block = 4096;
  return piece.Find(mesh.NumberOfPoints, mesh.NumberOfCells, request,
    [&]
    {
      bool good = true;
      for (const FluentFaces::Run& run : faces.GetRuns())
      {
        good = good &&
          (file.ZonesLeftOut.count(run.Zone) > 0 ||
            progress.ForBlocks(run.End - run.Begin, Block,
              [&](vtkIdType begin, vtkIdType end)
              {
                for (vtkIdType face = run.Begin + begin; face < run.Begin + end; ++face)
                {
                  piece.Visit(face, mesh.GetPoints(face), mesh.GetSize(face));
                }
              }));
      }
      return good;
    });
}

//------------------------------------------------------------------------------
void AddArrays(const FluentFaces& faces, const CellMeshPiece& piece, vtkUnstructuredGrid* grid)
{
  const auto add = [&](const char* name, int FluentFaces::Run::* value)
  {
    Buffer<int> values(piece.GetNumberOfCells());
    for (const FluentFaces::Run& run : faces.GetRuns())
    {
      for (vtkIdType face = run.Begin; face < run.End; ++face)
      {
        if (const vtkIdType cell = piece.FindCell(face); cell >= 0)
        {
          values[cell] = run.*value;
        }
      }
    }
    grid->GetCellData()->AddArray(values.TakeArray<vtkIntArray>(1, name));
  };
  add("Zone", &FluentFaces::Run::Zone);
  add("BoundaryType", &FluentFaces::Run::BoundaryType);
}
}

//------------------------------------------------------------------------------
bool ReadFluentSurface(FluentFile& file, FluentFaces& faces, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  FluentNodes nodes(file);
  CellMesh mesh;
  mesh.NumberOfPoints = nodes.Count();
  CellMeshPiece piece;
  if (!file.ZonesLeftOut.empty())
  {
    piece.LeaveOutUnusedPoints();
  }
  if (!faces.Keep(false, progress.Part(0, 0.3)) || !faces.Check(progress.Part(0.3, 0.4)) ||
    !ReadFaces(file, faces, mesh, progress.Part(0.4, 0.6)) ||
    !Select(file, faces, mesh, request, piece, progress.Part(0.6, 0.7)))
  {
    return false;
  }
  const vtkIdType all = mesh.NumberOfPoints;
  KeepPiece(mesh, piece);
  const IdSet* const some = piece.IsWhole() ? nullptr : &piece.GetPoints();
  const auto points = nodes.Read(all, some, progress.Part(0.7, 0.9));
  if (!points)
  {
    return false;
  }
  piece.WarnOfRepeatedPoints(mesh, warnings, progress.Part(0.9, 1), "face", "faces");
  FillGrid(mesh, piece, points, grid);
  AddArrays(faces, piece, grid);
  return true;
}
}
