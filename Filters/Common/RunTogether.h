// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunTogether.h
 * @brief Makes the failure of one process the failure of all, so that none waits for it.
 */
#ifndef camaron_RunTogether_h
#define camaron_RunTogether_h

#include "Ranks/Reducer.h"

#include <exception> // for failures
#include <stdexcept> // for failures
#include <string>    // for their reasons

namespace camaron
{
/// Collective. Runs what is not; if it throws anywhere, all processes throw std::runtime_error.
template <typename Function>
void RunTogether(Reducer& reducer, Function&& function)
{
  std::string error;
  std::int64_t hasFailed = 0;
  try
  {
    function();
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
    hasFailed = 1;
  }
  const bool hasOwnError = hasFailed != 0;
  reducer.Max(&hasFailed, 1);
  if (hasFailed)
  {
    throw std::runtime_error(hasOwnError ? error : "another process failed");
  }
}
}

#endif
