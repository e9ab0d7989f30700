// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FluentCellLists
 * @brief The faces of every cell of a piece, collected from the cells of every face.
 */
#ifndef camaron_FluentCellLists_h
#define camaron_FluentCellLists_h

#include "Base/Buffer.h"
#include "FluentCellFaces.h"

#include <atomic> // for cursors
#include <vector> // for cursors

namespace camaron
{
class FluentCellLists
{
public:
  /// Collects the positions of the faces of each cell, in any order; false if aborted.
  bool Find(const FluentMesh& mesh, const Progress& progress);

  Index* Get(vtkIdType cell) { return this->Lists.data() + this->Cursors[cell]; }
  const Index* Get(vtkIdType cell) const { return this->Lists.data() + this->Cursors[cell]; }
  vtkIdType GetSize(vtkIdType cell) const
  {
    return vtkIdType(this->Cursors[cell + 1]) - vtkIdType(this->Cursors[cell]);
  }
  /// Moves out the lists, one after the other.
  LargeVector<Index> Take() { return std::move(this->Lists); }

private:
  using Cursor = std::atomic<std::uint32_t>;
  static void Add(Cursor& cursor, std::uint32_t value, bool alone);
  static std::uint32_t TakeOne(Cursor& cursor, bool alone);

  std::vector<Cursor>
    Cursors; ///< per cell its number of faces, then the end of its list, then the begin
  LargeVector<Index> Lists;
};
}

#endif
