// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentGrid.h"

#include "Base/Parallel.h"
#include "Intake/FaceMesh/CellRing.h"
#include "Intake/FaceMesh/FacesOfCells.h"
#include "Intake/FaceMesh/GridBuilder.h"
#include "vtkCamaronCompat.h"

#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>

namespace camaron
{
namespace
{
const ScanError FileHasChanged = { ErrorKind::Changed,
  "expected the same faces in all passes, found different ones" };

//------------------------------------------------------------------------------
// The faces of the cells of a piece, and those of which they are parts, as a FaceMesh.
class PieceFaces
{
public:
  explicit PieceFaces(const FluentMesh& mesh)
    : Mesh(mesh)
    , Count(mesh.Piece.GetNumberOfCells())
  {
  }

  bool Load(const Progress& progress);

  FaceMesh Faces;
  IdSet FreeCells; ///< without faces
  Tally Joined;    ///< cells with split faces

private:
  bool FindFaces(const Progress& progress);
  bool ReadFaces(const Progress& progress);
  bool ListCells(const Progress& progress);
  void JoinFaces();
  bool JoinOnce(std::vector<std::int32_t>& faces) const;
  bool JoinFacesOf(vtkIdType cell, std::vector<std::int32_t>& faces);
  bool IsGhost(vtkIdType cell) const
  {
    return this->Mesh.Piece.IsGhostLeaf(this->Mesh.Piece.GetLeaf(cell));
  }

