// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellBuckets
 * @brief Places for items of cells in buckets of neighboring keys, in the order of the cells
 * within each.
 *
 * Cells are taken in chunks, in parallel. First every chunk counts what it has for each bucket,
 * which says where its items go; so their order does not depend on the number of threads.
 */
#ifndef camaron_CellBuckets_h
#define camaron_CellBuckets_h

#include "Base/Parallel.h"
#include "Mesh/FacetTable.h"

#include <algorithm> // for std::min
#include <vector>    // for the places

namespace camaron
{
class CellBuckets
{
public:
  static constexpr vtkIdType MaxBuckets = 4096; ///< into which a thread writes at the same time
  static constexpr vtkIdType Grain = 8;         ///< of loops over buckets

  /// For at most @a numberOfItems items with keys from 0 to @a maxKey.
  CellBuckets(vtkIdType numberOfCells, vtkIdType maxKey, vtkIdType numberOfItems);

  Index GetBucket(Index key) const { return key >> this->Shift; }
  Index GetNumberOfBuckets() const { return this->NumberOfBuckets; }

  /**
   * Calls @a visit(std::vector<Index>& places, vtkIdType begin, vtkIdType end) for the chunks of
   * cells. Of each bucket the chunk's place is 0 at first, to be counted up to the number of its
   * items, and after Place that of its next item.
   */
  template <typename Visit>
  void ForEachChunk(Visit&& visit)
  {
    ParallelFor(static_cast<vtkIdType>(this->Places.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          visit(
            this->Places[c], c * this->Chunk, std::min(this->NumberOfCells, (c + 1) * this->Chunk));
        }
      });
  }
  /// Those of the chunk that begins with a cell; of another object made for as many cells, too.
  std::vector<Index>& GetPlaces(vtkIdType begin) { return this->Places[begin / this->Chunk]; }
  /// Turns numbers of items into places; returns where the buckets begin, and behind them the
  /// number of all items.
  std::vector<Index> Place();

private:
  vtkIdType NumberOfCells, Chunk;
  int Shift = 0; // of a key to its bucket
  Index NumberOfBuckets;
  std::vector<std::vector<Index>> Places; // of each chunk and bucket
};
}

#endif
