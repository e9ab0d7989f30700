// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PLYLists
 * @brief Receives the lists of an element: stores all, or as cells of a piece, which is determined
 * or whose cells are stored.
 */
#ifndef camaron_PLYLists_h
#define camaron_PLYLists_h

#include "Intake/CellMesh/CellMeshPiece.h"
#include "PLYRows.h"

#include <mutex> // for what threads find

namespace camaron
{
class PLYLists
{
public:
  /**
   * Stores all lists one after the other.
   * @param repeating if given, counts the rows whose lists contain an id twice
   */
  PLYLists(const PLYSizes& sizes, std::int32_t* all, Tally* repeating = nullptr)
    : Sizes(sizes)
    , All(all)
    , Repeating(repeating)
  {
  }
  /**
   * Receives lists as cells of a piece.
   * @param items cell of the mesh for every row, -1 for none; or nullptr if row 0 is @a firstCell
   * and the others follow
   * @param mesh in which to store cells, or nullptr to determine the piece
   */
  PLYLists(const PLYSizes& sizes, vtkIdType firstCell, const std::int32_t* items,
    CellMeshPiece& piece, CellMesh* mesh)
    : Sizes(sizes)
    , FirstCell(firstCell)
    , Items(items)
    , Piece(&piece)
    , Mesh(mesh)
  {
  }

  /// Whether any of these rows is needed; the others may be skipped.
  bool Needs(vtkIdType row, vtkIdType rows = 1) const
  {
    bool needs = this->Mesh == nullptr;
    for (vtkIdType end = row + rows; row < end && !needs; ++row)
    {
      const vtkIdType cell = this->GetCell(row);
      needs = cell >= 0 && this->Piece->FindCell(cell) >= 0;
    }
    return needs;
  }
  /// Where to write the lists of consecutive rows; valid until the next call by the same thread.
  std::int32_t* Provide(vtkIdType row, vtkIdType rows) const
  {
    return this->All ? this->All + this->Sizes.GetOffset(row) : this->ProvideScratch(row, rows);
  }
  /// Receives the lists of some rows after they have been written.
  void Take(vtkIdType first, vtkIdType count, const std::int32_t* ids) const
  {
    if (this->Repeating)
    {
      Tally local;
      FindRepeatedPoints(ids, this->Sizes.Common < 0 ? this->Sizes.Offsets.data() + first : nullptr,
        this->Sizes.Common, first, count, local);
      if (local.Count > 0)
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Repeating->Merge(local);
      }
    }
    for (vtkIdType row = first; !this->All && row < first + count; ++row)
    {
      this->TakeCell(row, ids);
      ids += this->Sizes.GetSize(row);
    }
  }
  /// Receives the list of a row as a cell of the piece.
  void TakeCell(vtkIdType row, const std::int32_t* ids) const
  {
    const vtkIdType cell = this->GetCell(row);
    if (cell < 0)
    {
      return;
    }
    const vtkIdType size = this->Sizes.GetSize(row);
    if (!this->Mesh)
    {
      this->Piece->Visit(cell, ids, size);
    }
    else if (const vtkIdType index = this->Piece->FindCell(cell); index >= 0)
    {
      std::int32_t* const points = this->Mesh->Connectivity.data() + this->Mesh->GetBegin(index);
      for (vtkIdType i = 0; i < size; ++i)
      {
        points[i] = static_cast<std::int32_t>(this->Piece->FindPoint(ids[i]));
      }
    }
  }

  const PLYSizes& Sizes;

private:
  std::int32_t* ProvideScratch(vtkIdType row, vtkIdType rows) const
  {
    thread_local std::vector<std::int32_t> scratch;
    scratch.resize(
      static_cast<std::size_t>(this->Sizes.GetOffset(row + rows) - this->Sizes.GetOffset(row)));
    return scratch.data();
  }
  vtkIdType GetCell(vtkIdType row) const
  {
    return this->Items ? this->Items[row] : this->FirstCell + row;
  }

  std::int32_t* All = nullptr;
  Tally* Repeating = nullptr;
  mutable std::mutex Mutex; ///< for this
  vtkIdType FirstCell = 0;
  const std::int32_t* Items = nullptr;
  CellMeshPiece* Piece = nullptr;
  CellMesh* Mesh = nullptr;
};
}

#endif
