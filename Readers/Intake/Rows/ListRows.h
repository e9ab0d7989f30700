// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct camaron::ListRows
 * @brief Rows of a binary file, each with a list of 32-bit integers at a position that can be
 * computed from the row number.
 */
#ifndef camaron_ListRows_h
#define camaron_ListRows_h

#include "vtkType.h" // for vtkIdType

#include <cstddef> // for distances in memory
#include <cstdint> // for integers of known size

namespace camaron
{
struct ListRows
{
  const char* Begin = nullptr;           ///< start of the first list
  std::ptrdiff_t Rest = 0;               ///< bytes of a row outside its list
  bool Swap = false;                     ///< whether the byte order differs from the machine's
  std::int32_t Size = 0;                 ///< size of all lists, if there are no offsets
  const std::int32_t* Offsets = nullptr; ///< offsets of the concatenated lists, and one more

  const char* GetPlace(vtkIdType row) const
  {
    return this->Begin + row * this->Rest +
      std::ptrdiff_t(sizeof(std::int32_t)) *
      (this->Offsets ? this->Offsets[row] : row * this->Size);
  }
  vtkIdType GetNumberOfIds(vtkIdType first, vtkIdType last) const
  {
    return this->Offsets ? this->Offsets[last] - this->Offsets[first] : (last - first) * this->Size;
  }
  /// Copies the lists of the rows [first, last).
  void Copy(vtkIdType first, vtkIdType last, std::int32_t* ids) const;
};

/// Whether all ids are non-negative (or -1) and below a limit.
bool AreIds(const std::int32_t* ids, vtkIdType size, vtkIdType limit, bool mayBeMinusOne = false);
}

#endif
