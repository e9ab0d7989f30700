// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLBlocks.h
 * @brief Finds the ends of the blocks of a deck and the rows in them, in parallel.
 *
 * Blocks may declare missing or wrong counts, so their actual rows decide. A row of elements may
 * continue over several lines, and no line shows whether it begins a row. Chunks of text are
 * therefore counted once for each possible number of lines that continue a row at their start; the
 * right one is known when all chunks before have been counted.
 */
#ifndef camaron_MAPDLBlocks_h
#define camaron_MAPDLBlocks_h

#include "Base/FunctionRef.h" // for rows
#include "Base/Progress.h"
#include "MAPDLRows.h"

#include <vector> // for chunks

namespace camaron
{
/// Part of a block that is read in one task.
struct MAPDLChunk
{
  const char* Begin;
  int FurtherLines;   ///< lines at its start that continue the previous row
  vtkIdType FirstRow; ///< in the block
};

struct MAPDLExtent
{
  const char* Begin = nullptr;
  const char* End = nullptr;  ///< of the rows
  const char* Next = nullptr; ///< where the commands continue
  bool IsEnded = false;       ///< by -1 or a command, not by the end of the file
  vtkIdType NumberOfRows = 0;
  std::vector<MAPDLChunk> Chunks;

  const char* GetEnd(std::size_t chunk) const
  {
    return chunk + 1 < this->Chunks.size() ? this->Chunks[chunk + 1].Begin : this->End;
  }
  vtkIdType GetEndRow(std::size_t chunk) const
  {
    return chunk + 1 < this->Chunks.size() ? this->Chunks[chunk + 1].FirstRow : this->NumberOfRows;
  }
};

/// Finds the rows from @a begin on; false if aborted.
/// @param getFurtherLines number of lines that continue the row that begins on a line
bool MeasureMAPDLBlock(FunctionRef<int(const Line&)> getFurtherLines, const char* begin,
  const char* end, vtkIdType chunk, const Progress& progress, MAPDLExtent& extent);

/**
 * Calls @a visit(const Line&, row of the block) for the rows that begin in a chunk; it returns
 * where the next line begins, or nullptr to stop. Returns false then, and with a fault if the
 * number of rows differs from that measured, because the file has changed.
 */
template <typename Visit>
bool ForEachMAPDLRow(const MAPDLExtent& extent, std::size_t chunk, MAPDLFault& fault, Visit&& visit)
{
  constexpr char Expected[] = "the same number of rows as before";
  const MAPDLChunk& start = extent.Chunks[chunk];
  const char* const end = extent.GetEnd(chunk);
  const vtkIdType endRow = extent.GetEndRow(chunk);
  vtkIdType row = start.FirstRow;
  int furtherLines = start.FurtherLines;
  for (const char* text = start.Begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    if (furtherLines > 0)
    {
      furtherLines -= ContinuesMAPDLRow(line);
    }
    else if (ClassifyMAPDLLine(line) == MAPDLLine::Row)
    {
      if (row == endRow)
      {
        return fault.Set(line.Begin, ErrorKind::Count, Expected);
      }
      text = visit(line, row++);
      if (!text)
      {
        return false;
      }
    }
  }
  return row == endRow || fault.Set(start.Begin, ErrorKind::Count, Expected);
}

/// The same for all chunks, in order.
template <typename Visit>
bool ForEachMAPDLRow(const MAPDLExtent& extent, MAPDLFault& fault, Visit&& visit)
{
  bool good = true;
  for (std::size_t chunk = 0; chunk < extent.Chunks.size() && good; ++chunk)
  {
    good = ForEachMAPDLRow(extent, chunk, fault, visit);
  }
  return good;
}
}

#endif
