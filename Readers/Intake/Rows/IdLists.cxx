// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Rows/IdLists.h"

#include "Base/Parallel.h"
#include "Intake/Ids/RepeatedIds.h"
#include "Intake/Rows/ShortNumbers.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <optional>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
std::string DescribeRange(const IdLists::Expectation& expected)
{
  return expected.Limit > 0
    ? std::string("a ") + expected.Id + " id from 0 to " + std::to_string(expected.Limit - 1)
    : std::string("no id of a ") + expected.Id + " (there are none)";
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

  // Lists of one common size need no table. Whether all have the size of the first is checked in
  // the same pass; if not, this usually shows early.
  Validity validity = Validity::Uneven;
  if (this->GuessCommonSize(scanner))
  {
    BinaryScanner after = scanner;
    after.Skip(count * this->Stride, expected.List);
    validity = this->Check(after, expected, progress.Part(0, 0.5));
    if (validity != Validity::Uneven)
    {
      scanner = after;
    }
  }
  if (validity == Validity::Uneven && !progress.IsStopped())
  {
    this->CommonSize = -1;
    if (!this->FindStarts(scanner, expected.List))
    {
      return false;
    }
    validity = this->Check(scanner, expected, progress.Part(0.5, 1));
  }
  this->NumberOfIds = (scanner.GetPosition() - this->Data) / 4 - count;
  return validity == Validity::Good && !progress.IsStopped();
}

//------------------------------------------------------------------------------
bool IdLists::Open(const Buffer<std::int32_t>& words, vtkIdType count, Expectation& expected,
  const Progress& progress)
{
  const char* const bytes = reinterpret_cast<const char*>(words.data());
  BinaryScanner scanner("", bytes, bytes + sizeof(std::int32_t) * words.size(), GetByteOrder());
  return this->Scan(scanner, count, expected, progress);
}

//------------------------------------------------------------------------------
bool IdLists::Open(Buffer<std::int32_t>&& ids, Buffer<std::int32_t>&& offsets,
  std::int32_t commonSize, vtkIdType count, Expectation& expected, const Progress& progress)
{
  this->Ids = std::move(ids);
  this->Offsets = std::move(offsets);
  this->Count = count;
  this->NumberOfIds = this->Ids.size();
  this->Data = reinterpret_cast<const char*>(this->Ids.data());
  this->End = this->Data + 4 * this->NumberOfIds;
  this->Header = 0;
  this->CommonSize = this->Offsets.size() > 0 ? -1 : commonSize;
  this->Stride = 4 * std::ptrdiff_t(commonSize);
  BinaryScanner scanner("", this->Data, this->End, GetByteOrder());
  return this->Check(scanner, expected, progress) == Validity::Good && !progress.IsStopped();
}

//------------------------------------------------------------------------------
// Assumes the size of the first list for all; false if they would not fit into the file.
bool IdLists::GuessCommonSize(const BinaryScanner& scanner)
{
  const auto size = scanner.GetBytesLeft() >= 4 ? Load<std::int32_t>(this->Data, this->Swap) : -1;
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
      return scanner.FailAt(place, size < 0 ? ErrorKind::Count : ErrorKind::Truncated,
        std::string(what) + " " + std::to_string(i) + " of " + std::to_string(this->Count),
        size < 0     ? "a size of " + std::to_string(size)
          : size > 0 ? "a size of " + std::to_string(size) + " but only " +
            std::to_string(end - place - 4) + " bytes up to the end of the file"
                     : "the end of the file");
    }
    place += 4 + 4 * std::ptrdiff_t(size);
    if ((place - this->Blocks.back()) / 4 > UINT32_MAX)
    {
      return scanner.FailAt(
        place, ErrorKind::Unsupported, "less than 16 GB for 1024 consecutive lists", "more");
    }
  }
  scanner.SetPosition(place);
  return true;
}

