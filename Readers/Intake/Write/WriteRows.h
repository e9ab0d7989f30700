// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WriteRows.h
 * @brief Writes tables whose rows are converted to bytes in parallel.
 */
#ifndef camaron_WriteRows_h
#define camaron_WriteRows_h

#include "Base/Progress.h"
#include "Intake/Write/OutputFile.h"

#include "vtkSMPTools.h" // for the number of threads

#include <algorithm> // for std::min
#include <string>    // for bytes
#include <vector>    // for the chunks of all threads

namespace camaron
{
/**
 * Calls @a format(chunk, std::string& bytes), which must append, for every chunk, and writes the
 * bytes in the order of the chunks. False with the error in @a file, an OutputFile or one that
 * writes through it, or if stopped.
 */
template <typename File, typename Format>
bool WriteChunks(File& file, vtkIdType numberOfChunks, const Progress& progress, Format&& format)
{
  // Chunks in memory: threads seldom wait, and few threads keep them in the processor's cache.
  constexpr vtkIdType PerThread = 4, Most = 64;
  const vtkIdType batch = std::min(Most, PerThread * vtkSMPTools::GetEstimatedNumberOfThreads());
  std::vector<std::string> bytes(static_cast<std::size_t>(std::min(batch, numberOfChunks)));
  for (vtkIdType first = 0; first < numberOfChunks; first += batch)
  {
    const vtkIdType count = std::min(batch, numberOfChunks - first);
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

/**
 * Calls @a format(row, std::string& bytes), which must append, for every row in [0, count), and
 * writes the bytes in the order of the rows; for text and binary files. False with the error in
 * @a file, or if stopped.
 */
template <typename File, typename Format>
bool WriteRows(File& file, vtkIdType count, const Progress& progress, Format&& format)
{
  constexpr vtkIdType RowsPerChunk = 4096; // about 100 kB of text
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
