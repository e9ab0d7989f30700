// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::IdMap
 * @brief Finds the position of an id in a list of arbitrary positive ids.
 *
 * Files number their items arbitrarily, mostly consecutively, sometimes with gaps, and damaged
 * files may contain any number. Consecutive ascending ids need no memory, ids with few gaps a
 * table with one word per id between the smallest and the largest, all others a sorted list with a
 * table of its parts. Memory is at most 16 bytes per id in all cases.
 */
#ifndef camaron_IdMap_h
#define camaron_IdMap_h

#include "Base/Buffer.h"

#include <cstdint> // for integers of known size

namespace camaron
{
class IdMap
{
public:
  /// Maps the ids to their positions; of repeated ids, the last counts.
  void Build(const std::int32_t* ids, vtkIdType size);

  /// Position of an id, or -1.
  std::int32_t Find(std::int64_t id) const
  {
    // Unsigned, so that ids below the smallest are beyond the span as well.
    const std::uint64_t place =
      static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(this->Least);
    if (place >= static_cast<std::uint64_t>(this->Span))
    {
      return -1;
    }
    if (this->Form == Storage::Sequence)
    {
      return static_cast<std::int32_t>(place);
    }
    return this->Form == Storage::Table ? this->Table[static_cast<vtkIdType>(place)]
                                        : this->Search(id);
  }

  /// Number of ids that occur again later in the list.
  vtkIdType GetNumberOfRepeated() const { return this->Repeated; }
  ///@{
  /// Range of the ids; 1 to 0 if there are none.
  std::int64_t GetLeast() const { return this->Least; }
  std::int64_t GetGreatest() const { return this->Least + this->Span - 1; }
  ///@}

private:
  enum class Storage
  {
    Sequence,
    Table,
    Sorted
  };
  struct Entry
  {
    std::int32_t Id;
    std::int32_t Position;
  };
  std::int32_t Search(std::int64_t id) const;
  void FillTable(const std::int32_t* ids, vtkIdType size);
  void Sort(const std::int32_t* ids, vtkIdType size, bool ascending);

  Storage Form = Storage::Sequence;
  std::int64_t Least = 1;
  std::int64_t Span = 0;
  vtkIdType Repeated = 0;
  Buffer<std::int32_t> Table; ///< positions by id, or where the parts of the sorted list begin
  Buffer<Entry> Entries;
  vtkIdType NumberOfEntries = 0;
  int Shift = 0; ///< number of bits of an id within a part
};
}

#endif
