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

//------------------------------------------------------------------------------
std::string DescribeFace(const FluentFaces::Run& run, std::int64_t row)
{
  return "face " + std::to_string(run.FirstId + row);
}
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
bool FluentFaces::AddRuns(FluentFile& file)
{
  std::int64_t lastId = 0;
  vtkIdType position = 0;
  for (const FluentSection* section : FluentFile::SortById(file.Faces))
  {
    const std::int64_t element = section->GetElement();
    if (!file.CheckIds(*section, lastId, file.DeclaredFaces, "faces"))
    {
      return false;
    }
    if (element > FluentSection::Polygons || element == 1)
    {
      file.FailAt(section->Place, ErrorKind::Syntax, "a face type of 0, 2, 3, 4 or 5",
        std::to_string(element));
      return false;
    }
    if (!section->HasBody())
    {
      file.FailAt(section->Place, ErrorKind::Truncated,
        std::to_string(section->GetCount()) + " faces in parentheses", "none");
      return false;
    }
    lastId = section->Header[2];
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
    if (section->IsText() && !this->CheckSize(file, run))
    {
      return false;
    }
    if (section->Begin && !section->IsText())
    {
      run.Data = section->Begin;
      run.DataEnd = section->End;
      run.Swap = file.IsSwapped();
      run.Blocks = section->Blocks;
    }
    this->Runs.push_back(std::move(run));
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the text is long enough for the number of faces.
bool FluentFaces::CheckSize(FluentFile& file, const Run& run) const
{
  const std::ptrdiff_t size = run.Section->End - run.Section->Begin;
  const vtkIdType count = run.End - run.Begin, numbers = run.Size == 0 ? 3 : run.Size + 2;
  if (count > (size + 1) / (2 * numbers))
  {
    file.FailAt(run.Section->Place, ErrorKind::Truncated,
      std::to_string(count) + " faces in the section that begins here",
      std::to_string(size) + " characters");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Reads faces of text, one per line, in parallel; false for other layouts and errors.
bool FluentFaces::ReadLines(
  const FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress)
{
  const FluentRows rows = file.FindRows(*run.Section, progress.Part(0, 0.1), chunk);
  if (!rows.Records)
  {
    return false;
  }
  const TextLines& lines = rows.Lines;
  std::vector<vtkIdType> first(
    static_cast<std::size_t>(lines.GetNumberOfPieces(rows.Records)) + 1, 0);
  const bool isList = run.Size == 0;
  if (isList)
  {
    // First the number of nodes of every face, to allocate exactly the memory needed.
    const bool good = lines.ForEach(rows.Records, progress.Part(0.1, 0.3),
      [&](vtkIdType piece, vtkIdType, const char* text, const char* end)
      {
        std::int64_t size = 0;
        const bool isRead = ParseFaceSize(text, end, size) != nullptr;
        first[piece + 1] += 3 + size;
        return isRead;
      });
    if (!good)
    {
      return false;
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
  }
  const vtkIdType row = run.Size + 2;
  Buffer<std::int32_t> words(isList ? first.back() : row * (run.End - run.Begin));
  const std::vector<vtkIdType> last(first.begin() + 1, first.end());
  const bool good = lines.ForEach(rows.Records, progress.Part(0.3, 1),
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
    {
      std::int64_t size = run.Size;
      std::int32_t* word = words.data() + (isList ? first[piece] : row * line);
      text = ParseFaceSize(text, end, size);
      if (!text || (isList && size > last[piece] - first[piece] - 3))
      {
        return false; // the file has changed
      }
      if (isList)
      {
        *word++ = static_cast<std::int32_t>(size);
        first[piece] += size + 3;
      }
      text = ParseNumbers(text, end, size + 2,
        [word](std::int64_t i, std::int64_t value)
        {
          word[i] = static_cast<std::int32_t>(value);
          return value <= INT32_MAX;
        });
      return text && SkipSpaceFrom(text, end) == end;
    });
  if (good)
  {
    run.Words = std::move(words);
  }
  return good;
}

//------------------------------------------------------------------------------
// Reads faces of text in any layout.
bool FluentFaces::ReadWords(FluentFile& file, Run& run)
{
  const char* text = run.Section->Begin;
  const char* const end = run.Section->End;
  const vtkIdType count = run.End - run.Begin;
  const bool isList = run.Size == 0;
  std::vector<std::int32_t> words;
  words.reserve(static_cast<std::size_t>((isList ? 3 : run.Size + 2) * count));
  const auto read = [&](std::int64_t row, std::int64_t limit, const char* what)
  {
    std::int64_t value = 0;
    const char* const place = SkipSpaceFrom(text, end);
    text = ParseHex(place, end, value);
    if (!text || value > limit)
    {
      file.FailAt(place,
        text             ? ErrorKind::Index
          : place == end ? ErrorKind::Truncated
                         : ErrorKind::Syntax,
        std::string(what) + " of " + DescribeFace(run, row) + ", a hexadecimal number" +
          (text ? " up to " + std::to_string(limit) : ""));
      return std::int64_t(-1);
    }
    words.push_back(static_cast<std::int32_t>(value));
    return value;
  };
  for (vtkIdType row = 0; row < count; ++row)
  {
    std::int64_t size = run.Size;
    if (isList && (size = read(row, (end - text) / 2, "the number of nodes")) < 0)
    {
      return false;
    }
    for (std::int64_t i = 0; i < size + 2; ++i)
    {
      if (read(row, INT32_MAX, i < size ? "a node" : "a cell") < 0)
      {
        return false;
      }
    }
  }
  text = SkipSpaceFrom(text, end);
  if (text != end)
  {
    file.FailAt(
      text, ErrorKind::Count, "the end of the section after " + std::to_string(count) + " faces");
    return false;
  }
  run.Words = Buffer<std::int32_t>(static_cast<vtkIdType>(words.size()));
  std::copy(words.begin(), words.end(), run.Words.data());
  return true;
}

//------------------------------------------------------------------------------
bool FluentFaces::ReadText(FluentFile& file, Run& run, vtkIdType chunk, const Progress& progress)
{
  const bool isLarge = run.Section->End - run.Section->Begin >= 2 * chunk;
  if (!(isLarge && this->ReadLines(file, run, chunk, progress)) &&
    (progress.IsStopped() || !this->ReadWords(file, run)))
  {
    return false;
  }
  return SetWords(run.Words.data(), run.Words.size(), run);
}

//------------------------------------------------------------------------------
// Makes faces in the form of a binary file accessible; false if these are other ones.
bool FluentFaces::SetWords(const std::int32_t* words, vtkIdType size, Run& run)
{
  run.Data = reinterpret_cast<const char*>(words);
  run.DataEnd = run.Data + 4 * size;
  run.Blocks.clear();
  return run.Size > 0 ? run.DataEnd - run.Data == (run.End - run.Begin) * GetStride(run.Size)
                      : FindBlocks(run);
}

//------------------------------------------------------------------------------
bool FluentFaces::Load(FluentFile& file, const Run& run, vtkIdType begin, vtkIdType end, Run& part)
{
  part.Begin = begin;
  part.End = end;
  part.FirstId = run.FirstId + (begin - run.Begin);
  part.Zone = run.Zone;
  part.BoundaryType = run.BoundaryType;
  part.Size = run.Size;
  part.Bounds = run.Bounds;
  part.Section = run.Section;
  return file.LoadStored(*run.Section, begin - run.Begin, end - begin, part.Words) &&
    SetWords(part.Words.data(), part.Words.size(), part);
}

//------------------------------------------------------------------------------
bool FluentFaces::ForEachPart(const Run& run, FunctionRef<bool(const Run&)> visit) const
{
  PieceExchange none(nullptr);
  PieceExchange& exchange = run.Source->Exchange ? *run.Source->Exchange : none;
  Run part;
  return exchange.ForBatches<std::int32_t>(
    run.Begin, run.End - run.Begin, FluentFile::GetStoredBatch(this->GetCount()),
    [&](std::int64_t begin, std::int64_t end, Buffer<std::int32_t>& words) -> std::int64_t
    {
      const bool good = run.Source->LoadStored(*run.Section, begin, end - begin, words);
      return good ? words.size() : -1;
    },
    [&](std::int64_t begin, std::int64_t end, const std::int32_t* words, std::int64_t size)
    {
      part.Begin = run.Begin + begin;
      part.End = run.Begin + end;
      part.Size = run.Size;
      const bool areSame = SetWords(words, size, part);
      if (!areSame)
      {
        run.Source->Fail(
          ErrorKind::Changed, "the same file in all processes", "other faces in some");
      }
      return areSame && visit(part);
    });
}

//------------------------------------------------------------------------------
bool FluentFaces::FindBlocks(Run& run)
{
  const char* place = run.Data;
  for (vtkIdType i = 0; i < run.End - run.Begin; ++i)
  {
    if (i % BlockSize == 0)
    {
      run.Blocks.push_back(place);
    }
    const std::int32_t size =
      run.DataEnd - place >= 4 ? camaron::Load<std::int32_t>(place, false) : -1;
    if (size < 0 || run.DataEnd - place < GetStride(size) + 4)
    {
      return false;
    }
    place += GetStride(size) + 4;
  }
  return true;
}

//------------------------------------------------------------------------------
// Faces at non-conformal interfaces lie on others, which are the faces of the cells.
void FluentFaces::LeaveOutInterfaces(FluentFile& file)
{
  constexpr int InterfaceParents = 61;
  std::vector<std::int64_t> changes(this->Runs.size() + 1, 0); // of the number of sections per run
  for (const FluentSection& section : file.InterfaceFaces)
  {
    if (section.Index != InterfaceParents || section.HeaderSize < 2)
    {
      continue;
    }
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
bool FluentFaces::Open(FluentFile& file)
{
  if (!this->AddRuns(file))
  {
    return false;
  }
  std::vector<vtkIdType> ends;
  for (const Run& run : this->Runs)
  {
    const auto index = static_cast<std::uint32_t>(ends.size());
    for (vtkIdType begin = run.Begin; begin < run.End; begin += BlockSize)
    {
      this->Parts.push_back({ index, begin, std::min(begin + BlockSize, run.End) });
    }
    ends.push_back(run.End);
  }
  this->Finder.Build(std::move(ends));
  this->LeaveOutInterfaces(file);
  return true;
}

//------------------------------------------------------------------------------
bool FluentFaces::Keep(
  FluentFile& file, bool boundariesOnly, vtkIdType chunk, const Progress& progress)
{
  for (Run& run : this->Runs)
  {
    const auto count = static_cast<double>(this->GetCount());
    const Progress part =
      progress.Part(static_cast<double>(run.Begin) / count, static_cast<double>(run.End) / count);
    if (!run.Data && (!boundariesOnly || run.IsOfBoundary()) &&
      !(run.Section->IsStored ? Load(file, run, run.Begin, run.End, run)
                              : this->ReadText(file, run, chunk, part)))
    {
      return false;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool FluentFaces::Stream(FluentFile& file, std::int64_t nodes, std::int64_t cells, vtkIdType chunk,
  const Progress& progress)
{
  this->Nodes = nodes;
  this->Cells = cells;
  for (Run& run : this->Runs)
  {
    if (run.Data)
    {
      continue;
    }
    if (run.Section->IsStored)
    {
      run.Source = &file;
      continue;
    }
    run.Rows = std::make_unique<FluentRows>(file.FindRows(*run.Section, progress, chunk));
    if (!run.Rows->Records)
    {
      return false;
    }
  }
  return !progress.IsStopped();
}

//------------------------------------------------------------------------------
void FluentFaces::StopStreaming()
{
  for (Run& run : this->Runs)
  {
    run.Rows.reset();
    run.Source = nullptr;
  }
}

//------------------------------------------------------------------------------
// Reads a face on a line of its own; false if a number is missing, invalid or left over.
bool FluentFaces::ReadLine(
  const Run& run, const char* text, const char* end, std::vector<std::int32_t>& numbers) const
{
  std::int64_t size = run.Size;
  text = ParseFaceSize(text, end, size);
  if (!text)
  {
    return false;
  }
  numbers.resize(static_cast<std::size_t>(size) + 2);
  text = ParseNumbers(text, end, size + 2,
    [&](std::int64_t i, std::int64_t value)
    {
      numbers[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(value);
      return i < size ? value >= 1 && value <= this->Nodes : value <= this->Cells;
    });
  return text && SkipSpaceFrom(text, end) == end;
}

//------------------------------------------------------------------------------
void FluentFaces::KeepBoundariesOnly()
{
  for (Run& run : this->Runs)
  {
    run.Rows.reset();
    run.Source = nullptr;
    if (run.Words.size() > 0 && !run.IsOfBoundary())
    {
      run.Data = nullptr;
      run.Words = Buffer<std::int32_t>();
      run.Blocks.clear();
    }
  }
}

//------------------------------------------------------------------------------
// Position in the file of a number of a face.
const char* FluentFaces::FindInFile(const Run& run, const char* word) const
{
  if (!run.Section->IsText())
  {
    return word;
  }
  const char* text = run.Section->Begin;
  for (std::ptrdiff_t left = (word - run.Data) / 4; left > 0; --left)
  {
    std::int64_t value = 0;
    const char* const next = ParseHex(text, run.Section->End, value);
    text = next ? next : text;
  }
  return SkipSpaceFrom(text, run.Section->End);
}

//------------------------------------------------------------------------------
bool FluentFaces::Check(
  FluentFile& file, std::int64_t nodes, std::int64_t cells, const Progress& progress) const
{
  std::atomic<vtkIdType> bad{ this->GetCount() };
  const auto isGood = [=](const FluentFace& face)
  {
    bool good = true;
    for (std::int32_t i = 0; i < face.Nodes.Size; ++i)
    {
      good &= static_cast<std::uint32_t>(face.Nodes[i]) - 1 < static_cast<std::uint64_t>(nodes);
    }
    for (int side = 0; side < 2; ++side)
    {
      good &= static_cast<std::uint32_t>(face.GetCell(side)) <= static_cast<std::uint64_t>(cells);
    }
    return good;
  };
  const bool finished = this->ForEach(progress,
    [&](const Run&, vtkIdType position, const FluentFace& face)
    {
      if (!isGood(face))
      {
        LowerTo(bad, position);
      }
    });
  if (bad == this->GetCount())
  {
    return finished;
  }
  const Run& run = this->GetRun(bad);
  FluentFace face;
  ForEachOf(run, bad - (bad - run.Begin) % BlockSize, bad + 1,
    [&face](vtkIdType, const FluentFace& found) { face = found; });
  for (std::int32_t i = 0; i < face.Nodes.Size + 2; ++i)
  {
    const bool isNode = i < face.Nodes.Size;
    const std::int64_t first = isNode ? 1 : 0, last = isNode ? nodes : cells;
    if (face.Nodes[i] < first || face.Nodes[i] > last)
    {
      file.FailAt(this->FindInFile(run, face.Nodes.Ids + 4 * std::ptrdiff_t(i)), ErrorKind::Index,
        std::string(isNode ? "a node" : "a cell") + " of " + DescribeFace(run, bad - run.Begin) +
          " from " + std::to_string(first) + " to " + std::to_string(last),
        std::to_string(face.Nodes[i]));
      break;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkIdType FluentFaces::FindId(std::int64_t id) const
{
  const auto next = std::upper_bound(this->Runs.begin(), this->Runs.end(), id,
    [](std::int64_t value, const Run& run) { return value < run.FirstId; });
  if (next == this->Runs.begin())
  {
    return -1;
  }
  const Run& run = *(next - 1);
  const vtkIdType face = run.Begin + (id - run.FirstId);
  return face < run.End ? face : -1;
}
}
