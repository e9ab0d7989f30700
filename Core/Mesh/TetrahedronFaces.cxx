// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedronFaces.h"

#include "Base/Buffer.h"
#include "Base/Hash.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

namespace camaron
{
namespace
{
constexpr Index FacesPerCell = 4, FacesPerFan = 3;
constexpr Index ItemsPerRound = 1 << 23; // stored at a time, or a quarter of all if that is more

//------------------------------------------------------------------------------
// Calls visit(use) for those of [begin, end) with isWanted(use). If about half of them are wanted,
// branches are mispredicted, so it is faster to list them before visiting any.
template <typename IsWanted, typename Visit>
void ForEachWanted(vtkIdType begin, vtkIdType end, IsWanted&& isWanted, Visit&& visit)
{
  constexpr vtkIdType MaxListed = 1024;
  Index listed[MaxListed];
  for (vtkIdType first = begin; first < end; first += MaxListed)
  {
    const vtkIdType last = std::min(first + MaxListed, end);
    int size = 0;
    for (vtkIdType use = first; use < last; ++use)
    {
      listed[size] = static_cast<Index>(use);
      size += isWanted(use);
    }
    for (int i = 0; i < size; ++i)
    {
      visit(listed[i]);
    }
  }
}
}

//------------------------------------------------------------------------------
// The points of a cell in ascending order, and the local numbers of the first three, two bits each.
struct TetrahedronFaces::Cell
{
  Index Points[4];
  Index Order;

  Cell(const MeshView& mesh, vtkIdType cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    std::uint64_t keys[4];
    for (int i = 0; i < 4; ++i)
    {
      keys[i] = static_cast<std::uint64_t>(points[i]) << 2 | i;
    }
    const auto order = [&keys](int i, int j)
    {
      const std::uint64_t low = std::min(keys[i], keys[j]), high = std::max(keys[i], keys[j]);
      keys[i] = low;
      keys[j] = high;
    };
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
    for (int i = 0; i < 4; ++i)
    {
      this->Points[i] = static_cast<Index>(keys[i] >> 2);
    }
    this->Order = static_cast<Index>((keys[0] & 3) | (keys[1] & 3) << 2 | (keys[2] & 3) << 4);
  }

  bool IsSound() const
  {
    return (this->Points[0] < this->Points[1]) & (this->Points[1] < this->Points[2]) &
      (this->Points[2] < this->Points[3]);
  }
};

//------------------------------------------------------------------------------
TetrahedronFaces::FaceCodes::FaceCodes()
{
  constexpr int Faces[FacesPerCell][3] = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 },
    { 0, 2, 1 } }; // as VTK has them
  std::array<int, 4> sorted = { 0, 1, 2, 3 };
  do
  {
    std::array<int, 4> place;
    for (int i = 0; i < 4; ++i)
    {
      place[sorted[i]] = i;
    }
    unsigned char* const codes = this->Codes[sorted[0] | sorted[1] << 2 | sorted[2] << 4];
    for (int face = 0; face < FacesPerCell; ++face)
    {
      const int a = place[Faces[face][0]], b = place[Faces[face][1]], c = place[Faces[face][2]];
      codes[6 - a - b - c] = static_cast<unsigned char>(2 * face + ((a > b) ^ (b > c) ^ (a > c)));
    }
  } while (std::next_permutation(sorted.begin(), sorted.end()));
}

//------------------------------------------------------------------------------
// The three faces of a cell at its lowest point.
struct TetrahedronFaces::Fan
{
  Index Points[4];
  Index Cell, Order;
};

//------------------------------------------------------------------------------
struct TetrahedronFaces::Triangle
{
  Index Low, Middle, High;
  CellFacet Use; // reversed if it is opposite to the order of the points

  bool IsSame(const Triangle& other) const
  {
    return ((this->Low ^ other.Low) | (this->Middle ^ other.Middle) | (this->High ^ other.High)) ==
      0;
  }
  std::size_t GetHash() const
  {
    const auto part = [](Index id)
    { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(id)); };
    const std::uint64_t low = (part(this->Low) << 32 | part(this->Middle)) * HashFactor;
    return (low + part(this->High) * 0xc2b2ae3d27d4eb4full) >> 32;
  }
};

