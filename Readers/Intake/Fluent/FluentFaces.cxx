// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFaces.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <iterator>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Boundary types by their numbers; the first name of a number is the usual one.
constexpr std::pair<const char*, int> BoundaryTypes[] = { { "interior", FluentBoundary::Interior },
  { "wall", 3 }, { "pressure-inlet", 4 }, { "inlet-vent", 4 }, { "intake-fan", 4 },
  { "pressure-outlet", 5 }, { "exhaust-fan", 5 }, { "outlet-vent", 5 }, { "symmetry", 7 },
  { "shadow", 8 }, { "pressure-far-field", 9 }, { "velocity-inlet", 10 }, { "periodic", 12 },
  { "porous-jump", 14 }, { "fan", 14 }, { "radiator", 14 }, { "mass-flow-inlet", 20 },
  { "interface", 24 }, { "overset", 25 }, { "outflow", 36 }, { "axis", 37 } };
}

//------------------------------------------------------------------------------
std::string GetFluentBoundaryName(int type)
{
  const auto* const known = std::find_if(std::begin(BoundaryTypes), std::end(BoundaryTypes),
    [type](const auto& named) { return named.second == type; });
  return known != std::end(BoundaryTypes) ? known->first : "";
}

//------------------------------------------------------------------------------
int GetFluentBoundaryType(const std::string& name)
{
  const auto* const known = std::find_if(std::begin(BoundaryTypes), std::end(BoundaryTypes),
    [&name](const auto& named) { return named.first == name; });
  return known != std::end(BoundaryTypes) ? known->second : 0;
}

//------------------------------------------------------------------------------
std::string GetFluentZoneType(int boundaryType)
{
  const int type = boundaryType % FluentBoundary::Nonconformal;
  const std::string name =
    type == FluentBoundary::Parent ? "parent-face" : GetFluentBoundaryName(type);
  return name.empty() ? "unknown" : name;
}

