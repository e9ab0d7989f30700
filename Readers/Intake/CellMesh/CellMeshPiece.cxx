// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellMeshPiece.h"

#include "Base/Parallel.h"
#include "Intake/Ids/RepeatedIds.h"

#include <algorithm>

namespace camaron
{
namespace
{
constexpr vtkIdType Block = 4096;
constexpr std::uint32_t NoPoint = UINT32_MAX;
}

//------------------------------------------------------------------------------
void CellMeshPiece::NoteFirstUse(vtkIdType cell, const std::int32_t* points, vtkIdType size)
{
  for (vtkIdType i = 0; i < size; ++i)
  {
    this->Used.Add(points[i]);
  }
  if (HasRepeatedIds(points, size))
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Repeating.Add(cell);
  }
}

//------------------------------------------------------------------------------
void CellMeshPiece::Start(
  vtkIdType numberOfPoints, vtkIdType numberOfCells, const PieceRequest& request)
{
  this->NumberOfMeshPoints = numberOfPoints;
  this->NumberOfMeshCells = numberOfCells;
  this->Whole = request.NumberOfPieces <= 1 && this->KeepsUnused;
  this->Ghosts = !this->Whole && request.GhostLevels > 0;
  this->IsFirst = request.Piece == 0;
  this->HasFailed = false;
  this->Level = -1;
  this->NumberOfLevels = request.GhostLevels;
  this->Repeating = Tally();
  if (this->Whole)
  {
    return;
  }
  this->Space.Start(numberOfPoints, numberOfCells, request);
  this->Cells = IdSet(numberOfCells);
  this->Owned = IdSet(numberOfCells);
  for (IdSet* set : { &this->Points, &this->OwnedPoints, &this->LowerPoints, &this->Near })
  {
    *set = IdSet(numberOfPoints);
  }
  this->Used = IdSet(this->IsFirst ? numberOfPoints : 0);
}

//------------------------------------------------------------------------------
void CellMeshPiece::StartFaces(vtkIdType numberOfFaces, const PieceRequest& request)
{
  this->HasFaces = true;
  if (this->Whole)
  {
    return;
  }
  this->Space.Start(this->NumberOfMeshPoints, numberOfFaces, request);
  this->SmallestPoints =
    std::vector<std::atomic<std::uint32_t>>(static_cast<std::size_t>(this->NumberOfMeshCells));
  for (std::atomic<std::uint32_t>& point : this->SmallestPoints)
  {
    point.store(NoPoint, std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
void CellMeshPiece::VisitFace(
  vtkIdType face, const vtkIdType* cells, const std::int32_t* points, vtkIdType size)
{
  const auto forCells = [&](auto&& visit)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (cells[side] >= 0)
      {
        visit(cells[side]);
      }
    }
  };
  if (this->Level < 0)
  {
    const std::int32_t smallest = *std::min_element(points, points + size);
    this->Space.Add(face, smallest);
    forCells(
      [&](vtkIdType cell)
      {
        LowerTo(this->SmallestPoints[static_cast<std::size_t>(cell)],
          static_cast<std::uint32_t>(smallest));
      });
    return;
  }
  if (!this->IsAdding)
  {
    const bool isNear = this->AreNear(points, size);
    forCells(
      [&](vtkIdType cell)
      {
        if (isNear && !this->Cells.Contains(cell))
        {
          this->New.Add(cell);
        }
      });
    return;
  }
  const auto addTo = [&](IdSet& set)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      set.Add(points[i]);
    }
  };
  forCells(
    [&](vtkIdType cell)
    {
      if (this->New.Contains(cell))
      {
        addTo(this->Before.Contains(cell) ? this->LowerPoints : this->Points);
      }
      if (this->Level == 0 && this->IsFirst)
      {
        addTo(this->Used);
      }
    });
}

//------------------------------------------------------------------------------
// The cells of a mesh given by its faces.
void CellMeshPiece::FindOwned()
{
  this->Before = IdSet(this->NumberOfMeshCells);
  for (vtkIdType cell = 0; cell < this->NumberOfMeshCells; ++cell)
  {
    const std::uint32_t smallest = this->SmallestPoints[static_cast<std::size_t>(cell)];
    const vtkIdType point = smallest == NoPoint ? -1 : vtkIdType(smallest);
    if (this->Space.Has(point))
    {
      this->Owned.Add(cell);
    }
    else if (this->Space.IsBefore(point))
    {
      this->Before.Add(cell);
    }
  }
  this->SmallestPoints = std::vector<std::atomic<std::uint32_t>>();
  this->New = IdSet(this->NumberOfMeshCells);
  this->New.AddAll(this->Owned);
  this->IsAdding = true;
}

