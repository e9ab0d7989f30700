// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FluentFaceBatches.h"

#include "FluentText.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
// Enough for many threads; what pieces have of the faces should not weigh more than the piece.
constexpr vtkIdType BatchOfWhole = 64 * FluentFaces::BlockSize;
constexpr vtkIdType BatchOfPiece = 16 * FluentFaces::BlockSize;

//------------------------------------------------------------------------------
bool IsBlank(const char* text, const char* end)
{
  return std::all_of(text, end, [](char c) { return IsSpace(c); });
}
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::Copy(const FluentFace& face, bool bounds, Face& copy) const
{
  const std::int32_t size = face.Nodes.Size;
  if (size > Face::MaxSize && bounds)
  {
    return false;
  }
  bool good = true;
  copy.Size = size;
  for (std::int32_t i = 0; i < size; ++i)
  {
    const std::int32_t node = face.Nodes[i];
    good &= static_cast<std::uint32_t>(node) - 1 < static_cast<std::uint64_t>(this->Nodes);
    copy.Nodes[i % Face::MaxSize] = node;
  }
  const auto maxCell = static_cast<std::uint64_t>(this->Mesh.Cells.GetCount());
  for (int side = 0; side < 2 && good; ++side)
  {
    const std::int32_t cell = face.GetCell(side);
    good = static_cast<std::uint32_t>(cell) <= maxCell;
    copy.Cells[side] = good && size > 0 ? static_cast<std::int32_t>(this->Mesh.FindCell(cell)) : -1;
  }
  return good;
}

//------------------------------------------------------------------------------
// Faces that are accessible.
bool FluentFaceBatches::Copy(const Run& run, vtkIdType begin, vtkIdType end)
{
  constexpr vtkIdType BlockSize = FluentFaces::BlockSize;
  std::atomic<bool> good{ true };
  ParallelFor((end - begin + BlockSize - 1) / BlockSize, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      bool isGood = true;
      FluentFaces::ForEachOf(run, begin + first * BlockSize,
        std::min(begin + last * BlockSize, end),
        [&](vtkIdType position, const FluentFace& face)
        { isGood = this->Copy(face, run.Bounds, this->Batch[position - begin]) && isGood; });
      if (!isGood)
      {
        good = false;
      }
    });
  return good;
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::ReadLine(
  const Run& run, const char* text, const char* end, Face& face) const
{
  std::int64_t value = run.Size;
  if (run.Size == 0)
  {
    text = ParseHex(text, end, value);
    if (!text || value > Face::MaxSize)
    {
      return false;
    }
  }
  face.Size = static_cast<std::int32_t>(value);
  for (std::int32_t i = 0; i < face.Size; ++i)
  {
    text = ParseHex(text, end, value);
    if (!text || value < 1 || value > this->Nodes)
    {
      return false;
    }
    face.Nodes[i] = static_cast<std::int32_t>(value);
  }
  for (std::int32_t& cell : face.Cells)
  {
    text = ParseHex(text, end, value);
    if (!text || value > this->Mesh.Cells.GetCount())
    {
      return false;
    }
    cell = face.Size > 0
      ? static_cast<std::int32_t>(this->Mesh.FindCell(static_cast<std::int32_t>(value)))
      : -1;
  }
  return IsBlank(text, end);
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::VisitText(const Run& run, const VisitBatch& visit)
{
  TextScanner scanner("", this->File.GetBegin(), run.Section->End);
  scanner.SetPosition(run.Section->Begin);
  const TextLines lines(scanner, Progress(), this->Chunk);
  const char* place = run.Section->Begin;
  for (vtkIdType begin = run.Begin; begin < run.End; begin += this->BatchSize)
  {
    const vtkIdType end = std::min(begin + this->BatchSize, run.End);
    const TextLines::Section section = lines.Find(place, end - begin);
    if (!section ||
      !lines.ForEach(section, Progress(),
        [&](vtkIdType, vtkIdType line, const char* text, const char* lineEnd)
        { return this->ReadLine(run, text, lineEnd, this->Batch[line]); }) ||
      !visit(begin, end))
    {
      return false;
    }
    place = section.End;
  }
  return IsBlank(place, run.Section->End);
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::VisitKept(const Run& run, const VisitBatch& visit)
{
  for (vtkIdType begin = run.Begin; begin < run.End; begin += this->BatchSize)
  {
    const vtkIdType end = std::min(begin + this->BatchSize, run.End);
    if (!this->Copy(run, begin, end) || !visit(begin, end))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::ForEach(const Progress& progress,
  const std::function<bool(const FluentFaces::Run&, const Face*, vtkIdType)>& visit)
{
  const vtkIdType size = this->Mesh.Faces.GetCount();
  this->BatchSize = this->Mesh.Piece.IsWhole() ? BatchOfWhole : BatchOfPiece;
  this->Batch = Buffer<Face>(std::min(size, this->BatchSize));
  for (const Run& run : this->Mesh.Faces.GetRuns())
  {
    const auto visitBatch = [&](vtkIdType begin, vtkIdType end)
    {
      return (!run.Bounds || visit(run, this->Batch.data(), end - begin)) &&
        progress.Report(static_cast<double>(end) / static_cast<double>(size));
    };
    if (!(run.Data ? this->VisitKept(run, visitBatch) : this->VisitText(run, visitBatch)))
    {
      return false;
    }
  }
  return true;
}
}
