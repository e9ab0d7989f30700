// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/TetrahedronFaces.h"

#include "Mesh/CellBuckets.h"
#include "Parallel.h"
#include "Scan/Buffer.h"

#include <algorithm>
#include <atomic>

namespace camaron
{
namespace
{
constexpr Index TrianglesPerRound = 1 << 23; // kept at a time, or a quarter of all where that is more

//------------------------------------------------------------------------------
// The points of a face in ascending order, and which use it is and whether it runs from the lowest point to the highest.
struct Triangle
{
  Index Low, Middle, High;
  CellFacet Use;

  bool IsSame(const Triangle& other) const
  {
    return this->Low == other.Low && this->Middle == other.Middle && this->High == other.High;
  }
  std::size_t GetHash() const
  {
    const auto part = [](Index id) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(id)); };
    const std::uint64_t low = (part(this->Low) << 32 | part(this->Middle)) * 0x9e3779b97f4a7c15ull;
    return (low + part(this->High) * 0xc2b2ae3d27d4eb4full) >> 32;
  }
};

//------------------------------------------------------------------------------
// Those of a cell, face by face as VTK numbers them.
struct Triangles
{
  Index Low[4], Middle[4], High[4], Down[4];

  Triangles(const MeshView& mesh, vtkIdType cell)
  {
    const IndexRange points = mesh.GetCellPoints(cell);
    Index p[4];
    for (int i = 0; i < 4; ++i)
    {
      p[i] = static_cast<Index>(points[i]);
    }
    const Index first[4] = { p[0], p[1], p[2], p[0] };
    const Index second[4] = { p[1], p[2], p[0], p[2] };
    const Index third[4] = { p[3], p[3], p[3], p[1] };
    for (int face = 0; face < 4; ++face)
    {
      const Index a = first[face], b = second[face], c = third[face];
      this->Low[face] = std::min(a, std::min(b, c));
      this->High[face] = std::max(a, std::max(b, c));
      this->Middle[face] = a ^ b ^ c ^ this->Low[face] ^ this->High[face];
      this->Down[face] = (a > b) ^ (b > c) ^ (a > c);
    }
  }

  bool AreSound() const
  {
    bool sound = true;
    for (int face = 0; face < 4; ++face)
    {
      sound &= this->Low[face] < this->Middle[face] && this->Middle[face] < this->High[face];
    }
    return sound;
  }
  Triangle Get(int face, vtkIdType cell) const
  {
    return { this->Low[face], this->Middle[face], this->High[face],
      CellFacet(static_cast<Index>(4 * cell + face), this->Down[face] != 0) };
  }
};

//------------------------------------------------------------------------------
// Sorts triangles into buckets by their lowest point, some buckets at a time, and compares those within a bucket.
class TetrahedronMatcher
{
public:
  TetrahedronMatcher(const MeshView& mesh, LargeVector<CellFacet>& uses)
    : Mesh(mesh)
    , Uses(uses)
    , Buckets(mesh.GetNumberOfCells(), mesh.GetNumberOfPoints(), static_cast<vtkIdType>(uses.size()))
  {
  }

  /// False if a cell has a point twice; nothing is written then.
  bool Match();

private:
  bool CountTriangles();
  void FillBuckets(Index first, Index last, Index origin, Triangle* triangles);
  void MatchBucket(const Triangle* triangles, Index size, std::vector<Index>& slots);

  const MeshView& Mesh;
  LargeVector<CellFacet>& Uses;
  CellBuckets Buckets; // of triangles by their lowest points
};

//------------------------------------------------------------------------------
bool TetrahedronMatcher::CountTriangles()
{
  std::atomic<bool> areSound{ true };
  this->Buckets.ForEachChunk(
    [&](std::vector<Index>& sizes, vtkIdType begin, vtkIdType end)
    {
      bool sound = true;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const Triangles triangles(this->Mesh, cell);
        sound &= triangles.AreSound();
        for (const Index low : triangles.Low)
        {
          ++sizes[this->Buckets.GetBucket(low)];
        }
      }
      if (!sound)
      {
        areSound = false;
      }
    });
  return areSound;
}

//------------------------------------------------------------------------------
// With the triangles of buckets [first, last), in ascending order of their uses; the first one has the place @a origin.
void TetrahedronMatcher::FillBuckets(Index first, Index last, Index origin, Triangle* triangles)
{
  this->Buckets.ForEachChunk(
    [&](std::vector<Index>& places, vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const Triangles ofCell(this->Mesh, cell);
        for (int face = 0; face < 4; ++face)
        {
          const Index bucket = this->Buckets.GetBucket(ofCell.Low[face]);
          if (bucket >= first && bucket < last)
          {
            triangles[places[bucket]++ - origin] = ofCell.Get(face, cell);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void TetrahedronMatcher::MatchBucket(const Triangle* triangles, Index size, std::vector<Index>& slots)
{
  std::size_t mask = 1;
  while (mask < 2 * static_cast<std::size_t>(size))
  {
    mask = 2 * mask + 1;
  }
  slots.assign(mask + 1, -1);
  for (Index i = 0; i < size; ++i)
  {
    const Triangle& triangle = triangles[i];
    std::size_t slot = triangle.GetHash() & mask;
    while (slots[slot] >= 0 && !triangles[slots[slot]].IsSame(triangle))
    {
      slot = (slot + 1) & mask;
    }
    const CellFacet use = triangle.Use;
    if (slots[slot] < 0)
    {
      slots[slot] = i;
      this->Uses[use.Facet()] = CellFacet(use.Facet(), false);
    }
    else
    {
      const CellFacet first = triangles[slots[slot]].Use;
      this->Uses[use.Facet()].Packed = ~CellFacet(first.Facet(), first.IsReversed() != use.IsReversed()).Packed;
    }
  }
}

//------------------------------------------------------------------------------
bool TetrahedronMatcher::Match()
{
  if (!this->CountTriangles())
  {
    return false;
  }
  const std::vector<Index> begins = this->Buckets.Place();
  const Index numberOfBuckets = this->Buckets.GetNumberOfBuckets();
  const Index limit = std::max(TrianglesPerRound, begins.back() / 4);
  std::vector<Index> rounds{ 0 }; // by their first buckets
  Index size = 0;
  while (rounds.back() < numberOfBuckets)
  {
    const Index first = rounds.back();
    Index last = first + 1;
    while (last < numberOfBuckets && begins[last + 1] - begins[first] <= limit)
    {
      ++last;
    }
    size = std::max(size, begins[last] - begins[first]);
    rounds.push_back(last);
  }
  Buffer<Triangle> triangles(size);
  for (std::size_t round = 0; round + 1 < rounds.size(); ++round)
  {
    const Index first = rounds[round], last = rounds[round + 1];
    const Index origin = begins[first];
    this->FillBuckets(first, last, origin, triangles.data());
    ParallelFor(last - first, CellBuckets::Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        std::vector<Index> slots;
        for (vtkIdType bucket = first + begin; bucket < first + end; ++bucket)
        {
          const Index place = begins[bucket];
          this->MatchBucket(triangles.data() + (place - origin), begins[bucket + 1] - place, slots);
        }
      });
  }
  return true;
}
}

//------------------------------------------------------------------------------
bool MatchTetrahedronFaces(const MeshView& mesh, LargeVector<CellFacet>& uses)
{
  return TetrahedronMatcher(mesh, uses).Match();
}
}
