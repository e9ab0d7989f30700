// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::PieceExchange
 * @brief Processes that read pieces of one file load different parts of its data, and exchange
 * them.
 *
 * All processes take part in each step, and tell each other where they are. A process that leaves,
 * because it has finished, has failed or was aborted, takes part in one more step, its last. If the
 * processes are not all at the same place in a step, all leave, and each loads the rest on its own.
 * So none waits for another that reads no longer, as long as every process has created an exchange.
 */
#ifndef camaron_PieceExchange_h
#define camaron_PieceExchange_h

#include "Base/Buffer.h"

#include <algorithm> // for the ends of parts
#include <cstdint>   // for places
#include <vector>    // for parts

class vtkMultiProcessController;

namespace camaron
{
struct PieceRequest;

/// The controller of all processes, if each of them is reading its own piece; else nullptr.
vtkMultiProcessController* FindProcesses(const PieceRequest& request);

class PieceExchange
{
public:
  /// @param processes all of which create an exchange; nullptr for none
  explicit PieceExchange(vtkMultiProcessController* processes)
    : Processes(processes)
  {
  }
  ~PieceExchange() { this->Close(); }
  PieceExchange(const PieceExchange&) = delete;
  PieceExchange& operator=(const PieceExchange&) = delete;

  /// Leaves, unless all have left. Collective.
  void Close();

  /**
   * Loads all items from 0 to @a count, in any order, if the exchange is open together with the
   * other processes. Calls load(begin, end, values), which sets values and returns their number;
   * then visit(begin, end, values, number), until it returns false.
   * @param place a number that differs from those of other items
   * @param batch number of items to load at once
   */
  template <typename Value, typename Load, typename Visit>
  bool ForBatches(
    std::int64_t place, std::int64_t count, std::int64_t batch, Load&& load, Visit&& visit)
  {
    // Each process has a range of items, so that few chunks are loaded by several.
    const int parts = this->CountParts(count / batch);
    const auto getBegin = [&](int part) { return count * part / parts; };
    const std::int64_t step = std::max<std::int64_t>(batch / parts, 1);
    const std::int64_t most = count / parts + 1; // items of a part
    Buffer<Value> values;
    std::int64_t done = 0; // of the items of each part
    const auto getPlace = [&](int part)
    { return std::min(getBegin(part) + done, getBegin(part + 1)); };
    const auto getEnd = [&](int part)
    { return std::min(getBegin(part) + done + step, getBegin(part + 1)); };
    for (; parts > 1 && done < most; done += step)
    {
      const int own = this->GetOwnPart();
      const bool hasItems = getPlace(own) < getEnd(own);
      const std::int64_t size = hasItems ? load(getPlace(own), getEnd(own), values) : 0;
      Buffer<Value> all;
      std::vector<vtkIdType> begins;
      if (!this->Exchange(place + done, values.data(), size, all, begins))
      {
        break;
      }
      for (int part = 0; part < parts; ++part)
      {
        const vtkIdType begin = begins[static_cast<std::size_t>(part)];
        const vtkIdType end = begins[static_cast<std::size_t>(part) + 1];
        if (getPlace(part) < getEnd(part) &&
          !visit(getPlace(part), getEnd(part), all.data() + begin, end - begin))
        {
          return false;
        }
      }
    }
    for (int part = 0; part < parts; ++part)
    {
      const std::int64_t last = getBegin(part + 1);
      for (std::int64_t begin = getPlace(part); begin < last; begin += batch)
      {
        const std::int64_t end = std::min(begin + batch, last);
        const std::int64_t size = load(begin, end, values);
        if (!visit(begin, end, values.data(), size))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  int CountParts(std::int64_t batches) const;
  int GetOwnPart() const;
  bool AreTogether(std::int64_t place, std::int64_t size, std::vector<vtkIdType>& sizes);
  ///@{
  /// Sets @a all to the values of all processes, with the begins of their parts; false, and the
  /// exchange is closed, if the others are not at this place.
  bool Exchange(std::int64_t place, const std::int32_t* values, std::int64_t size,
    Buffer<std::int32_t>& all, std::vector<vtkIdType>& begins);
  bool Exchange(std::int64_t place, const double* values, std::int64_t size, Buffer<double>& all,
    std::vector<vtkIdType>& begins);
  template <typename Value>
  bool ExchangeAny(std::int64_t place, const Value* values, std::int64_t size, Buffer<Value>& all,
    std::vector<vtkIdType>& begins);
  ///@}

  vtkMultiProcessController* Processes; ///< nullptr if closed
};
}

#endif