//------------------------------------------------------------------------------
// Checks the lists of some blocks; returns the first invalid one, or the number of lists. Size is
// the common size if it is one of the usual ones, else 0.
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
  std::vector<std::int32_t> scratch(8);
  // Ids of any byte order, and unaligned in a file.
  const auto align = [&scratch](const char* ids, std::int32_t size)
  {
    if (scratch.size() < static_cast<std::size_t>(size))
    {
      scratch.resize(static_cast<std::size_t>(size));
    }
    std::memcpy(scratch.data(), ids, sizeof(std::int32_t) * static_cast<std::size_t>(size));
    return scratch.data();
  };
  for (vtkIdType i = firstBlock * BlockSize; i < end; ++i)
  {
    const IdList list = this->At(i, place);
    if (this->CommonSize >= 0 && this->Header > 0 &&
      Load<std::int32_t>(place, this->Swap) != this->CommonSize)
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
    for (std::int32_t j = 0; j < size; ++j)
    {
      valid &= static_cast<std::uint32_t>(list[j]) < limit;
    }
    if (!valid)
    {
      return i;
    }
    if (size < 3)
    {
      seen.Short.Add(i);
    }
    else if (seen.FindsRepeating && HasRepeatedIds(align(list.Ids, size), size))
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
IdLists::Validity IdLists::Check(
  BinaryScanner& scanner, Expectation& expected, const Progress& progress)
{
  this->Starts = Buffer<std::uint32_t>();
  if (this->CommonSize < 0 && this->Offsets.size() == 0 && expected.AccessAll)
  {
    this->Starts = Buffer<std::uint32_t>(this->Count);
  }
  std::atomic<vtkIdType> bad{ this->Count };
  std::atomic<bool> allEven{ true };
  std::mutex mutex;
  Census sum;
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
      seen.FindsRepeating = expected.FindsRepeating;
      bool even = true;
      const vtkIdType firstBad = this->CommonSize == 3
        ? this->CheckBlocks<3>(first, last, seen, even)
        : this->CommonSize == 4 ? this->CheckBlocks<4>(first, last, seen, even)
        : this->CommonSize == 6 ? this->CheckBlocks<6>(first, last, seen, even)
                                : this->CheckBlocks<0>(first, last, seen, even);
      if (!even)
      {
        allEven = false;
      }
      LowerTo(bad, firstBad);
      const std::lock_guard<std::mutex> lock(mutex);
      sum.Merge(seen);
    });
  if (!allEven)
  {
    if (expected.Used)
    {
      *expected.Used = IdSet(expected.Used->GetLimit());
    }
    return Validity::Uneven;
  }
  if (bad < this->Count)
  {
    this->FailAtList(scanner, bad, expected);
    return Validity::Bad;
  }
  static_cast<Census&>(expected) = sum;
  return Validity::Good;
}

//------------------------------------------------------------------------------
void IdLists::FailAtList(BinaryScanner& scanner, vtkIdType bad, const Expectation& expected) const
{
  vtkIdType i = bad / BlockSize * BlockSize;
  IdList list = this->At(i, this->GetBlock(bad / BlockSize));
  while (i < bad)
  {
    list = this->At(++i, list.Ids + 4 * std::ptrdiff_t(list.Size));
  }
  std::int32_t j = 0;
  while (j + 1 < list.Size && static_cast<std::uint32_t>(list[j]) < expected.Limit)
  {
    ++j;
  }
  scanner.FailAt(list.Ids + 4 * std::ptrdiff_t(j), ErrorKind::Index,
    DescribeRange(expected) + " in " + expected.List + " " + std::to_string(bad),
    list.Size > 0 ? std::to_string(list[j]) : "nothing");
}

//------------------------------------------------------------------------------
bool IdLists::Scan(TextScanner& scanner, const TextLines* lines, vtkIdType count, bool dropRest,
  Expectation& expected, const Progress& progress)
{
  this->Count = count;
  this->Swap = false;
  this->CommonSize = -1;
  this->Needed = nullptr;
  if (lines && this->CheckLines(scanner, *lines, dropRest, expected, progress))
  {
    return true;
  }
  this->Lines = nullptr;
  this->LineStarts = Buffer<std::uint16_t>();
  if (progress.IsStopped() || !this->ScanText(scanner, dropRest, expected))
  {
    return false;
  }
  // From here on, the text is handled like a valid binary file.
  const char* words = reinterpret_cast<const char*>(this->Words.data());
  BinaryScanner memory("", words, words + 4 * this->Words.size(), GetByteOrder());
  return this->Scan(memory, count, expected, progress.Part(0.8, 1));
}

//------------------------------------------------------------------------------
// Reads the next number of a line, which must be in [0, limit); false if it is invalid.
inline bool IdLists::ReadNumber(
  const char*& text, const char* end, std::int64_t limit, std::int32_t& number) const
{
  // Most are a blank, a few digits, and a blank or the end of the line. This takes half of the
  // time.
  constexpr int UsualDigits = 9;
  if (end - text > UsualDigits + 1)
  {
    const char* p = text + (*text == ' ');
    const char* const first = p;
    const char* const last = p + UsualDigits;
    std::int32_t usual = 0;
    for (; p < last && IsDigit(*p); ++p)
    {
      usual = usual * 10 + (*p - '0');
    }
    if (p > first && (*p == ' ' || *p == '\n') && usual < limit)
    {
      text = p;
      number = usual;
      return true;
    }
  }
  while (text < end && IsSpace(*text) && *text != '\n')
  {
    ++text;
  }
  std::int64_t value = 0;
  const char* const next = ParseInteger(text, end, value);
  if (!next || (next < end && !IsSpace(*next) && *next != this->Comment) || value < 0 ||
    value >= limit)
  {
    return false;
  }
  text = next;
  number = static_cast<std::int32_t>(value);
  return true;
}

