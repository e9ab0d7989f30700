// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetTableBuilder.h"

#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace camaron
{
namespace
{
constexpr vtkIdType CellGrain = 4096;
constexpr vtkIdType UseChunk = 1 << 16;
constexpr vtkIdType MaxUses = vtkIdType(1) << 30; // a use must fit CellFacet with its direction bit
constexpr vtkIdType MaxPoints = (vtkIdType(1) << 31) - 16; // larger values of Extra are marks

constexpr std::uint32_t DownBit = 0x80000000u;
constexpr std::uint32_t HashedBit = 0x80000000u;
constexpr std::uint32_t ThreePoints = 0x7fffffffu;
constexpr std::uint32_t TwoPoints = 0x7ffffffeu;
constexpr std::uint32_t OnePoint = 0x7ffffffdu;

//------------------------------------------------------------------------------
// True when the polygon runs from its smallest point towards the smaller of that point's neighbours;
// so two polygons with the same ring of points have equal signs when they run the same way.
bool RunsDown(const vtkIdType* points, vtkIdType size)
{
  if (size == 2)
  {
    return points[0] > points[1];
  }
  const vtkIdType smallest = std::min_element(points, points + size) - points;
  const vtkIdType next = points[smallest + 1 < size ? smallest + 1 : 0];
  const vtkIdType previous = points[smallest > 0 ? smallest - 1 : size - 1];
  return next > previous;
}

//------------------------------------------------------------------------------
std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ull;
  return hash ^ (hash >> 29);
}

//------------------------------------------------------------------------------
// Turns a point list into sorted distinct points.
template <typename Points>
void SortDistinct(Points& points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

//------------------------------------------------------------------------------
// A facet's bucket, and what tells it from the others there.
struct FacetKey
{
  vtkIdType Smallest;
  std::uint64_t Key;
  std::uint32_t Extra;
  bool Down; // see RunsDown
};

//------------------------------------------------------------------------------
FacetKey MakeKey(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& scratch)
{
  if (size == 3)
  {
    vtkIdType a = points[0], b = points[1], c = points[2];
    if (b < a && b < c)
    {
      a = points[1], b = points[2], c = points[0];
    }
    else if (c < a && c < b)
    {
      a = points[2], b = points[0], c = points[1];
    }
    // Now a is the smallest point, b the next one around the triangle.
    if (a != b && b != c && a != c)
    {
      const bool down = b > c;
      const std::uint64_t low = static_cast<std::uint64_t>(down ? c : b);
      const std::uint64_t high = static_cast<std::uint64_t>(down ? b : c);
      return { a, (low << 32) | high, ThreePoints, down };
    }
  }
  scratch.assign(points, points + size);
  SortDistinct(scratch);
  const vtkIdType smallest = scratch[0];
  const bool down = RunsDown(points, size);
  switch (scratch.size())
  {
    case 1:
      return { smallest, 0, OnePoint, down };
    case 2:
      return { smallest, static_cast<std::uint64_t>(scratch[1]), TwoPoints, down };
    case 3:
    case 4:
      return { smallest,
        (static_cast<std::uint64_t>(scratch[1]) << 32) | static_cast<std::uint64_t>(scratch[2]),
        scratch.size() == 3 ? ThreePoints : static_cast<std::uint32_t>(scratch[3]), down };
    default:
      break;
  }
  std::uint64_t hash = scratch.size();
  for (const vtkIdType point : scratch)
  {
    hash = Mix(hash, static_cast<std::uint64_t>(point));
  }
  return { smallest, hash, HashedBit | static_cast<std::uint32_t>(Mix(hash, 1) >> 33), down };
}

//------------------------------------------------------------------------------
vtkIdType GetSmallest(const vtkIdType* points, vtkIdType size)
{
  if (size == 3)
  {
    return std::min(points[0], std::min(points[1], points[2]));
  }
  return *std::min_element(points, points + size);
}

//------------------------------------------------------------------------------
// Buckets are small: insertion beats everything else there.
template <typename Entry>
void SortByKey(Entry* first, Entry* last)
{
  constexpr int small = 40;
  if (last - first > small)
  {
    std::sort(first, last, [](const Entry& a, const Entry& b) { return a.Key < b.Key; });
    return;
  }
  for (Entry* next = first + 1; next < last; ++next)
  {
    const Entry entry = *next;
    Entry* place = next;
    for (; place != first && entry.Key < place[-1].Key; --place)
    {
      *place = place[-1];
    }
    *place = entry;
  }
}

//------------------------------------------------------------------------------
Index GetUse(std::uint32_t item)
{
  return static_cast<Index>(item & ~DownBit);
}
}

//------------------------------------------------------------------------------
FacetTable FacetTableBuilder::Build(
  const MeshView& mesh, int dimension, const std::vector<Index>& given, Index numberOfGiven)
{
  FacetTableBuilder builder(mesh, dimension);
  builder.CountFacets();
  if (static_cast<Index>(given.size()) == builder.NumberOfUses && !given.empty())
  {
    builder.MatchGiven(given, numberOfGiven);
  }
  else
  {
    builder.MatchUses();
  }
  builder.NumberFacets();
  builder.ListCells();
  return std::move(builder.Table);
}

//------------------------------------------------------------------------------
FacetTableBuilder::FacetTableBuilder(const MeshView& mesh, int dimension)
  : Mesh(mesh)
  , Dimension(dimension)
{
  if (mesh.GetNumberOfPoints() > MaxPoints || mesh.GetNumberOfCells() > MaxUses)
  {
    throw std::length_error("more points or cells in one piece than 32 bit ids can number");
  }
  this->Table.NumberOfCells = static_cast<Index>(mesh.GetNumberOfCells());
}

//------------------------------------------------------------------------------
void FacetTableBuilder::CountFacets()
{
  const vtkIdType numberOfCells = this->Mesh.GetNumberOfCells();
  const CellFacets facets(this->Mesh);
  const auto numberOfFacets = [&](vtkIdType cell)
  { return facets.GetDimension(cell) == this->Dimension ? facets.GetNumberOfFacets(cell) : 0; };

  // Meshes of one type of cell need no offsets.
  const vtkIdType stride = numberOfCells > 0 ? numberOfFacets(0) : 0;
  std::atomic<bool> uniform{ true };
  ParallelFor(numberOfCells, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end && uniform.load(std::memory_order_relaxed); ++cell)
      {
        if (numberOfFacets(cell) != stride)
        {
          uniform = false;
        }
      }
    });
  vtkIdType total = stride * numberOfCells;
  if (uniform && stride > 0)
  {
    this->Table.Stride = static_cast<Index>(stride);
  }
  else
  {
    this->Table.CellOffsets.resize(numberOfCells + 1);
    total = ParallelScan(
      numberOfCells, UseChunk,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkIdType sum = 0;
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          sum += numberOfFacets(cell);
        }
        return sum;
      },
      [&](vtkIdType begin, vtkIdType end, vtkIdType sum)
      {
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          this->Table.CellOffsets[cell] = sum;
          sum += numberOfFacets(cell);
        }
      });
    this->Table.CellOffsets[numberOfCells] = total;
  }
  if (total > MaxUses)
  {
    throw std::length_error("more than 2^30 faces of cells in one piece of a mesh");
  }
  this->NumberOfUses = static_cast<Index>(total);
  this->Table.CellFacets.resize(total);
}

