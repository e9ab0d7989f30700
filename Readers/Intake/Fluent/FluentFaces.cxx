// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Fluent/FluentFaces.h"

#include "Intake/Fluent/FluentText.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <numeric>
#include <utility>

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
  this->Nodes = nodes;
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
    if (run.IsInFile())
    {
      run.Data = section->Begin;
      run.DataEnd = section->End;
      run.Swap = file.IsSwapped();
      run.Blocks = section->Blocks;
    }
    this->Runs.push_back(std::move(run));
    this->Lines.push_back(file.FindLines(*section, Progress()));
  }
  this->Words.resize(this->Runs.size());
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
void FluentFaces::FailAt(
  const char* place, std::int64_t face, bool isNode, std::int64_t found) const
{
  this->File->FailAt(place, ErrorKind::Index,
    std::string(isNode ? "a node" : "a cell") + " of face " + std::to_string(face) + " from " +
      (isNode ? "1 to " : "0 to ") + std::to_string(isNode ? this->Nodes : this->Cells),
    std::to_string(found));
}

//------------------------------------------------------------------------------
// Reads faces of text, one per line, in parallel; -1 without an error for other layouts and errors.
std::int64_t FluentFaces::ReadLines(const Run& run, const TextLines& lines,
  const TextLines::Section& section, Buffer<std::int32_t>& words, const Progress& progress) const
{
  const bool isList = run.Size == 0;
  // The begins of the words of every piece of the text, and the end.
  std::vector<std::int64_t> places(
    static_cast<std::size_t>(lines.GetNumberOfPieces(section)) + 1, 0);
  // First the number of nodes of every face, to allocate exactly the memory needed.
  if (isList &&
    !lines.ForEach(section, progress.Part(0, 0.2),
      [&](vtkIdType piece, vtkIdType, const char* text, const char* end)
      {
        std::int64_t size = 0;
        const bool isRead = ParseFaceSize(text, end, size) != nullptr;
        places[piece + 1] += 3 + size;
        return isRead;
      }))
  {
    return -1;
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  const std::vector<std::int64_t> ends(places.begin() + 1, places.end());
  const std::int64_t total =
    isList ? places.back() : section.NumberOfLines * (vtkIdType(run.Size) + 2);
  words = words.size() < total ? Buffer<std::int32_t>(total) : std::move(words);
  const bool good = lines.ForEach(section, progress.Part(0.2, 1),
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
    {
      std::int64_t size = run.Size;
      std::int32_t* word = words.data() + (isList ? places[piece] : (size + 2) * line);
      text = ParseFaceSize(text, end, size);
      if (!text || (isList && size > ends[piece] - places[piece] - 3))
      {
        return false; // the file has changed
      }
      if (isList)
      {
        *word++ = static_cast<std::int32_t>(size);
        places[piece] += size + 3;
      }
      text = ParseNumbers(text, end, size + 2,
        [&](std::int64_t i, std::int64_t value)
        {
          word[i] = static_cast<std::int32_t>(value);
          return this->IsId(value, i < size);
        });
      return text && SkipSpaceFrom(text, end) == end;
    });
  return good ? total : -1;
}

//------------------------------------------------------------------------------
// Reads faces of text in any layout.
std::int64_t FluentFaces::ReadWords(const Run& run, vtkIdType begin, vtkIdType end,
  const char*& place, Buffer<std::int32_t>& words) const
{
  const char* const textEnd = run.Section->End;
  const bool isList = run.Size == 0;
  std::vector<std::int32_t> found;
  found.reserve(static_cast<std::size_t>((isList ? 3 : run.Size + 2) * (end - begin)));
  std::int64_t face = run.FirstId + begin;
  const auto read = [&](std::int64_t limit, const char* what)
  {
    std::int64_t value = 0;
    place = SkipSpaceFrom(place, textEnd);
    const char* const next = ParseHex(place, textEnd, value);
    if (!next || value > limit)
    {
      this->File->FailAt(place,
        next                 ? ErrorKind::Index
          : place == textEnd ? ErrorKind::Truncated
                             : ErrorKind::Syntax,
        std::string(what) + " of face " + std::to_string(face) + ", a hexadecimal number" +
          (next ? " up to " + std::to_string(limit) : ""));
      return std::int64_t(-1);
    }
    found.push_back(static_cast<std::int32_t>(value));
    place = next;
    return value;
  };
  for (; face < run.FirstId + end; ++face)
  {
    std::int64_t size = run.Size;
    if (isList && (size = read((textEnd - place) / 2, "the number of nodes")) < 0)
    {
      return -1;
    }
    for (std::int64_t i = 0; i < size + 2; ++i)
    {
      const bool isNode = i < size;
      const char* const before = place;
      const std::int64_t value = read(INT32_MAX, isNode ? "a node" : "a cell");
      if (value >= 0 && !this->IsId(value, isNode))
      {
        this->FailAt(SkipSpaceFrom(before, textEnd), face, isNode, value);
      }
      if (this->File->HasFailed())
      {
        return -1;
      }
    }
  }
  words = Buffer<std::int32_t>(static_cast<vtkIdType>(found.size()));
  std::copy(found.begin(), found.end(), words.data());
  return words.size();
}

//------------------------------------------------------------------------------
std::int64_t FluentFaces::Load(const Run& run, vtkIdType begin, vtkIdType end, const char*& place,
  Buffer<std::int32_t>& words, const Progress& progress) const
{
  if (run.Section->IsStored)
  {
    return this->File->LoadStored(*run.Section, begin, end - begin, words) ? words.size() : -1;
  }
  const TextLines* const lines =
    this->Lines[static_cast<std::size_t>(&run - this->Runs.data())].get();
  const TextLines::Section section = lines ? lines->Find(place, end - begin) : TextLines::Section();
  std::int64_t size = section ? this->ReadLines(run, *lines, section, words, progress) : -1;
  place = size >= 0 ? section.End : place;
  size = size < 0 && !progress.IsStopped() ? this->ReadWords(run, begin, end, place, words) : size;
  if (size >= 0 && end == run.End - run.Begin)
  {
    place = SkipSpaceFrom(place, run.Section->End);
    if (place != run.Section->End)
    {
      this->File->FailAt(
        place, ErrorKind::Count, "the end of the section after " + std::to_string(end) + " faces");
      return -1;
    }
  }
  return size;
}

//------------------------------------------------------------------------------
// Makes faces in the form of a binary file accessible; false if these are other ones.
bool FluentFaces::SetWords(const std::int32_t* words, std::int64_t size, Run& run)
{
  const vtkIdType count = run.End - run.Begin;
  run.Data = reinterpret_cast<const char*>(words);
  run.DataEnd = run.Data + 4 * size;
  run.Blocks.clear();
  if (run.Size > 0)
  {
    return 4 * size == count * GetStride(run.Size);
  }
  const char* place = run.Data;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (i % BlockSize == 0)
    {
      run.Blocks.push_back(place);
    }
    const std::int32_t own =
      run.DataEnd - place >= 4 ? camaron::Load<std::int32_t>(place, false) : -1;
    if (own < 0 || run.DataEnd - place < GetStride(own) + 4)
    {
      return false;
    }
    place += GetStride(own) + 4;
  }
  return true;
}