//------------------------------------------------------------------------------
// On failure, returns false without appending anything. Text after the list is ignored.
bool IdLists::ReadLine(
  const char*& text, const char* end, std::vector<std::int32_t>& words, std::size_t& size) const
{
  std::int32_t count = 0;
  constexpr std::ptrdiff_t Room = 20; // for as many ids as a digit says
  if (end - text > Room && IsDigit(text[0]) && text[1] == ' ')
  {
    count = *text++ - '0';
  }
  else if (!this->ReadNumber(
             text, end, std::min<std::int64_t>((end - text) / 2 + 1, INT32_MAX), count))
  {
    return false;
  }
  const std::size_t newSize = size + static_cast<std::size_t>(count);
  if (newSize > words.size())
  {
    words.resize(2 * newSize);
  }
  std::int32_t* const list = words.data() + size;
  for (std::int32_t j = ReadShortNumbers(text, end, count, this->Limit, list); j < count; ++j)
  {
    if (!this->ReadNumber(text, end, this->Limit, list[j]))
    {
      return false;
    }
  }
  size = newSize;
  return true;
}

//------------------------------------------------------------------------------
// The same for the next counted line.
bool IdLists::ReadNextLine(
  const char*& text, std::vector<std::int32_t>& words, std::size_t& size) const
{
  const char* const end = this->Section.End;
  const bool good = this->Lines->NextLine(text, end) && this->ReadLine(text, end, words, size);
  const char* const lineEnd = good ? TextLines::GetEndOfLine(text, end) : nullptr;
  text = lineEnd ? lineEnd : end;
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
  this->Groups.resize(static_cast<std::size_t>((this->Count + GroupSize - 1) / GroupSize));
  this->LineStarts = Buffer<std::uint16_t>(expected.AccessAll ? this->Count : 0);
  struct Seen : Census
  {
    std::vector<std::int32_t> Words;
    std::optional<IdSet::Adder> Used;
    vtkIdType NumberOfIds = 0;
    std::int32_t Least = INT32_MAX, Most = -1;
  };
  std::vector<Seen> pieces(this->GetNumberOfPieces());
  const vtkIdType lastLine = this->Count - 1;
  const bool good = lines.ForEachToEnd(this->Section, progress,
    [&](vtkIdType piece, vtkIdType line, const char* text, const char* end) -> const char*
    {
      if (expected.AccessAll)
      {
        this->LineStarts[line] = this->GetLineStart(text);
      }
      if (line % GroupSize == 0)
      {
        this->Groups[static_cast<std::size_t>(line / GroupSize)] = text;
      }
      Seen& seen = pieces[static_cast<std::size_t>(piece)];
      std::size_t count = 0;
      if (!this->ReadLine(text, end, seen.Words, count))
      {
        return nullptr;
      }
      const auto size = static_cast<std::int32_t>(count);
      seen.NumberOfIds += size;
      seen.Least = std::min(seen.Least, size);
      seen.Most = std::max(seen.Most, size);
      const std::int32_t* const ids = seen.Words.data();
      if (expected.Used)
      {
        if (!seen.Used)
        {
          seen.Used.emplace(*expected.Used);
        }
        for (std::int32_t j = 0; j < size; ++j)
        {
          seen.Used->Add(ids[j]);
        }
      }
      if (size < 3)
      {
        (size == 0 ? seen.Empty : seen.Short).Add(line);
      }
      else if (expected.FindsRepeating && HasRepeatedIds(ids, size))
      {
        seen.Repeating.Add(line);
      }
      return dropRest || line == lastLine ? TextLines::GetEndOfLine(text, end)
                                          : lines.GetEndOfBlankLine(text, end);
    });
  if (!good || !this->AreGroupsSmall())
  {
    pieces.clear(); // adds the remaining used ids
    if (expected.Used)
    {
      *expected.Used = IdSet(expected.Used->GetLimit());
    }
    return false;
  }
  this->NumberOfIds = 0;
  std::int32_t least = INT32_MAX, most = -1;
  for (const Seen& seen : pieces)
  {
    this->NumberOfIds += seen.NumberOfIds;
    least = std::min(least, seen.Least);
    most = std::max(most, seen.Most);
    expected.Merge(seen);
  }
  this->LineSize = least == most ? least : -1;
  scanner.SetPosition(this->Section.End);
  return true;
}

