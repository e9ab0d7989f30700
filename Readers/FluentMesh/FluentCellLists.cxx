// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentCellLists.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// A single thread needs no locks.
bool IsAlone()
{
  return vtkSMPTools::GetEstimatedNumberOfThreads() <= 1;
}

//------------------------------------------------------------------------------
// Calls visit(cell, face) for the cells of the piece on both sides of all faces, in parallel.
template <typename Visit>
bool ForEachUse(const FluentMesh& mesh, const Progress& progress, Visit&& visit)
{
  return mesh.Faces.ForEach(progress,
    [&](const FluentFaces::Run& run, vtkIdType position, const FluentFace& face)
    {
      if (!run.Bounds || face.Nodes.Size == 0)
      {
        return;
      }
      for (int side = 0; side < 2; ++side)
      {
        const vtkIdType cell = mesh.FindCell(face.GetCell(side));
        if (cell >= 0)
        {
          visit(cell, position);
        }
      }
    });
}
}

//------------------------------------------------------------------------------
void FluentCellLists::Add(Cursor& cursor, std::uint32_t value, bool alone)
{
  if (alone)
  {
    cursor.store(cursor.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
  }
  else
  {
    cursor.fetch_add(value, std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
// Returns the new value.
std::uint32_t FluentCellLists::TakeOne(Cursor& cursor, bool alone)
{
  if (!alone)
  {
    return cursor.fetch_sub(1, std::memory_order_relaxed) - 1;
  }
  const std::uint32_t value = cursor.load(std::memory_order_relaxed) - 1;
  cursor.store(value, std::memory_order_relaxed);
  return value;
}

//------------------------------------------------------------------------------
bool FluentCellLists::Find(const FluentMesh& mesh, const Progress& progress)
{
  constexpr vtkIdType BlockSize = 1024;
  const vtkIdType count = mesh.Piece.GetNumberOfCells();
  this->Cursors = std::vector<Cursor>(static_cast<std::size_t>(count) + 1);
  const bool alone = IsAlone();
  if (!ForEachUse(mesh, progress.Part(0, 0.5),
        [this, alone](vtkIdType cell, vtkIdType) { Add(this->Cursors[cell], 1, alone); }))
  {
    return false;
  }
  const vtkIdType total = ParallelScan(
    count, BlockSize,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType sum = 0;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        sum += this->Cursors[cell];
      }
      return sum;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        before += this->Cursors[cell];
        this->Cursors[cell] = static_cast<std::uint32_t>(before);
      }
    });
  this->Cursors[count] = static_cast<std::uint32_t>(total);
  this->Lists.resize(static_cast<std::size_t>(total), 0);
  const bool finished = ForEachUse(mesh, progress.Part(0.5, 1),
    [&](vtkIdType cell, vtkIdType face)
    {
      const std::uint32_t place = TakeOne(this->Cursors[cell], alone);
      if (place < this->Lists.size()) // unless the file has changed
      {
        this->Lists[place] = static_cast<Index>(face);
      }
    });
  return finished && std::is_sorted(this->Cursors.begin(), this->Cursors.end());
}
}
