// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFile.h"

#include "Base/Parallel.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Fluent/FluentMesh.h"
#include "Intake/Fluent/FluentNumbers.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Split faces: "(59 (first last parents children) (n child1 ... childn ...))".
bool ReadTree(FluentMesh& mesh)
{
  FluentFile& file = mesh.File;
  for (const FluentSection& section : file.FaceTrees)
  {
    FluentNumbers<std::int32_t> numbers(file, section);
    numbers.Read(numbers.All, true);
    std::int64_t next = 0;
    const auto read = [&](const char* what)
    {
      if (next == numbers.GetCount())
      {
        file.FailAt(
          numbers.Find(next), ErrorKind::Syntax, std::string(what) + ", a hexadecimal number");
        return std::int32_t(0);
      }
      return std::int32_t(numbers.GetData()[next++]);
    };
    for (std::int64_t id = section.Header[0]; id <= section.Header[1]; ++id)
    {
      const vtkIdType whole = mesh.Faces.FindId(id);
      for (std::int32_t count = read("the number of parts of a face"); count > 0; --count)
      {
        const std::int32_t part = read("a part of a face");
        const vtkIdType position = mesh.Faces.FindId(part);
        if (position < 0 || whole < 0)
        {
          file.FailAt(numbers.Find(next - 1), ErrorKind::Index,
            whole < 0 ? "parts of an existing face" : "an existing face",
            std::to_string(whole < 0 ? id : part));
          return false;
        }
        mesh.SplitFaces.emplace(position, whole);
      }
      if (file.HasFailed())
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool SelectPiece(
  FluentMesh& mesh, vtkIdType nodes, const PieceRequest& request, const Progress& progress)
{
  if (mesh.File.LeavesOutCells())
  {
    mesh.Piece.LeaveOutUnusedPoints();
  }
  mesh.Piece.SetPoints([&](const PieceOfSpace::Visit& visit)
    { return ForEachFluentNode(mesh.File, visit, progress.Part(0, 0)); });
  const auto visit = [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
  {
    if (run.Bounds && face.Size > 0)
    {
      thread_local std::vector<std::int32_t> points;
      points.assign(face.Nodes, face.Nodes + face.Size);
      std::for_each(points.begin(), points.end(), [](std::int32_t& point) { --point; });
      const vtkIdType cells[2] = { mesh.Cells.FindLeaf(face.GetCell(0)),
        mesh.Cells.FindLeaf(face.GetCell(1)) };
      mesh.Piece.VisitFace(position, cells, points.data(), face.Size);
    }
  };
  const bool good = mesh.Piece.FindByFaces(nodes, mesh.Cells.GetNumberOfLeaves(),
    mesh.Faces.GetCount(), request, [&] { return mesh.Faces.ForEach(progress, visit); });
  if (good && !mesh.Piece.IsWhole())
  {
    mesh.Leaves = mesh.Piece.GetCells().GetMembers();
  }
  return good;
}

//------------------------------------------------------------------------------
// Faces need not be kept if all cells are of standard types, as in most meshes, or for a piece.
bool ReadCells(FluentMesh& mesh, vtkIdType nodes, const PieceRequest& request,
  vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  if (!ReadTree(mesh) || !SelectPiece(mesh, nodes, request, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (mesh.SplitFaces.empty() && StreamFluentStandardCells(mesh, grid, progress.Part(0.3, 1)))
  {
    return true;
  }
  return !progress.IsStopped() && !mesh.File.HasFailed() &&
    BuildFluentCells(mesh, request.Piece == 0, grid, warnings, progress.Part(0.4, 1));
}

//------------------------------------------------------------------------------
bool CheckDeclaredFaces(const FluentMesh& mesh)
{
  const FluentTotal& declared = mesh.File.DeclaredFaces;
  if (declared.Count > mesh.Faces.GetCount())
  {
    mesh.File.FailAt(declared.Place, ErrorKind::Truncated,
      std::to_string(declared.Count) + " faces, as declared",
      std::to_string(mesh.Faces.GetCount()));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void AddArrays(const FluentMesh& mesh, vtkUnstructuredGrid* grid)
{
  const vtkIdType size = mesh.Piece.GetNumberOfCells();
  Buffer<int> zones(size);
  const bool hasGaps = mesh.Cells.HasGaps();
  Buffer<vtkIdType> ids(hasGaps ? size : 0);
  ParallelForEach(size, LightGrain,
    [&](vtkIdType cell)
    {
      const vtkIdType leaf = mesh.GetLeaf(cell);
      zones[cell] = mesh.Cells.GetZone(leaf);
      if (hasGaps)
      {
        ids[cell] = mesh.Cells.GetId(leaf);
      }
    });
  grid->GetCellData()->AddArray(zones.TakeArray<vtkIntArray>(1, "Zone"));
  if (hasGaps)
  {
    grid->GetCellData()->AddArray(ids.TakeArray<vtkIdTypeArray>(1, "OriginalCellId"));
  }
  AddFluentZones(mesh.File, grid->GetFieldData());
  mesh.InteriorZones.AddTo(grid->GetFieldData());
}

//------------------------------------------------------------------------------
bool Read(FluentMesh& mesh, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, const Progress& progress)
{
  FluentFile& file = mesh.File;
  const vtkIdType nodes = CountFluentNodes(file);
  if (nodes < 0 || !mesh.Faces.Open(file, nodes))
  {
    return false;
  }
  if (mesh.Faces.GetCount() == 0 || nodes == 0)
  {
    file.Fail(
      ErrorKind::Unsupported, "a mesh with nodes and faces", nodes == 0 ? "no nodes" : "no faces");
    return false;
  }
  mesh.InteriorZones.Find(mesh.Faces);
  constexpr std::int64_t MaxCellsPerFace = 4; // two, and the same number of refined ones
  if (!mesh.Cells.Load(file, MaxCellsPerFace * mesh.Faces.GetCount()))
  {
    return false;
  }
  mesh.Faces.SetNumberOfCells(mesh.Cells.GetCount());
  if (mesh.Cells.GetNumberOfLeaves() == 0 && mesh.Cells.GetCount() > 0)
  {
    file.Fail(ErrorKind::Unsupported,
      file.LeavesOutCells() ? "at least one chosen zone of cells" : "a mesh with active cells",
      file.LeavesOutCells() ? "none" : "no active cell");
    return false;
  }
  if (mesh.Cells.GetNumberOfLeaves() == 0)
  {
    const bool good = ReadFluentSurface(file, mesh.Faces, request, grid, warnings, progress) &&
      CheckDeclaredFaces(mesh);
    AddFluentZones(file, grid->GetFieldData());
    return good;
  }
  if (!ReadCells(mesh, nodes, request, grid, warnings, progress.Part(0, 0.8)) ||
    !CheckDeclaredFaces(mesh))
  {
    return false;
  }
  const IdSet* const some = mesh.Piece.IsWhole() ? nullptr : &mesh.Piece.GetPoints();
  const auto coordinates = ReadFluentNodes(file, nodes, some, progress.Part(0.8, 1));
  if (!coordinates)
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
  AddArrays(mesh, grid);
  AddPieceIds(mesh.Piece, grid);
  Warnings unheard;
  Warnings& heard = request.Piece == 0 ? warnings : unheard; // of the file, not of the piece
  if (boundaries && !MakeFluentBoundaries(mesh, points, boundaries, heard))
  {
    return false;
  }
  if (mesh.Cells.GetNumberOfUndeclared() > 0)
  {
    heard.Add("cells without a section that declares their type and zone, which are unknown: " +
      std::to_string(mesh.Cells.GetNumberOfUndeclared()));
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool ReadFluent(FluentFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress)
{
  FluentMesh mesh{ file };
  const bool good = Read(mesh, request, grid, boundaries, warnings, progress);
  error = file.GetError();
  return good;
}
}
