// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Intake/CellMesh/CellGrid.h"
#include "Intake/CellMesh/CellMeshPiece.h"
#include "Mesh/CellShape.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

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
  std::vector<std::int32_t> points;
  const auto add = [&](vtkIdType position, const FluentFace& face)
  {
    const std::int32_t size = face.Size;
    mesh.Types[position] = size == 0 ? VTK_EMPTY_CELL
      : file.GetDimension() == 2     ? VTK_LINE
                                     : GetPolygonType(size);
    mesh.Offsets[position] = static_cast<std::int32_t>(points.size());
    for (std::int32_t i = 0; i < size; ++i)
    {
      points.push_back(face.Nodes[i] - 1);
    }
  };
  if (!faces.ForEachBatch(progress, true,
        [&](const FluentFaces::Run& batch, const Progress& part)
        {
          FluentFaces::ForEachOf(batch, batch.Begin, batch.End, add);
          return part.Report(1);
        }))
  {
    return false;
  }
  if (points.size() > INT32_MAX)
  {
    file.Fail(ErrorKind::Unsupported, "faces with fewer than 2147483648 nodes", "more");
    return false;
  }
  mesh.Connectivity = Buffer<std::int32_t>(static_cast<vtkIdType>(points.size()));
  std::copy(points.begin(), points.end(), mesh.Connectivity.data());
  mesh.Offsets[mesh.NumberOfCells] = static_cast<std::int32_t>(points.size());
  return true;
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
  CellMesh mesh;
  mesh.NumberOfPoints = CountFluentNodes(file);
  CellMeshPiece piece;
  if (!file.ZonesLeftOut.empty())
  {
    piece.LeaveOutUnusedPoints();
  }
  if (!ReadFaces(file, faces, mesh, progress.Part(0, 0.6)) ||
    !Select(file, faces, mesh, request, piece, progress.Part(0.6, 0.7)))
  {
    return false;
  }
  const vtkIdType all = mesh.NumberOfPoints;
  KeepPiece(mesh, piece);
  const IdSet* const some = piece.IsWhole() ? nullptr : &piece.GetPoints();
  const auto points = ReadFluentNodes(file, all, some, progress.Part(0.7, 0.9));
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
