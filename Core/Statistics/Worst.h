// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Worst.h
 * @brief The worst elements of a population in exact order.
 *
 * The worst values are the largest or the smallest; infinite values count, NaN does not. Of equal
 * values, the element with the smaller id comes first.
 */
#ifndef camaron_Worst_h
#define camaron_Worst_h

#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint>    // for counts
#include <functional> // for the describing function
#include <vector>     // for the list

namespace camaron
{
/// The bad end of the range.
enum class WorstEnd
{
  Smallest,
  Largest
};

/// An element of the list.
struct WorstElement
{
  double Value = 0;
  vtkIdType Id = -1;
  ///@{
  /// Location on the rank that owns the element: block of the population and index in the block.
  int Block = 0;
  vtkIdType Index = 0;
  ///@}
  ///@{
  /// Set by the owner.
  int Process = 0;
  int BlockNumber = 0;
  int CellType = 0;
  double Place[3] = { 0, 0, 0 };
  double Size = 0;
  int IsJudged = 1; ///< whether the acceptable range applies to it, see ValueBlock
  ///@}
};

/**
 * Collective, for short lists. Up to @a count worst elements, worst first, on every rank.
 * @a describe sets further members of those elements of this rank that may be in the list.
 */
std::vector<WorstElement> FindWorst(const Population& population, std::int64_t count, WorstEnd end,
  Reducer& reducer, const std::function<void(WorstElement&)>& describe);

/// The last element of a list of the worst elements; works for lists of any length.
struct WorstLimit
{
  std::int64_t Count = 0; ///< number of elements in the list
  WorstEnd End = WorstEnd::Largest;
  std::int64_t Key = 0;  ///< key of the last value, see OrderedKey.h
  vtkIdType LastId = -1; ///< id of the last element

  bool Contains(const ValueBlock& block, vtkIdType i) const;
};

/// Collective.
WorstLimit FindWorstLimit(
  const Population& population, std::int64_t count, WorstEnd end, Reducer& reducer);

/**
 * The elements of a population whose value is missing, as a separate population.
 *
 * A value is missing if it is undefined for another reason than NotApplicable. These elements have
 * the value 0 and all others NaN, so FindWorst() lists them by their ids. Needs 8 bytes per
 * element.
 */
class MissingValues
{
public:
  explicit MissingValues(const Population& population);

  /// Has the blocks of the original population; valid while this object and these blocks exist.
  const Population& Get() const { return this->Blocks; }

private:
  Population Blocks;
  std::vector<std::vector<double>> Values;
};
}

#endif