//------------------------------------------------------------------------------
bool FluentFaces::CheckSection(const FluentSection& section, std::int64_t lastId)
{
  FluentFile& file = *this->File;
  const std::int64_t element = section.GetElement(), count = section.GetCount();
  if (!file.CheckIds(section, lastId, file.DeclaredFaces, "faces"))
  {
    return false;
  }
  if (element > FluentSection::Polygons || element == 1)
  {
    file.FailAt(
      section.Place, ErrorKind::Syntax, "a face type of 0, 2, 3, 4 or 5", std::to_string(element));
    return false;
  }
  if (!section.HasBody())
  {
    file.FailAt(
      section.Place, ErrorKind::Truncated, std::to_string(count) + " faces in parentheses", "none");
    return false;
  }
  // Whether a text is long enough for the number of faces.
  const std::ptrdiff_t bytes = section.End - section.Begin;
  const std::int64_t numbers = element == 0 || element == FluentSection::Polygons ? 3 : element + 2;
  if (section.IsText() && count > (bytes + 1) / (2 * numbers))
  {
    file.FailAt(section.Place, ErrorKind::Truncated,
      std::to_string(count) + " faces in the section that begins here",
      std::to_string(bytes) + " characters");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentFaces::Open(FluentFile& file, std::int64_t nodes)
{
  this->File = &file;
  this->Nodes = static_cast<std::uint32_t>(nodes);
  std::int64_t lastId = 0;
  vtkIdType position = 0;
  for (const FluentSection* section : FluentFile::SortById(file.Faces))
  {
    if (!this->CheckSection(*section, lastId))
    {
      return false;
    }
    lastId = section->Header[2];
    const std::int64_t element = section->GetElement();
    Run run;
    run.Section = section;
    run.FirstId = section->Header[1];
    run.Begin = position;
    run.End = position += section->GetCount();
    run.Zone = static_cast<int>(section->Header[0]);
    run.BoundaryType = static_cast<int>(section->Header[3]);
    run.Size = element == FluentSection::Polygons ? 0 : static_cast<std::int32_t>(element);
    run.Bounds =
      run.BoundaryType != FluentBoundary::Parent && run.BoundaryType < FluentBoundary::Nonconformal;
    this->Runs.push_back(std::move(run));
  }
  this->LeaveOutInterfaces();
  return true;
}

//------------------------------------------------------------------------------
vtkIdType FluentFaces::FindId(std::int64_t id) const
{
  const auto next = std::upper_bound(this->Runs.begin(), this->Runs.end(), id,
    [](std::int64_t value, const Run& run) { return value < run.FirstId; });
  const vtkIdType face =
    next == this->Runs.begin() ? -1 : (next - 1)->Begin + id - (next - 1)->FirstId;
  return next != this->Runs.begin() && face < (next - 1)->End ? face : -1;
}

//------------------------------------------------------------------------------
// Faces at non-conformal interfaces lie on others, which are the faces of the cells.
void FluentFaces::LeaveOutInterfaces()
{
  std::vector<std::int64_t> changes(this->Runs.size() + 1, 0); // of the number of sections per run
  for (const FluentSection& section : this->File->InterfaceFaces)
  {
    const auto first = std::lower_bound(this->Runs.begin(), this->Runs.end(), section.Header[0],
      [](const Run& run, std::int64_t id) { return run.FirstId < id; });
    const auto last = std::upper_bound(first, this->Runs.end(), section.Header[1],
      [](std::int64_t id, const Run& run) { return id < run.FirstId + (run.End - run.Begin) - 1; });
    ++changes[static_cast<std::size_t>(first - this->Runs.begin())];
    --changes[static_cast<std::size_t>(last - this->Runs.begin())];
  }
  std::int64_t sections = 0;
  for (std::size_t run = 0; run < this->Runs.size(); ++run)
  {
    sections += changes[run];
    this->Runs[run].Bounds = this->Runs[run].Bounds && sections == 0;
  }
}

//------------------------------------------------------------------------------
// Makes the faces of a batch accessible with which words in the form of a binary file begin, and
// ends it behind the last complete one. Returns the number of their words.
std::int64_t FluentFaces::SetWords(const Word* words, std::int64_t size, Run& batch)
{
  const vtkIdType most = batch.End - batch.Begin;
  std::int64_t used = 0;
  vtkIdType faces = batch.Size > 0 ? std::min<vtkIdType>(most, size / (batch.Size + 2)) : 0;
  batch.Words = words;
  batch.Blocks.clear();
  for (; batch.Size == 0 && faces < most && used < size; ++faces)
  {
    const std::int32_t own = words[used];
    if (own < 0 || own > size - used - 3)
    {
      break;
    }
    if (faces % BlockSize == 0)
    {
      batch.Blocks.push_back(words + used);
    }
    used += own + 3;
  }
  batch.End = batch.Begin + faces;
  return batch.Size > 0 ? faces * (batch.Size + 2) : used;
}

//------------------------------------------------------------------------------
bool FluentFaces::ForBatchesInFile(const Run& run, FunctionRef<bool(const Run&)> visit) const
{
  FluentNumbers<std::int32_t> numbers(*this->File, *run.Section);
  const std::ptrdiff_t most = numbers.GetBatch();
  std::atomic<bool> hasBadIds{ false };
  Run batch = run;
  batch.Of = this;
  batch.HasBadIds = &hasBadIds;
  for (batch.End = run.Begin; batch.End < run.End;)
  {
    batch.Begin = batch.End;
    batch.FirstId = run.FirstId + batch.Begin - run.Begin;
    std::int64_t used = 0;
    for (std::ptrdiff_t bytes = most;; bytes *= 2) // until there is a complete face
    {
      numbers.Read(bytes, run.Size > 0); // sizes must not change
      batch.End = run.End;
      used = SetWords(numbers.GetData(), numbers.GetCount(), batch);
      if (used > 0 || !numbers.HasMore())
      {
        break;
      }
    }
    if (used == 0)
    {
      this->FailInFace(numbers, batch);
      return false;
    }
    const bool good = visit(batch);
    if (hasBadIds)
    {
      this->FailAtBadId(batch, numbers);
    }
    if (hasBadIds || !good)
    {
      return false;
    }
    numbers.Skip(used);
  }
  const char* const place = numbers.Find(0);
  if (place != numbers.GetEnd())
  {
    this->File->FailAt(place, ErrorKind::Count,
      "the end of the section after " + std::to_string(run.End - run.Begin) + " faces");
  }
  return place == numbers.GetEnd();
}

//------------------------------------------------------------------------------
// The error of a section in which the next face is incomplete.
void FluentFaces::FailInFace(const FluentNumbers<std::int32_t>& numbers, const Run& batch) const
{
  const char* const end = numbers.GetEnd();
  const std::int64_t mostNodes = (end - numbers.GetBegin()) / 2;
  const int isList = batch.Size == 0;
  const std::int64_t size = isList && numbers.GetCount() > 0 ? numbers.GetData()[0] : batch.Size;
  const std::int64_t word = size > mostNodes ? 0 : numbers.GetCount(); // of the face
  const bool isSize = isList && word == 0;
  const char* const place = numbers.Find(word);
  std::int64_t value = 0;
  const bool isLarge = ParseHex(place, end, value) != nullptr;
  this->File->FailAt(place,
    isLarge          ? ErrorKind::Index
      : place == end ? ErrorKind::Truncated
                     : ErrorKind::Syntax,
    std::string(isSize         ? "the number of nodes"
        : word < size + isList ? "a node"
                               : "a cell") +
      " of face " + std::to_string(batch.FirstId) + ", a hexadecimal number" +
      (isLarge ? " up to " + std::to_string(isSize ? mostNodes : INT32_MAX) : ""));
}

//------------------------------------------------------------------------------
bool FluentFaces::ForBatchesOf(
  const Run& run, bool inOrder, const Progress& progress, VisitBatch visit) const
{
  double done = 0;
  const auto visitPart = [&](const Run& batch)
  {
    const double before = done;
    done += static_cast<double>(batch.End - batch.Begin) / static_cast<double>(run.End - run.Begin);
    return visit(batch, progress.Part(before, done));
  };
  if (!run.Section->IsStored)
  {
    return this->ForBatchesInFile(run, visitPart) && !progress.IsStopped();
  }
  PieceExchange none(nullptr);
  PieceExchange& exchange = inOrder || !this->File->Exchange ? none : *this->File->Exchange;
  return exchange.ForBatches<std::int32_t>(
           run.Begin, run.End - run.Begin, FluentFile::GetStoredBatch(this->GetCount()),
           [&](std::int64_t begin, std::int64_t end, Buffer<std::int32_t>& words)
           {
             this->File->LoadStored(*run.Section, begin, end - begin, words);
             return words.size();
           },
           [&](std::int64_t begin, std::int64_t end, const std::int32_t* words, std::int64_t size)
           {
             Run batch = run;
             batch.Begin = run.Begin + begin;
             batch.End = run.Begin + end;
             batch.FirstId = run.FirstId + begin;
             std::atomic<bool> hasBadIds{ false };
             batch.Of = this;
             batch.HasBadIds = &hasBadIds;
             const auto* const all = reinterpret_cast<const Word*>(words);
             if (SetWords(all, size, batch) != size || batch.End != run.Begin + end)
             {
               this->File->Fail(
                 ErrorKind::Changed, "the same file in all processes", "other faces in some");
               return false;
             }
             const bool good = visitPart(batch);
             if (hasBadIds)
             {
               this->File->Fail(
                 ErrorKind::Changed, "the same faces in all passes", "different ones");
             }
             return good && !hasBadIds;
           }) &&
    !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool FluentFaces::ForEachBatch(const Progress& progress, bool inOrder, VisitBatch visit) const
{
  return std::all_of(this->Runs.begin(), this->Runs.end(), [&](const Run& run)
    { return this->ForBatchesOf(run, inOrder, this->GetPart(progress, run), visit); });
}

//------------------------------------------------------------------------------
// The error of the first id out of range in a batch, which has the first of the numbers.
void FluentFaces::FailAtBadId(const Run& batch, const FluentNumbers<std::int32_t>& numbers) const
{
  const Word* word = batch.Words;
  for (vtkIdType face = 0; face < batch.End - batch.Begin; ++face)
  {
    const std::int32_t size = batch.Size > 0 ? batch.Size : std::int32_t(*word++);
    for (std::int32_t i = 0; i < size + 2; ++i, ++word)
    {
      const bool isNode = i < size;
      if (!this->IsId(*word, isNode))
      {
        this->File->FailAt(numbers.Find(word - batch.Words), ErrorKind::Index,
          std::string(isNode ? "a node" : "a cell") + " of face " +
            std::to_string(batch.FirstId + face) + " from " + (isNode ? "1 to " : "0 to ") +
            std::to_string(isNode ? this->Nodes : this->Cells),
          std::to_string(*word));
        return;
      }
    }
  }
  this->File->Fail(ErrorKind::Changed, "the same faces in all passes", "different ones");
}
}