//------------------------------------------------------------------------------
bool FluentFaces::Keep(bool boundariesOnly, const Progress& progress)
{
  for (std::size_t i = 0; i < this->Runs.size(); ++i)
  {
    Run& run = this->Runs[i];
    if (run.Data || (boundariesOnly && !run.IsOfBoundary()))
    {
      continue;
    }
    const char* place = run.Section->Begin;
    const std::int64_t size = this->Load(run, 0, run.End - run.Begin, place, this->Words[i],
      this->GetPart(progress, run.Begin, run.End));
    if (size < 0 || !SetWords(this->Words[i].data(), size, run))
    {
      return false;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
void FluentFaces::KeepBoundariesOnly()
{
  for (std::size_t i = 0; i < this->Runs.size(); ++i)
  {
    if (this->Words[i].size() > 0 && !this->Runs[i].IsOfBoundary())
    {
      this->Runs[i].Data = nullptr;
      this->Runs[i].Blocks.clear();
      this->Words[i] = Buffer<std::int32_t>();
    }
  }
}

//------------------------------------------------------------------------------
bool FluentFaces::ForEachBatch(const Progress& progress, bool inOrder, VisitBatch visit) const
{
  vtkIdType done = 0;
  const auto visitNext = [&](const Run& batch)
  {
    const vtkIdType before = std::exchange(done, done + (batch.End - batch.Begin));
    return visit(batch, this->GetPart(progress, before, done));
  };
  PieceExchange none(nullptr);
  for (const Run& run : this->Runs)
  {
    if (run.Data)
    {
      if (!visitNext(run))
      {
        return false;
      }
      continue;
    }
    const bool isShared = run.Section->IsStored && !inOrder && this->File->Exchange;
    PieceExchange& exchange = isShared ? *this->File->Exchange : none;
    Run batch = run;
    const char* place = run.Section->Begin;
    if (!exchange.ForBatches<std::int32_t>(
          run.Begin, run.End - run.Begin, FluentFile::GetStoredBatch(this->GetCount()),
          [&](std::int64_t begin, std::int64_t end, Buffer<std::int32_t>& words)
          { return this->Load(run, begin, end, place, words, Progress()); },
          [&](std::int64_t begin, std::int64_t end, const std::int32_t* words, std::int64_t size)
          {
            batch.Begin = run.Begin + begin;
            batch.End = run.Begin + end;
            batch.FirstId = run.FirstId + begin;
            if (!SetWords(words, size, batch))
            {
              this->File->Fail(
                ErrorKind::Changed, "the same file in all processes", "other faces in some");
              return false;
            }
            return visitNext(batch);
          }))
    {
      return false;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool FluentFaces::Check(const Progress& progress) const
{
  for (const Run& run : this->Runs)
  {
    std::atomic<vtkIdType> bad{ run.End };
    // Notes an invalid face, or says what is wrong with the first one.
    const auto check = [&](vtkIdType position, const FluentFace& face, bool says)
    {
      const std::int32_t size = face.Nodes.Size;
      bool good = this->IsId(face.GetCell(0), false) && this->IsId(face.GetCell(1), false);
      for (std::int32_t i = 0; i < size; ++i)
      {
        good &= this->IsId(face.Nodes[i], true);
      }
      if (!good)
      {
        LowerTo(bad, position);
      }
      for (std::int32_t i = 0; !good && says && position == bad && i < size + 2; ++i)
      {
        if (!this->IsId(face.Nodes[i], i < size))
        {
          this->FailAt(face.Nodes.Ids + 4 * std::ptrdiff_t(i), run.FirstId + position - run.Begin,
            i < size, face.Nodes[i]);
        }
      }
    };
    const auto checkAll = [&](vtkIdType begin, vtkIdType end, bool says)
    {
      ForEachOf(run, begin, end,
        [&](vtkIdType position, const FluentFace& face) { check(position, face, says); });
    };
    const vtkIdType count = run.IsInFile() ? run.End - run.Begin : 0;
    if (!this->GetPart(progress, run.Begin, run.End)
          .ForBlocks(count, BlockSize, [&](vtkIdType first, vtkIdType last)
            { checkAll(run.Begin + first, run.Begin + last, false); }))
    {
      return false;
    }
    if (bad < run.End)
    {
      checkAll(bad - (bad - run.Begin) % BlockSize, bad + 1, true);
      return false;
    }
  }
  return true;
}
}