//------------------------------------------------------------------------------
void FacetTableBuilder::MatchUses()
{
  this->Match(this->Mesh.GetNumberOfCells(),
    [this](CellFacets& facets, vtkIdType cell, auto&& visit)
    {
      if (facets.GetDimension(cell) == this->Dimension)
      {
        const vtkIdType first = this->Table.GetOffset(cell);
        facets.ForEach(cell, [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
          { visit(static_cast<std::uint32_t>(first + local), points, size); });
      }
    });
}

//------------------------------------------------------------------------------
void FacetTableBuilder::MatchGiven(const std::vector<Index>& given, Index numberOfGiven)
{
  // Only the first use of every given number is compared with the others.
  std::vector<Index> firstUses(numberOfGiven, -1);
  for (Index use = 0; use < this->NumberOfUses; ++use)
  {
    if (firstUses[given[use]] < 0)
    {
      firstUses[given[use]] = use;
    }
  }
  std::vector<unsigned char> down(this->NumberOfUses);
  this->Match(this->Mesh.GetNumberOfCells(),
    [&](CellFacets& facets, vtkIdType cell, auto&& visit)
    {
      if (facets.GetDimension(cell) == this->Dimension)
      {
        const vtkIdType first = this->Table.GetOffset(cell);
        facets.ForEach(cell,
          [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
          {
            const Index use = static_cast<Index>(first + local);
            down[use] = RunsDown(points, size);
            if (firstUses[given[use]] == use)
            {
              visit(static_cast<std::uint32_t>(use), points, size);
            }
          });
      }
    });
  ParallelFor(this->NumberOfUses, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<CellFacet>& uses = this->Table.CellFacets;
      for (vtkIdType use = begin; use < end; ++use)
      {
        const Index first = firstUses[given[use]];
        if (first != use)
        {
          const Index leader = uses[first].Facet();
          uses[use] = CellFacet(leader, down[use] != down[leader]);
        }
      }
    });
}

//------------------------------------------------------------------------------
// Leaves in CellFacets for every visited item the first use with the same points.
template <typename ForEachItem>
void FacetTableBuilder::Match(vtkIdType numberOfCells, ForEachItem&& forEachItem)
{
  const vtkIdType numberOfPoints = this->Mesh.GetNumberOfPoints();
  std::unique_ptr<std::atomic<Index>[]> ends(new std::atomic<Index>[numberOfPoints + 1]);
  ParallelFor(numberOfPoints + 1, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        std::atomic_init(&ends[point], 0);
      }
    });
  ParallelFor(numberOfCells, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(this->Mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        forEachItem(facets, cell,
          [&](std::uint32_t, const vtkIdType* points, vtkIdType size)
          {
            if (size > 0)
            {
              ends[GetSmallest(points, size)].fetch_add(1, std::memory_order_relaxed);
            }
          });
      }
    });
  // From counts to the begin of every bucket; filling it moves this on to the bucket's end.
  Index total = 0;
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    const Index count = ends[point].load(std::memory_order_relaxed);
    ends[point].store(total, std::memory_order_relaxed);
    total += count;
  }

  std::unique_ptr<Entry[]> entries(new Entry[total]);
  ParallelFor(numberOfCells, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(this->Mesh);
      std::vector<vtkIdType> scratch;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        forEachItem(facets, cell,
          [&](std::uint32_t use, const vtkIdType* points, vtkIdType size)
          {
            if (size == 0)
            {
              this->Table.CellFacets[use] = CellFacet(static_cast<Index>(use), false);
              return;
            }
            const FacetKey key = MakeKey(points, size, scratch);
            entries[ends[key.Smallest].fetch_add(1, std::memory_order_relaxed)] = { key.Key, key.Extra,
              use | (key.Down ? DownBit : 0u) };
          });
      }
    });
  ParallelFor(numberOfPoints, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const Index first = point > 0 ? ends[point - 1].load(std::memory_order_relaxed) : 0;
        this->MatchBucket(entries.get() + first, entries.get() + ends[point].load());
      }
    });
}

