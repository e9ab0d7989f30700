// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::IdLists
 * @brief Lists of ids in the layout of many formats: n id1 ... idn, one list after the other.
 *
 * The lists are not copied; they stay in a memory-mapped file of either byte order. Lists of one
 * common size are located by arithmetic. Otherwise the start of every 1024th list is stored, and,
 * after MakeRandomAccess or if the reader requests it, the start of every list needed.
 *
 * Lists in text, one per line, stay text, because numbers would need much more memory than the two
 * bytes for the start of a line. They are parsed whenever they are accessed, for example by Read;
 * operator[] does not support them.
 *
 * Another program may change the file after the lists were checked. Lists and ids may then have
 * any value, but accessing them stays safe.
 */
#ifndef camaron_IdLists_h
#define camaron_IdLists_h

#include "Base/Buffer.h"
#include "Base/Progress.h"
#include "Intake/Ids/IdSet.h"
#include "Intake/Rows/BinaryScanner.h"
#include "Intake/Rows/TextLines.h"

#include <vector> // for starts

namespace camaron
{
/// One list, in place.
struct IdList
{
  const char* Ids = nullptr;
  std::int32_t Size = 0;
  std::int32_t Swap = 0; // not bool, because copying structs with padding is slow
  std::int32_t operator[](std::int32_t i) const
  {
    return Load<std::int32_t>(this->Ids + 4 * std::ptrdiff_t(i), this->Swap != 0);
  }
};

/// Lists read together, each in place or, for text, as a copy.
class IdListGroup
{
public:
  const IdList& operator[](vtkIdType i) const { return this->Lists[static_cast<std::size_t>(i)]; }
  const IdList* data() const { return this->Lists.data(); }
  vtkIdType size() const { return static_cast<vtkIdType>(this->Lists.size()); }

private:
  friend class IdLists;
  std::vector<IdList> Lists;
  std::vector<std::int32_t> Words;
};

class IdLists
{
public:
  /// Statistics of lists; merging does not depend on the order.
  struct Census
  {
    Tally Empty;     ///< lists without ids
    Tally Short;     ///< lists with one or two ids
    Tally Repeating; ///< lists of three or more ids with a repeated id
    void Merge(const Census& other)
    {
      this->Empty.Merge(other.Empty);
      this->Short.Merge(other.Short);
      this->Repeating.Merge(other.Repeating);
    }
  };

  /// Expected properties of the lists, and statistics of the lists found.
  struct Expectation : Census
  {
    const char* List = "";       ///< name of a list, e.g. "polygon"
    const char* Id = "";         ///< name of an id's target, e.g. "vertex"
    vtkIdType Limit = 0;         ///< ids must be in [0, Limit)
    IdSet* Used = nullptr;       ///< optional: all ids found are added to it
    bool AccessAll = true;       ///< whether any list may be accessed, not only blocks of them
    bool FindsRepeating = false; ///< whether to find Repeating
  };

  /// Finds @a count lists in a binary file; false with the error in the scanner, or if stopped.
  bool Scan(
    BinaryScanner& scanner, vtkIdType count, Expectation& expected, const Progress& progress);

  /**
   * Finds @a count lists in text; false with the error in the scanner, or if stopped.
   * @param lines of a text large enough for parallel reading, else nullptr; must outlive the lists
   * @param dropRest whether to ignore the rest of the line after every list; otherwise only after
   * the last one
   */
  bool Scan(TextScanner& scanner, const TextLines* lines, vtkIdType count, bool dropRest,
    Expectation& expected, const Progress& progress);

  /// Opens @a count lists in memory, which must outlive them; false if they are invalid, or if
  /// stopped.
  bool Open(const Buffer<std::int32_t>& words, vtkIdType count, Expectation& expected,
    const Progress& progress);
  /// The same for the ids of all lists one after the other.
  /// @param offsets of the lists in these, and one more; empty if all have @a commonSize ids
  bool Open(Buffer<std::int32_t>&& ids, Buffer<std::int32_t>&& offsets, std::int32_t commonSize,
    vtkIdType count, Expectation& expected, const Progress& progress);

  vtkIdType GetCount() const { return this->Count; }
  /// Total number of ids of all lists.
  vtkIdType GetNumberOfIds() const { return this->NumberOfIds; }
  /// The common size of the lists, or -1.
  std::int32_t GetCommonSize() const { return this->Lines ? this->LineSize : this->CommonSize; }