  const FluentMesh& Mesh;
  vtkIdType Count; ///< of cells
  IdSet Kept;      ///< positions of faces
  std::vector<std::int32_t> Positions;
  std::vector<std::array<std::int32_t, 3>> Parents; ///< split faces and the cells on their sides
  PrimitiveMatcher Matcher{ PointSource() };
  CellRing Ring;
};

//------------------------------------------------------------------------------
bool PieceFaces::FindFaces(const Progress& progress)
{
  this->Kept = IdSet(this->Mesh.Faces.GetCount());
  if (!this->Mesh.Faces.ForEach(progress,
        [this](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
        {
          if (run.Bounds && face.Nodes.Size > 0 &&
            (this->Mesh.FindCell(face.GetCell(0)) >= 0 ||
              this->Mesh.FindCell(face.GetCell(1)) >= 0))
          {
            this->Kept.Add(position);
          }
        }))
  {
    return false;
  }
  constexpr int MaxLevels = 32; // of faces whose parts were split again
  bool grows = true;
  for (int level = 0; level < MaxLevels && grows; ++level)
  {
    grows = false;
    for (const FluentFaceTree::Entry& entry : this->Mesh.Tree.Entries)
    {
      if (this->Kept.Contains(entry.Child) && !this->Kept.Contains(entry.Parent))
      {
        this->Kept.Add(entry.Parent);
        grows = true;
      }
    }
  }
  this->Kept.Number();
  return true;
}

//------------------------------------------------------------------------------
bool PieceFaces::ReadFaces(const Progress& progress)
{
  const vtkIdType count = this->Kept.GetNumberOfMembers();
  Buffer<vtkIdType> begins(count + 1);
  begins[0] = 0;
  const auto forEachKept = [this](const Progress& part, auto&& visit)
  {
    return this->Mesh.Faces.ForEach(part,
      [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
      {
        if (this->Kept.Contains(position))
        {
          visit(run, this->Kept.GetNumber(position), face);
        }
      });
  };
  if (!forEachKept(progress.Part(0, 0.4),
        [&](const FluentFaces::Run&, vtkIdType i, const FluentFace& face)
        { begins[i + 1] = 1 + face.Nodes.Size; }))
  {
    return false;
  }
  std::partial_sum(begins.data(), begins.data() + count + 1, begins.data());
  this->Faces.FaceWords = Buffer<std::int32_t>(begins[count]);
  this->Faces.Sides = Buffer<std::int32_t>(2 * count);
  std::mutex mutex;
  return forEachKept(progress.Part(0.4, 1),
    [&](const FluentFaces::Run& run, vtkIdType i, const FluentFace& face)
    {
      std::int32_t* word = this->Faces.FaceWords.data() + begins[i];
      const auto size = static_cast<std::int32_t>(begins[i + 1] - begins[i] - 1);
      const bool isSame = face.Nodes.Size == size; // unless the file has just changed
      *word++ = size;
      for (std::int32_t node = 0; node < size; ++node)
      {
        // Only points of split faces may be missing.
        const vtkIdType point = isSame ? this->Mesh.Piece.FindPoint(face.Nodes[node] - 1) : -1;
        *word++ = static_cast<std::int32_t>(std::max<vtkIdType>(point, 0));
      }
      const auto getCell = [&](int side)
      { return static_cast<std::int32_t>(this->Mesh.FindCell(face.GetCell(side))); };
      this->Faces.Sides[2 * i] = run.Bounds ? getCell(0) : -1;
      this->Faces.Sides[2 * i + 1] = run.Bounds ? getCell(1) : -1;
      if (!run.Bounds)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        this->Parents.push_back({ static_cast<std::int32_t>(i), getCell(0), getCell(1) });
      }
    });
}

//------------------------------------------------------------------------------
bool PieceFaces::ListCells(const Progress& progress)
{
  this->Faces.CellWords = ListFacesOfCells(this->Faces.Sides, this->Count);
  for (const auto& parent : this->Parents)
  {
    this->Faces.Sides[2 * vtkIdType(parent[0])] = parent[1];
    this->Faces.Sides[2 * vtkIdType(parent[0]) + 1] = parent[2];
  }
  this->Faces.Types = Buffer<unsigned char>(this->Count);
  this->FreeCells = IdSet(this->Count);
  ParallelFor(this->Count, HeavyGrain,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->Faces.Types[cell] = this->Mesh.GetShape(cell).Type;
      }
    });
  const std::int32_t* word = this->Faces.CellWords.data();
  for (vtkIdType cell = 0; cell < this->Count; ++cell, word += 1 + *word)
  {
    if (*word == 0)
    {
      this->FreeCells.Add(cell);
    }
  }
  IdLists::Expectation points;
  points.Id = "point";
  points.List = "face";
  points.Limit = this->Mesh.Piece.GetNumberOfPoints();
  const vtkIdType count = this->Kept.GetNumberOfMembers();
  return this->Faces.Faces.Open(this->Faces.FaceWords, count, points, progress);
}

//------------------------------------------------------------------------------
// Replaces all parts of a split face by this face. If some of its parts belong to other cells, it
// is a face of a parent of the cell; its parts remain.
bool PieceFaces::JoinOnce(std::vector<std::int32_t>& faces) const
{
  std::vector<std::pair<vtkIdType, std::int32_t>> found; // split face and part
  for (const std::int32_t face : faces)
  {
    const vtkIdType parent = this->Mesh.Tree.FindParent(this->Positions[face]);
    if (parent >= 0)
    {
      found.emplace_back(parent, face);
    }
  }
  std::sort(found.begin(), found.end());
  bool isChanged = false;
  for (auto begin = found.begin(); begin != found.end();)
  {
    auto end = begin;
    while (end != found.end() && end->first == begin->first)
    {
      ++end;
    }
    if (end - begin == this->Mesh.Tree.GetNumberOfParts(begin->first) &&
      this->Kept.Contains(begin->first))
    {
      for (auto part = begin; part != end; ++part)
      {
        faces.erase(std::remove(faces.begin(), faces.end(), part->second), faces.end());
      }
      faces.push_back(static_cast<std::int32_t>(this->Kept.GetNumber(begin->first)));
      isChanged = true;
    }
    begin = end;
  }
  return isChanged;
}

//------------------------------------------------------------------------------
// Joins the parts of split faces of a cell, if it is of its declared type then.
bool PieceFaces::JoinFacesOf(vtkIdType cell, std::vector<std::int32_t>& faces)
{
  constexpr std::size_t MaxFaces = 256; // cells at hanging nodes do not have more
  const FluentShape shape = this->Mesh.GetShape(cell);
  const auto wanted = static_cast<std::size_t>(shape.Faces);
  while (faces.size() > wanted)
  {
    const std::size_t before = faces.size();
    if (before > MaxFaces || !this->JoinOnce(faces) || faces.size() >= before)
    {
      return false;
    }
  }
  std::vector<IdList> lists;
  std::vector<FaceDirection> directions;
  for (const std::int32_t face : faces)
  {
    const bool isFirst = this->Faces.Sides[2 * vtkIdType(face)] == cell;
    if (!isFirst && this->Faces.Sides[2 * vtkIdType(face) + 1] != cell)
    {
      return false;
    }
    lists.push_back(this->Faces.Faces[face]);
    directions.push_back(isFirst ? FaceDirection::Inward : FaceDirection::Outward);
  }
  const auto size = static_cast<std::int32_t>(lists.size());
  return faces.size() == wanted &&
    (this->Mesh.Dimension == 2 ? this->Ring.Make(lists.data(), directions.data(), size)
                               : PrimitiveMatcher::Guess(lists.data(), size) == shape.Type &&
          this->Matcher.Match(shape.Type, lists.data(), directions.data()));
}

//------------------------------------------------------------------------------
void PieceFaces::JoinFaces()
{
  this->Positions = this->Kept.GetMembers();
  std::vector<std::int32_t> words, faces;
  const std::int32_t* word = this->Faces.CellWords.data();
  for (vtkIdType cell = 0; cell < this->Count; ++cell)
  {
    const std::int32_t* const begin = word + 1;
    word = begin + *word;
    faces.assign(begin, word);
    const int usual = this->Mesh.GetShape(cell).Faces;
    if (usual > 0 && word - begin > usual)
    {
      if (!this->JoinFacesOf(cell, faces))
      {
        faces.assign(begin, word);
      }
      else if (!this->IsGhost(cell))
      {
        this->Joined.Add(this->Mesh.Cells.GetId(this->Mesh.Piece.GetLeaf(cell)));
      }
    }
    words.push_back(static_cast<std::int32_t>(faces.size()));
    words.insert(words.end(), faces.begin(), faces.end());
  }
  this->Faces.CellWords = Buffer<std::int32_t>(static_cast<vtkIdType>(words.size()));
  std::copy(words.begin(), words.end(), this->Faces.CellWords.data());
}

//------------------------------------------------------------------------------
// False if stopped, or if the file has changed.
bool PieceFaces::Load(const Progress& progress)
{
  this->Faces.HasSides = true;
  this->Faces.Dimension = this->Mesh.Dimension;
  this->Faces.Points.Count = this->Mesh.Piece.GetNumberOfPoints();
  if (!this->FindFaces(progress.Part(0, 0.2)) || !this->ReadFaces(progress.Part(0.2, 0.7)) ||
    !this->ListCells(progress.Part(0.7, 0.9)))
  {
    return false;
  }
  if (!this->Mesh.Tree.Entries.empty())
  {
    this->JoinFaces();
  }
  // All are faces of cells, or split.
  this->Faces.FacesOfCells = IdSet(this->Kept.GetNumberOfMembers());
  this->Faces.FacesOfCells.AddMissing(IdSet(this->Kept.GetNumberOfMembers()));
  IdLists::Expectation faces;
  faces.Id = "face";
  faces.List = "cell";
  faces.Limit = this->Kept.GetNumberOfMembers();
  return this->Faces.Cells.Open(this->Faces.CellWords, this->Count, faces, progress.Part(0.9, 1));
}

//------------------------------------------------------------------------------
void Warn(
  const FluentMesh& mesh, const PieceFaces& faces, vtkUnstructuredGrid* grid, Warnings& warnings)
{
  Tally empty, broken, other;
  const auto* const types = vtkUnsignedCharArray::SafeDownCast(GetCellTypes(grid)); // of SetCells
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const vtkIdType leaf = mesh.Piece.GetLeaf(cell);
    if (mesh.Piece.IsGhostLeaf(leaf))
    {
      continue; // another piece reports these
    }
    const unsigned char type = types->GetValue(cell);
    const FluentShape shape = mesh.GetShape(cell);
    if (type == VTK_EMPTY_CELL)
    {
      (faces.FreeCells.Contains(cell) ? empty : broken).Add(mesh.Cells.GetId(leaf));
    }
    else if (shape.Faces > 0 && type != shape.Type)
    {
      other.Add(mesh.Cells.GetId(leaf));
    }
  }
  warnings.Add(empty, "cell", "cells", "without faces");
  warnings.Add(broken, "cell", "cells", "whose edges do not form a closed ring, left empty");
  warnings.Add(other, "cell", "cells",
    mesh.Dimension == 2 ? "whose edges do not match the declared type, read as polygons"
                        : "whose faces do not match the declared type, read as polyhedra");
  warnings.Add(faces.Joined, "cell", "cells",
    "at hanging nodes, not connected to refined neighbors because split faces are joined (Join "
    "Split Faces)");
}
}

//------------------------------------------------------------------------------
bool BuildFluentCells(const FluentMesh& mesh, vtkUnstructuredGrid* grid, Warnings& warnings,
  ScanError& error, const Progress& progress)
{
  if (mesh.Piece.GetNumberOfCells() == 0)
  {
    return true;
  }
  PieceFaces faces(mesh);
  if (!faces.Load(progress.Part(0, 0.5)))
  {
    error = progress.IsStopped() ? ScanError() : FileHasChanged;
    return false;
  }
  mesh.Faces.KeepBoundariesOnly();
  if (!BuildGrid(faces.Faces, PieceRequest(), grid, warnings, error, progress.Part(0.5, 1)))
  {
    return false;
  }
  Warn(mesh, faces, grid, warnings);
  return true;
}
}
