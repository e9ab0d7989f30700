// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ArraysOfSteps
 * @brief Records which arrays exist at which time steps, for a warning about missing arrays.
 */
#ifndef camaron_ArraysOfSteps_h
#define camaron_ArraysOfSteps_h

#include "StatisticsArrays.h"

#include <map>      // for the times of each array
#include <optional> // for an optional time
#include <string>   // for names
#include <vector>   // for times

namespace camaron
{
class ArraysOfSteps
{
public:
  /// Forgets all steps.
  void Clear();

  /// @a time: of the step, none if there is only one step. @a arrays: the arrays of the step. @a
  /// missing: names of requested arrays that the step lacks.
  void Add(const std::optional<double>& time, const std::vector<StatisticsArray>& arrays,
    const std::vector<std::string>& missing, bool hasElements = true);

  /// Sentences about arrays that no step has and arrays that only some steps have; empty if nothing
  /// is missing, or no step has elements. @a kind: element type for the message, such as "cell".
  std::string Describe(const std::string& kind) const;

private:
  std::vector<double> Times;
  std::map<std::string, std::vector<double>> TimesOfArrays;
  std::vector<std::string> Missing;
  bool HasElements = false;
};
}

#endif
