// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ArraysOfSteps
 * @brief Keeps account of which arrays are there at which time steps, to tell of those that are
 * not.
 */
#ifndef camaron_ArraysOfSteps_h
#define camaron_ArraysOfSteps_h

#include "StatisticsArrays.h"

#include <map>      // for the account
#include <optional> // for a time
#include <string>   // for names
#include <vector>   // for times

namespace camaron
{
class ArraysOfSteps
{
public:
  void Clear();

  /// @a time: of the step, none if there is but one; @a missing: wanted and not there.
  void Add(const std::optional<double>& time, const std::vector<StatisticsArray>& arrays,
    const std::vector<std::string>& missing);

  /// Sentences about arrays that are nowhere, and about those that only some steps have; empty if
  /// all is there.
  /// @a kind: such as "cell".
  std::string Describe(const std::string& kind) const;

private:
  std::vector<double> Times;
  std::map<std::string, std::vector<double>> TimesOfArrays;
  std::vector<std::string> Missing;
};
}

#endif
