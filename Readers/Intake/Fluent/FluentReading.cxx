// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentReading.h"

#include "Base/Parallel.h"
#include "Intake/CellMesh/CellGrid.h"
#include "Intake/Fluent/FluentBoundaries.h"
#include "Intake/Fluent/FluentGrid.h"
#include "Intake/Fluent/FluentNodes.h"
#include "Intake/Fluent/FluentSurface.h"
#include "Intake/Fluent/FluentText.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
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
  FluentReading(FluentFile& file, const PieceRequest& request, const FluentOptions& options)
    : File(file)
    , Request(request)
    , Options(options)
  {
  }

  bool Read(vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, Warnings& warnings,
    const Progress& progress);

  const ScanError& GetError() const
  {
    return this->File.HasFailed() ? this->File.GetError() : this->Error;
  }

private:
  bool KeepFaces(vtkIdType nodes, const Progress& progress);
  bool StreamFaces(vtkIdType nodes, const Progress& progress);
  FluentPiece::FindSpace MakeSpaceFinder(const Progress& progress)
  {
    return [this, progress](PieceOfSpace& space)
    { return FindFluentSpace(this->File, this->Options.Chunk, progress.Part(0, 0), space); };
  }
  bool ReadTree();
  bool ReadCells(
    vtkIdType nodes, vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress);
  bool CheckDeclaredFaces();
  void AddArrays(vtkUnstructuredGrid* grid) const;

  FluentFile& File;
  const PieceRequest& Request;
  const FluentOptions& Options;
  FluentFaces Faces;
  FluentCells Cells;
  FluentPiece Piece;
  FluentFaceTree Tree;
  FluentInteriorZones Interior;
  ScanError Error;
};

//------------------------------------------------------------------------------
// Split faces: "(59 (first last parents children) (n child1 ... childn ...))".
bool FluentReading::ReadTree()
{
  for (const FluentSection& section : this->File.FaceTrees)
  {
    if (!section.Begin || section.HeaderSize < 2)
    {
      continue;
    }
    const char* text = section.Begin;
    const auto read = [&](std::int64_t& value, const char* what)
    {
      if (!section.IsText())
      {
        if (section.End - text < 4)
        {
          return false; // it was valid before the file changed
        }
        value = Load<std::int32_t>(text, this->File.IsSwapped());
        text += 4;
        return true;
      }
      const char* const place = text;
      text = ParseHex(text, section.End, value);
      if (!text)
      {
        this->File.FailAt(place, ErrorKind::Syntax, std::string(what) + ", a hexadecimal number");
      }
      return text != nullptr;
    };
    for (std::int64_t id = section.Header[0]; id <= section.Header[1]; ++id)
    {
      std::int64_t count = 0, child = 0;
      const vtkIdType parent = this->Faces.FindId(id);
      if (!read(count, "the number of parts of a face"))
      {
        return false;
      }
      for (; count > 0; --count)
      {
        const char* const place = text;
        if (!read(child, "a part of a face"))
        {
          return false;
        }
        const vtkIdType position = this->Faces.FindId(child);
        if (position < 0 || parent < 0)
        {
          this->File.FailAt(place, ErrorKind::Index,
            parent < 0 ? "parts of an existing face" : "an existing face",
            std::to_string(parent < 0 ? id : child));
          return false;
        }
        this->Tree.Entries.push_back({ position, parent });
      }
    }
  }
  if (!this->Options.JoinSplitFaces)
  {
    this->Tree = FluentFaceTree();
  }
  this->Tree.Build();
  return true;
}

//------------------------------------------------------------------------------
// Makes all faces accessible.
bool FluentReading::KeepFaces(vtkIdType nodes, const Progress& progress)
{
  if (!this->Faces.Keep(this->File, false, this->Options.Chunk, progress.Part(0, 0.8)) ||
    !this->Faces.Check(this->File, nodes, this->Cells.GetCount(), progress.Part(0.8, 1)))
  {
    return false;
  }
  return this->Interior.AddAll(this->Faces, this->Cells, progress.Part(1, 1)) && this->ReadTree();
}

