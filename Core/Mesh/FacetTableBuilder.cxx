// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/FacetTableBuilder.h"

#include "Base/Hash.h"
#include "Base/Parallel.h"
#include "Geometry/FacetRing.h"
#include "Mesh/CellBuckets.h"
#include "Mesh/FacetMatcher.h"
#include "Mesh/TetrahedronFaces.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <utility>

namespace camaron
{
namespace
{
constexpr vtkIdType MaxUses = vtkIdType(1) << 30;   // a use and its direction bit must fit into
                                                    // CellFacet
constexpr vtkIdType MaxPoints = vtkIdType(1) << 31; // limit of Index

//------------------------------------------------------------------------------
// Maps a set of points to a number from 0, regardless of their order and repetitions. Few other
// facets have the same number, and neighboring facets have similar numbers in a well-numbered mesh.
class PointHash
{
public:
  explicit PointHash(vtkIdType numberOfPoints)
  {
    while (numberOfPoints >> this->Shift >= CellBuckets::MaxBuckets)
    {
      ++this->Shift;
    }
    this->Largest = static_cast<Index>((numberOfPoints >> this->Shift) << Bits | Mask);
  }

  Index GetLargest() const { return this->Largest; }

  Index operator()(const vtkIdType* points, vtkIdType size) const
  {
    vtkIdType smallest = points[0];
    std::uint64_t sum = 0, seen = 0, twice = 0;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const std::uint64_t hash = MixHash(1, static_cast<std::uint64_t>(points[i]));
      const std::uint64_t bit = std::uint64_t(1) << (hash >> 58);
      twice |= seen & bit;
      seen |= bit;
      sum += hash;
      smallest = std::min(smallest, points[i]);
    }
    if (twice != 0 && HasRepeatedPoints(points, size))
    {
      sum = SumDistinct(points, size);
    }
    return static_cast<Index>(
      (smallest >> this->Shift) << Bits | (static_cast<vtkIdType>(MixHash(1, sum) >> 32) & Mask));
  }

private:
  static bool HasRepeatedPoints(const vtkIdType* points, vtkIdType size)
  {
    constexpr vtkIdType MaxCompared = 16; // compares all pairs; for larger facets, distinct points
                                          // are assumed
    bool isRepeated = size > MaxCompared;
    for (vtkIdType i = 1; i < size && size <= MaxCompared; ++i)
    {
      for (vtkIdType j = 0; j < i; ++j)
      {
        isRepeated |= points[i] == points[j];
      }
    }
    return isRepeated;
  }

  static std::uint64_t SumDistinct(const vtkIdType* points, vtkIdType size)
  {
    std::vector<vtkIdType> distinct(points, points + size);
    SortDistinct(distinct);
    std::uint64_t sum = 0;
    for (const vtkIdType point : distinct)
    {
      sum += MixHash(1, static_cast<std::uint64_t>(point));
    }
    return sum;
  }

