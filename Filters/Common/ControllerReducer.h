// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ControllerReducer
 * @brief Implements Reducer with a vtkMultiProcessController.
 *
 * All filters use it, so that Core needs no knowledge of VTK's parallel modules.
 */
#ifndef camaron_ControllerReducer_h
#define camaron_ControllerReducer_h

#include "Ranks/Reducer.h"

class vtkMultiProcessController;

namespace camaron
{
class ControllerReducer : public Reducer
{
public:
  /// Uses the global controller, whose processes execute the pipeline together. Without a
  /// controller there is one process.
  ControllerReducer();

  int GetNumberOfProcesses() const override;
  int GetProcess() const override;
  void Sum(std::int64_t* values, std::size_t size) override;
  void Min(std::int64_t* values, std::size_t size) override;
  void Max(std::int64_t* values, std::size_t size) override;
  std::vector<char> Gather(
    const std::vector<char>& bytes, std::vector<std::size_t>& sizes) override;
  std::vector<std::vector<char>> Exchange(std::vector<std::vector<char>>&& lists) override;

private:
  void Reduce(std::int64_t* values, std::size_t size, int operation);

  vtkMultiProcessController* Controller;
};
}

#endif
