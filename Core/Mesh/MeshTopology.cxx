// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/MeshTopology.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Mesh/CellFacets.h"
#include "Mesh/ConnectivityKey.h"
#include "Mesh/FacetTableBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sorts items into one bucket per point: visit(cell, put) calls put(point, value) for every item of
// a cell, and is called twice for all cells. Returns the distinct values bucket by bucket, sorted,
// and the ends of the buckets.
template <typename Visit>
void FillBuckets(
  const MeshView& mesh, Visit&& visit, std::vector<vtkIdType>& ends, std::vector<Index>& values)
{
  const vtkIdType numberOfPoints = mesh.GetNumberOfPoints();
  std::unique_ptr<std::atomic<vtkIdType>[]> cursors(new std::atomic<vtkIdType>[numberOfPoints]);
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    std::atomic_init(&cursors[point], 0);
  }
  const auto forAllItems = [&](auto&& put)
  {
    ParallelFor(mesh.GetNumberOfCells(), MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          visit(facets, cell, put);
        }
      });
  };
  forAllItems(
    [&](vtkIdType point, Index) { cursors[point].fetch_add(1, std::memory_order_relaxed); });
  vtkIdType total = 0;
  for (vtkIdType point = 0; point < numberOfPoints; ++point)
  {
    total += cursors[point].exchange(total, std::memory_order_relaxed);
  }
  values.resize(total);
  forAllItems([&](vtkIdType point, Index value)
    { values[cursors[point].fetch_add(1, std::memory_order_relaxed)] = value; });
  ends.resize(numberOfPoints);
  ParallelFor(numberOfPoints, MediumGrain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const vtkIdType first = point > 0 ? cursors[point - 1].load() : 0;
        ends[point] = cursors[point].load();
        std::sort(values.begin() + first, values.begin() + ends[point]);
      }
    });
  vtkIdType first = 0, last = 0;
  for (vtkIdType& end : ends)
  {
    const auto newEnd = std::unique(values.begin() + first, values.begin() + end);
    last = std::move(values.begin() + first, newEnd, values.begin() + last) - values.begin();
    first = std::exchange(end, last);
  }
  values.resize(last);
  values.shrink_to_fit();
}

//------------------------------------------------------------------------------
EdgeList FindEdges(const MeshView& mesh)
{
  std::vector<vtkIdType> ends;
  std::vector<Index> others;
  FillBuckets(
    mesh,
    [](CellFacets& facets, vtkIdType cell, auto&& put)
    {
      facets.ForEachEdge(cell,
        [&](vtkIdType a, vtkIdType b)
        {
          if (a != b)
          {
            put(std::min(a, b), static_cast<Index>(std::max(a, b)));
          }
        });
    },
    ends, others);
  EdgeList edges;
  edges.reserve(others.size());
  vtkIdType first = 0;
  for (vtkIdType point = 0; point < static_cast<vtkIdType>(ends.size()); ++point)
  {
    for (; first < ends[point]; ++first)
    {
      edges.push_back({ { static_cast<Index>(point), others[first] } });
    }
  }
  return edges;
}

//------------------------------------------------------------------------------
PointCells FindPointCells(const MeshView& mesh)
{
  PointCells result;
  std::vector<vtkIdType> ends;
  FillBuckets(
    mesh,
    [&mesh](CellFacets&, vtkIdType cell, auto&& put)
    {
      const bool isEmpty =
        mesh.GetCellType(cell) == VTK_EMPTY_CELL; // hidden cells, regardless of their points
      const IndexRange points = mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i < points.Size && !isEmpty; ++i)
      {
        put(points[i], static_cast<Index>(cell));
      }
    },
    ends, result.Cells);
  result.Offsets.assign(1, 0);
  result.Offsets.insert(result.Offsets.end(), ends.begin(), ends.end());
  return result;
}