//------------------------------------------------------------------------------
void FacetTableBuilder::MatchBucket(Entry* first, Entry* last)
{
  SortByKey(first, last);
  while (first != last)
  {
    Entry* runEnd = first + 1;
    while (runEnd != last && runEnd->Key == first->Key)
    {
      ++runEnd;
    }
    if (runEnd - first > 1)
    {
      std::sort(first, runEnd,
        [](const Entry& a, const Entry& b)
        { return a.Extra != b.Extra ? a.Extra < b.Extra : GetUse(a.Item) < GetUse(b.Item); });
    }
    // The entries that are the same facet as *first come to the front of those that may be.
    Entry* sameEnd = first + 1;
    while (sameEnd != runEnd && sameEnd->Extra == first->Extra)
    {
      ++sameEnd;
    }
    if ((first->Extra & HashedBit) && sameEnd - first > 1)
    {
      sameEnd = std::stable_partition(first + 1, sameEnd, [&](const Entry& entry)
        { return this->HaveSamePoints(GetUse(first->Item), GetUse(entry.Item)); });
    }
    const Index leader = GetUse(first->Item);
    for (const Entry* entry = first; entry != sameEnd; ++entry)
    {
      this->Table.CellFacets[GetUse(entry->Item)] =
        CellFacet(leader, ((entry->Item ^ first->Item) & DownBit) != 0);
    }
    first = sameEnd;
  }
}

//------------------------------------------------------------------------------
void FacetTableBuilder::GetSortedPoints(Index use, std::vector<vtkIdType>& points) const
{
  vtkIdType cell = 0;
  if (this->Table.Stride)
  {
    cell = use / this->Table.Stride;
  }
  else
  {
    const auto& offsets = this->Table.CellOffsets;
    cell = std::upper_bound(offsets.begin(), offsets.end(), vtkIdType(use)) - offsets.begin() - 1;
  }
  const vtkIdType wanted = use - this->Table.GetOffset(cell);
  points.clear();
  CellFacets(this->Mesh).GetFacet(cell, wanted, points);
  SortDistinct(points);
}

