// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LineChunks.h
 * @brief Whole lines of text, including blanks, for formats where columns matter.
 *
 * TextLines is for formats where white space does not matter.
 */
#ifndef camaron_LineChunks_h
#define camaron_LineChunks_h

#include "vtkType.h" // for vtkIdType

#include <cstring> // for std::memchr

namespace camaron
{
/// A line without its end, and the start of the next one.
struct Line
{
  const char* Begin;
  const char* End;
  const char* Next;

  Line(const char* begin, const char* end)
    : Begin(begin)
  {
    const void* const found = begin < end ? std::memchr(begin, '\n', end - begin) : nullptr;
    this->End = found ? static_cast<const char*>(found) : end;
    this->Next = found ? this->End + 1 : end;
    this->End -= this->End > begin && this->End[-1] == '\r';
  }
};

/// The start of the first line that begins at least @a size bytes after @a begin, or the end.
inline const char* CutAtLine(const char* begin, const char* end, vtkIdType size)
{
  return end - begin > size ? Line(begin + size, end).Next : end;
}
}

#endif