  static constexpr int Bits = 19; // of the hash itself; higher bits distinguish up to MaxBuckets
                                  // buckets
  static constexpr vtkIdType Mask = (1 << Bits) - 1;
  int Shift = 0;
  Index Largest;
};

//------------------------------------------------------------------------------
// Whether a list has three different points; usually the first three are.
template <typename Points>
bool IsPolygon(const Points& points)
{
  vtkIdType second = 1;
  while (second < points.Size && points[second] == points[0])
  {
    ++second;
  }
  for (vtkIdType third = second + 1; third < points.Size; ++third)
  {
    if (points[third] != points[0] && points[third] != points[second])
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
// Uses grouped by ranges of their keys, in order within each group.
struct FacetTableBuilder::Buckets
{
  LargeVector<Index> Uses;
  std::vector<Index> Begins;
};

//------------------------------------------------------------------------------
FacetTable FacetTableBuilder::Build(
  const MeshView& mesh, int dimension, const LargeVector<Index>& given, Index numberOfGiven)
{
  FacetTableBuilder builder(mesh, dimension);
  builder.CountFacets();
  const bool areGiven = static_cast<Index>(given.size()) == builder.NumberOfUses && !given.empty();
  if (builder.AreTetrahedra && !areGiven && TetrahedronFaces::Fill(mesh, builder.Table))
  {
    return std::move(builder.Table);
  }
  builder.ClearUses();
  areGiven ? builder.MatchGiven(given, numberOfGiven) : builder.MatchUses();
  builder.NumberFacets();
  builder.ListCells();
  builder.KeepCollapsed();
  return std::move(builder.Table);
}

//------------------------------------------------------------------------------
FacetTableBuilder::FacetTableBuilder(const MeshView& mesh, int dimension)
  : Mesh(mesh)
  , Dimension(dimension)
{
  if (mesh.GetNumberOfPoints() > MaxPoints || mesh.GetNumberOfCells() > MaxUses)
  {
    throw std::length_error("a piece has more points or cells than 32-bit ids can number");
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
  std::atomic<bool> uniform{ true }, areTetrahedra{ this->Dimension == 3 };
  ParallelFor(numberOfCells, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      bool sameNumber = true, sameType = true;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        sameNumber &= numberOfFacets(cell) == stride;
        sameType &= this->Mesh.GetCellType(cell) == VTK_TETRA;
      }
      if (!sameNumber)
      {
        uniform = false;
      }
      if (!sameType)
      {
        areTetrahedra = false;
      }
    });
  this->AreTetrahedra = areTetrahedra && uniform;
  vtkIdType total = stride * numberOfCells;
  if (uniform && stride > 0)
  {
    this->Table.Stride = static_cast<Index>(stride);
  }
  else
  {
    this->Table.CellOffsets.resize(numberOfCells + 1);
    total = ParallelScan(
      numberOfCells, LightGrain,
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
    throw std::length_error("a piece has more than 2^30 faces of cells");
  }
  this->NumberOfUses = static_cast<Index>(total);
  this->Table.CellFacets.resize(total);
}

//------------------------------------------------------------------------------
void FacetTableBuilder::ClearUses()
{
  ParallelFor(this->NumberOfUses, LightGrain,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType use = begin; use < end; ++use)
      {
        this->Table.CellFacets[use].Packed = -1;
      }
    });
}

//------------------------------------------------------------------------------
// Calls put(use, points, size) for the facets of a cell that are not collapsed, and records the
// collapsed ones.
template <typename PutFacet>
void FacetTableBuilder::ForEachValidFacet(CellFacets& facets, vtkIdType cell, PutFacet&& put)
{
  if (facets.GetDimension(cell) != this->Dimension)
  {
    return;
  }
  const vtkIdType begin = this->Table.GetOffset(cell);
  const bool isSoundPolygon = this->Dimension == 2 && IsPolygon(this->Mesh.GetCellPoints(cell));
  facets.ForEach(cell,
    [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
    {
      const Index use = static_cast<Index>(begin + local);
      const bool isSound = this->Dimension == 2 ? isSoundPolygon && points[0] != points[1]
                                                : IsPolygon(FacetPoints{ points, size });
      if (isSound)
      {
        put(use, points, size);
        return;
      }
      const std::lock_guard<std::mutex> lock(this->Mutex);
      this->Collapsed.push_back(use);
    });
}

//------------------------------------------------------------------------------
// Stores in CellFacets, for every use, the first one with the same points: itself, or the
// complement of another one.
void FacetTableBuilder::MatchUses()
{
  this->Match(this->FillBuckets([](Index, const vtkIdType*, vtkIdType) { return true; }));
}

//------------------------------------------------------------------------------
// The same. Only the first use of every given number is compared with others, and few of these have
// the same points.
void FacetTableBuilder::MatchGiven(const LargeVector<Index>& given, Index numberOfGiven)
{
  const LargeVector<std::atomic<Index>> firstUses = this->FindFirstUses(given, numberOfGiven);
  LargeVector<unsigned char> down(given.size(), 0);
  this->Match(this->FillBuckets(
    [&](Index use, const vtkIdType* points, vtkIdType size)
    {
      down[use] = RunsDown(points, size);
      return firstUses[given[use]].load(std::memory_order_relaxed) == use;
    }));
  ParallelFor(this->NumberOfUses, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      LargeVector<CellFacet>& uses = this->Table.CellFacets;
      for (vtkIdType use = begin; use < end; ++use)
      {
        const Index first = firstUses[given[use]].load(std::memory_order_relaxed);
        if (first != use)
        {
          const Index leader = this->GetLeader(first).Facet();
          uses[use].Packed = ~CellFacet(leader, down[use] != down[leader]).Packed;
        }
      }
    });
  for (const Index use : this->Collapsed)
  {
    this->Table.CellFacets[use] = CellFacet(use, false);
  }
}

//------------------------------------------------------------------------------
LargeVector<std::atomic<Index>> FacetTableBuilder::FindFirstUses(
  const LargeVector<Index>& given, Index numberOfGiven)
{
  LargeVector<std::atomic<Index>> firstUses(static_cast<std::size_t>(numberOfGiven));
  ParallelFor(numberOfGiven, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType number = begin; number < end; ++number)
      {
        std::atomic_init(&firstUses[number], std::numeric_limits<Index>::max());
      }
    });
  ParallelFor(this->NumberOfUses, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (Index use = static_cast<Index>(begin); use < static_cast<Index>(end); ++use)
      {
        LowerTo(firstUses[given[use]], use);
      }
    });
  return firstUses;
}

