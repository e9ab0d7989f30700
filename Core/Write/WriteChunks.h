// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WriteChunks.h
 * @brief Writes a file whose parts are put into bytes in parallel.
 */
#ifndef camaron_WriteChunks_h
#define camaron_WriteChunks_h

#include "Write/OutputFile.h"
#include "Base/Progress.h"

#include <algorithm> // for std::min
#include <string>    // for bytes

namespace camaron
{
/**
 * Calls @a format(chunk, std::string& bytes), which appends, for every chunk and writes the bytes in
 * the order of the chunks. False with the error in @a file, or if stopped.
 */
template <typename Format>
bool WriteChunks(
  OutputFile& file, vtkIdType numberOfChunks, const Progress& progress, Format&& format)
{
  constexpr vtkIdType Batch = 64; // of chunks in memory; enough for many threads
  std::vector<std::string> bytes(static_cast<std::size_t>(std::min(Batch, numberOfChunks)));
  for (vtkIdType first = 0; first < numberOfChunks; first += Batch)
  {
    const vtkIdType count = std::min(Batch, numberOfChunks - first);
    Progress().For(count,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          bytes[i].clear();
          format(first + i, bytes[i]);
        }
      });
    for (vtkIdType i = 0; i < count; ++i)
    {
      file.Write(bytes[i]);
    }
    if (file.HasFailed() || !progress.Report(static_cast<double>(first + count) / numberOfChunks))
    {
      return false;
    }
  }
  return true;
}
}

#endif