//------------------------------------------------------------------------------
// The triangles of a bucket, and a hash table of the distinct ones.
struct TetrahedronFaces::Bucket
{
  std::vector<Triangle> Triangles;
  std::vector<Index> Slots;
};

//------------------------------------------------------------------------------
// A third or further use of a face.
struct TetrahedronFaces::FurtherUse
{
  CellFacet Known; // one of the first two
  CellFacet Use;
};

//------------------------------------------------------------------------------
bool TetrahedronFaces::Fill(const MeshView& mesh, FacetTable& table)
{
  TetrahedronFaces faces(mesh, table);
  if (!faces.CountItems())
  {
    return false;
  }
  CellFacet alone;
  alone.Packed = NoOther;
  ParallelFor(static_cast<vtkIdType>(table.CellFacets.size()), LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    { std::fill(table.CellFacets.begin() + begin, table.CellFacets.begin() + end, alone); });
  faces.Match();
  faces.OrderFurtherUses();
  faces.NumberFaces();
  faces.ListFurtherCells();
  return true;
}

//------------------------------------------------------------------------------
TetrahedronFaces::TetrahedronFaces(const MeshView& mesh, FacetTable& table)
  : Mesh(mesh)
  , Table(table)
  , FanBuckets(mesh.GetNumberOfCells(), mesh.GetNumberOfPoints(),
      static_cast<vtkIdType>(table.CellFacets.size()))
  , TriangleBuckets(this->FanBuckets)
{
}

//------------------------------------------------------------------------------
bool TetrahedronFaces::CountItems()
{
  std::atomic<bool> areSound{ true };
  this->FanBuckets.ForEachChunk(
    [&](std::vector<Index>& fans, vtkIdType begin, vtkIdType end)
    {
      std::vector<Index>& triangles = this->TriangleBuckets.GetPlaces(begin);
      bool sound = true;
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Cell cell(this->Mesh, id);
        sound &= cell.IsSound();
        ++fans[this->FanBuckets.GetBucket(cell.Points[0])];
        ++triangles[this->FanBuckets.GetBucket(cell.Points[1])];
      }
      if (!sound)
      {
        areSound = false;
      }
    });
  this->FanBegins = this->FanBuckets.Place();
  this->TriangleBegins = this->TriangleBuckets.Place();
  return areSound;
}

//------------------------------------------------------------------------------
// The first bucket of each round, so that rounds have about the same number of items, followed by
// the number of buckets.
std::vector<Index> TetrahedronFaces::FindRounds() const
{
  const Index numberOfBuckets = this->FanBuckets.GetNumberOfBuckets();
  const auto begin = [this](Index bucket)
  { return this->FanBegins[bucket] + this->TriangleBegins[bucket]; };
  const Index limit = std::max(ItemsPerRound, begin(numberOfBuckets) / 4);
  std::vector<Index> rounds{ 0 };
  while (rounds.back() < numberOfBuckets)
  {
    const Index first = rounds.back();
    Index last = first + 1;
    while (last < numberOfBuckets && begin(last + 1) - begin(first) <= limit)
    {
      ++last;
    }
    rounds.push_back(last);
  }
  return rounds;
}

//------------------------------------------------------------------------------
// Fills buckets [first, last).
void TetrahedronFaces::FillBuckets(Index first, Index last, Fan* fans, Triangle* triangles)
{
  const Index firstFan = this->FanBegins[first], firstTriangle = this->TriangleBegins[first];
  this->FanBuckets.ForEachChunk(
    [&](std::vector<Index>& fanPlaces, vtkIdType begin, vtkIdType end)
    {
      std::vector<Index>& trianglePlaces = this->TriangleBuckets.GetPlaces(begin);
      for (Index id = static_cast<Index>(begin); id < static_cast<Index>(end); ++id)
      {
        const Cell cell(this->Mesh, id);
        const Index a = cell.Points[0], b = cell.Points[1], c = cell.Points[2], d = cell.Points[3];
        const Index ofFan = this->FanBuckets.GetBucket(a),
                    ofTriangle = this->FanBuckets.GetBucket(b);
        if (ofFan >= first && ofFan < last)
        {
          fans[fanPlaces[ofFan]++ - firstFan] = { { a, b, c, d }, id, cell.Order };
        }
        if (ofTriangle >= first && ofTriangle < last)
        {
          triangles[trianglePlaces[ofTriangle]++ - firstTriangle] = { b, c, d,
            this->Codes.GetUse(id, cell.Order, 0) };
        }
      }
    });
}

