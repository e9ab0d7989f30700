// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::CellBuckets
 * @brief Parallel counting sort: assigns items of cells to buckets of neighboring keys, and to
 * positions within each bucket in the order of the cells.
 *
 * Threads process chunks of cells. In a first pass, each chunk counts its items per bucket; Place
 * converts these counts to positions, so the order does not depend on the number of threads.
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
  static constexpr vtkIdType MaxBuckets = 4096; ///< limits the memory regions a thread writes to at
                                                ///< the same time
  static constexpr vtkIdType Grain = 8;         ///< grain size of parallel loops over buckets

  /// For at most @a numberOfItems items with keys from 0 to @a maxKey.
  CellBuckets(vtkIdType numberOfCells, vtkIdType maxKey, vtkIdType numberOfItems);

  Index GetBucket(Index key) const { return key >> this->Shift; }
  Index GetNumberOfBuckets() const { return this->NumberOfBuckets; }

  /**
   * Calls @a visit(std::vector<Index>& places, vtkIdType begin, vtkIdType end) for the chunks of
   * cells, in parallel. places[bucket] is initially 0 and must be incremented for each item; after
   * Place, it is the position of the chunk's next item in that bucket.
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
  /// The positions of the chunk that begins with cell @a begin; also works for another CellBuckets
  /// of the same number of cells.
  std::vector<Index>& GetPlaces(vtkIdType begin) { return this->Places[begin / this->Chunk]; }
  /// Converts the counts of items to positions. Returns the position where each bucket begins,
  /// followed by the total number of items.
  std::vector<Index> Place();

private:
  vtkIdType NumberOfCells, Chunk;
  int Shift = 0; // maps a key to its bucket
  Index NumberOfBuckets;
  std::vector<std::vector<Index>> Places; // of each chunk and bucket
};
}

#endif
