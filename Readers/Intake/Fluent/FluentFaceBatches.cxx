// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFaceBatches.h"

#include "Intake/Fluent/FluentText.h"

#include "vtkSMPTools.h"

namespace camaron
{
namespace
{
// For text: enough for many threads, but only a small part of the mesh.
constexpr vtkIdType MinBatch = 8 * FluentFaceBatches::BlockSize;
constexpr vtkIdType MaxBatch = 64 * FluentFaceBatches::BlockSize;
constexpr vtkIdType MinNumberOfBatches = 40;
}

//------------------------------------------------------------------------------
int FluentFaceBatches::GetNumberOfShares()
{
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  int shares = 1;
  while (2 * shares <= std::min(threads, MaxShares))
  {
    shares *= 2;
  }
  return shares;
}

//------------------------------------------------------------------------------
// Checks the nodes of faces without cells in the piece. For other faces, the code that creates the
// cells does so.
bool FluentFaceBatches::AreNodesGood(const Face& face, bool swap) const
{
  bool good = true;
  for (std::int32_t i = 0; i < face.Size; ++i)
  {
    const auto node = Load<std::uint32_t>(face.Nodes + 4 * std::ptrdiff_t(i), swap);
    good &= node - 1 < static_cast<std::uint64_t>(this->Nodes);
  }
  return good;
}

//------------------------------------------------------------------------------
// For faces of one size in a whole mesh, whose cells are numbered as in the file.
template <int Size>
bool FluentFaceBatches::FindPlain(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const
{
  constexpr std::ptrdiff_t Stride = 4 * (Size + 2);
  const auto maxCell = static_cast<std::uint64_t>(this->Mesh.Cells.GetCount());
  const char* place = run.Data + (begin - run.Begin) * Stride;
  bool good = true;
  for (vtkIdType i = begin; i < end; ++i, ++faces, place += Stride)
  {
    faces->Nodes = place;
    faces->Size = Size;
    for (int side = 0; side < 2; ++side)
    {
      const auto cell = Load<std::uint32_t>(place + 4 * (Size + side), run.Swap);
      good &= cell <= maxCell;
      faces->Cells[side] = static_cast<std::int32_t>(cell - 1);
    }
    if (std::max(faces->Cells[0], faces->Cells[1]) < 0)
    {
      good = this->AreNodesGood(*faces, run.Swap) && good;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
// Sets the cells of a face that are in the piece.
bool FluentFaceBatches::SetCells(const std::int64_t* cells, Face& face) const
{
  bool good = true;
  if (this->IsPlain && face.Size > 0)
  {
    for (int side = 0; side < 2; ++side)
    {
      good &= static_cast<std::uint64_t>(cells[side]) <=
        static_cast<std::uint64_t>(this->Mesh.Cells.GetCount());
      face.Cells[side] = static_cast<std::int32_t>(static_cast<std::uint32_t>(cells[side]) - 1);
    }
    return good;
  }
  for (int side = 0; side < 2; ++side)
  {
    const bool isThere = cells[side] >= 0 && cells[side] <= this->Mesh.Cells.GetCount();
    good &= isThere;
    face.Cells[side] = isThere && face.Size > 0
      ? static_cast<std::int32_t>(this->Mesh.FindCell(static_cast<std::int32_t>(cells[side])))
      : -1;
  }
  return good;
}

//------------------------------------------------------------------------------
// For accessible faces.
bool FluentFaceBatches::Find(const Run& run, vtkIdType begin, vtkIdType end, Face* faces) const
{
  if (this->IsPlain)
  {
    switch (run.Size)
    {
      case 2:
        return this->FindPlain<2>(run, begin, end, faces);
      case 3:
        return this->FindPlain<3>(run, begin, end, faces);
      case 4:
        return this->FindPlain<4>(run, begin, end, faces);
      default:
        break;
    }
  }
  bool good = true;
  FluentFaces::ForEachOf(run, begin, end,
    [&](vtkIdType position, const FluentFace& record)
    {
      Face& face = faces[position - begin];
      face.Nodes = record.Nodes.Ids;
      face.Size = record.Nodes.Size;
      const std::int64_t cells[2] = { record.GetCell(0), record.GetCell(1) };
      good = this->SetCells(cells, face) && good;
      if (std::max(face.Cells[0], face.Cells[1]) < 0)
      {
        good = this->AreNodesGood(face, run.Swap) && good;
      }
    });
  return good;
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::ReadLine(
  const Run& run, const char* text, const char* end, Face& face, char* nodes) const
{
  std::int64_t size = run.Size;
  text = ParseFaceSize(text, end, size);
  if (!text)
  {
    return false;
  }
  face.Size = static_cast<std::int32_t>(size);
  face.Nodes = nodes;
  bool good = true;
  text = ParseNumbers(text, end, size,
    [&](std::int64_t i, std::int64_t value)
    {
      good &= value >= 1 && value <= this->Nodes;
      Store(nodes + 4 * i, static_cast<std::int32_t>(value), false);
      return true;
    });
  std::int64_t cells[2];
  text = ParseNumbers(text, end, 2,
    [&cells](std::int64_t side, std::int64_t value)
    {
      cells[side] = value;
      return true;
    });
  return good && text && this->SetCells(cells, face) && SkipSpaceFrom(text, end) == end;
}

//------------------------------------------------------------------------------
// Reads the next faces of text from a position, which moves past them.
bool FluentFaceBatches::ReadText(
  const TextLines& lines, const Run& run, const char*& place, vtkIdType count)
{
  const TextLines::Section section = lines.Find(place, count);
  if (!section)
  {
    return false;
  }
  const char* const begin = place;
  place = section.End;
  // A number and its separator take at least two characters, which limits the memory needed.
  const vtkIdType words = (section.End - begin) / 2 + 2;
  if (words > this->Words.size())
  {
    this->Words = Buffer<std::int32_t>(); // released before the next allocation
    this->Words = Buffer<std::int32_t>(words + words / 8);
  }
  char* const nodes = reinterpret_cast<char*>(this->Words.data());
  return lines.ForEach(section, Progress(),
    [&](vtkIdType, vtkIdType line, const char* text, const char* end)
    { return this->ReadLine(run, text, end, this->Faces[line], nodes + (text - begin) / 2 * 4); });
}

//------------------------------------------------------------------------------
bool FluentFaceBatches::ForEach(
  const Progress& progress, const std::function<bool(const Batch&)>& visit)
{
  const vtkIdType total = this->Mesh.Faces.GetCount();
  const vtkIdType batchSize =
    std::max(MinBatch, std::min(MaxBatch, total / MinNumberOfBatches / BlockSize * BlockSize));
  // Accessible faces need no memory; batches only serve to report progress.
  constexpr vtkIdType Reports = 20;
  const vtkIdType longBatch = std::max(batchSize, total / Reports / BlockSize * BlockSize);
  this->Lines.resize(this->Mesh.Faces.GetRuns().size());
  for (const Run& run : this->Mesh.Faces.GetRuns())
  {
    auto& lines = this->Lines[static_cast<std::size_t>(&run - this->Mesh.Faces.GetRuns().data())];
    const char* place = nullptr;
    const bool isStored = !run.Data && run.Section->IsStored;
    if (!run.Data && !isStored)
    {
      constexpr vtkIdType MaxChunk = vtkIdType(1) << 16; // several per batch
      place = run.Section->Begin;
      if (!lines)
      {
        lines = std::make_unique<TextLines>(
          this->File.GetLines(*run.Section, Progress(), std::min(this->Chunk, MaxChunk)));
      }
      if (this->Faces.size() == 0)
      {
        this->Faces = Buffer<Face>(std::min(total, batchSize));
      }
    }
    const vtkIdType size = lines ? batchSize
      : isStored                 ? FluentFile::GetStoredBatch(total)
                                 : longBatch;
    Batch batch;
    batch.Of = isStored ? &this->Stored : &run;
    batch.Read = lines ? this->Faces.data() : nullptr;
    batch.Swap = run.Swap;
    for (batch.Begin = run.Begin; batch.Begin < run.End; batch.Begin = batch.End)
    {
      batch.End = std::min(batch.Begin + size, run.End);
      if ((isStored && !FluentFaces::Load(this->File, run, batch.Begin, batch.End, this->Stored)) ||
        (lines && !this->ReadText(*lines, run, place, batch.End - batch.Begin)) ||
        (run.Bounds && !visit(batch)) ||
        !progress.Report(static_cast<double>(batch.End) / static_cast<double>(total)))
      {
        return false;
      }
    }
    if (lines && SkipSpaceFrom(place, run.Section->End) != run.Section->End)
    {
      return false;
    }
  }
  return true;
}
}