//------------------------------------------------------------------------------
void TetrahedronFaces::Match()
{
  const std::vector<Index> rounds = this->FindRounds();
  Index numberOfFans = 0, numberOfTriangles = 0;
  for (std::size_t round = 0; round + 1 < rounds.size(); ++round)
  {
    const Index first = rounds[round], last = rounds[round + 1];
    numberOfFans = std::max(numberOfFans, this->FanBegins[last] - this->FanBegins[first]);
    numberOfTriangles =
      std::max(numberOfTriangles, this->TriangleBegins[last] - this->TriangleBegins[first]);
  }
  Buffer<Fan> fans(numberOfFans);
  Buffer<Triangle> triangles(numberOfTriangles);
  for (std::size_t round = 0; round + 1 < rounds.size(); ++round)
  {
    const Index first = rounds[round], last = rounds[round + 1];
    this->FillBuckets(first, last, fans.data(), triangles.data());
    ParallelFor(last - first, CellBuckets::Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        Bucket bucket;
        for (Index b = first + static_cast<Index>(begin); b < first + static_cast<Index>(end); ++b)
        {
          this->LoadBucket(b, fans.data() + (this->FanBegins[b] - this->FanBegins[first]),
            triangles.data() + (this->TriangleBegins[b] - this->TriangleBegins[first]), bucket);
          this->MatchBucket(bucket);
        }
      });
  }
}

//------------------------------------------------------------------------------
void TetrahedronFaces::LoadBucket(
  Index number, const Fan* fans, const Triangle* triangles, Bucket& bucket) const
{
  const Index numberOfFans = this->FanBegins[number + 1] - this->FanBegins[number];
  const Index numberOfTriangles = this->TriangleBegins[number + 1] - this->TriangleBegins[number];
  bucket.Triangles.resize(FacesPerFan * numberOfFans + numberOfTriangles);
  Triangle* to = bucket.Triangles.data();
  for (Index i = 0; i < numberOfFans; ++i)
  {
    const Fan& fan = fans[i];
    const Index a = fan.Points[0], b = fan.Points[1], c = fan.Points[2], d = fan.Points[3];
    *to++ = { a, b, c, this->Codes.GetUse(fan.Cell, fan.Order, 3) };
    *to++ = { a, b, d, this->Codes.GetUse(fan.Cell, fan.Order, 2) };
    *to++ = { a, c, d, this->Codes.GetUse(fan.Cell, fan.Order, 1) };
  }
  std::copy_n(triangles, numberOfTriangles, to);
}

//------------------------------------------------------------------------------
void TetrahedronFaces::MatchBucket(Bucket& bucket)
{
  const Triangle* const triangles = bucket.Triangles.data();
  const Index size = static_cast<Index>(bucket.Triangles.size());
  std::size_t mask = 1;
  while (mask < 2 * static_cast<std::size_t>(size))
  {
    mask = 2 * mask + 1;
  }
  bucket.Slots.assign(mask + 1, -1);
  Index* const slots = bucket.Slots.data();
  for (Index i = 0; i < size; ++i)
  {
    const Triangle triangle = triangles[i];
    std::size_t slot = triangle.GetHash() & mask;
    while (slots[slot] >= 0 && !triangles[slots[slot]].IsSame(triangle))
    {
      slot = (slot + 1) & mask;
    }
    if (slots[slot] < 0)
    {
      slots[slot] = i;
      continue;
    }
    const CellFacet known = triangles[slots[slot]].Use;
    if (this->Table.CellFacets[known.Facet()].Packed == NoOther)
    {
      const bool isKnownFirst = known.Packed < triangle.Use.Packed;
      this->Link(isKnownFirst ? known : triangle.Use, isKnownFirst ? triangle.Use : known);
      continue;
    }
    const std::lock_guard<std::mutex> lock(this->FurtherMutex);
    this->FurtherUses.push_back({ known, triangle.Use });
  }
}

