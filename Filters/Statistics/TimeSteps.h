// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::TimeSteps
 * @brief Lets a filter evaluate all time steps of its inputs in one update, with one step in memory
 * at a time.
 *
 * The filter calls Find, Request and Begin in RequestInformation, RequestUpdateExtent and
 * RequestData, and at the end of RequestData GoOn, which makes the pipeline come back with the next
 * step; after a failure Stop.
 */
#ifndef camaron_TimeSteps_h
#define camaron_TimeSteps_h

#include <optional> // for a time
#include <vector>   // for times

class vtkInformation;
class vtkInformationVector;

namespace camaron
{
class TimeSteps
{
public:
  /// The steps are those of the first of the inputs that has any. With @a isOn outputs have none,
  /// else the same.
  void Find(
    bool isOn, vtkInformationVector** inputs, int numberOfInputs, vtkInformationVector* outputs);

  /// Asks all inputs for the step to evaluate.
  void Request(vtkInformationVector** inputs, int numberOfInputs) const;

  bool IsFirst() const { return this->Step == 0; }
  bool IsLast() const { return this->Step + 1 >= this->Times.size(); }
  /// Of the step to evaluate; none unless all are, NaN if the inputs have none.
  std::optional<double> GetTime() const;
  /// Of all steps, from the share of this one that is done.
  double GetProgress(double share) const;

  /// Returns whether there is another step.
  bool GoOn(vtkInformation* request);
  void Stop(vtkInformation* request);

private:
  bool IsOn = false;
  std::vector<double> Times;
  std::size_t Step = 0;
};
}

#endif
