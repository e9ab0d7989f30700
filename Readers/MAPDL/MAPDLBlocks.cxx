// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLBlocks.h"

#include <algorithm>

namespace camaron
{
namespace
{
// Numbers of continuation lines for which chunks are counted in advance: rows of up to 46 nodes.
constexpr int NumberOfStates = 3;

//------------------------------------------------------------------------------
// Contents of a chunk.
struct Count
{
  const char* Stop = nullptr; // the line at which the block ends
  bool IsEnd = false;         // that line is part of it
  struct State
  {
    int FurtherLines = 0;
    vtkIdType Rows = 0;
    vtkIdType Nodes = 0;
  };
  State States[NumberOfStates];
};

//------------------------------------------------------------------------------
// Visits lines until one ends the block.
template <typename Visit>
void CountLines(const char* begin, const char* end, Count& count, Visit&& visit)
{
  for (const char* text = begin; text < end;)
  {
    const Line line(text, end);
    text = line.Next;
    const MAPDLLine kind = ClassifyMAPDLLine(line);
    if (kind == MAPDLLine::End || kind == MAPDLLine::Command)
    {
      count.Stop = line.Begin;
      count.IsEnd = kind == MAPDLLine::End;
      return;
    }
    visit(line, kind == MAPDLLine::Row);
  }
}

//------------------------------------------------------------------------------
// Counts many chunks at a time, independently of those before.
template <typename CountChunk, typename CountFrom>
bool Measure(const char* begin, const char* end, vtkIdType chunkSize, const Progress& progress,
  MAPDLExtent& extent, CountChunk&& countChunk, CountFrom&& countFrom)
{
  constexpr vtkIdType MaxBatch = 1024; // of chunks; at most about this many are counted in vain
  const char* const first = begin;
  extent.Begin = begin;
  int furtherLines = 0;
  for (vtkIdType batch = 1; begin < end && !extent.IsEnded; batch = std::min(2 * batch, MaxBatch))
  {
    std::vector<const char*> starts{ begin };
    for (vtkIdType i = 0; i < batch && starts.back() < end; ++i)
    {
      starts.push_back(CutAtLine(starts.back(), end, chunkSize));
    }
    const auto size = static_cast<vtkIdType>(starts.size()) - 1;
    const auto getFraction = [&](const char* text)
    { return static_cast<double>(text - first) / static_cast<double>(end - first); };
    std::vector<Count> counts(static_cast<std::size_t>(size));
    if (!progress.Part(getFraction(begin), getFraction(starts.back()))
          .For(size,
            [&](vtkIdType firstChunk, vtkIdType lastChunk)
            {
              for (vtkIdType i = firstChunk; i < lastChunk; ++i)
              {
                countChunk(starts[i], starts[i + 1], counts[i]);
              }
            }))
    {
      return false;
    }
    for (vtkIdType i = 0; i < size && !extent.IsEnded; ++i)
    {
      Count& count = counts[i];
      extent.Chunks.push_back(
        { starts[i], furtherLines, extent.NumberOfRows, extent.NumberOfNodes });
      const Count::State state = furtherLines < NumberOfStates
        ? count.States[furtherLines]
        : countFrom(starts[i], starts[i + 1], furtherLines);
      furtherLines = state.FurtherLines;
      extent.NumberOfRows += state.Rows;
      extent.NumberOfNodes += state.Nodes;
      if (count.Stop)
      {
        extent.IsEnded = true;
        extent.End = count.Stop;
        extent.Next = count.IsEnd ? Line(count.Stop, end).Next : count.Stop;
      }
    }
    begin = starts.back();
  }
  if (!extent.IsEnded)
  {
    extent.End = extent.Next = end;
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool MeasureMAPDLNodes(const char* begin, const char* end, vtkIdType chunk,
  const Progress& progress, MAPDLExtent& extent)
{
  return Measure(
    begin, end, chunk, progress, extent,
    [](const char* first, const char* last, Count& count)
    {
      CountLines(
        first, last, count, [&count](const Line&, bool isRow) { count.States[0].Rows += isRow; });
    },
    [](const char*, const char*, int) { return Count::State(); });
}

//------------------------------------------------------------------------------
bool MeasureMAPDLElements(const MAPDLElementFormat& format, const char* begin, const char* end,
  vtkIdType chunk, const Progress& progress, MAPDLExtent& extent)
{
  const auto countStates = [&](const char* first, const char* last, Count& count)
  {
    CountLines(first, last, count,
      [&](const Line& line, bool isRow)
      {
        int nodes = 0, furtherLines = 0;
        if (isRow)
        {
          nodes = format.PeekNumberOfNodes(line);
          furtherLines = format.GetNumberOfFurtherLines(nodes, format.PeekType(line));
          nodes += format.IsSolid() ? 0 : furtherLines * format.FieldsPerLine;
        }
        const bool isBlank = !isRow && SkipBlanks(line.Begin, line.End) == line.End;
        for (Count::State& state : count.States)
        {
          if (state.FurtherLines > 0)
          {
            state.FurtherLines -= isRow || isBlank;
          }
          else if (isRow)
          {
            ++state.Rows;
            state.Nodes += std::min(nodes, MaxMAPDLNodes);
            state.FurtherLines = furtherLines;
          }
        }
      });
  };
  return Measure(
    begin, end, chunk, progress, extent,
    [&](const char* first, const char* last, Count& count)
    {
      for (int state = 0; state < NumberOfStates; ++state)
      {
        count.States[state].FurtherLines = state;
      }
      countStates(first, last, count);
    },
    [&](const char* first, const char* last, int furtherLines)
    {
      Count count;
      count.States[0].FurtherLines = furtherLines;
      countStates(first, last, count);
      return count.States[0];
    });
}
}
