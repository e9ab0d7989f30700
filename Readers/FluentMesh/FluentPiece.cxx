// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentPiece.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Calls visit(leaf) for the leaves on both sides of a face.
template <typename Visit>
void ForLeaves(const FluentCells& cells, const FluentFace& face, Visit&& visit)
{
  for (int side = 0; side < 2; ++side)
  {
    const vtkIdType leaf = cells.FindLeaf(face.GetCell(side));
    if (leaf >= 0)
    {
      visit(leaf);
    }
  }
}

//------------------------------------------------------------------------------
void AddNodes(const FluentFace& face, IdSet& points)
{
  for (std::int32_t i = 0; i < face.Nodes.Size; ++i)
  {
    points.Add(vtkIdType(face.Nodes[i]) - 1);
  }
}
}

//------------------------------------------------------------------------------
bool FluentPiece::AddGhosts(
  const FluentFaces& faces, const FluentCells& cells, const Progress& progress)
{
  IdSet before(this->NumberOfMeshPoints);
  before.AddAll(this->Points);
  before.AddAll(this->LowerPoints);
  IdSet added(this->NumberOfLeaves);
  bool good = faces.ForEach(progress.Part(0, 0.5),
    [&](const FluentFaces::Run& run, vtkIdType, const FluentFace& face)
    {
      bool touches = false;
      for (std::int32_t i = 0; run.Bounds && i < face.Nodes.Size && !touches; ++i)
      {
        touches = before.Contains(vtkIdType(face.Nodes[i]) - 1);
      }
      if (touches)
      {
        ForLeaves(cells, face,
          [&](vtkIdType leaf)
          {
            if (!this->Leaves.Contains(leaf))
            {
              added.Add(leaf);
            }
          });
      }
    });
  good = good &&
    faces.ForEach(progress.Part(0.5, 1),
      [&](const FluentFaces::Run& run, vtkIdType, const FluentFace& face)
      {
        if (run.Bounds)
        {
          ForLeaves(cells, face,
            [&](vtkIdType leaf)
            {
              if (added.Contains(leaf))
              {
                AddNodes(face, leaf < this->Begin ? this->LowerPoints : this->Points);
              }
            });
        }
      });
  this->Leaves.AddAll(added);
  return good;
}

//------------------------------------------------------------------------------
bool FluentPiece::Select(const FluentFaces& faces, const FluentCells& cells,
  vtkIdType numberOfPoints, const PieceRequest& request, const Progress& progress)
{
  *this = FluentPiece();
  this->NumberOfMeshPoints = numberOfPoints;
  this->NumberOfLeaves = cells.GetNumberOfLeaves();
  this->Whole = request.NumberOfPieces <= 1;
  this->End = this->NumberOfLeaves;
  if (this->Whole)
  {
    return true;
  }
  const vtkIdType pieces = request.NumberOfPieces, piece = request.Piece;
  const vtkIdType share = this->NumberOfLeaves / pieces, rest = this->NumberOfLeaves % pieces;
  this->Begin = share * piece + std::min(piece, rest);
  this->End = this->Begin + share + (piece < rest ? 1 : 0);
  this->Ghosts = request.GhostLevels > 0;

  this->Leaves = IdSet(this->NumberOfLeaves);
  for (vtkIdType leaf = this->Begin; leaf < this->End; ++leaf)
  {
    this->Leaves.Add(leaf);
  }
  this->Points = IdSet(numberOfPoints);
  this->OwnedPoints = IdSet(numberOfPoints);
  this->LowerPoints = IdSet(numberOfPoints);
  IdSet used(piece == 0 ? numberOfPoints : 0);
  bool good = faces.ForEach(progress.Part(0, 0.3),
    [&](const FluentFaces::Run& run, vtkIdType, const FluentFace& face)
    {
      bool isOwned = false, isUsed = false;
      if (run.Bounds)
      {
        ForLeaves(cells, face,
          [&](vtkIdType leaf)
          {
            isUsed = true;
            isOwned = isOwned || !this->IsGhostLeaf(leaf);
          });
      }
      if (isOwned)
      {
        AddNodes(face, this->Points);
      }
      if (isUsed && piece == 0)
      {
        AddNodes(face, used);
      }
    });
  this->OwnedPoints.AddAll(this->Points);
  for (int level = 0; level < request.GhostLevels && good; ++level)
  {
    good = this->AddGhosts(faces, cells, progress.Part(0.3, 1));
  }
  this->Points.AddAll(this->LowerPoints);
  if (piece == 0)
  {
    this->Points.AddMissing(used);
    this->OwnedPoints.AddMissing(used);
  }
  this->Points.Number();
  this->Leaves.Number();
  this->Members = this->Leaves.GetMembers();
  return good && !progress.IsStopped();
}
}
