// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::ConsecutiveRanges
 * @brief Finds the range that contains a position, among consecutive ranges, in constant time.
 */
#ifndef camaron_ConsecutiveRanges_h
#define camaron_ConsecutiveRanges_h

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for the table
#include <vector>  // for the table

namespace camaron
{
class ConsecutiveRanges
{
public:
  /// @param ends the end of each range, ascending; the first range begins at 0
  void Build(std::vector<vtkIdType> ends)
  {
    this->Ends = std::move(ends);
    const vtkIdType size = this->Ends.empty() ? 0 : this->Ends.back();
    this->Firsts.resize(static_cast<std::size_t>((size + BlockSize - 1) / BlockSize));
    std::uint32_t run = 0;
    for (std::size_t block = 0; block < this->Firsts.size(); ++block)
    {
      while (this->Ends[run] <= static_cast<vtkIdType>(block) * BlockSize)
      {
        ++run;
      }
      this->Firsts[block] = run;
    }
  }

  std::uint32_t Find(vtkIdType position) const
  {
    if (this->Ends.size() == 1)
    {
      return 0;
    }
    std::uint32_t run = this->Firsts[static_cast<std::size_t>(position / BlockSize)];
    while (this->Ends[run] <= position)
    {
      ++run;
    }
    return run;
  }

private:
  static constexpr vtkIdType BlockSize = 1024;
  std::vector<vtkIdType> Ends;
  std::vector<std::uint32_t> Firsts; ///< for each block of positions, the range of the first
};
}

#endif
