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
#include <vector>

namespace camaron
{
namespace
{
using Cells = std::array<vtkIdType, 2>; // on both sides of a face, -1 for none

//------------------------------------------------------------------------------
// The cells of split faces that have them instead of their parts.
using JoinedFaces = std::map<vtkIdType, Cells>;

//------------------------------------------------------------------------------
// Ids of faces whose cells cannot be right: interior ones without the first or the second cell, and
// those with the same cell on both sides.
struct OddFaces
{
  Tally Kinds[3];

  void Add(const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
  {
    const int kind = face.GetCell(0) == face.GetCell(1) ? 2 : face.GetCell(0) == 0 ? 0 : 1;
    this->Kinds[kind].Add(run.FirstId + position - run.Begin);
  }
  void Warn(const FluentFile& file, Warnings& warnings) const
  {
    static constexpr const char* What[] = { "of interior zones without the first cell (c0)",
      "of interior zones without the second cell (c1)",
      "with the same cell on both sides (c0 and c1)" };
    for (int kind = 0; kind < 3; ++kind)
    {
      const Tally& tally = this->Kinds[kind];
      warnings.Add(tally, "face", "faces", What[kind],
        file.LocateCell(tally.First, kind == 0 ? 0 : 1).c_str());
    }
  }
};

//------------------------------------------------------------------------------
// The cells of a piece that a face bounds: a split face has those of a declared type.
Cells FindCells(
  const FluentMesh& mesh, const FluentFaces::Run& run, const FluentFace& face, bool isSplit)
{
  Cells cells = { -1, -1 };
  for (int side = 0; side < 2 && face.Size > 0 && (run.Bounds || isSplit); ++side)
  {
    const vtkIdType cell = mesh.FindCell(face.GetCell(side));
    cells[side] = cell >= 0 && (run.Bounds || mesh.GetShape(cell).Faces > 0) ? cell : -1;
  }
  return cells;
}

//------------------------------------------------------------------------------
// The faces of the cells of a piece, in the order of the file.
class FaceCollection
{
public:
  explicit FaceCollection(FluentMesh& mesh)
    : Mesh(mesh)
    , Split(mesh.SplitFaces.empty() ? 0 : mesh.Faces.GetCount())
    , Kept(this->Split.GetLimit())
  {
    for (const auto& [part, whole] : mesh.SplitFaces)
    {
      this->Split.Add(whole);
    }
  }

  /// False with the error in the file, or if stopped.
  bool Read(const Progress& progress);

  FaceMesh Faces; ///< only FaceWords and Sides
  JoinedFaces Joined;
  OddFaces Odd; ///< in the whole mesh

private:
  /// Some values of the arrays of Faces.
  struct Part
  {
    std::vector<std::int32_t> Words, Sides;
  };
  void Add(const FluentFaces::Run& run, vtkIdType position, const FluentFace& face, Part& part);
  bool IsJoined(vtkIdType position, vtkIdType cell) const;

