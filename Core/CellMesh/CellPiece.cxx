// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellMesh/CellPiece.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls visit(cell) for [begin, end) in parallel.
template <typename Visit>
void ForCells(vtkIdType begin, vtkIdType end, const Progress& progress, Visit&& visit)
{
  constexpr vtkIdType Block = 4096;
  progress.For((end - begin + Block - 1) / Block,
    [&](vtkIdType first, vtkIdType last)
    {
      const vtkIdType stop = std::min(begin + last * Block, end);
      for (vtkIdType cell = begin + first * Block; cell < stop; ++cell)
      {
        visit(cell);
      }
    });
}

//------------------------------------------------------------------------------
void AddPoints(const CellMesh& mesh, vtkIdType cell, IdSet& points)
{
  const std::int32_t* ids = mesh.GetPoints(cell);
  for (vtkIdType i = 0; i < mesh.GetSize(cell); ++i)
  {
    points.Add(ids[i]);
  }
}
}

//------------------------------------------------------------------------------
void CellPiece::AddGhosts(const CellMesh& mesh, const Progress& progress)
{
  IdSet before(this->NumberOfMeshPoints);
  before.AddAll(this->Points);
  before.AddAll(this->LowerPoints);
  ForCells(0, mesh.NumberOfCells, progress,
    [&](vtkIdType cell)
    {
      const std::int32_t* ids = mesh.GetPoints(cell);
      const std::int32_t* const end = ids + mesh.GetSize(cell);
      if (!this->Cells.Contains(cell) &&
        std::any_of(ids, end, [&](std::int32_t id) { return before.Contains(id); }))
      {
        this->Cells.Add(cell);
        AddPoints(mesh, cell, cell < this->Begin ? this->LowerPoints : this->Points);
      }
    });
}

//------------------------------------------------------------------------------
bool CellPiece::Select(const CellMesh& mesh, const PieceRequest& request, const Progress& progress)
{
  this->NumberOfMeshPoints = mesh.NumberOfPoints;
  this->NumberOfMeshCells = mesh.NumberOfCells;
  this->Whole = request.NumberOfPieces <= 1;
  this->End = mesh.NumberOfCells;
  if (this->Whole)
  {
    return true;
  }
  const vtkIdType pieces = request.NumberOfPieces, piece = request.Piece;
  const vtkIdType share = mesh.NumberOfCells / pieces, rest = mesh.NumberOfCells % pieces;
  this->Begin = share * piece + std::min(piece, rest);
  this->End = this->Begin + share + (piece < rest ? 1 : 0);
  this->Ghosts = request.GhostLevels > 0;

  this->Cells = IdSet(mesh.NumberOfCells);
  this->Points = IdSet(mesh.NumberOfPoints);
  this->OwnedPoints = IdSet(mesh.NumberOfPoints);
  this->LowerPoints = IdSet(mesh.NumberOfPoints);
  ForCells(this->Begin, this->End, progress.Part(0, 0.2),
    [&](vtkIdType cell)
    {
      this->Cells.Add(cell);
      AddPoints(mesh, cell, this->Points);
    });
  this->OwnedPoints.AddAll(this->Points);
  for (int level = 0; level < request.GhostLevels && !progress.IsStopped(); ++level)
  {
    this->AddGhosts(mesh, progress.Part(0.2, 0.8));
  }
  this->Points.AddAll(this->LowerPoints);
  if (piece == 0)
  {
    IdSet used(mesh.NumberOfPoints);
    ForCells(0, mesh.NumberOfCells, progress.Part(0.8, 1),
      [&](vtkIdType cell) { AddPoints(mesh, cell, used); });
    this->Points.AddMissing(used);
    this->OwnedPoints.AddMissing(used);
  }
  this->Points.Number();
  this->Cells.Number();
  return !progress.IsStopped();
}
}
