// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::IdLists
 * @brief Lists of ids as many formats store them: n id1 ... idn, one list after the other.
 *
 * The lists stay where they are, usually in a mapped file of either byte order. Lists of one common
 * length are found by arithmetic. For others the start of every 1024th list is kept, and, once
 * MakeRandomAccess was called or if the reader asks for it, the start of every list that is needed.
 */
#ifndef camaron_IdLists_h
#define camaron_IdLists_h

#include "Scan/BinaryScanner.h"
#include "Scan/Buffer.h"
#include "Scan/IdSet.h"
#include "Scan/Progress.h"
#include "Scan/TextLines.h"

#include <vector> // for starts

namespace camaron
{
/// One list, in place.
struct IdList
{
  const char* Ids = nullptr;
  std::int32_t Size = 0;
  std::int32_t Swap = 0; // not bool: copies of a struct with holes are slow
  std::int32_t operator[](std::int32_t i) const
  {
    return Load<std::int32_t>(this->Ids + 4 * std::ptrdiff_t(i), this->Swap != 0);
  }
};

class IdLists
{
public:
  /// What to expect of the lists, and what was seen.
  struct Expectation
  {
    const char* List = "";  ///< what a list is, e.g. "polygon"
    const char* Id = "";    ///< what an id stands for, e.g. "vertex"
    vtkIdType Limit = 0;    ///< ids must be in [0, Limit)
    IdSet* Used = nullptr;  ///< if given, all ids found are added to it
    bool AccessAll = true;  ///< whether operator[] shall work for all lists
    Tally Empty;            ///< lists without ids
    Tally Short;            ///< lists with one or two ids
    Tally Repeating;        ///< lists with the same id twice in a row (cyclically)
  };

  /// Takes @a count lists from a binary file; false with the error in the scanner, or if stopped.
  bool Scan(BinaryScanner& scanner, vtkIdType count, Expectation& expected,
    const Progress& progress);

  /**
   * Takes @a count lists from text; false with the error in the scanner, or if stopped.
   * @param lines of the text if it is large enough to read it in parallel, else nullptr
   * @param dropRest whether the rest of the line after every list is ignored; otherwise only that
   *   after the last one is
   */
  bool Scan(TextScanner& scanner, const TextLines* lines, vtkIdType count, bool dropRest,
    Expectation& expected, const Progress& progress);

  vtkIdType GetCount() const { return this->Count; }
  /// Length of all lists together.
  vtkIdType GetNumberOfIds() const { return this->NumberOfIds; }
  /// The common length of the lists, or -1.
  std::int32_t GetCommonSize() const { return this->CommonSize; }

  /// Calls @a visit(i, list) for all lists in parallel; one thread visits ascending runs.
  template <typename Visit>
  bool ForEach(const Progress& progress, Visit&& visit) const
  {
    const vtkIdType blocks = (this->Count + BlockSize - 1) / BlockSize;
    return progress.For(blocks,
      [&](vtkIdType first, vtkIdType last)
      {
        const vtkIdType end = last * BlockSize < this->Count ? last * BlockSize : this->Count;
        const char* place = this->GetBlock(first);
        for (vtkIdType i = first * BlockSize; i < end; ++i)
        {
          const IdList list = this->At(place);
          visit(i, list);
          place = list.Ids + 4 * std::ptrdiff_t(list.Size);
        }
      });
  }

  /// Calls @a visit(i, list) for all lists in order.
  template <typename Visit>
  void ForEachInOrder(Visit&& visit) const
  {
    const char* place = this->Count > 0 ? this->GetBlock(0) : nullptr;
    for (vtkIdType i = 0; i < this->Count; ++i)
    {
      const IdList list = this->At(place);
      visit(i, list);
      place = list.Ids + 4 * std::ptrdiff_t(list.Size);
    }
  }

  /// Makes operator[] work for the members of @a needed, which must be numbered and stay alive.
  bool MakeRandomAccess(const IdSet& needed, const Progress& progress);

  IdList operator[](vtkIdType i) const
  {
    return this->At(this->CommonSize >= 0 ? this->Data + i * this->Stride : this->Place(i));
  }

  /// Announces that a list will be read soon.
  void Prefetch(vtkIdType i) const
  {
    camaron::Prefetch(this->CommonSize >= 0 ? this->Data + i * this->Stride : this->Place(i));
  }

private:
  static constexpr vtkIdType BlockSize = 1024;

  const char* Place(vtkIdType i) const
  {
    const vtkIdType number = this->Needed ? this->Needed->GetNumber(i) : i;
    return this->Blocks[i / BlockSize] + 4 * std::ptrdiff_t(this->Starts[number]);
  }

  IdList At(const char* place) const
  {
    return { place + 4, Load<std::int32_t>(place, this->Swap), this->Swap };
  }
  const char* GetBlock(vtkIdType block) const
  {
    return this->CommonSize >= 0 ? this->Data + block * BlockSize * this->Stride
                                 : this->Blocks[block];
  }
  bool FindStarts(BinaryScanner& scanner, const char* what);
  enum class Verdict
  {
    Good,
    Bad,   ///< an id is out of range; the error is in the scanner
    Uneven ///< lists that were taken to be of one length are not
  };
  Verdict Check(BinaryScanner& scanner, Expectation& expected, const Progress& progress);
  template <int Size>
  vtkIdType CheckBlocks(vtkIdType firstBlock, vtkIdType lastBlock, Expectation& seen, bool& even);
  bool GuessCommonSize(const BinaryScanner& scanner);
  void FailAtList(BinaryScanner& scanner, vtkIdType bad, const Expectation& expected) const;
  bool ScanLines(TextScanner& scanner, const TextLines& lines, bool dropRest,
    const Expectation& expected, const Progress& progress);
  bool ScanText(TextScanner& scanner, bool dropRest, const Expectation& expected);

  vtkIdType Count = 0;
  vtkIdType NumberOfIds = 0;
  const char* Data = nullptr;
  bool Swap = false;
  std::int32_t CommonSize = -1;
  std::ptrdiff_t Stride = 0; ///< bytes from list to list if all have the common size
  std::vector<const char*> Blocks;
  const IdSet* Needed = nullptr;
  Buffer<std::uint32_t> Starts; ///< words from the start of the block
  Buffer<std::int32_t> Words;   ///< the lists, if they came from text
  std::vector<std::int32_t> GrownWords;
};
}

#endif
