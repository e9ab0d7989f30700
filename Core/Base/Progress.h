// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::Progress
 * @brief Tells somebody how far a long piece of work is, and hears whether to stop.
 *
 * A Progress stands for a part of the whole work; parts of it are made with Part. It reports only
 * from the thread that made it. Once stopped, all parts of the same work stay stopped.
 */
#ifndef camaron_Progress_h
#define camaron_Progress_h

#include "Base/Parallel.h"

#include <exception>  // for errors in threads
#include <functional> // for std::function
#include <memory>     // for the shared state
#include <mutex>      // for errors in threads

namespace camaron
{
class Progress
{
public:
  /// Is told a fraction of the whole work; returns false to stop it.
  using Listener = std::function<bool(double)>;

  Progress() = default; ///< nobody listens
  explicit Progress(Listener listener)
    : Shared(std::make_shared<State>(State{ std::move(listener) }))
  {
  }

  /// The part of this part between two fractions of it.
  Progress Part(double from, double to) const
  {
    Progress part = *this;
    part.From = this->From + from * (this->To - this->From);
    part.To = this->From + to * (this->To - this->From);
    return part;
  }

  /// Reports that @a fraction of this part is done; false when the work should stop.
  bool Report(double fraction) const
  {
    if (this->Shared && !this->Shared->Stopped)
    {
      const double whole = this->From + fraction * (this->To - this->From);
      constexpr double Step = 0.01; // about 100 reports for the whole work
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
   * Calls @a function(begin, end) in parallel for pieces of [0, size), reporting in between;
   * returns false if stopped. The first exception thrown by a piece is thrown again here.
   */
  template <typename Function>
  bool For(vtkIdType size, Function&& function) const
  {
    // Few enough that waiting for threads at the end of each costs little.
    const vtkIdType slices = this->Shared && size >= 64 ? 10 : 1;
    std::exception_ptr error;
    std::mutex mutex;
    for (vtkIdType slice = 0; slice < slices; ++slice)
    {
      const vtkIdType first = size * slice / slices;
      const vtkIdType count = size * (slice + 1) / slices - first;
      ParallelFor(count, count > 1 ? 0 : 1, // 0 leaves the choice to VTK
        [&](vtkIdType begin, vtkIdType end)
        {
          try
          {
            function(first + begin, first + end);
          }
          catch (...)
          {
            const std::lock_guard<std::mutex> lock(mutex);
            error = error ? error : std::current_exception();
          }
        });
      if (error)
      {
        std::rethrow_exception(error);
      }
      if (!this->Report(static_cast<double>(slice + 1) / slices))
      {
        return false;
      }
    }
    return true;
  }

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
