// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WriteRows.h
 * @brief Writes tables, whose rows are put into bytes in parallel.
 */
#ifndef camaron_WriteRows_h
#define camaron_WriteRows_h

#include "Write/WriteChunks.h"

#include <algorithm> // for std::min

namespace camaron
{
/**
 * Calls @a format(row, std::string& bytes), which appends, for every row in [0, count) and writes
 * the bytes in the order of the rows; works for text and for binary files. False with the error in
 * @a file, or if stopped.
 */
template <typename Format>
bool WriteRows(OutputFile& file, vtkIdType count, const Progress& progress, Format&& format)
{
  constexpr vtkIdType RowsPerChunk = 4096; // some 100 kB of text
  return WriteChunks(file, (count + RowsPerChunk - 1) / RowsPerChunk, progress,
    [&](vtkIdType chunk, std::string& bytes)
    {
      const vtkIdType end = std::min((chunk + 1) * RowsPerChunk, count);
      for (vtkIdType row = chunk * RowsPerChunk; row < end; ++row)
      {
        format(row, bytes);
      }
    });
}
}

#endif
