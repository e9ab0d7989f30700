// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentPiece.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <vector>

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
                AddNodes(face, this->Before.Contains(leaf) ? this->LowerPoints : this->Points);
              }
            });
        }
      });
  this->Leaves.AddAll(added);
  return good;
}

//------------------------------------------------------------------------------
// A cell is where its point with the smallest id is, which does not depend on the order of visits.
bool FluentPiece::FindOwned(const FluentFaces& faces, const FluentCells& cells,
  const PieceRequest& request, const FindSpace& findSpace, const Progress& progress)
{
  PieceOfSpace space;
  space.Start(this->NumberOfMeshPoints, faces.GetCount(), request);
  constexpr std::uint32_t None = UINT32_MAX;
  std::vector<std::atomic<std::uint32_t>> smallest(static_cast<std::size_t>(this->NumberOfLeaves));
  for (std::atomic<std::uint32_t>& node : smallest)
  {
    node.store(None, std::memory_order_relaxed);
  }
  const bool good = faces.ForEach(progress,
    [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
    {
      std::uint32_t node = None;
      for (std::int32_t i = 0; run.Bounds && i < face.Nodes.Size; ++i)
      {
        node = std::min(node, static_cast<std::uint32_t>(face.Nodes[i]));
      }
      if (node != None)
      {
        space.Add(position, vtkIdType(node) - 1);
        ForLeaves(cells, face,
          [&](vtkIdType leaf) { LowerTo(smallest[static_cast<std::size_t>(leaf)], node); });
      }
    });
  if (!good || !findSpace(space))
  {
    return false;
  }
  this->Owned = IdSet(this->NumberOfLeaves);
  this->Before = IdSet(this->NumberOfLeaves);
  for (vtkIdType leaf = 0; leaf < this->NumberOfLeaves; ++leaf)
  {
    const std::uint32_t node = smallest[static_cast<std::size_t>(leaf)];
    const vtkIdType point = node == None ? -1 : vtkIdType(node) - 1;
    if (space.Has(point))
    {
      this->Owned.Add(leaf);
    }
    else if (space.IsBefore(point))
    {
      this->Before.Add(leaf);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentPiece::Select(const FluentFaces& faces, const FluentCells& cells,
  vtkIdType numberOfPoints, const PieceRequest& request, const FindSpace& findSpace,
  const Progress& progress)
{
  *this = FluentPiece();
  this->NumberOfMeshPoints = numberOfPoints;
  this->NumberOfLeaves = cells.GetNumberOfLeaves();
  this->Whole = request.NumberOfPieces <= 1;
  if (this->Whole)
  {
    return true;
  }
  this->Ghosts = request.GhostLevels > 0;
  if (!this->FindOwned(faces, cells, request, findSpace, progress.Part(0, 0.1)))
  {
    return false;
  }
  this->Leaves = IdSet(this->NumberOfLeaves);
  this->Leaves.AddAll(this->Owned);
  this->Points = IdSet(numberOfPoints);
  this->OwnedPoints = IdSet(numberOfPoints);
  this->LowerPoints = IdSet(numberOfPoints);
  IdSet used(request.Piece == 0 ? numberOfPoints : 0);
  bool good = faces.ForEach(progress.Part(0.1, 0.3),
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
      if (isUsed && request.Piece == 0)
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
  if (request.Piece == 0)
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
