// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellBuckets.h"

#include "Base/Parallel.h"

#include <utility>

namespace camaron
{
namespace
{
constexpr vtkIdType ItemsPerBucket =
  4096; // fits into the processor cache with the hash table of the bucket
constexpr vtkIdType MaxChunks = 64;
}

//------------------------------------------------------------------------------
CellBuckets::CellBuckets(vtkIdType numberOfCells, vtkIdType maxKey, vtkIdType numberOfItems)
  : NumberOfCells(numberOfCells)
  , Chunk(std::max(MediumGrain, numberOfCells / MaxChunks + 1))
{
  while (maxKey >> this->Shift >= std::min(MaxBuckets, numberOfItems / ItemsPerBucket + 1))
  {
    ++this->Shift;
  }
  this->NumberOfBuckets = static_cast<Index>(maxKey >> this->Shift) + 1;
  this->Places.assign(
    (numberOfCells + this->Chunk - 1) / this->Chunk, std::vector<Index>(this->NumberOfBuckets, 0));
}

//------------------------------------------------------------------------------
std::vector<Index> CellBuckets::Place()
{
  std::vector<Index> begins;
  Index total = 0;
  for (Index bucket = 0; bucket < this->NumberOfBuckets; ++bucket)
  {
    begins.push_back(total);
    for (std::vector<Index>& sizes : this->Places)
    {
      total += std::exchange(sizes[bucket], total);
    }
  }
  begins.push_back(total);
  return begins;
}
}
