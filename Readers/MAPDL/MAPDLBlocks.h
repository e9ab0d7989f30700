// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLBlocks.h
 * @brief Finds where the blocks of a deck end, and which rows are where in them, in parallel.
 *
 * The counts that blocks promise may be missing or wrong, so their rows decide. A row of elements
 * may go on over several lines, and nothing in a line says whether it begins a row. Text is
 * therefore counted in chunks for every number of lines that a row may still need at their start;
 * which of these is true is known once all chunks before are counted.
 */
#ifndef camaron_MAPDLBlocks_h
#define camaron_MAPDLBlocks_h

#include "Base/Progress.h"
#include "MAPDLRows.h"

#include <vector> // for chunks

namespace camaron
{
/// Part of a block that is read as one piece of work.
struct MAPDLChunk
{
  const char* Begin;
  int FurtherLines;   ///< lines at its start that belong to the row before
  vtkIdType FirstRow; ///< in the block
  vtkIdType
    FirstNode; ///< of elements: number of nodes of all rows before, MaxMAPDLNodes of each at most
};

struct MAPDLExtent
{
  const char* Begin = nullptr;
  const char* End = nullptr;  ///< of the rows
  const char* Next = nullptr; ///< where commands go on
  bool IsEnded = false;       ///< by -1 or a command, not by the end of the file
  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfNodes = 0; ///< of elements
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

/// Finds the rows of nodes from @a begin on; false if stopped.
bool MeasureMAPDLNodes(const char* begin, const char* end, vtkIdType chunk,
  const Progress& progress, MAPDLExtent& extent);

/// Finds the rows of elements.
bool MeasureMAPDLElements(const MAPDLElementFormat& format, const char* begin, const char* end,
  vtkIdType chunk, const Progress& progress, MAPDLExtent& extent);

/// Calls @a visit(const Line&, row of the block) for the rows of nodes in a chunk until it returns
/// false. False then, or if there are not as many as were measured, because the file was changed.
template <typename Visit>
bool ForEachMAPDLNode(const MAPDLExtent& extent, std::size_t chunk, Visit&& visit)
{
  vtkIdType row = extent.Chunks[chunk].FirstRow;
  const vtkIdType endRow = extent.GetEndRow(chunk);
  const char* const end = extent.GetEnd(chunk);
  for (const char* text = extent.Chunks[chunk].Begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    if (ClassifyMAPDLLine(line) == MAPDLLine::Row && (row == endRow || !visit(line, row++)))
    {
      return false;
    }
  }
  return row == endRow;
}

/**
 * Calls @a visit(const Line&, row of the block, MAPDLElement&) for the elements that begin in a
 * chunk until it returns false. There is a fault if there are not as many as were measured, because
 * the file was changed.
 * @param withNodes whether to read the nodes as well
 */
template <typename Visit>
bool ForEachMAPDLElement(const MAPDLElementFormat& format, const MAPDLExtent& extent,
  std::size_t chunk, bool withNodes, MAPDLFault& fault, Visit&& visit)
{
  const MAPDLChunk& start = extent.Chunks[chunk];
  const char* const end = extent.GetEnd(chunk);
  const vtkIdType endRow = extent.GetEndRow(chunk);
  vtkIdType row = start.FirstRow;
  int furtherLines = start.FurtherLines;
  MAPDLElement element;
  for (const char* text = start.Begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    const bool isRow = ClassifyMAPDLLine(line) == MAPDLLine::Row;
    if (furtherLines > 0)
    {
      furtherLines -= isRow || SkipBlanks(line.Begin, line.End) == line.End;
      continue;
    }
    if (!isRow)
    {
      continue;
    }
    if (row == endRow || !format.ReadHeader(line, element, fault))
    {
      return !fault && fault.Set(line.Begin, ErrorKind::Count, "no further element");
    }
    const int lines = format.GetNumberOfFurtherLines(format.PeekNumberOfNodes(line), element.Type);
    if (!format.CheckEnd(line, extent.End, element.Type, fault))
    {
      return false;
    }
    if (withNodes)
    {
      text = format.ReadNodes(line, extent.End, lines, element, fault);
    }
    else
    {
      furtherLines = lines;
    }
    if (!text || !visit(line, row++, element))
    {
      return false;
    }
  }
  return row == endRow || fault.Set(start.Begin, ErrorKind::Count, "further elements");
}
}

#endif
