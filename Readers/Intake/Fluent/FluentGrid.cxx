// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentMesh.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/FacesOfCells.h"
#include "Intake/FaceMesh/GridBuilder.h"
#include "vtkCamaronCompat.h"

#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <numeric>

namespace camaron
{
namespace
{
using Cells = std::array<vtkIdType, 2>; // on both sides of a face, -1 for none

//------------------------------------------------------------------------------
// The cells of split faces that have them instead of their parts.
using JoinedFaces = std::map<vtkIdType, Cells>;

//------------------------------------------------------------------------------
// Ids of faces whose cells cannot be right.
struct OddFaces
{
  Tally OneSided[2]; // without a cell on this side, although they are interior
  Tally SameCell;

  void Add(const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
  {
    const bool isSame = face.GetCell(0) == face.GetCell(1);
    Tally& tally = isSame ? this->SameCell : this->OneSided[face.GetCell(0) == 0 ? 0 : 1];
    tally.Add(run.FirstId + position - run.Begin);
  }
  void Warn(const FluentFile& file, Warnings& warnings) const
  {
    const auto warn = [&](const Tally& tally, int side, const char* what)
    { warnings.Add(tally, "face", "faces", what, file.LocateCell(tally.First, side).c_str()); };
    for (int side = 0; side < 2; ++side)
    {
      warn(this->OneSided[side], side,
        side == 0 ? "of interior zones without the first cell (c0)"
                  : "of interior zones without the second cell (c1)");
    }
    warn(this->SameCell, 1, "with the same cell on both sides (c0 and c1)");
  }
};

//------------------------------------------------------------------------------
// The cells of a piece beside a face. Only cells of a declared type have split faces.
Cells FindCells(const FluentMesh& mesh, const FluentFaces::Run& run, const FluentFace& face)
{
  Cells cells;
  for (int side = 0; side < 2; ++side)
  {
    const vtkIdType cell = mesh.FindCell(face.GetCell(side));
    cells[side] = cell >= 0 && (run.Bounds || mesh.GetShape(cell).Faces > 0) ? cell : -1;
  }
  return cells;
}

//------------------------------------------------------------------------------
// Whether a cell has a face of which this one is a part.
bool IsJoined(const FluentMesh& mesh, const JoinedFaces& joined, vtkIdType position, vtkIdType cell)
{
  constexpr int MaxLevels = 32; // of faces whose parts were split again
  auto part = mesh.SplitFaces.find(position);
  for (int level = 0; level < MaxLevels && part != mesh.SplitFaces.end(); ++level)
  {
    const auto whole = joined.find(part->second);
    if (whole != joined.end() && (whole->second[0] == cell || whole->second[1] == cell))
    {
      return true;
    }
    part = mesh.SplitFaces.find(part->second);
  }
  return false;
}

//------------------------------------------------------------------------------
// Finds the faces of the cells of a piece, and in the whole mesh those whose cells cannot be right.
// False if stopped, or if the file has changed.
bool FindFaces(
  const FluentMesh& mesh, IdSet& kept, JoinedFaces& joined, OddFaces& odd, const Progress& progress)
{
  IdSet split(mesh.Faces.GetCount()); // positions
  for (const auto& [part, whole] : mesh.SplitFaces)
  {
    split.Add(whole);
  }
  std::mutex mutex;
  return mesh.Faces.ForEach(progress,
    [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
    {
      const Cells cells = FindCells(mesh, run, face);
      if (face.Nodes.Size > 0 && run.HasOddCells(face.GetCell(0), face.GetCell(1)))
      {
        const std::lock_guard<std::mutex> lock(mutex);
        odd.Add(run, position, face);
      }
      if (face.Nodes.Size > 0 && (run.Bounds || split.Contains(position)) &&
        std::max(cells[0], cells[1]) >= 0)
      {
        kept.Add(position);
        if (!run.Bounds)
        {
          const std::lock_guard<std::mutex> lock(mutex);
          joined.emplace(position, cells);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Reads the faces that were found, and lists those of every cell. False if stopped, or if the file
// has changed.
bool ReadFaces(const FluentMesh& mesh, IdSet& kept, const JoinedFaces& joined, FaceMesh& faces,
  const Progress& progress)
{
  const vtkIdType count = kept.Number();
  const auto forEachKept = [&](const Progress& part, auto&& visit)
  {
    return mesh.Faces.ForEach(part,
      [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
      {
        if (kept.Contains(position))
        {
          visit(run, position, kept.GetNumber(position), face);
        }
      });
  };
  Buffer<vtkIdType> begins(count + 1);
  begins[0] = 0;
  if (!forEachKept(progress.Part(0, 0.3),
        [&](const FluentFaces::Run&, vtkIdType, vtkIdType i, const FluentFace& face)
        { begins[i + 1] = 1 + face.Nodes.Size; }))
  {
    return false;
  }
  std::partial_sum(begins.data(), begins.data() + count + 1, begins.data());
  faces.FaceWords = Buffer<std::int32_t>(begins[count]);
  faces.Sides = Buffer<std::int32_t>(2 * count);
  if (!forEachKept(progress.Part(0.3, 0.7),
        [&](const FluentFaces::Run& run, vtkIdType position, vtkIdType i, const FluentFace& face)
        {
          std::int32_t* word = faces.FaceWords.data() + begins[i];
          const auto size = static_cast<std::int32_t>(begins[i + 1] - begins[i] - 1);
          const bool isSame = face.Nodes.Size == size; // unless the file has just changed
          *word++ = size;
          for (std::int32_t node = 0; node < size; ++node)
          {
            const vtkIdType point = isSame ? mesh.Piece.FindPoint(face.Nodes[node] - 1) : -1;
            *word++ = static_cast<std::int32_t>(std::max<vtkIdType>(point, 0));
          }
          const Cells cells = FindCells(mesh, run, face);
          for (int side = 0; side < 2; ++side)
          {
            const bool isHere = joined.empty() || !IsJoined(mesh, joined, position, cells[side]);
            faces.Sides[2 * i + side] = isHere ? static_cast<std::int32_t>(cells[side]) : -1;
          }
        }))
  {
    return false;
  }
  const vtkIdType cells = mesh.Piece.GetNumberOfCells();
  faces.CellWords = ListFacesOfCells(faces.Sides, cells);
  faces.FacesOfCells = IdSet(count);
  faces.FacesOfCells.AddMissing(IdSet(count)); // all
  IdLists::Expectation pointsOfFaces, facesOfCells;
  pointsOfFaces.Limit = mesh.Piece.GetNumberOfPoints();
  facesOfCells.Limit = count;
  return faces.Faces.Open(faces.FaceWords, count, pointsOfFaces, progress.Part(0.7, 0.9)) &&
    faces.Cells.Open(faces.CellWords, cells, facesOfCells, progress.Part(0.9, 1));
}

//------------------------------------------------------------------------------
// Warns about cells that the piece owns.
void Warn(const FluentMesh& mesh, const IdSet& faceless, const JoinedFaces& joined,
  vtkUnstructuredGrid* grid, Warnings& warnings)
{
  IdSet atHangingNodes(mesh.Piece.GetNumberOfCells());
  for (const auto& [face, cells] : joined)
  {
    atHangingNodes.Add(cells[0]);
    atHangingNodes.Add(cells[1]);
  }
  Tally empty, broken, other, hanging;
  const auto* const types = vtkUnsignedCharArray::SafeDownCast(GetCellTypes(grid)); // of SetCells
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const vtkIdType leaf = mesh.GetLeaf(cell);
    const FluentShape shape = mesh.GetShape(cell);
    if (mesh.Piece.IsGhostCell(leaf))
    {
      continue;
    }
    if (atHangingNodes.Contains(cell))
    {
      hanging.Add(mesh.Cells.GetId(leaf));
    }
    if (types->GetValue(cell) == VTK_EMPTY_CELL)
    {
      (faceless.Contains(cell) ? empty : broken).Add(mesh.Cells.GetId(leaf));
    }
    else if (shape.Faces > 0 && types->GetValue(cell) != shape.Type)
    {
      other.Add(mesh.Cells.GetId(leaf));
    }
  }
  warnings.Add(empty, "cell", "cells", "without faces");
  warnings.Add(broken, "cell", "cells", "whose edges do not form a closed ring, left empty");
  warnings.Add(other, "cell", "cells",
    mesh.Dimension == 2 ? "whose edges do not match the declared type, read as polygons"
                        : "whose faces do not match the declared type, read as polyhedra");
  warnings.Add(hanging, "cell", "cells",
    "at hanging nodes, not connected to refined neighbors because split faces are joined");
}
}

//------------------------------------------------------------------------------
bool BuildFluentCells(FluentMesh& mesh, bool isFirstPiece, vtkUnstructuredGrid* grid,
  Warnings& warnings, ScanError& error, const Progress& progress)
{
  const vtkIdType count = mesh.Piece.GetNumberOfCells();
  IdSet kept(mesh.Faces.GetCount()); // positions
  JoinedFaces joined;
  OddFaces odd;
  const bool areFound = FindFaces(mesh, kept, joined, odd, progress.Part(0, 0.1));
  if (areFound && isFirstPiece)
  {
    odd.Warn(mesh.Faces.GetFile(), warnings);
  }
  if (areFound && count == 0)
  {
    return true;
  }
  FaceMesh faces;
  faces.HasSides = true;
  faces.Dimension = mesh.Dimension;
  faces.Points.Count = mesh.Piece.GetNumberOfPoints();
  faces.Types = Buffer<unsigned char>(count);
  ParallelForEach(
    count, HeavyGrain, [&](vtkIdType cell) { faces.Types[cell] = mesh.GetShape(cell).Type; });
  if (!areFound || !ReadFaces(mesh, kept, joined, faces, progress.Part(0.1, 0.5)))
  {
    error = progress.IsStopped()
      ? ScanError()
      : ScanError{ ErrorKind::Changed,
          "expected the same faces in all passes, found different ones" };
    return false;
  }
  mesh.Faces.KeepBoundariesOnly();
  IdSet faceless(count);
  faces.Cells.ForEach(progress.Part(0.5, 0.5),
    [&](vtkIdType cell, const IdList& list)
    {
      if (list.Size == 0)
      {
        faceless.Add(cell);
      }
    });
  if (!BuildGrid(faces, PieceRequest(), grid, warnings, error, progress.Part(0.5, 1)))
  {
    return false;
  }
  Warn(mesh, faceless, joined, grid, warnings);
  return true;
}
}