  /// Calls @a visit(i, list) for all lists in parallel; each call range of a thread is ascending.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const
  {
    return this->ForEachIf(progress, [](vtkIdType) { return true; }, visit);
  }

  /// The same for the lists in a set.
  template <typename Visit>
  bool ForEachOf(const IdSet& lists, const Progress& progress, Visit&& visit) const
  {
    return this->ForEachIf(progress, [&lists](vtkIdType i) { return lists.Contains(i); }, visit);
  }

  /// Calls @a visit(i, list) for all lists in order.
  template <typename Visit>
  void ForEachInOrder(Visit&& visit) const
  {
    if (this->Lines)
    {
      std::vector<std::int32_t> ids;
      const char* text = this->Section.Begin;
      std::size_t size = 0;
      for (vtkIdType i = 0; i < this->Count && this->ReadNextLine(text, ids, size); ++i)
      {
        visit(i, MakeList(ids, size));
        size = 0;
      }
      return;
    }
    const char* place = this->Count > 0 ? this->GetBlock(0) : nullptr;
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const IdList list = this->At(i, place);
      visit(i, list);
      place = list.Ids + 4 * std::ptrdiff_t(list.Size);
    }
  }

  /// Enables random access to the members of @a needed, which must be numbered and outlive the
  /// lists.
  bool MakeRandomAccess(const IdSet& needed, const Progress& progress);

  /// Reads the lists with the given numbers; lists that cannot be read any more are replaced by
  /// empty lists.
  void Read(const IdList& numbers, IdListGroup& group) const;
  /// The same for consecutive lists, the first at a multiple of BlockSize.
  void ReadBlock(vtkIdType first, vtkIdType last, IdListGroup& group) const;
  /// Length of a list.
  std::int32_t GetSize(vtkIdType i) const;

  /// A list of numbers.
  IdList operator[](vtkIdType i) const
  {
    return this->Has(i) ? this->At(i, this->FindPlace(i)) : IdList{ this->End, 0, this->Swap };
  }

  /// Prefetches a list that will be read soon.
  void Prefetch(vtkIdType i) const
  {
    if (this->Has(i))
    {
      camaron::Prefetch(this->Lines ? this->FindLine(i) : this->FindPlace(i));
    }
  }

  static constexpr vtkIdType BlockSize = 1024;

private:
  /// Calls @a visit(i, list) for the lists for which @a isWanted(i).
  template <typename IsWanted, typename Visit>
  bool ForEachIf(const Progress& progress, IsWanted&& isWanted, Visit&& visit) const
  {
    if (this->Lines)
    {
      std::vector<std::vector<std::int32_t>> ids(this->GetNumberOfPieces());
      return this->Lines->ForEach(this->Section, progress,
        [&](vtkIdType piece, vtkIdType line, const char* text, const char* end)
        {
          std::size_t size = 0;
          const bool good = isWanted(line) && this->ReadLine(text, end, ids[piece], size);
          if (good)
          {
            visit(line, MakeList(ids[piece], size));
          }
          return good || !isWanted(line);
        });
    }
    return progress.ForBlocks(this->Count, BlockSize,
      [&](vtkIdType begin, vtkIdType end)
      {
        const char* place = this->GetBlock(begin / BlockSize);
        for (vtkIdType i = begin; i < end; ++i)
        {
          const IdList list = this->At(i, place);
          if (isWanted(i))
          {
            visit(i, list);
          }
          place = list.Ids + 4 * std::ptrdiff_t(list.Size);
        }
      });
  }
  bool Has(vtkIdType i) const
  {
    return static_cast<std::uint64_t>(i) < static_cast<std::uint64_t>(this->Count);
  }
  const char* FindPlace(vtkIdType i) const
  {
    if (this->CommonSize >= 0)
    {
      return this->Data + i * this->Stride;
    }
    if (this->Offsets.size() > 0)
    {
      return this->Data + 4 * std::ptrdiff_t(this->Offsets[i]);
    }
    const vtkIdType number = this->Needed ? this->Needed->GetNumber(i) : i;
    return number < this->Starts.size()
      ? this->Blocks[i / BlockSize] + 4 * std::ptrdiff_t(this->Starts[number])
      : this->End;
  }

