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

constexpr int PointsPerShareBits = 8; // threads share the points out in runs of 2^8
constexpr int MaxShares = 64;
constexpr int MaxListBits = 3;
constexpr Index NodesPerBlock = 4096;

constexpr vtkIdType MaxUnsorted = 12; // points of a facet that are compared pair by pair

constexpr std::uint32_t DownBit = 0x80000000u;
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
// What tells a facet from the others with its smallest point: of up to four points the other ones, of more
// a hash.
struct FacetKey
{
  std::uint32_t Parts[3];
  bool Down; // see RunsDown
};

std::uint32_t Part(vtkIdType id)
{
  return static_cast<std::uint32_t>(id);
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
  return { { static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32),
             HashedBit | static_cast<std::uint32_t>(Mix(hash, 1) >> 33) },
    down };
}

//------------------------------------------------------------------------------
// Sorting is for facets of few points, and for the rare ones that come to a point twice. Of others its branches
// would be as hard to foresee as the numbering of the points.
FacetKey MakeKey(const vtkIdType* points, vtkIdType size, std::vector<vtkIdType>& sorted)
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
      return { { Part(middle), Part(high), ThreePoints }, down };
    }
  }
  const bool down = RunsDown(points, size);
  if (size > 4 && size <= MaxUnsorted && !HasRepeatedPoints(points, size))
  {
    return MakeHashedKey(points, size, down);
  }
  sorted.assign(points, points + size);
  SortDistinct(sorted);
  switch (sorted.size())
  {
    case 1:
      return { { 0, 0, OnePoint }, down };
    case 2:
      return { { Part(sorted[1]), 0, TwoPoints }, down };
    case 3:
      return { { Part(sorted[1]), Part(sorted[2]), ThreePoints }, down };
    case 4:
      return { { Part(sorted[1]), Part(sorted[2]), Part(sorted[3]) }, down };
    default:
      return MakeHashedKey(sorted.data(), static_cast<vtkIdType>(sorted.size()), down);
  }
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
Index GetUse(std::uint32_t item)
{
  return static_cast<Index>(item & ~DownBit);
}
}

//------------------------------------------------------------------------------
// Hands nodes out to threads in blocks. The memory is that of the worst case, but only what is used of it
// is ever touched.
class FacetTableBuilder::NodePool
{
public:
  NodePool(Index numberOfUses, int numberOfShares)
    : Nodes(new Node[static_cast<std::size_t>(numberOfUses) +
        static_cast<std::size_t>(numberOfShares) * NodesPerBlock])
  {
  }
  Node& operator[](Index node) { return this->Nodes[node]; }
  /// The next node of a share whose last one was @a node, -1 for none so far.
  Index GetNext(Index node)
  {
    return node < 0 || (node + 1) % NodesPerBlock == 0
      ? this->NextBlock.fetch_add(NodesPerBlock, std::memory_order_relaxed)
      : node + 1;
  }

private:
  std::unique_ptr<Node[]> Nodes;
  std::atomic<Index> NextBlock{ 0 };
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
  this->Table.CellFacets.resize(total);
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
// Leaves in CellFacets for every visited item the first use with the same points. Every list of facets
// belongs to one share of the points and sees its items in order, whatever the number of shares.
template <typename ForEachItem>
void FacetTableBuilder::Match(ForEachItem&& forEachItem)
{
  const vtkIdType numberOfPoints = this->Mesh.GetNumberOfPoints();
  // Where many facets share their smallest point, as in a mesh of tetrahedra, it has several lists.
  int listBits = 0;
  while (listBits < MaxListBits && (numberOfPoints << (listBits + 2)) < this->NumberOfUses)
  {
    ++listBits;
  }
  std::vector<Index> lists(static_cast<std::size_t>(numberOfPoints) << listBits, -1);
  WithThreads(
    [&]
    {
      const int numberOfShares =
        std::max(1, std::min(vtkSMPTools::GetEstimatedNumberOfThreads(), MaxShares));
      std::vector<unsigned char> shares((numberOfPoints >> PointsPerShareBits) + 1);
      for (std::size_t run = 0; run < shares.size(); ++run)
      {
        shares[run] = static_cast<unsigned char>(run % numberOfShares);
      }
      NodePool nodes(this->NumberOfUses, numberOfShares);
      const auto matchShare = [&](int share)
      {
        CellFacets facets(this->Mesh), others(this->Mesh);
        std::vector<vtkIdType> scratch;
        Index lastNode = -1;
        vtkIdType cell = 0;
        const auto match = [&](std::uint32_t use, const vtkIdType* points, vtkIdType size)
        {
          if (size == 0)
          {
            this->Table.CellFacets[use] = CellFacet(static_cast<Index>(use), false);
            return;
          }
          const vtkIdType smallest = GetSmallest(points, size);
          if (shares[smallest >> PointsPerShareBits] != share)
          {
            return;
          }
          const FacetKey key = MakeKey(points, size, scratch);
          const std::uint32_t which = (key.Parts[0] ^ key.Parts[1]) & ((1u << listBits) - 1);
          Index& list = lists[(smallest << listBits) + which];
          Index found = list;
          for (; found >= 0; found = nodes[found].Next)
          {
            const Node& node = nodes[found];
            if (node.Key[0] == key.Parts[0] && node.Key[1] == key.Parts[1] &&
              node.Key[2] == key.Parts[2] &&
              (!(key.Parts[2] & HashedBit) || this->HasPoints(node, points, size, others, scratch)))
            {
              break;
            }
          }
          if (found < 0)
          {
            lastNode = nodes.GetNext(lastNode);
            nodes[lastNode] = { { key.Parts[0], key.Parts[1], key.Parts[2] }, list,
              use | (key.Down ? DownBit : 0u), static_cast<Index>(cell) };
            list = lastNode;
            this->Table.CellFacets[use] = CellFacet(static_cast<Index>(use), false);
            return;
          }
          const std::uint32_t first = nodes[found].Item;
          this->Table.CellFacets[use] =
            CellFacet(GetUse(first), ((first & DownBit) != 0) != key.Down);
        };
        for (; cell < this->Mesh.GetNumberOfCells(); ++cell)
        {
          forEachItem(facets, cell, match);
        }
      };
      vtkSMPTools::For(0, numberOfShares, 1,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (vtkIdType share = begin; share < end; ++share)
          {
            matchShare(static_cast<int>(share));
          }
        });
    });
}

//------------------------------------------------------------------------------
// Whether the first use of a facet has the same points, each however often.
bool FacetTableBuilder::HasPoints(const Node& node, const vtkIdType* points, vtkIdType size,
  CellFacets& facets, std::vector<vtkIdType>& first) const
{
  first.clear();
  facets.GetFacet(node.Cell, GetUse(node.Item) - this->Table.GetOffset(node.Cell), first);
  if (static_cast<vtkIdType>(first.size()) == size && IsSameRing(points, first.data(), size))
  {
    return true;
  }
  std::vector<vtkIdType> sorted(points, points + size);
  SortDistinct(sorted);
  SortDistinct(first);
  return first == sorted;
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