  FluentMesh& Mesh;
  IdSet Split, Kept; ///< positions, if some faces are split
  std::mutex Mutex;
};

//------------------------------------------------------------------------------
// Appends values, with room for more: for those of the whole file, if these are from a share of it
// and as large as the others.
void Append(const std::vector<std::int32_t>& more, double share, vtkIdType& size,
  Buffer<std::int32_t>& values)
{
  const auto needed = size + static_cast<vtkIdType>(more.size());
  if (needed > values.size())
  {
    constexpr double Most = 4; // times as many
    Buffer<std::int32_t> larger(
      static_cast<vtkIdType>(static_cast<double>(needed) * std::min(Most, 1 / share)));
    std::copy_n(values.data(), size, larger.data());
    values = std::move(larger);
  }
  std::copy(more.begin(), more.end(), values.data() + size);
  size = needed;
}

//------------------------------------------------------------------------------
void FaceCollection::Add(
  const FluentFaces::Run& run, vtkIdType position, const FluentFace& face, Part& part)
{
  const Cells cells = FindCells(this->Mesh, run, face, this->Split.Contains(position));
  if (run.HasOddCells(face.GetCell(0), face.GetCell(1)) && face.Size > 0)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Odd.Add(run, position, face);
  }
  if (std::max(cells[0], cells[1]) < 0)
  {
    return;
  }
  part.Words.push_back(face.Size);
  for (std::int32_t i = 0; i < face.Size; ++i)
  {
    const vtkIdType point = this->Mesh.Piece.FindPoint(face.Nodes[i] - 1);
    part.Words.push_back(static_cast<std::int32_t>(point));
  }
  part.Sides.insert(
    part.Sides.end(), { static_cast<std::int32_t>(cells[0]), static_cast<std::int32_t>(cells[1]) });
  this->Kept.Add(position);
  if (!run.Bounds)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Joined.emplace(position, cells);
  }
}

//------------------------------------------------------------------------------
// Whether a cell has a face, or one of which it is a part, although it was split.
bool FaceCollection::IsJoined(vtkIdType position, vtkIdType cell) const
{
  constexpr int MaxLevels = 32; // of faces whose parts were split again
  for (int level = 0; level < MaxLevels; ++level)
  {
    const auto joined = this->Joined.find(position);
    if (joined != this->Joined.end() && (joined->second[0] == cell || joined->second[1] == cell))
    {
      return true;
    }
    const auto next = this->Mesh.SplitFaces.find(position);
    position = next != this->Mesh.SplitFaces.end() ? next->second : -1;
  }
  return false;
}

//------------------------------------------------------------------------------
bool FaceCollection::Read(const Progress& progress)
{
  constexpr vtkIdType BlockSize = FluentFaces::BlockSize;
  Buffer<std::int32_t>&words = this->Faces.FaceWords, &sides = this->Faces.Sides;
  vtkIdType numberOfWords = 0, numberOfSides = 0;
  const auto read = [&](const FluentFaces::Run& batch, const Progress& done)
  {
    const vtkIdType blocks = (batch.End - batch.Begin + BlockSize - 1) / BlockSize;
    std::vector<Part> parts(static_cast<std::size_t>(blocks));
    ParallelForEach(blocks, 4,
      [&](vtkIdType i)
      {
        const vtkIdType first = batch.Begin + i * BlockSize;
        const vtkIdType last = std::min(first + BlockSize, batch.End);
        this->Mesh.InteriorZones.Add(batch, first, last, this->Mesh.Cells);
        FluentFaces::ForEachOf(batch, first, last, [&](vtkIdType position, const FluentFace& face)
          { this->Add(batch, position, face, parts[i]); });
      });
    const auto all = 1.1 * static_cast<double>(this->Mesh.Faces.GetCount()); // and a reserve
    for (const Part& part : parts)
    {
      Append(part.Words, static_cast<double>(batch.End) / all, numberOfWords, words);
      Append(part.Sides, static_cast<double>(batch.End) / all, numberOfSides, sides);
    }
    return done.Report(1);
  };
  if (!this->Mesh.Faces.ForEachBatch(progress, true, read))
  {
    return false;
  }
  words.Shrink(numberOfWords);
  sides.Shrink(numberOfSides);
  this->Kept.Number();
  for (const auto& [position, whole] : this->Mesh.SplitFaces)
  {
    std::int32_t* const cells = sides.data() + 2 * this->Kept.GetNumber(position);
    for (int side = 0; side < 2 && this->Kept.Contains(position); ++side)
    {
      cells[side] = this->IsJoined(whole, cells[side]) ? -1 : cells[side];
    }
  }
  return true;
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
    mesh.File.GetDimension() == 2
      ? "whose edges do not match the declared type, read as polygons"
      : "whose faces do not match the declared type, read as polyhedra");
  warnings.Add(hanging, "cell", "cells",
    "at hanging nodes, not connected to refined neighbors because split faces are joined");
}
}

//------------------------------------------------------------------------------
bool BuildFluentCells(FluentMesh& mesh, bool isFirstPiece, vtkUnstructuredGrid* grid,
  Warnings& warnings, const Progress& progress)
{
  const vtkIdType count = mesh.Piece.GetNumberOfCells();
  FaceCollection collection(mesh);
  FaceMesh& faces = collection.Faces;
  if (!collection.Read(progress.Part(0, 0.4)))
  {
    return false;
  }
  if (isFirstPiece)
  {
    collection.Odd.Warn(mesh.File, warnings);
  }
  if (count == 0)
  {
    return true;
  }
  faces.HasSides = true;
  faces.Dimension = mesh.File.GetDimension();
  faces.Points.Count = mesh.Piece.GetNumberOfPoints();
  faces.Types = Buffer<unsigned char>(count);
  ParallelForEach(
    count, HeavyGrain, [&](vtkIdType cell) { faces.Types[cell] = mesh.GetShape(cell).Type; });
  const vtkIdType numberOfFaces = faces.Sides.size() / 2;
  faces.CellWords = ListFacesOfCells(faces.Sides, count);
  faces.FacesOfCells = IdSet(numberOfFaces);
  faces.FacesOfCells.AddMissing(IdSet(numberOfFaces)); // all
  IdLists::Expectation pointsOfFaces, facesOfCells;
  pointsOfFaces.Limit = faces.Points.Count;
  facesOfCells.Limit = numberOfFaces;
  if (!faces.Faces.Open(faces.FaceWords, numberOfFaces, pointsOfFaces, progress.Part(0.4, 0.45)) ||
    !faces.Cells.Open(faces.CellWords, count, facesOfCells, progress.Part(0.45, 0.5)))
  {
    if (!progress.IsStopped())
    {
      mesh.File.Fail(ErrorKind::Changed, "the same faces in all passes", "different ones");
    }
    return false;
  }
  IdSet faceless(count);
  faces.Cells.ForEach(progress.Part(0.5, 0.5),
    [&](vtkIdType cell, const IdList& list)
    {
      if (list.Size == 0)
      {
        faceless.Add(cell);
      }
    });
  ScanError error;
  if (!BuildGrid(faces, PieceRequest(), grid, warnings, error, progress.Part(0.5, 1)))
  {
    mesh.File.Fail(error);
    return false;
  }
  Warn(mesh, faceless, collection.Joined, grid, warnings);
  return true;
}
}