  IdList At(vtkIdType i, const char* place) const
  {
    if (this->CommonSize >= 0)
    {
      return { place + this->Header, this->CommonSize, this->Swap };
    }
    if (this->Offsets.size() > 0)
    {
      return { place, this->Offsets[i + 1] - this->Offsets[i], 0 };
    }
    const std::ptrdiff_t room = (this->End - place) / 4 - 1;
    if (room < 0)
    {
      return { this->End, 0, this->Swap };
    }
    const auto size = Load<std::int32_t>(place, this->Swap);
    return { place + 4, size >= 0 && size <= room ? size : 0, this->Swap };
  }
  const char* GetBlock(vtkIdType block) const
  {
    return this->CommonSize < 0 && this->Offsets.size() == 0 ? this->Blocks[block]
                                                             : this->FindPlace(block * BlockSize);
  }
  bool FindStarts(BinaryScanner& scanner, const char* what);
  enum class Validity
  {
    Good,
    Bad,   ///< an id is out of range; the error is in the scanner
    Uneven ///< lists assumed to have a common size have different ones
  };
  Validity Check(BinaryScanner& scanner, Expectation& expected, const Progress& progress);
  template <int Size>
  vtkIdType CheckBlocks(vtkIdType firstBlock, vtkIdType lastBlock, Expectation& seen, bool& even);
  bool GuessCommonSize(const BinaryScanner& scanner);
  void FailAtList(BinaryScanner& scanner, vtkIdType bad, const Expectation& expected) const;
  bool ScanText(TextScanner& scanner, bool dropRest, const Expectation& expected);

  ///@{
  /// Lists that stay text.
  bool CheckLines(TextScanner& scanner, const TextLines& lines, bool dropRest,
    Expectation& expected, const Progress& progress);
  bool ReadNumber(
    const char*& text, const char* end, std::int64_t limit, std::int32_t& number) const;
  ///@{
  /// Appends a list to the first @a size words, which are resized if necessary.
  bool ReadLine(
    const char*& text, const char* end, std::vector<std::int32_t>& words, std::size_t& size) const;
  bool ReadNextLine(const char*& text, std::vector<std::int32_t>& words, std::size_t& size) const;
  ///@}
  /// Whether lines are located by the lower bits of their starts.
  bool AreGroupsSmall() const;
  std::uint16_t GetLineStart(const char* line) const
  {
    return static_cast<std::uint16_t>(line - this->Section.Begin);
  }
  const char* FindLine(vtkIdType i) const
  {
    const vtkIdType number = this->Needed ? this->Needed->GetNumber(i) : i;
    const char* const group = this->Groups[static_cast<std::size_t>(i / GroupSize)];
    return number < this->LineStarts.size()
      ? group + static_cast<std::uint16_t>(this->LineStarts[number] - this->GetLineStart(group))
      : this->Section.End;
  }
  std::size_t GetNumberOfPieces() const
  {
    return static_cast<std::size_t>(this->Lines->GetNumberOfPieces(this->Section));
  }
  static IdList MakeList(const std::vector<std::int32_t>& words, std::size_t size)
  {
    return { reinterpret_cast<const char*>(words.data()), static_cast<std::int32_t>(size), 0 };
  }
  static void PointToWords(IdListGroup& group);

  static constexpr vtkIdType GroupSize = 64; ///< lines
  const TextLines* Lines = nullptr;
  TextLines::Section Section;
  char Comment = '\0';
  vtkIdType Limit = 0;
  std::int32_t LineSize = -1;       ///< the common length of the lists
  std::vector<const char*> Groups;  ///< starts of the first lines of groups
  Buffer<std::uint16_t> LineStarts; ///< lower bits of the starts of all or of the needed lines
  ///@}

  vtkIdType Count = 0;
  vtkIdType NumberOfIds = 0;
  const char* Data = nullptr;
  const char* End = nullptr; ///< end of the file or of the memory
  bool Swap = false;
  std::int32_t CommonSize = -1;
  std::ptrdiff_t Stride = 0; ///< bytes between lists if all have the common size
  std::ptrdiff_t Header = 4; ///< bytes of the size of a list, before its ids
  ///@{
  /// Ids without sizes between them, and where lists of several sizes begin.
  Buffer<std::int32_t> Ids;
  Buffer<std::int32_t> Offsets;
  ///@}
  std::vector<const char*> Blocks;
  const IdSet* Needed = nullptr;
  Buffer<std::uint32_t> Starts;    ///< words from the start of the block
  std::vector<std::int32_t> Words; ///< the lists, if they come from text in another layout
};
}

#endif
