// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ValueChanges.h
 * @brief How many elements have become better or worse.
 */
#ifndef camaron_ValueChanges_h
#define camaron_ValueChanges_h

#include "Criteria/Criterion.h"
#include "Ranks/Reducer.h"
#include "Statistics/Population.h"

#include <cstdint> // for counts

namespace camaron
{
struct ValueChanges
{
  std::int64_t Compared = 0; ///< elements with a value in one of the populations, or in both
  std::int64_t Improved = 0;
  std::int64_t Worsened = 0;
  std::int64_t Unchanged = 0; ///< the rest of Compared has changed in no direction that is known
};

/**
 * Collective. From @a before to @a after, populations with the same blocks; those of @a after say
 * what counts. Values are unchanged if they differ by at most @a tolerance times the larger
 * magnitude; a value is better than none.
 */
ValueChanges CountChanges(const Population& before, const Population& after, Better better,
  double tolerance, Reducer& reducer);

/// after - before for elements [begin, end); NaN if one of them is, 0 if they are the same
/// infinity.
void FindDifferences(const ValueBlock& before, const ValueBlock& after, vtkIdType begin,
  vtkIdType end, double* differences);
}

#endif