//------------------------------------------------------------------------------
void FacetTableBuilder::Match(const Buckets& buckets)
{
  ParallelFor(static_cast<vtkIdType>(buckets.Begins.size()) - 1, CellBuckets::Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      FacetMatcher matcher(this->Mesh, this->Table);
      for (vtkIdType bucket = begin; bucket < end; ++bucket)
      {
        const Index first = buckets.Begins[bucket];
        matcher.Match(buckets.Uses.data() + first, buckets.Begins[bucket + 1] - first);
      }
      if (matcher.MatchesOtherRings)
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->Table.OtherRings = true;
      }
    });
}

//------------------------------------------------------------------------------
// First every use to be matched, those with wants(use, points, size), gets a hash as its key, which
// determines how many uses each chunk of cells puts into each bucket.
template <typename Wants>
FacetTableBuilder::Buckets FacetTableBuilder::FillBuckets(Wants&& wants)
{
  const PointHash hash(this->Mesh.GetNumberOfPoints());
  CellBuckets places(this->Mesh.GetNumberOfCells(), hash.GetLargest(), this->NumberOfUses);
  LargeVector<CellFacet>& keys = this->Table.CellFacets; // -1 for uses without a key
  places.ForEachChunk(
    [&](std::vector<Index>& sizes, vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(this->Mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->ForEachValidFacet(facets, cell,
          [&](Index use, const vtkIdType* points, vtkIdType size)
          {
            if (wants(use, points, size))
            {
              const Index key = hash(points, size);
              keys[use].Packed = key;
              ++sizes[places.GetBucket(key)];
            }
          });
      }
    });
  Buckets buckets;
  buckets.Begins = places.Place();
  buckets.Uses.resize(static_cast<std::size_t>(buckets.Begins.back()));
  places.ForEachChunk(
    [&](std::vector<Index>& next, vtkIdType begin, vtkIdType end)
    {
      const Index last = static_cast<Index>(this->Table.GetOffset(end));
      for (Index use = static_cast<Index>(this->Table.GetOffset(begin)); use < last; ++use)
      {
        if (keys[use].Packed >= 0)
        {
          buckets.Uses[next[places.GetBucket(keys[use].Packed)]++] = use;
        }
        else
        {
          keys[use] = CellFacet(use, false);
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
// Consecutive numbers for the first uses of facets; the others still refer to these.
void FacetTableBuilder::NumberFacets()
{
  LargeVector<CellFacet>& uses = this->Table.CellFacets;
  const vtkIdType numberOfFacets = ParallelScan(
    this->NumberOfUses, LightGrain,
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
// The cells of facets, and then the numbers of further uses.
void FacetTableBuilder::ListCells()
{
  FacetTable& table = this->Table;
  const vtkIdType numberOfFacets = table.GetNumberOfFacets();
  // If threads compete at a facet with more than two cells, one wins; the sum below detects these
  // facets.
  LargeVector<std::atomic<Index>> seconds(numberOfFacets);
  ParallelFor(numberOfFacets, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType facet = begin; facet < end; ++facet)
      {
        seconds[facet].store(-1, std::memory_order_relaxed);
      }
    });
  ParallelFor(table.NumberOfCells, MediumGrain,
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
          seconds[facet.Facet()].store(static_cast<Index>(cell), std::memory_order_relaxed);
        }
      }
    });
  std::atomic<Index> listed{ 0 };
  ParallelFor(numberOfFacets, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Index cells = 0;
      for (vtkIdType facet = begin; facet < end; ++facet)
      {
        const Index second = seconds[facet].load(std::memory_order_relaxed);
        table.FacetCells[facet].Second = second;
        cells += second < 0 ? 1 : 2;
      }
      listed += cells;
    });
  if (listed < this->NumberOfUses)
  {
    this->ListExtraCells();
  }
}

//------------------------------------------------------------------------------
void FacetTableBuilder::KeepCollapsed()
{
  for (const Index use : this->Collapsed)
  {
    const Index facet = this->Table.CellFacets[use].Facet();
    this->Table.FacetCells[facet].Second = FacetTable::Nothing;
  }
}

//------------------------------------------------------------------------------
// For facets with more than two cells, which are rare.
void FacetTableBuilder::ListExtraCells()
{
  FacetTable& table = this->Table;
  std::vector<unsigned char> found(table.FacetCells.size(), 0);
  for (Index cell = 0; cell < table.NumberOfCells; ++cell)
  {
    for (const CellFacet use : table.GetCellFacets(cell))
    {
      unsigned char& cells = found[use.Facet()];
      if (cells == 1)
      {
        table.FacetCells[use.Facet()].Second = cell;
      }
      else if (cells == 2)
      {
        table.ExtraCells.push_back({ use.Facet(), cell });
      }
      cells = std::min(cells + 1, 2);
    }
  }
  std::stable_sort(table.ExtraCells.begin(), table.ExtraCells.end(),
    [](const FacetTable::ExtraCell& a, const FacetTable::ExtraCell& b)
    { return a.Facet < b.Facet; });
}
}