//------------------------------------------------------------------------------
// Determines the piece without storing faces; false if that is impossible.
bool FluentReading::StreamFaces(vtkIdType nodes, const Progress& progress)
{
  return this->File.FaceTrees.empty() &&
    this->Faces.Keep(this->File, true, this->Options.Chunk, progress.Part(0, 0.1)) &&
    this->Faces.Check(this->File, nodes, this->Cells.GetCount(), progress.Part(0.1, 0.2)) &&
    this->Faces.Stream(
      this->File, nodes, this->Cells.GetCount(), this->Options.Chunk, progress.Part(0.2, 0.3)) &&
    this->Interior.AddAll(this->Faces, this->Cells, progress.Part(0.3, 0.5)) &&
    this->Piece.Select(this->Faces, this->Cells, nodes, this->Request,
      this->MakeSpaceFinder(progress), progress.Part(0.5, 1));
}

//------------------------------------------------------------------------------
// Faces need not be stored if all cells are of standard types, as in most meshes.
bool FluentReading::ReadCells(
  vtkIdType nodes, vtkUnstructuredGrid* grid, Warnings& warnings, const Progress& progress)
{
  const bool isWhole = this->Request.NumberOfPieces <= 1;
  const bool streams = !isWhole && this->StreamFaces(nodes, progress.Part(0, 0.3));
  if (progress.IsStopped() || this->File.HasFailed())
  {
    return false;
  }
  if (!streams)
  {
    this->Faces.StopStreaming();
    if (!(isWhole ? this->Faces.Keep(this->File, true, this->Options.Chunk, progress.Part(0, 0.2))
                  : this->KeepFaces(nodes, progress.Part(0, 0.2))) ||
      !this->Piece.Select(this->Faces, this->Cells, nodes, this->Request,
        this->MakeSpaceFinder(progress), progress.Part(0.2, 0.3)))
    {
      return false;
    }
  }
  const FluentMesh mesh{ this->Faces, this->Cells, this->Piece, this->Tree,
    this->File.GetDimension() };
  if (this->File.FaceTrees.empty())
  {
    FluentFaceBatches batches(this->File, mesh, nodes, this->Options.Chunk);
    const Progress part = progress.Part(0.3, 1);
    if (StreamFluentStandardCells(mesh, batches, this->Interior, grid, part))
    {
      return true;
    }
  }
  if (progress.IsStopped() || (isWhole && !this->KeepFaces(nodes, progress.Part(0.3, 0.5))))
  {
    return false;
  }
  const bool good = BuildFluentCells(mesh, grid, warnings, this->Error, progress.Part(0.5, 1));
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
  if (declared.Count > this->Faces.GetCount())
  {
    this->File.FailAt(declared.Place, ErrorKind::Truncated,
      std::to_string(declared.Count) + " faces, as declared",
      std::to_string(this->Faces.GetCount()));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentReading::Read(vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries,
  Warnings& warnings, const Progress& progress)
{
  const vtkIdType nodes = CountFluentNodes(this->File);
  if (nodes < 0 || !this->Faces.Open(this->File))
  {
    return false;
  }
  if (this->Faces.GetCount() == 0 || nodes == 0)
  {
    this->File.Fail(
      ErrorKind::Unsupported, "a mesh with nodes and faces", nodes == 0 ? "no nodes" : "no faces");
    return false;
  }
  this->Interior.Find(this->Faces);
  constexpr std::int64_t MaxCellsPerFace = 4; // two, and the same number of refined ones
  if (!this->Cells.Load(this->File, MaxCellsPerFace * this->Faces.GetCount()))
  {
    return false;
  }
  if (this->Cells.GetNumberOfLeaves() == 0 && this->Cells.GetCount() > 0)
  {
    this->File.Fail(ErrorKind::Unsupported, "a mesh with active cells", "no active cell");
    return false;
  }
  if (this->Cells.GetNumberOfLeaves() == 0)
  {
    const bool good = ReadFluentSurface(this->File, this->Faces, nodes, this->Request,
                        this->Options.Chunk, grid, warnings, progress) &&
      this->CheckDeclaredFaces();
    AddFluentZones(this->File, grid->GetFieldData());
    return good;
  }
  if (!this->ReadCells(nodes, grid, warnings, progress.Part(0, 0.8)) || !this->CheckDeclaredFaces())
  {
    return false;
  }
  this->Faces.KeepBoundariesOnly();
  const IdSet* const some = this->Piece.IsWhole() ? nullptr : &this->Piece.GetPoints();
  const auto coordinates =
    ReadFluentNodes(this->File, nodes, some, this->Options.Chunk, progress.Part(0.8, 1));
  if (!coordinates)
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
  this->AddArrays(grid);
  if (!this->Piece.IsWhole())
  {
    using Test = std::function<bool(vtkIdType)>;
    const FluentPiece& piece = this->Piece;
    AddPieceIds(grid->GetPointData(), piece.GetPoints(),
      piece.HasGhosts() ? [&piece](vtkIdType id) { return piece.IsGhostPoint(id); } : Test());
    AddPieceIds(grid->GetCellData(), piece.GetLeaves(),
      piece.HasGhosts() ? [&piece](vtkIdType id) { return piece.IsGhostLeaf(id); } : Test());
  }
  if (boundaries &&
    !MakeFluentBoundaries(this->File, this->Faces, this->Cells, this->Piece, points, boundaries,
      this->Request.Piece == 0 ? &warnings : nullptr) &&
    this->Request.Piece == 0)
  {
    warnings.Add("there are too many face zones; boundaries are not shown");
  }
  if (this->Request.Piece == 0 && this->Cells.GetNumberOfUndeclared() > 0)
  {
    warnings.Add("cells without a section that declares their type and zone, which are unknown: " +
      std::to_string(this->Cells.GetNumberOfUndeclared()));
  }
  return true;
}

//------------------------------------------------------------------------------
void FluentReading::AddArrays(vtkUnstructuredGrid* grid) const
{
  const vtkIdType size = this->Piece.GetNumberOfCells();
  Buffer<int> zones(size);
  const bool hasGaps = this->Cells.HasGaps();
  Buffer<vtkIdType> ids(hasGaps ? size : 0);
  constexpr vtkIdType Grain = 65536;
  ParallelFor(size, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      const bool isOne = this->Piece.IsWhole() && this->Cells.HaveOneZone(begin, end);
      const int zone = this->Cells.GetZone(this->Piece.GetLeaf(begin));
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType leaf = this->Piece.GetLeaf(cell);
        zones[cell] = isOne ? zone : this->Cells.GetZone(leaf);
        if (hasGaps)
        {
          ids[cell] = this->Cells.GetId(leaf);
        }
      }
    });
  const auto add = [grid](vtkDataArray* array, const char* name)
  {
    array->SetName(name);
    grid->GetCellData()->AddArray(array);
  };
  add(zones.TakeArray<vtkIntArray>(), "Zone");
  if (hasGaps)
  {
    add(ids.TakeArray<vtkIdTypeArray>(), "OriginalCellId");
  }
  AddFluentZones(this->File, grid->GetFieldData());
  this->Interior.AddTo(grid->GetFieldData());
}
}

//------------------------------------------------------------------------------
bool ReadFluent(FluentFile& file, const PieceRequest& request, const FluentOptions& options,
  vtkUnstructuredGrid* grid, vtkMultiBlockDataSet* boundaries, Warnings& warnings, ScanError& error,
  const Progress& progress)
{
  FluentReading reading(file, request, options);
  const bool good = reading.Read(grid, boundaries, warnings, progress);
  error = good ? ScanError() : reading.GetError();
  return good;
}
}
