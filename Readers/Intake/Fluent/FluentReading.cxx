// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentReading.h"

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
// Reads a mesh, once.
class FluentReading
{
public:
  FluentReading(FluentFile& file, const PieceRequest& request)
    : File(file)
    , Request(request)
  {
    this->Mesh.Dimension = file.GetDimension();
  }

  bool Read(vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, Warnings& warnings,
    const Progress& progress);

  const ScanError& GetError() const
  {
    return this->File.HasFailed() ? this->File.GetError() : this->Error;
  }

private:
  bool ReadTree();
  bool SelectPiece(vtkIdType nodes, const Progress& progress);
  bool ReadCells(
    vtkIdType nodes, vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);
  bool CheckDeclaredFaces();
  void AddArrays(vtkUnstructuredGrid* grid) const;

  FluentFile& File;
  const PieceRequest& Request;
  FluentMesh Mesh;
  FluentInteriorZones Interior;
  ScanError Error;
};

//------------------------------------------------------------------------------
// Split faces: "(59 (first last parents children) (n child1 ... childn ...))".
bool FluentReading::ReadTree()
{
  for (const FluentSection& section : this->File.FaceTrees)
  {
    FluentNumbers<std::int32_t> numbers(this->File, section);
    numbers.Read(numbers.All);
    std::int64_t next = 0;
    const auto read = [&](const char* what)
    {
      if (next == numbers.GetCount())
      {
        this->File.FailAt(
          numbers.Find(next), ErrorKind::Syntax, std::string(what) + ", a hexadecimal number");
        return std::int32_t(0);
      }
      return numbers.GetData()[next++];
    };
    for (std::int64_t id = section.Header[0]; id <= section.Header[1]; ++id)
    {
      const vtkIdType whole = this->Mesh.Faces.FindId(id);
      for (std::int32_t count = read("the number of parts of a face"); count > 0; --count)
      {
        const std::int32_t part = read("a part of a face");
        const vtkIdType position = this->Mesh.Faces.FindId(part);
        if (position < 0 || whole < 0)
        {
          this->File.FailAt(numbers.Find(next - 1), ErrorKind::Index,
            whole < 0 ? "parts of an existing face" : "an existing face",
            std::to_string(whole < 0 ? id : part));
          return false;
        }
        this->Mesh.SplitFaces.emplace(position, whole);
      }
      if (this->File.HasFailed())
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentReading::SelectPiece(vtkIdType nodes, const Progress& progress)
{
  if (this->File.LeavesOutCells())
  {
    this->Mesh.Piece.LeaveOutUnusedPoints();
  }
  this->Mesh.Piece.SetPoints([&](const PieceOfSpace::Visit& visit)
    { return ForEachFluentNode(this->File, visit, progress.Part(0, 0)); });
  const bool good = this->Mesh.Piece.FindByFaces(nodes, this->Mesh.Cells.GetNumberOfLeaves(),
    this->Mesh.Faces.GetCount(), this->Request,
    [&]
    {
      return this->Mesh.Faces.ForEach(progress,
        [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
        {
          if (!run.Bounds || face.Size == 0)
          {
            return;
          }
          thread_local std::vector<std::int32_t> points;
          points.assign(face.Nodes, face.Nodes + face.Size);
          for (std::int32_t& point : points)
          {
            --point;
          }
          const vtkIdType cells[2] = { this->Mesh.Cells.FindLeaf(face.GetCell(0)),
            this->Mesh.Cells.FindLeaf(face.GetCell(1)) };
          this->Mesh.Piece.VisitFace(position, cells, points.data(), face.Size);
        });
    });
  if (good && !this->Mesh.Piece.IsWhole())
  {
    this->Mesh.Leaves = this->Mesh.Piece.GetCells().GetMembers();
  }
  return good;
}

//------------------------------------------------------------------------------
// Faces need not be kept if all cells are of standard types, as in most meshes, or for a piece.
bool FluentReading::ReadCells(
  vtkIdType nodes, vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  if (!this->ReadTree() || !this->SelectPiece(nodes, progress.Part(0, 0.3)))
  {
    return false;
  }
  if (this->Mesh.SplitFaces.empty() &&
    StreamFluentStandardCells(this->Mesh, this->Interior, grid, progress.Part(0.3, 1)))
  {
    return true;
  }
  if (progress.IsStopped() || this->File.HasFailed())
  {
    return false;
  }
  const bool good = BuildFluentCells(this->Mesh, this->Request.Piece == 0, this->Interior, grid,
    warnings, this->Error, progress.Part(0.4, 1));
  if (this->Error)
  {
    this->Error.Message = this->File.GetName() + ": " + this->Error.Message;
  }
  return good;
}

//------------------------------------------------------------------------------
bool FluentReading::CheckDeclaredFaces()
{
  const FluentTotal& declared = this->File.DeclaredFaces;
  if (declared.Count > this->Mesh.Faces.GetCount())
  {
    this->File.FailAt(declared.Place, ErrorKind::Truncated,
      std::to_string(declared.Count) + " faces, as declared",
      std::to_string(this->Mesh.Faces.GetCount()));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentReading::Read(vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries,
  Warnings& warnings, const Progress& progress)
{
  const vtkIdType nodes = CountFluentNodes(this->File);
  if (nodes < 0 || !this->Mesh.Faces.Open(this->File, nodes))
  {
    return false;
  }
  if (this->Mesh.Faces.GetCount() == 0 || nodes == 0)
  {
    this->File.Fail(
      ErrorKind::Unsupported, "a mesh with nodes and faces", nodes == 0 ? "no nodes" : "no faces");
    return false;
  }
  this->Interior.Find(this->Mesh.Faces);
  constexpr std::int64_t MaxCellsPerFace = 4; // two, and the same number of refined ones
  if (!this->Mesh.Cells.Load(this->File, MaxCellsPerFace * this->Mesh.Faces.GetCount()))
  {
    return false;
  }
  this->Mesh.Faces.SetNumberOfCells(this->Mesh.Cells.GetCount());
  if (this->Mesh.Cells.GetNumberOfLeaves() == 0 && this->Mesh.Cells.GetCount() > 0)
  {
    this->File.Fail(ErrorKind::Unsupported,
      this->File.LeavesOutCells() ? "at least one chosen zone of cells"
                                  : "a mesh with active cells",
      this->File.LeavesOutCells() ? "none" : "no active cell");
    return false;
  }
  if (this->Mesh.Cells.GetNumberOfLeaves() == 0)
  {
    const bool good =
      ReadFluentSurface(this->File, this->Mesh.Faces, this->Request, grid, warnings, progress) &&
      this->CheckDeclaredFaces();
    AddFluentZones(this->File, grid->GetFieldData());
    return good;
  }
  if (!this->ReadCells(nodes, grid, warnings, progress.Part(0, 0.8)) || !this->CheckDeclaredFaces())
  {
    return false;
  }
  const IdSet* const some = this->Mesh.Piece.IsWhole() ? nullptr : &this->Mesh.Piece.GetPoints();
  const auto coordinates = ReadFluentNodes(this->File, nodes, some, progress.Part(0.8, 1));
  if (!coordinates)
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
  this->AddArrays(grid);
  AddPieceIds(this->Mesh.Piece, grid);
  Warnings none;
  if (boundaries &&
    !MakeFluentBoundaries(
      this->File, this->Mesh, points, boundaries, this->Request.Piece == 0 ? warnings : none))
  {
    return false;
  }
  if (this->Request.Piece == 0 && this->Mesh.Cells.GetNumberOfUndeclared() > 0)
  {
    warnings.Add("cells without a section that declares their type and zone, which are unknown: " +
      std::to_string(this->Mesh.Cells.GetNumberOfUndeclared()));
  }
  return true;
}

//------------------------------------------------------------------------------
void FluentReading::AddArrays(vtkUnstructuredGrid* grid) const
{
  const vtkIdType size = this->Mesh.Piece.GetNumberOfCells();
  Buffer<int> zones(size);
  const bool hasGaps = this->Mesh.Cells.HasGaps();
  Buffer<vtkIdType> ids(hasGaps ? size : 0);
  ParallelFor(size, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType leaf = this->Mesh.GetLeaf(cell);
        zones[cell] = this->Mesh.Cells.GetZone(leaf);
        if (hasGaps)
        {
          ids[cell] = this->Mesh.Cells.GetId(leaf);
        }
      }
    });
  grid->GetCellData()->AddArray(zones.TakeArray<vtkIntArray>(1, "Zone"));
  if (hasGaps)
  {
    grid->GetCellData()->AddArray(ids.TakeArray<vtkIdTypeArray>(1, "OriginalCellId"));
  }
  AddFluentZones(this->File, grid->GetFieldData());
  this->Interior.AddTo(grid->GetFieldData());
}
}

//------------------------------------------------------------------------------
bool ReadFluent(FluentFile& file, const PieceRequest& request, vtkUnstructuredGrid* grid,
  vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error, const Progress& progress)
{
  FluentReading reading(file, request);
  const bool good = reading.Read(grid, boundaries, warnings, progress);
  error = good ? ScanError() : reading.GetError();
  return good;
}
}