//------------------------------------------------------------------------------
std::vector<Index> FindCellRegions(const MeshTopology& topology)
{
  const vtkIdType numberOfCells = topology.GetMesh().GetNumberOfCells();
  DisjointSets sets(static_cast<std::size_t>(numberOfCells));
  std::vector<Index> cells;
  for (const FacetTable* table : { &topology.GetFaces(), &topology.GetSurfaceEdges() })
  {
    for (Index facet = 0; facet < table->GetNumberOfFacets(); ++facet)
    {
      table->GetCells(facet, cells);
      for (const Index cell : cells)
      {
        sets.Insert(cell);
        sets.Join(cell, cells[0]);
      }
    }
  }
  std::vector<Index> regions(static_cast<std::size_t>(numberOfCells), -1);
  Index count = 0;
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    if (sets.Contains(cell))
    {
      const vtkIdType first = sets.Find(cell);
      regions[cell] = first == cell ? count++ : regions[first];
    }
  }
  return regions;
}

//------------------------------------------------------------------------------
// The sets contain uses of points by cells, numbered as in the topology's lists of cells of points.
std::vector<Index> CountPointRegions(const MeshTopology& topology)
{
  const MeshView& mesh = topology.GetMesh();
  const PointCells& around = topology.GetPointCells();
  const auto findUse = [&](vtkIdType point, Index cell)
  {
    const auto begin = around.Cells.begin();
    const auto first = begin + around.Offsets[point], last = begin + around.Offsets[point + 1];
    return std::lower_bound(first, last, cell) - begin;
  };
  DisjointSets sets(around.Cells.size());
  CellFacets facets(mesh);
  std::vector<Index> cells;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const int dimension = facets.GetDimension(cell);
    if (dimension < 2)
    {
      continue;
    }
    const FacetTable& table = topology.GetFacets(dimension);
    const FacetTable::Range uses = table.GetCellFacets(cell);
    facets.ForEach(cell,
      [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
      {
        const Index facet = uses[static_cast<Index>(local)].Facet();
        table.GetCells(facet, cells);
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType own = findUse(points[i], static_cast<Index>(cell));
          sets.Insert(own);
          for (const Index other : cells)
          {
            const vtkIdType theirs = findUse(points[i], other);
            sets.Insert(theirs);
            sets.Join(own, theirs);
          }
        }
      });
  }
  std::vector<Index> counts(static_cast<std::size_t>(mesh.GetNumberOfPoints()), 0);
  for (vtkIdType point = 0; point < mesh.GetNumberOfPoints(); ++point)
  {
    Index ofPolygons = 0, ofPolyhedra = 0;
    for (vtkIdType use = around.Offsets[point]; use < around.Offsets[point + 1]; ++use)
    {
      const bool isGroup = sets.Contains(use) && sets.Find(use) == use;
      (facets.GetDimension(around.Cells[use]) == 2 ? ofPolygons : ofPolyhedra) += isGroup;
    }
    counts[point] = std::max(ofPolygons, ofPolyhedra);
  }
  return counts;
}

//------------------------------------------------------------------------------
// A table that is computed on first use.
template <typename Table>
class OnDemand
{
public:
  template <typename Compute>
  const Table& Get(Compute&& compute)
  {
    std::call_once(this->Once, [&] { this->Value = compute(); });
    return this->Value;
  }

private:
  std::once_flag Once;
  Table Value;
};
}

//------------------------------------------------------------------------------
struct MeshTopology::Tables
{
  OnDemand<FacetTable> Faces, SurfaceEdges;
  OnDemand<EdgeList> Edges;
  OnDemand<camaron::PointCells> PointCells;
  OnDemand<std::vector<Index>> CellRegions, PointRegionCounts;
  LargeVector<Index> GivenFaces; // until Faces is built
  Index NumberOfGivenFaces = 0;
};

//------------------------------------------------------------------------------
// Tables of all meshes whose connectivity arrays exist. The arrays notify the cache when they are
// deleted.
class MeshTopology::Cache
{
public:
  static Cache& Get()
  {
    static Cache* cache = new Cache; // must outlive all arrays
    return *cache;
  }