//------------------------------------------------------------------------------
inline void TetrahedronFaces::Link(CellFacet first, CellFacet second)
{
  const bool isReversed = first.IsReversed() != second.IsReversed();
  this->Table.CellFacets[first.Facet()] = CellFacet(second.Facet(), isReversed);
  this->Table.CellFacets[second.Facet()].Packed = ~CellFacet(first.Facet(), isReversed).Packed;
}

//------------------------------------------------------------------------------
// The uses of a face are not found in ascending order: the lowest two must be linked; the others
// are further uses.
void TetrahedronFaces::OrderFurtherUses()
{
  std::vector<FurtherUse>& all = this->FurtherUses;
  std::sort(all.begin(), all.end(),
    [](const FurtherUse& a, const FurtherUse& b) { return a.Known.Packed < b.Known.Packed; });
  std::vector<CellFacet> uses;
  for (auto begin = all.begin(), end = begin; begin != all.end(); begin = end)
  {
    const CellFacet known = begin->Known;
    CellFacet other = this->Table.CellFacets[known.Facet()];
    other.Packed = IsFirst(other.Packed) ? other.Packed : ~other.Packed;
    uses = { known, CellFacet(other.Facet(), other.IsReversed() != known.IsReversed()) };
    for (; end != all.end() && end->Known.Packed == known.Packed; ++end)
    {
      uses.push_back(end->Use);
    }
    std::sort(
      uses.begin(), uses.end(), [](CellFacet a, CellFacet b) { return a.Packed < b.Packed; });
    for (std::size_t i = uses.size() - 1; i > 0; --i)
    {
      this->Link(uses[0], uses[i]); // the second one comes last
    }
    std::transform(begin, end, uses.begin() + 2, begin,
      [&uses](const FurtherUse&, CellFacet use) { return FurtherUse{ uses[0], use }; });
  }
}

//------------------------------------------------------------------------------
// First uses get consecutive numbers; then the others look up theirs.
void TetrahedronFaces::NumberFaces()
{
  LargeVector<CellFacet>& uses = this->Table.CellFacets;
  LargeVector<FacetTable::CellPair>& cells = this->Table.FacetCells;
  const vtkIdType numberOfUses = static_cast<vtkIdType>(uses.size());
  ParallelScan(
    numberOfUses, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType firsts = 0;
      for (vtkIdType use = begin; use < end; ++use)
      {
        firsts += IsFirst(uses[use].Packed);
      }
      return firsts;
    },
    [&](vtkIdType numberOfFaces) { cells.resize(numberOfFaces); },
    [&](vtkIdType begin, vtkIdType end, vtkIdType number)
    {
      ForEachWanted(
        begin, end, [&](vtkIdType use) { return IsFirst(uses[use].Packed); },
        [&](Index use)
        {
          const CellFacet link = uses[use];
          const Index second =
            link.Packed == NoOther ? FacetTable::NoCell : link.Facet() / FacesPerCell;
          cells[number] = { use / FacesPerCell, second };
          uses[use] = CellFacet(static_cast<Index>(number++), false);
        });
    });
  ParallelFor(numberOfUses, LightGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      ForEachWanted(
        begin, end, [&](vtkIdType use) { return uses[use].Packed < 0; },
        [&](Index use)
        {
          CellFacet first;
          first.Packed = ~uses[use].Packed;
          uses[use] = CellFacet(uses[first.Facet()].Facet(), first.IsReversed());
        });
    });
}

//------------------------------------------------------------------------------
void TetrahedronFaces::ListFurtherCells()
{
  std::vector<FacetTable::ExtraCell>& cells = this->Table.ExtraCells;
  for (const FurtherUse& further : this->FurtherUses)
  {
    const Index use = further.Use.Facet();
    cells.push_back({ this->Table.CellFacets[use].Facet(), use / FacesPerCell });
  }
  std::sort(cells.begin(), cells.end(),
    [](const FacetTable::ExtraCell& a, const FacetTable::ExtraCell& b)
    { return std::make_pair(a.Facet, a.Cell) < std::make_pair(b.Facet, b.Cell); });
}
}
