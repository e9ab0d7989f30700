// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetMatcher.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Whether one ring of points is the other one, in the same direction or against it.
bool IsSameRing(const vtkIdType* a, const vtkIdType* b, vtkIdType size)
{
  const vtkIdType start = std::find(b, b + size, a[0]) - b;
  if (start == size)
  {
    return false;
  }
  bool isSame = true, isReversed = true;
  vtkIdType forward = start, backward = start;
  for (vtkIdType i = 0; i < size; ++i)
  {
    isSame &= a[i] == b[forward];
    isReversed &= a[i] == b[backward];
    forward = forward + 1 < size ? forward + 1 : 0;
    backward = backward > 0 ? backward - 1 : size - 1;
  }
  return isSame || isReversed;
}
}

//------------------------------------------------------------------------------
void FacetMatcher::Match(const Index* uses, Index size)
{
  this->LoadEntries(uses, size);
  int bits = 1;
  while ((Index(1) << bits) < size)
  {
    ++bits;
  }
  this->Lists.assign(std::size_t(2) << bits, -1);
  for (Index i = 0; i < size; ++i)
  {
    Entry& entry = this->Entries[i];
    Index& list = this->Lists[entry.Hash >> (63 - bits)];
    Index found = list;
    while (found >= 0 && !this->IsSame(this->Entries[found], entry))
    {
      found = this->Entries[found].Next;
    }
    CellFacet& use = this->Table.CellFacets[uses[i]];
    if (found >= 0)
    {
      const bool isReversed = this->Entries[found].Key.Down != entry.Key.Down;
      use.Packed = ~CellFacet(uses[found], isReversed).Packed;
      continue;
    }
    entry.Next = list;
    list = i;
    use = CellFacet(uses[i], false);
  }
}

//------------------------------------------------------------------------------
void FacetMatcher::MatchHashed(const Index* uses, Index size)
{
  this->FindAlike(uses, size);
  this->Alike.clear();
  for (Index i = 0; i < size; ++i)
  {
    if (this->IsAlike[i])
    {
      this->Alike.push_back(uses[i]);
    }
    else
    {
      this->Table.CellFacets[uses[i]] = CellFacet(uses[i], false);
    }
  }
  this->Match(this->Alike.data(), static_cast<Index>(this->Alike.size()));
}

//------------------------------------------------------------------------------
void FacetMatcher::FindAlike(const Index* uses, Index size)
{
  this->IsAlike.assign(size, 0);
  std::size_t slots = 2;
  while (slots < 2 * static_cast<std::size_t>(size))
  {
    slots *= 2;
  }
  this->Lists.assign(slots, -1);
  for (Index i = 0; i < size; ++i)
  {
    // The upper bits are those of the bucket.
    const Index hash = this->Table.CellFacets[uses[i]].Packed;
    std::size_t slot = static_cast<std::size_t>(hash) & (slots - 1);
    while (this->Lists[slot] >= 0 && this->Table.CellFacets[uses[this->Lists[slot]]].Packed != hash)
    {
      slot = (slot + 1) & (slots - 1);
    }
    if (this->Lists[slot] < 0)
    {
      this->Lists[slot] = i;
    }
    else
    {
      this->IsAlike[this->Lists[slot]] = this->IsAlike[i] = 1;
    }
  }
}

//------------------------------------------------------------------------------
void FacetMatcher::LoadEntries(const Index* uses, Index size)
{
  this->Entries.resize(size);
  this->Points.clear();
  vtkIdType cell = 0;
  for (Index i = 0; i < size; ++i)
  {
    cell = this->FindCell(uses[i], cell);
    this->Facets.Visit(cell, uses[i] - this->Table.GetOffset(cell),
      [&](const vtkIdType* points, vtkIdType numberOfPoints)
      { this->Load(this->Entries[i], points, numberOfPoints); });
  }
}

//------------------------------------------------------------------------------
void FacetMatcher::Load(Entry& entry, const vtkIdType* points, vtkIdType size)
{
  FacetKey& key = entry.Key;
  MakeKey(points, size, this->Sorted, key);
  entry.Hash = key.GetHash();
  if (key.IsHashed())
  {
    entry.Begin = static_cast<vtkIdType>(this->Points.size());
    entry.Size = size;
    this->Points.insert(this->Points.end(), points, points + size);
  }
}

//------------------------------------------------------------------------------
// Each however often.
bool FacetMatcher::HaveSamePoints(const Entry& a, const Entry& b) const
{
  const vtkIdType *first = this->Points.data() + a.Begin, *second = this->Points.data() + b.Begin;
  if (a.Size == b.Size && IsSameRing(first, second, a.Size))
  {
    return true;
  }
  std::vector<vtkIdType> firsts(first, first + a.Size), seconds(second, second + b.Size);
  SortDistinct(firsts);
  SortDistinct(seconds);
  return firsts == seconds;
}

//------------------------------------------------------------------------------
// The cell of a use, in larger and larger steps from one that is not behind it.
vtkIdType FacetMatcher::FindCell(Index use, vtkIdType from) const
{
  const FacetTable& table = this->Table;
  if (table.Stride)
  {
    return use / table.Stride;
  }
  const auto begin = table.CellOffsets.begin() + from, end = table.CellOffsets.end();
  vtkIdType step = 1;
  while (step < end - begin && begin[step] <= use)
  {
    step *= 2;
  }
  const auto next = std::upper_bound(begin + step / 2, begin + std::min<vtkIdType>(step, end - begin), use);
  return next - table.CellOffsets.begin() - 1;
}
}
