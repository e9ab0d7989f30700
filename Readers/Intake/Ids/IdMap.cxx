// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/Ids/IdMap.h"

#include "Base/Parallel.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <mutex>

namespace camaron
{
//------------------------------------------------------------------------------
void IdMap::Build(const std::int32_t* ids, vtkIdType size)
{
  *this = IdMap();
  if (size == 0)
  {
    return;
  }
  std::mutex mutex;
  std::int32_t least = ids[0], greatest = ids[0];
  bool ascending = true;
  ParallelFor(size, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::int32_t low = ids[begin], high = ids[begin];
      bool good = begin == 0 || ids[begin - 1] < ids[begin];
      for (vtkIdType i = begin + 1; i < end; ++i)
      {
        low = std::min(low, ids[i]);
        high = std::max(high, ids[i]);
        good = good && ids[i - 1] < ids[i];
      }
      const std::lock_guard<std::mutex> lock(mutex);
      least = std::min(least, low);
      greatest = std::max(greatest, high);
      ascending = ascending && good;
    });
  this->Least = least;
  this->Span = std::int64_t(greatest) - least + 1;
  constexpr std::int64_t MaxGap = 4; // words of the table per id
  if (ascending && this->Span == size)
  {
    this->Form = Storage::Sequence;
  }
  else if (this->Span <= MaxGap * size)
  {
    this->Form = Storage::Table;
    this->FillTable(ids, size);
  }
  else
  {
    this->Form = Storage::Sorted;
    this->Sort(ids, size, ascending);
  }
}

//------------------------------------------------------------------------------
void IdMap::FillTable(const std::int32_t* ids, vtkIdType size)
{
  this->Table = Buffer<std::int32_t>(this->Span);
  ParallelFor(this->Span, LightGrain, [this](vtkIdType begin, vtkIdType end)
    { std::fill(this->Table.data() + begin, this->Table.data() + end, -1); });
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::int32_t& position = this->Table[ids[i] - this->Least];
    this->Repeated += position >= 0;
    position = static_cast<std::int32_t>(i);
  }
}

//------------------------------------------------------------------------------
void IdMap::Sort(const std::int32_t* ids, vtkIdType size, bool ascending)
{
  this->Entries = Buffer<Entry>(size);
  Entry* const entries = this->Entries.data();
  for (vtkIdType i = 0; i < size; ++i)
  {
    entries[i] = { ids[i], static_cast<std::int32_t>(i) };
  }
  this->NumberOfEntries = size;
  if (!ascending)
  {
    WithThreads(
      [&]
      {
        vtkSMPTools::Sort(entries, entries + size, [](const Entry& a, const Entry& b)
          { return a.Id != b.Id ? a.Id < b.Id : a.Position < b.Position; });
      });
    vtkIdType kept = 0;
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (i + 1 == size || entries[i + 1].Id != entries[i].Id)
      {
        entries[kept++] = entries[i];
      }
    }
    this->Repeated = size - kept;
    this->NumberOfEntries = kept;
  }
  while (this->Span >> this->Shift >= this->NumberOfEntries)
  {
    ++this->Shift;
  }
  const std::int64_t parts = (this->Span >> this->Shift) + 1;
  this->Table = Buffer<std::int32_t>(parts + 1);
  vtkIdType next = 0;
  for (std::int64_t part = 0; part <= parts; ++part)
  {
    while (next < this->NumberOfEntries && (entries[next].Id - this->Least) >> this->Shift < part)
    {
      ++next;
    }
    this->Table[part] = static_cast<std::int32_t>(next);
  }
}

//------------------------------------------------------------------------------
std::int32_t IdMap::Search(std::int64_t id) const
{
  const std::int64_t part = (id - this->Least) >> this->Shift;
  const Entry* const begin = this->Entries.data() + this->Table[part];
  const Entry* const end = this->Entries.data() + this->Table[part + 1];
  const Entry* const found = std::lower_bound(
    begin, end, id, [](const Entry& entry, std::int64_t i) { return entry.Id < i; });
  return found < end && found->Id == id ? found->Position : -1;
}
}