//------------------------------------------------------------------------------
bool FacetTableBuilder::HaveSamePoints(Index use0, Index use1) const
{
  thread_local std::vector<vtkIdType> points0, points1;
  this->GetSortedPoints(use0, points0);
  this->GetSortedPoints(use1, points1);
  return points0 == points1;
}

//------------------------------------------------------------------------------
// From "first use with the same points" to consecutive facet numbers.
void FacetTableBuilder::NumberFacets()
{
  std::vector<CellFacet>& uses = this->Table.CellFacets;
  const vtkIdType size = this->NumberOfUses;
  // Numbered leaders are kept as complements, and so told from uses that still name their leader.
  const vtkIdType numberOfFacets = ParallelScan(
    size, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType leaders = 0;
      for (vtkIdType use = begin; use < end; ++use)
      {
        leaders += uses[use].Facet() == use;
      }
      return leaders;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType number)
    {
      for (vtkIdType use = begin; use < end; ++use)
      {
        if (uses[use].Facet() == use)
        {
          uses[use].Packed = ~CellFacet(static_cast<Index>(number++), false).Packed;
        }
      }
    });
  ParallelFor(size, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType use = begin; use < end; ++use)
      {
        if (uses[use].Packed >= 0)
        {
          const CellFacet toLeader = uses[use];
          uses[use].Packed = ~uses[toLeader.Facet()].Packed | (toLeader.IsReversed() ? 1 : 0);
        }
      }
    });
  this->Table.FacetCells.resize(numberOfFacets);
}

//------------------------------------------------------------------------------
// Owners first, so that every further use finds the owner of its facet.
void FacetTableBuilder::ListCells()
{
  FacetTable& table = this->Table;
  ParallelFor(table.NumberOfCells, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType last = table.GetOffset(cell + 1);
        for (vtkIdType use = table.GetOffset(cell); use < last; ++use)
        {
          CellFacet& facet = table.CellFacets[use];
          if (facet.Packed < 0)
          {
            facet.Packed = ~facet.Packed;
            table.FacetCells[facet.Facet()].First = static_cast<Index>(cell);
          }
          else
          {
            facet.Packed = -2 - facet.Packed; // marked as a further use until the next pass
          }
        }
      }
    });
  const vtkIdType numberOfFacets = table.GetNumberOfFacets();
  std::unique_ptr<std::atomic<Index>[]> seconds(new std::atomic<Index>[numberOfFacets]);
  ParallelFor(numberOfFacets, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType facet = begin; facet < end; ++facet)
      {
        std::atomic_init(&seconds[facet], -1);
      }
    });
  std::mutex extraMutex;
  ParallelFor(table.NumberOfCells, CellGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType last = table.GetOffset(cell + 1);
        for (vtkIdType use = table.GetOffset(cell); use < last; ++use)
        {
          CellFacet& facet = table.CellFacets[use];
          if (facet.Packed < 0)
          {
            facet.Packed = -2 - facet.Packed;
            // Threads may meet at a facet with more than two cells; all but one cell go to the extra
            // list, which is put in order below.
            Index none = -1;
            if (!seconds[facet.Facet()].compare_exchange_strong(
                  none, static_cast<Index>(cell), std::memory_order_relaxed))
            {
              const std::lock_guard<std::mutex> lock(extraMutex);
              table.ExtraCells.push_back({ facet.Facet(), static_cast<Index>(cell) });
            }
          }
        }
      }
    });
  ParallelFor(numberOfFacets, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType facet = begin; facet < end; ++facet)
      {
        table.FacetCells[facet].Second = seconds[facet].load(std::memory_order_relaxed);
      }
    });
  for (FacetTable::ExtraCell& extra : table.ExtraCells)
  {
    Index& second = table.FacetCells[extra.Facet].Second;
    if (extra.Cell < second)
    {
      std::swap(extra.Cell, second);
    }
  }
  std::sort(table.ExtraCells.begin(), table.ExtraCells.end(),
    [](const FacetTable::ExtraCell& a, const FacetTable::ExtraCell& b)
    { return a.Facet != b.Facet ? a.Facet < b.Facet : a.Cell < b.Cell; });
}
}
