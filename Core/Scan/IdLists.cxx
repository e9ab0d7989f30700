// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/IdLists.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::string Describe(const IdLists::Expectation& expected, vtkIdType list)
{
  return std::string(expected.List) + " " + std::to_string(list);
}

//------------------------------------------------------------------------------
std::string DescribeRange(const IdLists::Expectation& expected)
{
  return expected.Limit > 0 ? std::string("a ") + expected.Id + " id from 0 to " +
      std::to_string(expected.Limit - 1)
                            : std::string("no id of a ") + expected.Id + " (there are none)";
}

//------------------------------------------------------------------------------
void Lower(std::atomic<vtkIdType>& least, vtkIdType value)
{
  vtkIdType current = least;
  while (value < current && !least.compare_exchange_weak(current, value))
  {
  }
}
}

//------------------------------------------------------------------------------
bool IdLists::Scan(
  BinaryScanner& scanner, vtkIdType count, Expectation& expected, const Progress& progress)
{
  this->Count = count;
  this->Data = scanner.GetPosition();
  this->End = this->Data + scanner.GetBytesLeft();
  this->Swap = scanner.IsSwapped();
  this->CommonSize = -1;
  this->Needed = nullptr;
  if (scanner.HasFailed() || count == 0)
  {
    return !scanner.HasFailed();
  }

  // Lists of one length need no table. Whether all have the length of the first is found out on the
  // way, and soon if not.
  Verdict verdict = Verdict::Uneven;
  if (this->GuessCommonSize(scanner))
  {
    BinaryScanner after = scanner;
    after.Skip(count * this->Stride, expected.List);
    verdict = this->Check(after, expected, progress.Part(0, 0.5));
    if (verdict != Verdict::Uneven)
    {
      scanner = after;
    }
  }
  if (verdict == Verdict::Uneven && !progress.IsStopped())
  {
    this->CommonSize = -1;
    if (!this->FindStarts(scanner, expected.List))
    {
      return false;
    }
    verdict = this->Check(scanner, expected, progress.Part(0.5, 1));
  }
  this->NumberOfIds = (scanner.GetPosition() - this->Data) / 4 - count;
  return verdict == Verdict::Good && !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Takes the length of the first list for that of all; false if they would not fit the file.
bool IdLists::GuessCommonSize(const BinaryScanner& scanner)
{
  const auto size =
    scanner.GetBytesLeft() >= 4 ? Load<std::int32_t>(this->Data, this->Swap) : -1;
  if (size < 0 || scanner.GetBytesLeft() / 4 / this->Count < vtkIdType(size) + 1)
  {
    return false;
  }
  this->CommonSize = size;
  this->Stride = 4 * (std::ptrdiff_t(size) + 1);
  return true;
}

//------------------------------------------------------------------------------
bool IdLists::FindStarts(BinaryScanner& scanner, const char* what)
{
  this->Blocks.reserve(static_cast<std::size_t>((this->Count + BlockSize - 1) / BlockSize));
  const char* place = scanner.GetPosition();
  const char* const end = place + scanner.GetBytesLeft();
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    if (i % BlockSize == 0)
    {
      this->Blocks.push_back(place);
    }
    const std::int32_t size = end - place >= 4 ? Load<std::int32_t>(place, this->Swap) : 0;
    if (end - place < 4 || size < 0 || size > (end - place - 4) / 4)
    {
      scanner.FailAt(place, size < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        std::string(what) + " " + std::to_string(i) + " of " + std::to_string(this->Count),
        size < 0 ? "a size of " + std::to_string(size)
          : size > 0
          ? "a size of " + std::to_string(size) + " but only " +
            std::to_string(end - place - 4) + " bytes up to the end of the file"
          : "the end of the file");
      return false;
    }
    place += 4 + 4 * std::ptrdiff_t(size);
    if ((place - this->Blocks.back()) / 4 > UINT32_MAX)
    {
      scanner.FailAt(place, ErrorKind::Unsupported,
        "less than 16 GB for 1024 consecutive lists", "more");
      return false;
    }
  }
  scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// Checks the lists of some blocks; returns the first bad one, or how many lists there are. Size is the
// common size of the lists if it is one of the usual ones, or 0.
template <int Size>
vtkIdType IdLists::CheckBlocks(
  vtkIdType firstBlock, vtkIdType lastBlock, Expectation& seen, bool& even)
{
  const auto limit = static_cast<std::uint32_t>(seen.Limit);
  IdSet nothing;
  IdSet::Adder used(seen.Used ? *seen.Used : nothing);
  const char* place = this->GetBlock(firstBlock);
  const char* block = place;
  const vtkIdType end = std::min(lastBlock * BlockSize, this->Count);
  for (vtkIdType i = firstBlock * BlockSize; i < end; ++i)
  {
    const IdList list = this->At(place);
    if (this->CommonSize >= 0 && Load<std::int32_t>(place, this->Swap) != this->CommonSize)
    {
      even = false;
      return this->Count;
    }
    if (this->Starts.size() > 0)
    {
      block = i % BlockSize == 0 ? place : block;
      this->Starts[i] = static_cast<std::uint32_t>((place - block) / 4);
    }
    const std::int32_t size = Size > 0 ? Size : list.Size;
    place = list.Ids + 4 * std::ptrdiff_t(size);
    if (size == 0)
    {
      seen.Empty.Add(i);
      continue;
    }
    bool valid = true;
    bool repeats = false;
    std::int32_t previous = list[size - 1];
    for (std::int32_t j = 0; j < size; ++j)
    {
      const std::int32_t id = list[j];
      valid &= static_cast<std::uint32_t>(id) < limit;
      repeats |= id == previous;
      previous = id;
    }
    if (!valid)
    {
      return i;
    }
    if (size < 3)
    {
      seen.Short.Add(i);
    }
    else if (repeats)
    {
      seen.Repeating.Add(i);
    }
    if (seen.Used)
    {
      for (std::int32_t j = 0; j < size; ++j)
      {
        used.Add(list[j]);
      }
    }
  }
  return this->Count;
}

//------------------------------------------------------------------------------
IdLists::Verdict IdLists::Check(
  BinaryScanner& scanner, Expectation& expected, const Progress& progress)
{
  this->Starts = Buffer<std::uint32_t>();
  if (this->CommonSize < 0 && expected.AccessAll)
  {
    this->Starts = Buffer<std::uint32_t>(this->Count);
  }
  std::atomic<vtkIdType> bad{ this->Count };
  std::atomic<bool> allEven{ true };
  std::mutex mutex;
  Expectation sum;
  progress.For((this->Count + BlockSize - 1) / BlockSize,
    [&](vtkIdType first, vtkIdType last)
    {
      if (!allEven)
      {
        return;
      }
      Expectation seen;
      seen.Limit = expected.Limit;
      seen.Used = expected.Used;
      bool even = true;
      const vtkIdType firstBad = this->CommonSize == 3 ? this->CheckBlocks<3>(first, last, seen, even)
        : this->CommonSize == 4 ? this->CheckBlocks<4>(first, last, seen, even)
        : this->CommonSize == 6 ? this->CheckBlocks<6>(first, last, seen, even)
                                : this->CheckBlocks<0>(first, last, seen, even);
      if (!even)
      {
        allEven = false;
      }
      Lower(bad, firstBad);
      const std::lock_guard<std::mutex> lock(mutex);
      sum.Empty.Merge(seen.Empty);
      sum.Short.Merge(seen.Short);
      sum.Repeating.Merge(seen.Repeating);
    });
  if (!allEven)
  {
    if (expected.Used)
    {
      *expected.Used = IdSet(expected.Used->GetLimit());
    }
    return Verdict::Uneven;
  }
  if (bad < this->Count)
  {
    this->FailAtList(scanner, bad, expected);
    return Verdict::Bad;
  }
  expected.Empty = sum.Empty;
  expected.Short = sum.Short;
  expected.Repeating = sum.Repeating;
  return Verdict::Good;
}

//------------------------------------------------------------------------------
void IdLists::FailAtList(
  BinaryScanner& scanner, vtkIdType bad, const Expectation& expected) const
{
  IdList list = this->At(this->GetBlock(bad / BlockSize));
  for (vtkIdType i = bad / BlockSize * BlockSize; i < bad; ++i)
  {
    list = this->At(list.Ids + 4 * std::ptrdiff_t(list.Size));
  }
  std::int32_t j = 0;
  while (j + 1 < list.Size && static_cast<std::uint32_t>(list[j]) < expected.Limit)
  {
    ++j;
  }
  scanner.FailAt(list.Ids + 4 * std::ptrdiff_t(j), ErrorKind::Index,
    DescribeRange(expected) + " in " + Describe(expected, bad),
    list.Size > 0 ? std::to_string(list[j]) : "nothing");
}

//------------------------------------------------------------------------------
bool IdLists::Scan(TextScanner& scanner, const TextLines* lines, vtkIdType count, bool dropRest,
  Expectation& expected, const Progress& progress)
{
  this->Count = count;
  this->Swap = false;
  this->CommonSize = -1;
  if (lines && !expected.AccessAll &&
    this->CheckLines(scanner, *lines, dropRest, expected, progress))
  {
    return true;
  }
  if (progress.IsStopped())
  {
    return false;
  }
  this->Lines = nullptr;
  if (!(lines && this->ScanLines(scanner, *lines, dropRest, expected, progress.Part(0, 0.8))))
  {
    if (progress.IsStopped() || !this->ScanText(scanner, dropRest, expected))
    {
      return false;
    }
  }
  // From here on the text is as good as a binary file without errors.
  const char* words = reinterpret_cast<const char*>(
    this->Words.size() > 0 ? this->Words.data() : this->GrownWords.data());
  const auto size = this->Words.size() + static_cast<vtkIdType>(this->GrownWords.size());
  BinaryScanner memory("", words, words + 4 * size, GetByteOrder());
  return this->Scan(memory, count, expected, progress.Part(0.8, 1));
}

//------------------------------------------------------------------------------
bool IdLists::ScanLines(TextScanner& scanner, const TextLines& lines, bool dropRest,
  const Expectation& expected, const Progress& progress)
{
  const TextLines::Section section = lines.Find(scanner.GetPosition(), this->Count);
  if (!section)
  {
    return false;
  }
  const char comment = scanner.GetComment();
  const auto parse = [comment](const char*& text, const char* end, std::int64_t& value)
  {
    while (text < end && IsSpace(*text))
    {
      ++text;
    }
    text = ParseInteger(text, end, value);
    return text && (text == end || IsSpace(*text) || *text == comment);
  };

  // The length of every list first, so that there is exactly the memory that is needed.
  std::vector<vtkIdType> first(static_cast<std::size_t>(lines.GetNumberOfPieces(section)) + 1, 0);
  bool good = lines.ForEach(section, progress.Part(0, 0.2),
    [&](vtkIdType piece, vtkIdType, const char* text, const char* end)
    {
      std::int64_t size = 0;
      const char* const begin = text;
      if (!parse(text, end, size) || size < 0 || size > (end - begin) / 2)
      {
        return false;
      }
      first[piece + 1] += 1 + size;
      return true;
    });
  if (!good)
  {
    return false;
  }
  for (std::size_t piece = 1; piece < first.size(); ++piece)
  {
    first[piece] += first[piece - 1];
  }

  Buffer<std::int32_t> words(first.back());
  const std::vector<vtkIdType> last(first.begin() + 1, first.end());
  const auto limit = static_cast<std::uint64_t>(expected.Limit);
  const vtkIdType lastLine = this->Count - 1;
  good = lines.ForEach(section, progress.Part(0.2, 1),
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
    {
      std::int64_t size = 0;
      if (!parse(text, end, size) || size < 0 || size >= last[piece] - first[piece])
      {
        return false; // the file was changed
      }
      std::int32_t* word = words.data() + first[piece];
      *word++ = static_cast<std::int32_t>(size);
      for (std::int64_t j = 0; j < size; ++j)
      {
        std::int64_t id;
        if (!parse(text, end, id) || static_cast<std::uint64_t>(id) >= limit)
        {
          return false;
        }
        *word++ = static_cast<std::int32_t>(id);
      }
      first[piece] += 1 + size;
      return dropRest || line == lastLine ? TextLines::HasOneEnd(text, end)
                                          : lines.IsBlank(text, end);
    });
  if (good)
  {
    this->Words = std::move(words);
    scanner.SetPosition(section.End);
  }
  return good;
}

//------------------------------------------------------------------------------
// Reads a list; false if something is wrong with it. What follows it is left.
bool IdLists::ReadLine(
  const char*& text, const char* end, std::vector<std::int32_t>& ids) const
{
  const auto limit = static_cast<std::uint64_t>(this->Limit);
  const auto parse = [&](std::int64_t& value)
  {
    while (text < end && IsSpace(*text))
    {
      ++text;
    }
    const char* const next = ParseInteger(text, end, value);
    text = next ? next : text;
    return next && (next == end || IsSpace(*next) || *next == this->Comment);
  };
  std::int64_t size = 0, id = 0;
  if (!parse(size) || size < 0 || size > (end - text) / 2)
  {
    return false;
  }
  ids.resize(static_cast<std::size_t>(size));
  for (std::int32_t& place : ids)
  {
    if (!parse(id) || static_cast<std::uint64_t>(id) >= limit)
    {
      return false;
    }
    place = static_cast<std::int32_t>(id);
  }
  return true;
}

//------------------------------------------------------------------------------
// The same of the next line that counts.
bool IdLists::ReadNextLine(const char*& text, std::vector<std::int32_t>& ids) const
{
  TextScanner scanner("", text, this->Section.End, this->Comment);
  scanner.SetPosition(text);
  const bool isThere = scanner.SkipSpace();
  text = scanner.GetPosition();
  scanner.SkipLine();
  const bool good = isThere && this->ReadLine(text, scanner.GetPosition(), ids);
  text = scanner.GetPosition();
  return good;
}

//------------------------------------------------------------------------------
bool IdLists::CheckLines(TextScanner& scanner, const TextLines& lines, bool dropRest,
  Expectation& expected, const Progress& progress)
{
  this->Section = lines.Find(scanner.GetPosition(), this->Count);
  if (!this->Section)
  {
    return false;
  }
  this->Lines = &lines;
  this->Comment = scanner.GetComment();
  this->Limit = expected.Limit;
  struct Seen
  {
    std::vector<std::int32_t> Ids;
    vtkIdType NumberOfIds = 0;
    Tally Empty, Short, Repeating;
  };
  std::vector<Seen> pieces(this->GetNumberOfPieces());
  const vtkIdType lastLine = this->Count - 1;
  const bool good = lines.ForEach(this->Section, progress,
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
    {
      Seen& seen = pieces[piece];
      if (!this->ReadLine(text, end, seen.Ids) ||
        !(dropRest || line == lastLine ? TextLines::HasOneEnd(text, end)
                                       : lines.IsBlank(text, end)))
      {
        return false;
      }
      const auto size = static_cast<vtkIdType>(seen.Ids.size());
      seen.NumberOfIds += size;
      std::int32_t previous = size > 0 ? seen.Ids.back() : -1;
      bool repeats = false;
      for (const std::int32_t id : seen.Ids)
      {
        repeats |= id == previous;
        previous = id;
        if (expected.Used)
        {
          expected.Used->Add(id);
        }
      }
      if (size < 3)
      {
        (size == 0 ? seen.Empty : seen.Short).Add(line);
      }
      else if (repeats)
      {
        seen.Repeating.Add(line);
      }
      return true;
    });
  if (!good)
  {
    if (expected.Used)
    {
      *expected.Used = IdSet(expected.Used->GetLimit());
    }
    return false;
  }
  this->NumberOfIds = 0;
  for (const Seen& seen : pieces)
  {
    this->NumberOfIds += seen.NumberOfIds;
    expected.Empty.Merge(seen.Empty);
    expected.Short.Merge(seen.Short);
    expected.Repeating.Merge(seen.Repeating);
  }
  scanner.SetPosition(this->Section.End);
  return true;
}

//------------------------------------------------------------------------------
bool IdLists::KeepNeeded(const Progress& progress)
{
  std::vector<std::vector<std::int32_t>> kept(this->GetNumberOfPieces()), ids(kept.size());
  if (!this->Lines->ForEach(this->Section, progress,
        [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
        {
          if (!this->Needed->Contains(line))
          {
            return true;
          }
          const bool good = this->ReadLine(text, end, ids[piece]);
          kept[piece].push_back(static_cast<std::int32_t>(ids[piece].size()));
          kept[piece].insert(kept[piece].end(), ids[piece].begin(), ids[piece].end());
          return good;
        }))
  {
    return false;
  }
  std::size_t size = 0;
  for (const auto& words : kept)
  {
    size += words.size();
  }
  this->Words = Buffer<std::int32_t>(static_cast<vtkIdType>(size));
  std::int32_t* word = this->Words.data();
  for (auto& words : kept)
  {
    word = std::copy(words.begin(), words.end(), word);
    words = {};
  }
  this->End = reinterpret_cast<const char*>(word);
  this->Blocks.assign(static_cast<std::size_t>((this->Count + BlockSize - 1) / BlockSize), nullptr);
  this->Starts = Buffer<std::uint32_t>(this->Needed->GetNumberOfMembers());
  const char* place = reinterpret_cast<const char*>(this->Words.data());
  vtkIdType number = 0;
  for (const std::int32_t list : this->Needed->GetMembers())
  {
    const char*& block = this->Blocks[static_cast<std::size_t>(list / BlockSize)];
    block = block ? block : place;
    this->Starts[number++] = static_cast<std::uint32_t>((place - block) / 4);
    place += 4 + 4 * std::ptrdiff_t(this->At(place).Size);
  }
  return true;
}

//------------------------------------------------------------------------------
bool IdLists::ScanText(TextScanner& scanner, bool dropRest, const Expectation& expected)
{
  const std::string size = std::string("the size of a ") + expected.List;
  const std::string id = std::string("a ") + expected.Id + " id";
  for (vtkIdType i = 0; i < this->Count; ++i)
  {
    std::int64_t value = 0;
    if (!scanner.ReadCount(value, 2, size.c_str()))
    {
      return false;
    }
    this->GrownWords.push_back(static_cast<std::int32_t>(value));
    for (std::int64_t left = value; left > 0; --left)
    {
      if (!scanner.ReadInteger(value, 0, expected.Limit - 1, ErrorKind::Index, id.c_str()))
      {
        return false;
      }
      this->GrownWords.push_back(static_cast<std::int32_t>(value));
    }
    if (dropRest || i + 1 == this->Count)
    {
      scanner.SkipLine();
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool IdLists::MakeRandomAccess(const IdSet& needed, const Progress& progress)
{
  if (this->CommonSize >= 0)
  {
    return true;
  }
  this->Needed = &needed;
  if (this->Lines)
  {
    return this->KeepNeeded(progress);
  }
  this->Starts = Buffer<std::uint32_t>(needed.GetNumberOfMembers());
  return this->ForEach(progress,
    [&](vtkIdType i, const IdList& list)
    {
      if (needed.Contains(i))
      {
        this->Starts[needed.GetNumber(i)] =
          static_cast<std::uint32_t>((list.Ids - 4 - this->Blocks[i / BlockSize]) / 4);
      }
    });
}
}
