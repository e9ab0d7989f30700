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

#include "Base/Progress.h"
#include "MAPDLRows.h"

#include <vector> // for chunks

namespace camaron
{
/// Part of a block that is read in one task.
struct MAPDLChunk
{
  const char* Begin;
  int FurtherLines;    ///< lines at its start that continue the previous row
  vtkIdType FirstRow;  ///< in the block
  vtkIdType FirstNode; ///< of elements: nodes of all rows before, at most MaxMAPDLNodes of each
};

struct MAPDLExtent
{
  const char* Begin = nullptr;
  const char* End = nullptr;  ///< of the rows
  const char* Next = nullptr; ///< where the commands continue
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
  vtkIdType GetEndNode(std::size_t chunk) const
  {
    return chunk + 1 < this->Chunks.size() ? this->Chunks[chunk + 1].FirstNode
                                           : this->NumberOfNodes;
  }
};

/// Finds the rows of nodes from @a begin on; false if aborted.
bool MeasureMAPDLNodes(const char* begin, const char* end, vtkIdType chunk,
  const Progress& progress, MAPDLExtent& extent);

/// Finds the rows of elements.
bool MeasureMAPDLElements(const MAPDLElementFormat& format, const char* begin, const char* end,
  vtkIdType chunk, const Progress& progress, MAPDLExtent& extent);

/// Calls @a visit(const Line&, row of the block) for the rows of nodes in a chunk until it returns
/// false. Returns false then, or if the number of rows differs from that measured, because the file
/// has changed.
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

/// The same for all chunks, in order.
template <typename Visit>
bool ForEachMAPDLNode(const MAPDLExtent& extent, Visit&& visit)
{
  bool good = true;
  for (std::size_t chunk = 0; chunk < extent.Chunks.size() && good; ++chunk)
  {
    good = ForEachMAPDLNode(extent, chunk, visit);
  }
  return good;
}

/**
 * Calls @a visit(const Line&, row of the block, MAPDLElement&) for the elements that begin in a
 * chunk until it returns false. Sets a fault if their number differs from that measured, because
 * the file has changed.
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

/// The same for all chunks, in order.
template <typename Visit>
bool ForEachMAPDLElement(const MAPDLElementFormat& format, const MAPDLExtent& extent,
  bool withNodes, MAPDLFault& fault, Visit&& visit)
{
  bool good = true;
  for (std::size_t chunk = 0; chunk < extent.Chunks.size() && good; ++chunk)
  {
    good = ForEachMAPDLElement(format, extent, chunk, withNodes, fault, visit);
  }
  return good;
}
}

#endif
