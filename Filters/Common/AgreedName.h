// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AgreedName.h
 * @brief The name of an array that all processes take where it has not been told to all of them.
 *
 * Processes with clients of their own (pvbatch --sym) may have been told different names, or none, as defaults of
 * properties come from what each of them has.
 */
#ifndef camaron_AgreedName_h
#define camaron_AgreedName_h

#include "Ranks/Reducer.h"

#include <string> // for names
#include <vector> // for lists

namespace camaron
{
/**
 * Collective. What this process or else another one has been told; if none has, the first in alphabetical order of the
 * first list of candidates that is not empty on all processes. Empty if there is none.
 */
inline std::string AgreeOnName(
  const std::string& told, const std::vector<std::vector<std::string>>& candidates, Reducer& reducer)
{
  std::vector<std::string> names =
    reducer.GatherNames(told.empty() ? std::vector<std::string>() : std::vector<std::string>{ told });
  for (std::size_t i = 0; i < candidates.size() && names.empty(); ++i)
  {
    names = reducer.GatherNames(candidates[i]);
  }
  return names.empty() ? std::string() : names.front();
}
}

#endif
