// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Population.h
 * @brief The input of statistics, and parallel loops over it.
 */
#ifndef camaron_Population_h
#define camaron_Population_h

#include "Base/Parallel.h"
#include "Criteria/Criterion.h"

#include "vtkSMPTools.h" // for the number of threads
#include "vtkType.h"     // for vtkIdType

#include <algorithm> // for std::min
#include <cmath>     // for whole numbers
#include <cstdint>   // for shapes
#include <vector>    // for lists of blocks

namespace camaron
{
/// From 2^53 on, several integers are the same double; integer arrays that have such values are
/// refused.
constexpr std::int64_t LeastInexactInteger = std::int64_t(1) << 53;

/// Whether it is an integer below LeastInexactInteger in magnitude.
inline bool IsExactInteger(double value)
{
  return std::abs(value) < static_cast<double>(LeastInexactInteger) && std::trunc(value) == value;
}

/// Values of consecutive elements of one array; all pointers are borrowed.
struct ValueBlock
{
  const double* Values = nullptr;
  vtkIdType Size = 0;
  /// Elements with a nonzero entry do not belong to the population (ghosts, other groups).
  const unsigned char* Skip = nullptr;
  /// NullReason of each element; if nullptr, taken from the payload of NaN.
  const unsigned char* NullReasons = nullptr;
  /// Ids of the elements, unique over all ranks; if nullptr, FirstId + index.
  const vtkIdType* Ids = nullptr;
  vtkIdType FirstId = 0;
  /// Shapes (Criterion.h) of each element, and those that the acceptable range applies to; if
  /// nullptr, it applies to all.
  const std::uint16_t* Shapes = nullptr;
  unsigned JudgedShapes = 0;

  bool Contains(vtkIdType i) const { return !this->Skip || !this->Skip[i]; }
  /// Whether the acceptable range applies to the element; other elements are neither inside nor
  /// outside.
  bool IsJudged(vtkIdType i) const
  {
    return !this->Shapes || (this->Shapes[i] & this->JudgedShapes);
  }
  /// The same elements with other values.
  ValueBlock WithValues(const double* values) const
  {
    ValueBlock block = *this;
    block.Values = values;
    return block;
  }
  vtkIdType GetId(vtkIdType i) const { return this->Ids ? this->Ids[i] : this->FirstId + i; }
  /// Of an element with the value NaN.
  NullReason GetNullReason(vtkIdType i) const
  {
    return this->NullReasons ? static_cast<NullReason>(this->NullReasons[i])
                             : camaron::GetNullReason(this->Values[i]);
  }
};

/// All blocks of this rank.
using Population = std::vector<ValueBlock>;

/**
 * Calls @a accumulate(partial, block, begin, end) for chunks that cover the population. Each
 * thread has its own, value-initialized Partial; returns all of them, at least one. The assignment
 * of chunks to partials varies, so merging them must not depend on it.
 */
template <typename Partial, typename Accumulate>
std::vector<Partial> ForEachChunk(const Population& population, Accumulate&& accumulate)
{
  struct Chunk
  {
    const ValueBlock* Block;
    vtkIdType Begin, End;
  };
  constexpr vtkIdType chunkSize = 1 << 15;
  std::vector<Chunk> chunks;
  for (const ValueBlock& block : population)
  {
    for (vtkIdType begin = 0; begin < block.Size; begin += chunkSize)
    {
      chunks.push_back({ &block, begin, std::min(begin + chunkSize, block.Size) });
    }
  }

  std::vector<Partial> partials;
  WithThreads(
    [&]
    {
      const auto numberOfChunks = static_cast<vtkIdType>(chunks.size());
      const vtkIdType numberOfParts = std::max<vtkIdType>(
        1, std::min<vtkIdType>(numberOfChunks, vtkSMPTools::GetEstimatedNumberOfThreads()));
      partials.resize(numberOfParts);
      ParallelForEach(numberOfParts, 1,
        [&](vtkIdType part)
        {
          for (vtkIdType c = part; c < numberOfChunks; c += numberOfParts)
          {
            accumulate(partials[part], *chunks[c].Block, chunks[c].Begin, chunks[c].End);
          }
        });
    });
  return partials;
}
}

#endif