//------------------------------------------------------------------------------
bool CellMeshPiece::NextPass()
{
  if (this->Whole)
  {
    return false;
  }
  if (this->Level < 0)
  {
    const auto byIds = [this](const PieceOfSpace::Visit& visit)
    {
      for (vtkIdType point = 0; point < this->NumberOfMeshPoints; ++point)
      {
        const double x[3] = { static_cast<double>(point), 0, 0 };
        visit(point, x);
      }
      return true;
    };
    this->HasFailed = !this->Space.Find(
      this->ForEachPoint ? this->ForEachPoint : PieceOfSpace::ForEachPoint(byIds));
    this->ForEachPoint = nullptr;
    ++this->Level;
    if (this->HasFaces && !this->HasFailed)
    {
      this->FindOwned();
    }
    return !this->HasFailed;
  }
  if (this->HasFaces)
  {
    this->IsAdding = !this->IsAdding;
    if (this->IsAdding)
    {
      return true;
    }
    this->Cells.AddAll(this->New);
    this->New = IdSet(this->NumberOfMeshCells);
  }
  if (this->Level == 0)
  {
    this->OwnedPoints.AddAll(this->Points);
  }
  if (this->Level < this->NumberOfLevels)
  {
    this->Near.AddAll(this->Points);
    this->Near.AddAll(this->LowerPoints);
    ++this->Level;
    return true;
  }
  this->Points.AddAll(this->LowerPoints);
  if (this->IsFirst && this->KeepsUnused)
  {
    this->Points.AddMissing(this->Used);
    this->OwnedPoints.AddMissing(this->Used);
  }
  this->Points.Number();
  this->Cells.Number();
  this->Space = PieceOfSpace();
  this->Before = IdSet();
  this->New = IdSet();
  return false;
}

//------------------------------------------------------------------------------
bool CellMeshPiece::Select(
  const CellMesh& mesh, const PieceRequest& request, const Progress& progress)
{
  return this->Find(mesh.NumberOfPoints, mesh.NumberOfCells, request,
    [&]
    {
      return progress.ForBlocks(mesh.NumberOfCells, Block,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType cell = begin; cell < end; ++cell)
          {
            this->Visit(cell, mesh.GetPoints(cell), mesh.GetSize(cell));
          }
        });
    });
}

//------------------------------------------------------------------------------
void CellMeshPiece::WarnOfRepeatedPoints(const CellMesh& mesh, Warnings& warnings,
  const Progress& progress, const char* one, const char* many) const
{
  Tally repeating = this->Whole && mesh.Repeating ? *mesh.Repeating : this->Repeating;
  if (this->Whole && !mesh.Repeating)
  {
    std::mutex mutex;
    progress.ForBlocks(mesh.NumberOfCells, Block,
      [&](vtkIdType begin, vtkIdType end)
      {
        Tally local;
        FindRepeatedPoints(mesh.GetPoints(begin),
          mesh.Offsets.size() > 0 ? mesh.Offsets.data() + begin : nullptr, mesh.CommonSize, begin,
          end - begin, local);
        const std::lock_guard<std::mutex> lock(mutex);
        repeating.Merge(local);
      });
  }
  warnings.Add(repeating, one, many, "with repeated points", FromZero);
}

//------------------------------------------------------------------------------
void KeepPiece(CellMesh& mesh, const CellMeshPiece& piece)
{
  if (piece.IsWhole())
  {
    return;
  }
  const vtkIdType size = piece.GetNumberOfCells();
  const bool hasTypes = mesh.Types.size() > 0, hasOffsets = mesh.Offsets.size() > 0;
  CellMesh part;
  part.NumberOfPoints = piece.GetNumberOfPoints();
  part.NumberOfCells = size;
  part.CommonType = mesh.CommonType;
  part.CommonSize = mesh.CommonSize;
  part.Types = Buffer<unsigned char>(hasTypes ? size : 0);
  part.Offsets = Buffer<std::int32_t>(hasOffsets ? size + 1 : 0);
  if (hasOffsets)
  {
    std::int32_t* offset = part.Offsets.data();
    *offset = 0;
    for (vtkIdType cell = 0; cell < mesh.NumberOfCells; ++cell)
    {
      if (piece.GetCells().Contains(cell))
      {
        offset[1] = offset[0] + static_cast<std::int32_t>(mesh.GetSize(cell));
        ++offset;
      }
    }
  }
  part.Connectivity = Buffer<std::int32_t>(part.GetBegin(size));
  ParallelFor(mesh.NumberOfCells, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType i = piece.FindCell(cell);
        if (i < 0)
        {
          continue;
        }
        if (hasTypes)
        {
          part.Types[i] = mesh.Types[cell];
        }
        const std::int32_t* const points = mesh.GetPoints(cell);
        std::transform(points, points + mesh.GetSize(cell),
          part.Connectivity.data() + part.GetBegin(i),
          [&](std::int32_t point) { return static_cast<std::int32_t>(piece.FindPoint(point)); });
      }
    });
  mesh = std::move(part);
}

//------------------------------------------------------------------------------
bool MakeCloud(
  vtkIdType numberOfPoints, const PieceRequest& request, CellMeshPiece& piece, CellMesh& cloud)
{
  const bool isGood = piece.Find(numberOfPoints, numberOfPoints, request,
    [&]
    {
      return Progress().ForBlocks(numberOfPoints, Block,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (auto point = static_cast<std::int32_t>(begin); point < end; ++point)
          {
            piece.Visit(point, &point, 1);
          }
        });
    });
  cloud = MakeCloud(piece.GetNumberOfCells()); // as many cells as points
  return isGood;
}
}
