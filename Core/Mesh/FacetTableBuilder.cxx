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
constexpr vtkIdType MaxPoints = (vtkIdType(1) << 31) - 16; // larger values mark keys

constexpr Index UsesPerBucket = 4096; // what a processor has in its cache with the hash table of the bucket
constexpr Index MaxBuckets = 4096;    // into which a thread writes at the same time
constexpr vtkIdType BucketGrain = 8;
constexpr vtkIdType MaxChunks = 64; // of cells

constexpr vtkIdType MaxUnsorted = 12; // points of a facet that are compared pair by pair

// Values of the last part of a key where it is not the fourth point.
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
  vtkIdType smallest = 0;
  for (vtkIdType i = 1; i < size; ++i)
  {
    smallest = points[i] < points[smallest] ? i : smallest;
  }
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
bool HasRepeatedPoints(const vtkIdType* points, vtkIdType size)
{
  bool isRepeated = false;
  for (vtkIdType i = 1; i < size; ++i)
  {
    for (vtkIdType j = 0; j < i; ++j)
    {
      isRepeated |= points[i] == points[j];
    }
  }
  return isRepeated;
}

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

//------------------------------------------------------------------------------
vtkIdType GetSmallest(const vtkIdType* points, vtkIdType size)
{
  if (size == 3)
  {
    return std::min(points[0], std::min(points[1], points[2]));
  }
  vtkIdType smallest = points[0];
  for (vtkIdType i = 1; i < size; ++i)
  {
    smallest = std::min(smallest, points[i]);
  }
  return smallest;
}

//------------------------------------------------------------------------------
// What tells a facet from others: the smallest of its points, and of up to four points the other ones, of more a hash.
struct FacetKey
{
  std::uint32_t Smallest;
  std::uint32_t Parts[3];
  bool Down; // see RunsDown
  bool IsHashed() const { return (this->Parts[2] & HashedBit) != 0; }
};

std::uint32_t Part(vtkIdType id)
{
  return static_cast<std::uint32_t>(id);
}

void Order(vtkIdType& low, vtkIdType& high)
{
  const vtkIdType smaller = std::min(low, high);
  high = std::max(low, high);
  low = smaller;
}

//------------------------------------------------------------------------------
// Of more than four different points, in whatever order.
FacetKey MakeHashedKey(const vtkIdType* points, vtkIdType size, bool down)
{
  std::uint64_t sum = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    sum += Mix(1, static_cast<std::uint64_t>(points[i]));
  }
  const std::uint64_t hash = Mix(sum, static_cast<std::uint64_t>(size));
  return { Part(GetSmallest(points, size)),
    { static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32),
      HashedBit | static_cast<std::uint32_t>(Mix(hash, 1) >> 33) },
    down };
}

//------------------------------------------------------------------------------
// Sorting is for the rare facets that come to a point twice. Of others its branches would be as hard to foresee as
// the numbering of the points.
FacetKey MakeKeyOfAny(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& sorted)
{
  const bool down = RunsDown(points, size);
  if (size > 4 && size <= MaxUnsorted && !HasRepeatedPoints(points, size))
  {
    return MakeHashedKey(points, size, down);
  }
  if (size == 4)
  {
    vtkIdType a = points[0], b = points[1], c = points[2], d = points[3];
    Order(a, b), Order(c, d), Order(a, c), Order(b, d), Order(b, c);
    if (a != b && b != c && c != d)
    {
      return { Part(a), { Part(b), Part(c), Part(d) }, down };
    }
  }
  sorted.assign(points, points + size);
  SortDistinct(sorted);
  const std::uint32_t smallest = Part(sorted[0]);
  switch (sorted.size())
  {
    case 1:
      return { smallest, { 0, 0, OnePoint }, down };
    case 2:
      return { smallest, { Part(sorted[1]), 0, TwoPoints }, down };
    case 3:
      return { smallest, { Part(sorted[1]), Part(sorted[2]), ThreePoints }, down };
    case 4:
      return { smallest, { Part(sorted[1]), Part(sorted[2]), Part(sorted[3]) }, down };
    default:
      return MakeHashedKey(sorted.data(), static_cast<vtkIdType>(sorted.size()), down);
  }
}

