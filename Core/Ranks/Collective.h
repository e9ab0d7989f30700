// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Collective.h
 * @brief Functions that all ranks call together: to fail together, and to agree on a name.
 */
#ifndef camaron_Collective_h
#define camaron_Collective_h

#include "Base/Text.h"
#include "Ranks/Reducer.h"

#include <exception> // for failures
#include <stdexcept> // for failures
#include <string>    // for their reasons
#include <vector>    // for lists

namespace camaron
{
/// Collective. Calls a function that is not collective; if it throws on any rank, all ranks throw
/// std::runtime_error with the same reason, the first in alphabetical order.
template <typename Function>
void RunCollectively(Reducer& reducer, Function&& function)
{
  std::vector<std::string> reasons;
  std::int64_t hasFailed = 0;
  try
  {
    function();
  }
  catch (const std::exception& exception)
  {
    reasons.push_back(GetReason(exception));
    hasFailed = 1;
  }
  reducer.Max(&hasFailed, 1);
  if (hasFailed)
  {
    throw std::runtime_error(reducer.GatherNames(reasons).front());
  }
}

/**
 * Collective. Returns @a told of this rank, or else of another rank. If none has one, returns the
 * first name in alphabetical order from the first list of candidates that is not empty on all
 * ranks; empty if there is none.
 */
inline std::string AgreeOnName(const std::string& told,
  const std::vector<std::vector<std::string>>& candidates, Reducer& reducer)
{
  std::vector<std::string> names = reducer.GatherNames(
    told.empty() ? std::vector<std::string>() : std::vector<std::string>{ told });
  for (std::size_t i = 0; i < candidates.size() && names.empty(); ++i)
  {
    names = reducer.GatherNames(candidates[i]);
  }
  return names.empty() ? std::string() : names.front();
}
}

#endif