//------------------------------------------------------------------------------
bool IdLists::AreGroupsSmall() const
{
  const char* end = this->Section.End;
  bool areSmall = true;
  for (auto group = this->Groups.rbegin(); group != this->Groups.rend(); ++group)
  {
    areSmall &= end - *group <= UINT16_MAX;
    end = *group;
  }
  return areSmall;
}

//------------------------------------------------------------------------------
// The sizes are known, and the words are contiguous.
void IdLists::PointToWords(IdListGroup& group)
{
  const std::int32_t* words = group.Words.data();
  for (IdList& list : group.Lists)
  {
    list.Ids = reinterpret_cast<const char*>(words);
    words += list.Size;
  }
}

//------------------------------------------------------------------------------
void IdLists::Read(const IdList& numbers, IdListGroup& group) const
{
  group.Lists.resize(static_cast<std::size_t>(numbers.Size));
  if (!this->Lines)
  {
    for (std::int32_t j = 0; j < numbers.Size; ++j)
    {
      group.Lists[static_cast<std::size_t>(j)] = (*this)[numbers[j]];
    }
    return;
  }
  std::size_t size = 0;
  for (std::int32_t j = 0; j < numbers.Size; ++j)
  {
    const std::size_t begin = size;
    if (this->Has(numbers[j]))
    {
      const char* text = this->FindLine(numbers[j]);
      this->ReadLine(text, this->Section.End, group.Words, size);
    }
    group.Lists[static_cast<std::size_t>(j)] = { nullptr, static_cast<std::int32_t>(size - begin),
      0 };
  }
  PointToWords(group);
}

//------------------------------------------------------------------------------
void IdLists::ReadBlock(vtkIdType first, vtkIdType last, IdListGroup& group) const
{
  static_assert(BlockSize % GroupSize == 0, "blocks begin where groups do");
  group.Lists.clear();
  if (!this->Lines)
  {
    const char* place = first < last ? this->GetBlock(first / BlockSize) : nullptr;
    for (vtkIdType i = first; i < last; ++i)
    {
      group.Lists.push_back(this->At(i, place));
      place = group.Lists.back().Ids + 4 * std::ptrdiff_t(group.Lists.back().Size);
    }
    return;
  }
  std::size_t size = 0;
  const char* text =
    first < last ? this->Groups[static_cast<std::size_t>(first / GroupSize)] : nullptr;
  for (vtkIdType i = first; i < last; ++i)
  {
    const std::size_t begin = size;
    this->ReadNextLine(text, group.Words, size);
    group.Lists.push_back({ nullptr, static_cast<std::int32_t>(size - begin), 0 });
  }
  PointToWords(group);
}

//------------------------------------------------------------------------------
std::int32_t IdLists::GetSize(vtkIdType i) const
{
  if (!this->Lines)
  {
    return (*this)[i].Size;
  }
  std::int32_t size = 0;
  const char* text = this->Has(i) ? this->FindLine(i) : this->Section.End;
  return this->ReadNumber(text, this->Section.End, INT32_MAX, size) ? size : 0;
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
    this->Words.push_back(static_cast<std::int32_t>(value));
    for (std::int64_t left = value; left > 0; --left)
    {
      if (!scanner.ReadInteger(value, 0, expected.Limit - 1, ErrorKind::Index, id.c_str()))
      {
        return false;
      }
      this->Words.push_back(static_cast<std::int32_t>(value));
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
  if (this->CommonSize >= 0 || this->Offsets.size() > 0)
  {
    return true;
  }
  this->Needed = &needed;
  if (this->Lines)
  {
    this->LineStarts = Buffer<std::uint16_t>(needed.GetNumberOfMembers());
    return this->Lines->ForEach(this->Section, progress,
      [&](vtkIdType, vtkIdType line, const char* text, const char*)
      {
        if (needed.Contains(line))
        {
          this->LineStarts[needed.GetNumber(line)] = this->GetLineStart(text);
        }
        return true;
      });
  }
  this->Starts = Buffer<std::uint32_t>(needed.GetNumberOfMembers());
  return this->ForEachOf(needed, progress,
    [&](vtkIdType i, const IdList& list)
    {
      this->Starts[needed.GetNumber(i)] =
        static_cast<std::uint32_t>((list.Ids - 4 - this->Blocks[i / BlockSize]) / 4);
    });
}
}
