// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Population.h
 * @brief The values that statistics are made of, and threads running over them.
 */
#ifndef camaron_Population_h
#define camaron_Population_h

#include "Base/Parallel.h"
#include "Criteria/Criterion.h"
#include "Statistics/ExactValue.h"

#include "vtkType.h" // for vtkIdType

#include <algorithm> // for std::min
#include <cstdint>   // for rests and shapes
#include <vector>    // for lists of blocks

namespace camaron
{
/// Values of consecutive elements of one array; borrowed.
struct ValueBlock
{
  const double* Values = nullptr;
  /// What integers have beyond their doubles; where absent they are exact.
  const std::int16_t* Rests = nullptr;
  vtkIdType Size = 0;
  /// Elements with a nonzero entry do not belong to the population (ghosts, other groups).
  const unsigned char* Skip = nullptr;
  /// NullReason of each element; where absent the payload of NaN tells.
  const unsigned char* NullReasons = nullptr;
  /// Identity of each element, unique among all processes; where absent FirstId + index.
  const vtkIdType* Ids = nullptr;
  vtkIdType FirstId = 0;
  /// Shapes (Criterion.h) of each element, and those that the acceptable range is for; without them
  /// it is for all.
  const std::uint16_t* Shapes = nullptr;
  unsigned JudgedShapes = 0;

  bool Contains(vtkIdType i) const { return !this->Skip || !this->Skip[i]; }
  int GetRest(vtkIdType i) const { return this->Rests ? this->Rests[i] : 0; }
  ExactValue GetExact(vtkIdType i) const { return { this->Values[i], this->GetRest(i) }; }
  /// Whether the acceptable range is for the element: no other one is inside or outside of it.
  bool IsJudged(vtkIdType i) const
  {
    return !this->Shapes || (this->Shapes[i] & this->JudgedShapes);
  }
  /// The same elements with other values, which are doubles.
  ValueBlock WithValues(const double* values) const
  {
    ValueBlock block = *this;
    block.Values = values;
    block.Rests = nullptr;
    return block;
  }
  vtkIdType GetId(vtkIdType i) const { return this->Ids ? this->Ids[i] : this->FirstId + i; }
  /// Of an element whose value is NaN.
  NullReason GetNullReason(vtkIdType i) const
  {
    return this->NullReasons ? static_cast<NullReason>(this->NullReasons[i])
                             : camaron::GetNullReason(this->Values[i]);
  }
};

/// All blocks of this process.
using Population = std::vector<ValueBlock>;

/**
 * Calls @a accumulate(partial, block, begin, end) for chunks that cover the population. Each thread
 * has a Partial of its own, value-initialized; all of them are returned, one or more. Which chunks
 * go into which is not defined, so merging them must not depend on it.
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
      ParallelFor(numberOfParts, 1,
        [&](vtkIdType firstPart, vtkIdType endPart)
        {
          for (vtkIdType part = firstPart; part < endPart; ++part)
          {
            for (vtkIdType c = part; c < numberOfChunks; c += numberOfParts)
            {
              accumulate(partials[part], *chunks[c].Block, chunks[c].Begin, chunks[c].End);
            }
          }
        });
    });
  return partials;
}
}

#endif
