// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetMatcher.h"

#include "Geometry/FacetRing.h"

#include <algorithm>
#include <vector>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
template <typename Points>
bool RunsDown(const Points& points)
{
  return RingRunsDown(points.Size, [&points](vtkIdType i) { return points[i]; });
}

//------------------------------------------------------------------------------
template <typename Points>
std::vector<vtkIdType> GetDistinct(const Points& points)
{
  std::vector<vtkIdType> distinct;
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    distinct.push_back(points[i]);
  }
  SortDistinct(distinct);
  return distinct;
}

//------------------------------------------------------------------------------
// Whether two facets have the same points, in any order and with any repetitions. Nearly always
// they are the same ring, in either direction; if that is not certain, areOtherRings is set.
template <typename Points>
bool AreSameFacets(const Points& a, const Points& b, bool& isReversed, bool& areOtherRings)
{
  const vtkIdType size = a.Size;
  if (size == 2 && b.Size == 2)
  {
    isReversed = a[0] != b[0];
    return std::min(a[0], a[1]) == std::min(b[0], b[1]) &&
      std::max(a[0], a[1]) == std::max(b[0], b[1]);
  }
  if (size == b.Size)
  {
    vtkIdType start = 0;
    int found = 0; // a ring with a repeated point could begin at either occurrence
    for (vtkIdType i = 0; i < size; ++i)
    {
      const bool isFirst = b[i] == a[0];
      start = isFirst ? i : start;
      found += isFirst;
    }
    bool isSame = found == 1, isOpposite = isSame;
    vtkIdType forward = start, backward = start;
    for (vtkIdType i = 1; i < size; ++i)
    {
      forward = forward + 1 < size ? forward + 1 : 0;
      backward = backward > 0 ? backward - 1 : size - 1;
      isSame &= a[i] == b[forward];
      isOpposite &= a[i] == b[backward];
    }
    if (isSame != isOpposite)
    {
      isReversed = isOpposite;
      return true;
    }
  }
  isReversed = RunsDown(a) != RunsDown(b);
  const bool areSame = GetDistinct(a) == GetDistinct(b);
  areOtherRings |= areSame;
  return areSame;
}
}

//------------------------------------------------------------------------------
void FacetMatcher::Match(const Index* uses, Index size)
{
  this->FindAlike(uses, size);
  this->Cells.resize(size);
  this->Nexts.assign(size, -1);
  vtkIdType cell = 0;
  for (Index i = 0; i < size; ++i)
  {
    if (this->AreAlike[i])
    {
      cell = this->FindCell(uses[i], cell);
      this->Cells[i] = static_cast<Index>(cell);
    }
    CellFacet& facet = this->Table.CellFacets[uses[i]];
    facet = CellFacet(uses[i], false);
    for (Index other = this->Firsts[i]; other != i;)
    {
      bool isReversed = false;
      if (this->AreSame(uses[i], uses[other], cell, this->Cells[other], isReversed))
      {
        facet.Packed = ~CellFacet(uses[other], isReversed).Packed;
        break;
      }
      Index& next = this->Nexts[other];
      next = next < 0 ? i : next;
      other = next;
    }
  }
}

//------------------------------------------------------------------------------
void FacetMatcher::FindAlike(const Index* uses, Index size)
{
  this->Hashes.resize(size);
  this->Firsts.resize(size);
  this->AreAlike.assign(size, 0);
  std::size_t mask = 1;
  while (mask < 2 * static_cast<std::size_t>(size))
  {
    mask = 2 * mask + 1;
  }
  this->Slots.assign(mask + 1, -1);
  for (Index i = 0; i < size; ++i)
  {
    const Index hash = this->Table.CellFacets[uses[i]].Packed;
    this->Hashes[i] = hash;
    std::size_t slot = static_cast<std::size_t>(hash) & mask; // the upper bits select the bucket
    while (this->Slots[slot] >= 0 && this->Hashes[this->Slots[slot]] != hash)
    {
      slot = (slot + 1) & mask;
    }
    Index& first = this->Slots[slot];
    const bool isFirst = first < 0;
    first = isFirst ? i : first;
    this->Firsts[i] = first;
    this->AreAlike[i] = !isFirst;
    this->AreAlike[first] |= !isFirst;
  }
}

//------------------------------------------------------------------------------
bool FacetMatcher::AreSame(
  Index use, Index other, vtkIdType cell, vtkIdType otherCell, bool& isReversed)
{
  const vtkIdType local = use - this->Table.GetOffset(cell),
                  otherLocal = other - this->Table.GetOffset(otherCell);
  if (this->Facets.ListsFacets(cell) && this->Facets.ListsFacets(otherCell))
  {
    return AreSameFacets(this->Facets.GetListedFacet(cell, local),
      this->Facets.GetListedFacet(otherCell, otherLocal), isReversed, this->MatchesOtherRings);
  }
  bool areSame = false;
  this->Facets.Visit(cell, local,
    [&](const vtkIdType* points, vtkIdType size)
    {
      this->OtherFacets.Visit(otherCell, otherLocal,
        [&](const vtkIdType* otherPoints, vtkIdType otherSize)
        {
          areSame = AreSameFacets(FacetPoints{ points, size },
            FacetPoints{ otherPoints, otherSize }, isReversed, this->MatchesOtherRings);
        });
    });
  return areSame;
}

//------------------------------------------------------------------------------
// The cell of a use, by a search in growing steps from a cell that is not after it.
vtkIdType FacetMatcher::FindCell(Index use, vtkIdType from) const
{
  const FacetTable& table = this->Table;
  if (table.Stride)
  {
    return static_cast<vtkIdType>(
      (use + 0.5) * this->CellsPerUse); // same result as a division, but faster
  }
  const auto begin = table.CellOffsets.begin() + from, end = table.CellOffsets.end();
  vtkIdType step = 1;
  while (step < end - begin && begin[step] <= use)
  {
    step *= 2;
  }
  const auto next =
    std::upper_bound(begin + step / 2, begin + std::min<vtkIdType>(step, end - begin), use);
  return next - table.CellOffsets.begin() - 1;
}
}
