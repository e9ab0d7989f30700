// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TimeSteps
 * @brief Lets a filter evaluate all time steps of its inputs in one update, with one step in memory
 * at a time.
 *
 * The filter calls Find in RequestInformation and Request in RequestUpdateExtent. At the end of
 * RequestData it calls CheckAbortOnAllRanks, after which the pipeline executes the filter again
 * with the next step, or Stop after a failure.
 */
#ifndef camaron_TimeSteps_h
#define camaron_TimeSteps_h

#include "StatisticsArrays.h"

#include <map>      // for the times of each array
#include <optional> // for a time
#include <string>   // for names
#include <vector>   // for times

class vtkInformation;
class vtkInformationVector;

namespace camaron
{
class TimeSteps
{
public:
  /// Reads the time steps of the first input that has any. If @a isOn, all steps are evaluated and
  /// the outputs have no time steps; else the outputs have the same steps.
  void Find(
    bool isOn, vtkInformationVector** inputs, int numberOfInputs, vtkInformationVector* outputs);

  /// Requests the step to evaluate from all inputs.
  void Request(vtkInformationVector** inputs, int numberOfInputs) const;

  bool IsFirst() const { return this->Step == 0; }
  bool IsLast() const { return this->Step + 1 >= this->Times.size(); }
  /// Time of the step to evaluate. None unless all steps are evaluated; NaN if the inputs have no
  /// time steps.
  std::optional<double> GetTime() const;
  /// Progress over all steps, from 0 to 1; @a share is the fraction of the current step that is
  /// done.
  double GetProgress(double share) const;

  /// Continues with the next step. False if there is none.
  bool CheckAbortOnAllRanks(vtkInformation* request);
  /// Ends the loop over steps.
  void Stop(vtkInformation* request);

private:
  bool IsOn = false;
  std::vector<double> Times;
  std::size_t Step = 0;
};

/// Records which arrays exist at which time steps, for a warning about missing arrays.
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
