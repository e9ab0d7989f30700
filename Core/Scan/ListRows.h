// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct camaron::ListRows
 * @brief Rows of a binary file with a list of 32 bit integers each, whose places follow from their
 * numbers.
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
  const char* Begin = nullptr;           ///< of the first list
  std::ptrdiff_t Rest = 0;               ///< bytes of a row that are not of its list
  bool Swap = false;                     ///< if the byte order is not the machine's
  std::int32_t Size = 0;                 ///< of all lists, if there are no offsets
  const std::int32_t* Offsets = nullptr; ///< of the lists one after the other, and one more

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
  /// Copies the lists of rows up to @a last.
  void Copy(vtkIdType first, vtkIdType last, std::int32_t* ids) const;
};

/// Whether all ids are at least 0 (or -1) and below a limit.
bool AreIds(const std::int32_t* ids, vtkIdType size, vtkIdType limit, bool mayBeMinusOne = false);
}

#endif
