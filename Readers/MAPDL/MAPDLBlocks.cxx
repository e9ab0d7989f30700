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
  };
  State States[NumberOfStates];
};

//------------------------------------------------------------------------------
// Counts lines until one ends the block.
void CountRows(
  FunctionRef<int(const Line&)> getFurtherLines, const char* begin, const char* end, Count& count)
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
    const bool isRow = kind == MAPDLLine::Row;
    const int furtherLines = isRow ? getFurtherLines(line) : 0;
    for (Count::State& state : count.States)
    {
      if (state.FurtherLines > 0)
      {
        state.FurtherLines -= ContinuesMAPDLRow(line);
      }
      else if (isRow)
      {
        ++state.Rows;
        state.FurtherLines = furtherLines;
      }
    }
  }
}
}

//------------------------------------------------------------------------------
// Counts many chunks at a time, independently of those before.
bool MeasureMAPDLBlock(FunctionRef<int(const Line&)> getFurtherLines, const char* begin,
  const char* end, vtkIdType chunkSize, const Progress& progress, MAPDLExtent& extent)
{
  constexpr vtkIdType MaxBatch = 1024; // of chunks; at most about this many are counted in vain
  extent.Begin = begin;
  extent.End = extent.Next = end;
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
    { return static_cast<double>(text - extent.Begin) / static_cast<double>(end - extent.Begin); };
    std::vector<Count> counts(static_cast<std::size_t>(size));
    if (!progress.Part(getFraction(begin), getFraction(starts.back()))
          .For(size,
            [&](vtkIdType firstChunk, vtkIdType lastChunk)
            {
              for (vtkIdType i = firstChunk; i < lastChunk; ++i)
              {
                for (int state = 0; state < NumberOfStates; ++state)
                {
                  counts[i].States[state].FurtherLines = state;
                }
                CountRows(getFurtherLines, starts[i], starts[i + 1], counts[i]);
              }
            }))
    {
      return false;
    }
    for (vtkIdType i = 0; i < size && !extent.IsEnded; ++i)
    {
      extent.Chunks.push_back({ starts[i], furtherLines, extent.NumberOfRows });
      Count count = counts[i];
      int known = furtherLines;
      if (furtherLines >= NumberOfStates)
      {
        known = 0;
        count.States[known] = { furtherLines, 0 };
        CountRows(getFurtherLines, starts[i], starts[i + 1], count);
      }
      furtherLines = count.States[known].FurtherLines;
      extent.NumberOfRows += count.States[known].Rows;
      if (count.Stop)
      {
        extent.IsEnded = true;
        extent.End = count.Stop;
        extent.Next = count.IsEnd ? Line(count.Stop, end).Next : count.Stop;
      }
    }
    begin = starts.back();
  }
  return true;
}
}
