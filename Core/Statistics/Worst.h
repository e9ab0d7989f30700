// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Worst.h
 * @brief The worst elements of a population in their exact order.
 *
 * Worst are the largest or the smallest values; infinite ones take part, NaN does not. Among equal
 * values the element with the smaller identity comes first.
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
/// The end of the number line where bad values are.
enum class WorstEnd
{
  Smallest,
  Largest
};

/// An element of the list.
struct WorstElement
{
  double Value = 0;
  int Rest = 0; ///< see ExactValue
  vtkIdType Id = -1;
  ///@{
  /// Where the process that owns the element has it: block of the population and place in the
  /// block.
  int Block = 0;
  vtkIdType Index = 0;
  ///@}
  ///@{
  /// For the owner to fill in.
  int Process = 0;
  int BlockNumber = 0;
  int CellType = 0;
  double Place[3] = { 0, 0, 0 };
  ///@}
};

/**
 * Up to @a count worst elements, worst first, known to every process. @a describe fills in what it
 * likes about the elements of this process that may be in the list. Collective, for short lists.
 */
std::vector<WorstElement> FindWorst(const Population& population, std::int64_t count, WorstEnd end,
  Reducer& reducer, const std::function<void(WorstElement&)>& describe);

/// Where the list of the worst ends; made for any length of it.
struct WorstLimit
{
  std::int64_t Count = 0; ///< elements in the list
  WorstEnd End = WorstEnd::Largest;
  std::int64_t Key = 0;  ///< of the last one's value, see OrderedKey.h
  std::int64_t Rest = 0; ///< of the last one
  vtkIdType LastId = -1; ///< of the last one

  bool Contains(const ValueBlock& block, vtkIdType i) const;
};

/// Collective.
WorstLimit FindWorstLimit(
  const Population& population, std::int64_t count, WorstEnd end, Reducer& reducer);
}

#endif
