// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Progress
 * @brief Reports the progress of a long operation, and whether it should stop.
 *
 * A Progress represents a part of the whole operation; Part creates smaller parts. Only the thread
 * that created it reports. Once stopped, all parts of the same operation stay stopped.
 */
#ifndef camaron_Progress_h
#define camaron_Progress_h

#include "Base/FunctionRef.h" // for parameters

#include "vtkType.h" // for vtkIdType

#include <functional> // for std::function
#include <memory>     // for the shared state

namespace camaron
{
class Progress
{
public:
  /// Receives the completed fraction of the whole operation; returns false to stop it.
  using Listener = std::function<bool(double)>;

  Progress() = default; ///< without a listener
  explicit Progress(Listener listener)
    : Shared(std::make_shared<State>(State{ std::move(listener) }))
  {
  }

  /// The part between two fractions of this part.
  Progress Part(double from, double to) const
  {
    Progress part = *this;
    part.From = this->From + from * (this->To - this->From);
    part.To = this->From + to * (this->To - this->From);
    return part;
  }

  /// Reports that @a fraction of this part is complete; false if the operation should stop.
  bool Report(double fraction) const
  {
    if (this->Shared && !this->Shared->Stopped)
    {
      const double whole = this->From + fraction * (this->To - this->From);
      constexpr double Step = 0.01; // about 100 reports for the whole operation
      if (whole >= this->Shared->Last + Step)
      {
        this->Shared->Last = whole;
        this->Shared->Stopped = !this->Shared->Tell(whole);
      }
    }
    return !this->IsStopped();
  }
  bool IsStopped() const { return this->Shared && this->Shared->Stopped; }

  /**
   * Calls @a function(begin, end) in parallel for ranges of [0, size), and reports in between.
   * Rethrows the first exception thrown by a call.
   * @return false if stopped
   */
  bool For(vtkIdType size, FunctionRef<void(vtkIdType, vtkIdType)> function) const;

  /// The same for cheap items: the ranges consist of whole blocks of this size, but for the last.
  bool ForBlocks(
    vtkIdType size, vtkIdType block, FunctionRef<void(vtkIdType, vtkIdType)> function) const;

private:
  struct State
  {
    Listener Tell;
    double Last = 0;
    bool Stopped = false;
  };
  std::shared_ptr<State> Shared;
  double From = 0;
  double To = 1;
};
}

#endif