//------------------------------------------------------------------------------
inline FacetKey MakeKey(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& scratch)
{
  if (size == 3)
  {
    // An odd number of inversions means that the triangle runs from its smallest point to the largest one.
    const vtkIdType a = points[0], b = points[1], c = points[2];
    const vtkIdType low = std::min(a, std::min(b, c)), high = std::max(a, std::max(b, c));
    const vtkIdType middle = a + b + c - low - high;
    const bool down = (a > b) ^ (b > c) ^ (a > c);
    if (low != middle && middle != high)
    {
      return { Part(low), { Part(middle), Part(high), ThreePoints }, down };
    }
  }
  return MakeKeyOfAny(points, size, scratch);
}
}

//------------------------------------------------------------------------------
// Uses by runs of smallest points, and in order within each.
struct FacetTableBuilder::Buckets
{
  std::unique_ptr<Index[]> Uses;
  std::vector<Index> Begins;
};

//------------------------------------------------------------------------------
// Compares the uses of one bucket after the other. Holds its memory for the next bucket.
class FacetTableBuilder::BucketMatcher
{
public:
  explicit BucketMatcher(FacetTableBuilder& builder)
    : Table(builder.Table)
    , Facets(builder.Mesh)
  {
  }

  void Match(const Index* uses, Index size)
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

private:
  struct Entry
  {
    FacetKey Key;
    std::uint64_t Hash;
    vtkIdType Begin, Size; // in Points, if the key is hashed
    Index Next;            // with the same hash
  };

  void LoadEntries(const Index* uses, Index size)
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

  void Load(Entry& entry, const vtkIdType* points, vtkIdType size)
  {
    const FacetKey key = MakeKey(points, size, this->Sorted);
    entry.Key = key;
    entry.Hash = Mix(Mix(1, Join(key.Smallest, key.Parts[0])), Join(key.Parts[1], key.Parts[2]));
    if (key.IsHashed())
    {
      entry.Begin = static_cast<vtkIdType>(this->Points.size());
      entry.Size = size;
      this->Points.insert(this->Points.end(), points, points + size);
    }
  }

  static std::uint64_t Join(std::uint32_t a, std::uint32_t b)
  {
    return static_cast<std::uint64_t>(a) << 32 | b;
  }

  bool IsSame(const Entry& a, const Entry& b) const
  {
    const std::uint32_t *first = a.Key.Parts, *second = b.Key.Parts;
    return a.Key.Smallest == b.Key.Smallest && first[0] == second[0] && first[1] == second[1] &&
      first[2] == second[2] && (!a.Key.IsHashed() || this->HaveSamePoints(a, b));
  }

  /// Each however often.
  bool HaveSamePoints(const Entry& a, const Entry& b) const
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

  /// The cell of a use, in larger and larger steps from one that is not behind it.
  vtkIdType FindCell(Index use, vtkIdType from) const
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

  FacetTable& Table;
  CellFacets Facets;
  std::vector<Entry> Entries;
  std::vector<Index> Lists; // of entries with the same hash
  std::vector<vtkIdType> Points, Sorted;
};

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
  CellFacet none;
  none.Packed = -1;
  this->Table.CellFacets.assign(total, none);
}

//------------------------------------------------------------------------------
void FacetTableBuilder::MatchUses()
{
  this->Match(
    [this](CellFacets& facets, vtkIdType cell, auto&& visit)
    {
      if (facets.GetDimension(cell) == this->Dimension)
      {
        const vtkIdType first = this->Table.GetOffset(cell);
        facets.ForEach(cell, [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
          { visit(static_cast<Index>(first + local), points, size); });
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
  this->Match(
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
              visit(use, points, size);
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
          const Index leader = this->GetLeader(first).Facet();
          uses[use].Packed = ~CellFacet(leader, down[use] != down[leader]).Packed;
        }
      }
    });
}

//------------------------------------------------------------------------------
// Leaves in CellFacets for every visited item the first use with the same points: itself, or the complement of
// another one.
template <typename ForEachItem>
void FacetTableBuilder::Match(ForEachItem&& forEachItem)
{
  const Buckets buckets = this->FillBuckets(forEachItem);
  ParallelFor(static_cast<vtkIdType>(buckets.Begins.size()) - 1, BucketGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      BucketMatcher matcher(*this);
      for (vtkIdType bucket = begin; bucket < end; ++bucket)
      {
        const Index first = buckets.Begins[bucket];
        matcher.Match(buckets.Uses.get() + first, buckets.Begins[bucket + 1] - first);
      }
    });
}

