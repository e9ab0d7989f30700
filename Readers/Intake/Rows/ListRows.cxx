// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/ListRows.h"

#include "Intake/Rows/Bytes.h"

namespace camaron
{
namespace
{
constexpr int Word = sizeof(std::int32_t);

//------------------------------------------------------------------------------
template <bool Swap>
void CopyTwo(const char* from, std::int32_t* to)
{
  std::uint64_t words;
  std::memcpy(&words, from, 2 * Word);
  constexpr int HalfBits = 32;
  words = Swap ? SwapBytes(words) : words;
  words = Swap ? words >> HalfBits | words << HalfBits : words;
  std::memcpy(to, &words, 2 * Word);
}

//------------------------------------------------------------------------------
template <bool Swap>
void CopyWords(const char* from, std::int32_t* to, vtkIdType size)
{
  for (; size > 1; size -= 2, from += 2 * Word, to += 2)
  {
    CopyTwo<Swap>(from, to);
  }
  if (size > 0)
  {
    *to = Load<std::int32_t>(from, Swap);
  }
}

//------------------------------------------------------------------------------
template <bool Swap>
void CopyAlike(const ListRows& rows, vtkIdType first, vtkIdType last, std::int32_t* ids)
{
  const std::int32_t size = rows.Size;
  const std::ptrdiff_t stride = rows.Rest + size * Word;
  const char* place = rows.GetPlace(first);
  for (vtkIdType row = first; row < last; ++row, place += stride, ids += size)
  {
    if (size != 3)
    {
      CopyWords<Swap>(place, ids, size);
      continue;
    }
    CopyTwo<Swap>(place, ids); // triangles and points, by far the most frequent
    ids[2] = Load<std::int32_t>(place + 2 * Word, Swap);
  }
}

//------------------------------------------------------------------------------
template <bool Swap>
void CopyUneven(const ListRows& rows, vtkIdType first, vtkIdType last, std::int32_t* ids)
{
  const std::int32_t* const offsets = rows.Offsets;
  const std::int32_t end = offsets[last];
  constexpr int Few = 4;
  for (vtkIdType row = first; row < last; ++row)
  {
    const char* const place = rows.GetPlace(row);
    std::int32_t* const to = ids + (offsets[row] - offsets[first]);
    const std::int32_t size = offsets[row + 1] - offsets[row];
    if (size > Few || offsets[row] + Few > end)
    {
      CopyWords<Swap>(place, to, size);
      continue;
    }
    // Saves a branch for lists of three and four: the next list overwrites the excess.
    CopyTwo<Swap>(place, to);
    CopyTwo<Swap>(place + 2 * Word, to + 2);
  }
}

//------------------------------------------------------------------------------
template <bool Swap>
void CopyRows(const ListRows& rows, vtkIdType first, vtkIdType last, std::int32_t* ids)
{
  if (rows.Offsets)
  {
    CopyUneven<Swap>(rows, first, last, ids);
  }
  else
  {
    CopyAlike<Swap>(rows, first, last, ids);
  }
}
}

//------------------------------------------------------------------------------
void ListRows::Copy(vtkIdType first, vtkIdType last, std::int32_t* ids) const
{
  if (this->Swap)
  {
    CopyRows<true>(*this, first, last, ids);
  }
  else
  {
    CopyRows<false>(*this, first, last, ids);
  }
}

//------------------------------------------------------------------------------
bool AreIds(const std::int32_t* ids, vtkIdType size, vtkIdType limit, bool mayBeMinusOne)
{
  // For unsigned numbers below 2^31, the difference to the limit is negative if they are below it.
  const std::uint32_t shift = mayBeMinusOne ? 1 : 0;
  const std::uint32_t end = static_cast<std::uint32_t>(limit) + shift;
  std::uint32_t bad = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const std::uint32_t id = static_cast<std::uint32_t>(ids[i]) + shift;
    bad |= id | ~(id - end);
  }
  return size == 0 || bad >> 31 == 0;
}
}
