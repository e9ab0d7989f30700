// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of one of several pieces: elements are read again instead of being stored.
#include "MAPDLMesh.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
// Most decks have a cell in every row, and define all nodes of these; then the cells are known from
// the first pass.
void MAPDLMesh::CheckItem(const Item& item, Outcome& outcome, CellMeshPiece& piece)
{
  std::int32_t points[MaxMAPDLNodes];
  this->ForEachCell(
    item, outcome,
    [&](vtkIdType row, const MAPDLElement& element, const MAPDLCell& cell)
    {
      this->ElementIds[row] = element.Id;
      this->Cells.Types[row] = cell.Type;
      this->Sizes[row] = static_cast<unsigned char>(cell.Size);
      if (cell.Type == VTK_EMPTY_CELL)
      {
        this->LeftOut.Add(row);
      }
      return points;
    },
    [&](vtkIdType row, const MAPDLCell& cell, const std::int32_t* ids, bool isComplete)
    {
      if (isComplete)
      {
        piece.Visit(row, ids, cell.Size);
      }
    });
}

//------------------------------------------------------------------------------
bool MAPDLMesh::VisitCells(CellMeshPiece& piece, const Progress& progress) const
{
  return this->ForEachElementItem(progress,
    [&](vtkIdType i)
    {
      Outcome known;
      std::int32_t points[MaxMAPDLNodes];
      this->ForEachCell(
        this->ElementItems[i], known,
        [&](vtkIdType, const MAPDLElement&, const MAPDLCell&) { return points; },
        [&](vtkIdType row, const MAPDLCell& cell, const std::int32_t* ids, bool isComplete)
        {
          if (const vtkIdType index = this->GetCell(row); index >= 0 && isComplete)
          {
            piece.Visit(index, ids, cell.Size);
          }
        });
    });
}

//------------------------------------------------------------------------------
bool MAPDLMesh::FindPiece(
  const PieceRequest& request, CellMeshPiece& piece, const Progress& progress)
{
  if (this->Kept.GetLimit() > 0 || !this->Midpoints.empty())
  {
    piece.Start(this->GetNumberOfPoints(), this->GetNumberOfCells(), request);
    if (!this->VisitCells(piece, progress))
    {
      return false;
    }
  }
  while (piece.NextPass())
  {
    if (!this->VisitCells(piece, progress))
    {
      return false;
    }
  }
  return piece.IsFound();
}

//------------------------------------------------------------------------------
void MAPDLMesh::AllocatePiece(const CellMeshPiece& piece)
{
  const Buffer<unsigned char> types = std::move(this->Cells.Types);
  const Buffer<unsigned char> sizes = std::move(this->Sizes);
  const vtkIdType size = piece.GetNumberOfCells();
  this->Cells.NumberOfPoints = piece.GetNumberOfPoints();
  this->Cells.NumberOfCells = size;
  this->Cells.Types = Buffer<unsigned char>(size);
  this->Cells.Offsets = Buffer<std::int32_t>(size + 1);
  std::int32_t sum = this->Cells.Offsets[0] = 0;
  vtkIdType next = 0;
  for (vtkIdType row = 0; row < this->NumberOfRows; ++row)
  {
    if (this->FindCell(row, piece) >= 0)
    {
      sum += sizes[row];
      this->Cells.Types[next] = types[row];
      this->Cells.Offsets[++next] = sum;
    }
  }
  this->Cells.Connectivity = Buffer<std::int32_t>(sum);
}

//------------------------------------------------------------------------------
bool MAPDLMesh::ReadPiece(const CellMeshPiece& piece, const Progress& progress)
{
  this->AllocatePiece(piece);
  return this->ForEachElementItem(progress,
    [&](vtkIdType i)
    {
      const Item& item = this->ElementItems[i];
      vtkIdType row = item.FirstRow;
      const vtkIdType end = row + item.NumberOfRows;
      while (row < end && this->FindCell(row, piece) < 0)
      {
        ++row;
      }
      if (row == end)
      {
        return;
      }
      Outcome known;
      std::int32_t others[MaxMAPDLNodes];
      this->ForEachCell(
        item, known,
        [&](vtkIdType at, const MAPDLElement&, const MAPDLCell& read)
        {
          const vtkIdType cell = this->FindCell(at, piece);
          const std::int32_t* const offset = this->Cells.Offsets.data() + cell;
          // If the size of a cell differs, the file has changed.
          return cell < 0 || offset[1] - offset[0] != read.Size
            ? others
            : this->Cells.Connectivity.data() + offset[0];
        },
        [&](vtkIdType, const MAPDLCell& cell, std::int32_t* points, bool isComplete)
        {
          for (std::int32_t p = 0; points != others && isComplete && p < cell.Size; ++p)
          {
            points[p] = static_cast<std::int32_t>(piece.FindPoint(points[p]));
          }
        });
    });
}
}