//------------------------------------------------------------------------------
// Every use gets its smallest point first, which says how much every chunk of cells puts into every bucket.
template <typename ForEachItem>
FacetTableBuilder::Buckets FacetTableBuilder::FillBuckets(ForEachItem&& forEachItem)
{
  const vtkIdType numberOfCells = this->Mesh.GetNumberOfCells();
  const Index numberOfPoints = static_cast<Index>(this->Mesh.GetNumberOfPoints());
  int shift = 0;
  while (numberOfPoints >> shift >= std::min(MaxBuckets, this->NumberOfUses / UsesPerBucket + 1))
  {
    ++shift;
  }
  const Index numberOfBuckets = (numberOfPoints >> shift) + 1;
  const vtkIdType chunk = std::max(CellGrain, numberOfCells / MaxChunks + 1);
  const vtkIdType numberOfChunks = (numberOfCells + chunk - 1) / chunk;
  std::vector<std::vector<Index>> ends(numberOfChunks, std::vector<Index>(numberOfBuckets, 0));
  std::vector<CellFacet>& smallest = this->Table.CellFacets; // -1 where there is none
  const auto forEachChunk = [&](auto&& function)
  {
    ParallelFor(numberOfChunks, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          function(ends[c], c * chunk, std::min(numberOfCells, (c + 1) * chunk));
        }
      });
  };

  forEachChunk(
    [&](std::vector<Index>& sizes, vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(this->Mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        forEachItem(facets, cell,
          [&](Index use, const vtkIdType* points, vtkIdType size)
          {
            if (size > 0)
            {
              smallest[use].Packed = static_cast<Index>(GetSmallest(points, size));
              ++sizes[smallest[use].Packed >> shift];
            }
          });
      }
    });
  Buckets buckets;
  buckets.Begins.resize(numberOfBuckets + 1);
  Index total = 0;
  for (Index bucket = 0; bucket < numberOfBuckets; ++bucket)
  {
    buckets.Begins[bucket] = total;
    for (std::vector<Index>& sizes : ends)
    {
      total += std::exchange(sizes[bucket], total);
    }
  }
  buckets.Begins[numberOfBuckets] = total;
  buckets.Uses.reset(new Index[total]);
  forEachChunk(
    [&](std::vector<Index>& places, vtkIdType begin, vtkIdType end)
    {
      const Index last = static_cast<Index>(this->Table.GetOffset(end));
      for (Index use = static_cast<Index>(this->Table.GetOffset(begin)); use < last; ++use)
      {
        if (smallest[use].Packed >= 0)
        {
          buckets.Uses[places[smallest[use].Packed >> shift]++] = use;
        }
        else
        {
          smallest[use] = CellFacet(use, false);
        }
      }
    });
  return buckets;
}

//------------------------------------------------------------------------------
CellFacet FacetTableBuilder::GetLeader(Index use) const
{
  CellFacet leader = this->Table.CellFacets[use];
  leader.Packed = leader.Packed < 0 ? ~leader.Packed : leader.Packed;
  return leader;
}

//------------------------------------------------------------------------------
// Consecutive numbers for the first uses of facets; the others still name these.
void FacetTableBuilder::NumberFacets()
{
  std::vector<CellFacet>& uses = this->Table.CellFacets;
  const vtkIdType numberOfFacets = ParallelScan(
    this->NumberOfUses, UseChunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType leaders = 0;
      for (vtkIdType use = begin; use < end; ++use)
      {
        leaders += uses[use].Packed >= 0;
      }
      return leaders;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType number)
    {
      for (vtkIdType use = begin; use < end; ++use)
      {
        if (uses[use].Packed >= 0)
        {
          uses[use] = CellFacet(static_cast<Index>(number++), false);
        }
      }
    });
  this->Table.FacetCells.resize(numberOfFacets);
}

//------------------------------------------------------------------------------
// Cells of facets, and with them the numbers of further uses.
void FacetTableBuilder::ListCells()
{
  FacetTable& table = this->Table;
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
          if (facet.Packed >= 0)
          {
            table.FacetCells[facet.Facet()].First = static_cast<Index>(cell);
            continue;
          }
          const CellFacet leader = this->GetLeader(static_cast<Index>(use));
          facet = CellFacet(table.CellFacets[leader.Facet()].Facet(), leader.IsReversed());
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