  /// @param isNew the contents of the mesh have not been modified since it was created
  std::shared_ptr<Tables> Find(vtkDataSet* mesh, bool isNew = false)
  {
    ConnectivityKey key(mesh);
    if (key.GetArrays().empty())
    {
      return std::make_shared<Tables>();
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (Entry& entry : this->Entries)
    {
      if (key.IsOf(entry.Key))
      {
        return entry.Tables;
      }
    }
    for (const auto& known : key.GetArrays())
    {
      vtkObject* const array = std::get<0>(known);
      if (!std::binary_search(this->Observed.begin(), this->Observed.end(), array))
      {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(
          [](vtkObject* caller, unsigned long, void*, void*) { Cache::Get().Forget(caller); });
        array->AddObserver(vtkCommand::DeleteEvent, command);
        this->Observed.insert(
          std::upper_bound(this->Observed.begin(), this->Observed.end(), array), array);
      }
    }
    if (!isNew)
    {
      key.Learn();
    }
    // Tables for the previous contents of a changed array are obsolete.
    const auto first = [](const ConnectivityKey& of) { return std::get<0>(of.GetArrays()[0]); };
    this->Erase([&](const Entry& entry) { return first(entry.Key) == first(key); });
    this->Entries.push_back({ key, std::make_shared<Tables>() });
    return this->Entries.back().Tables;
  }

private:
  struct Entry
  {
    ConnectivityKey Key;
    std::shared_ptr<MeshTopology::Tables> Tables;
  };

  void Forget(vtkObject* array)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Erase(
      [&](const Entry& entry)
      {
        const auto& arrays = entry.Key.GetArrays();
        return std::any_of(arrays.begin(), arrays.end(),
          [&](const auto& known) { return std::get<0>(known) == array; });
      });
    this->Observed.erase(
      std::remove(this->Observed.begin(), this->Observed.end(), array), this->Observed.end());
  }

  template <typename Predicate>
  void Erase(Predicate&& predicate)
  {
    this->Entries.erase(
      std::remove_if(this->Entries.begin(), this->Entries.end(), predicate), this->Entries.end());
  }

  std::mutex Mutex;
  std::vector<Entry> Entries;
  std::vector<vtkObject*> Observed; // sorted
};

//------------------------------------------------------------------------------
MeshTopology::MeshTopology(vtkDataSet* mesh)
  : Mesh(mesh)
  , Shared(Cache::Get().Find(mesh))
{
}

//------------------------------------------------------------------------------
MeshTopology::~MeshTopology() = default;

//------------------------------------------------------------------------------
const FacetTable& MeshTopology::GetFaces() const
{
  Tables& tables = *this->Shared;
  return tables.Faces.Get(
    [&]
    {
      const LargeVector<Index> given = std::move(tables.GivenFaces);
      return FacetTableBuilder::Build(this->Mesh, 3, given, tables.NumberOfGivenFaces);
    });
}

//------------------------------------------------------------------------------
const FacetTable& MeshTopology::GetSurfaceEdges() const
{
  return this->Shared->SurfaceEdges.Get([&] { return FacetTableBuilder::Build(this->Mesh, 2); });
}

//------------------------------------------------------------------------------
const EdgeList& MeshTopology::GetEdges() const
{
  return this->Shared->Edges.Get([&] { return FindEdges(this->Mesh); });
}

//------------------------------------------------------------------------------
const PointCells& MeshTopology::GetPointCells() const
{
  return this->Shared->PointCells.Get([&] { return FindPointCells(this->Mesh); });
}

//------------------------------------------------------------------------------
const std::vector<Index>& MeshTopology::GetCellRegions() const
{
  return this->Shared->CellRegions.Get([&] { return FindCellRegions(*this); });
}

//------------------------------------------------------------------------------
const std::vector<Index>& MeshTopology::GetPointRegionCounts() const
{
  return this->Shared->PointRegionCounts.Get([&] { return CountPointRegions(*this); });
}

//------------------------------------------------------------------------------
void MeshTopology::GetFacePoints(Index face, std::vector<vtkIdType>& points) const
{
  const FacetTable& faces = this->GetFaces();
  points.clear();
  CellFacets(this->Mesh)
    .GetFacet(faces.GetCells(face).First, faces.GetOwnerLocalFacet(face), points);
}

//------------------------------------------------------------------------------
void MeshTopology::Provide(
  vtkUnstructuredGrid* grid, LargeVector<Index>&& cellFaces, Index numberOfFileFaces)
{
  const std::shared_ptr<Tables> tables = Cache::Get().Find(grid, true);
  tables->GivenFaces = std::move(cellFaces);
  tables->NumberOfGivenFaces = numberOfFileFaces;
}
}
