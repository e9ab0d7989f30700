// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/MeshElements.h"

#include "Base/Buffer.h"
#include "Base/Parallel.h"
#include "Cell/CellGeometry.h"
#include "Elements/Counters.h"
#include "Mesh/CellFacets.h"
#include "Ranks/KeyRanks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// nullptr if stopped.
vtkSmartPointer<vtkCellArray> MakePolygons(const ElementContext& context, const FacetTable& table)
{
  const MeshView& mesh = context.GetMesh();
  const auto offsets = MakeLargeArray<vtkTypeInt64Array>(table.GetNumberOfFacets() + 1);
  vtkTypeInt64* starts = offsets->GetPointer(0);
  starts[0] = 0;
  const auto forCells = [&](auto&& visit)
  {
    context.ForCells(
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          table.ForEachOwned(cell, facets, visit);
        }
      });
  };
  forCells([&](Index facet, const vtkIdType*, vtkIdType size) { starts[facet + 1] = size; });
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  if (!context.GoesOn())
  {
    return polygons;
  }
  std::partial_sum(starts, starts + table.GetNumberOfFacets() + 1, starts);
  const auto connectivity = MakeLargeArray<vtkTypeInt64Array>(starts[table.GetNumberOfFacets()]);
  vtkTypeInt64* ids = connectivity->GetPointer(0);
  forCells([&](Index facet, const vtkIdType* points, vtkIdType size)
    { std::copy_n(points, size, ids + starts[facet]); });
  polygons->SetData(offsets, connectivity);
  return polygons;
}

//------------------------------------------------------------------------------
// Faces of polyhedra have the orientation of the file, which need not be out of their owners.
void TurnOutward(const ElementContext& context, const FacetTable& table, vtkCellArray* polygons)
{
  const MeshView& mesh = context.GetMesh();
  if (!mesh.HasPolyhedra())
  {
    return;
  }
  const vtkTypeInt64* starts =
    vtkTypeInt64Array::SafeDownCast(polygons->GetOffsetsArray())->GetPointer(0);
  vtkTypeInt64* ids =
    vtkTypeInt64Array::SafeDownCast(polygons->GetConnectivityArray())->GetPointer(0);
  context.ForCells(
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry geometry;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const FacetTable::Range uses = table.GetCellFacets(cell);
        if (uses.size() == 0 || mesh.GetPolyhedronFaces(cell).Size == 0)
        {
          continue;
        }
        geometry.Load(mesh, cell, context.GetOptions());
        geometry.Normalize();
        if (!geometry.IsFinite())
        {
          continue;
        }
        geometry.Compute(NeedsVolume);
        const CellTopology& topology = geometry.GetTopology();
        for (int face = 0; face < topology.GetNumberOfFaces(); ++face)
        {
          const Index local = topology.FaceNumbers[face], facet = uses[local].Facet();
          if (topology.IsReversed(face) && table.IsOwner(facet, cell, local))
          {
            std::reverse(ids + starts[facet] + 1, ids + starts[facet + 1]); // the first point stays
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakePolygonCells(const ElementContext& context)
{
  const CellFacets facets(context.GetMesh());
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> points;
  for (const vtkIdType cell : context.GetPolygonCells())
  {
    facets.GetPolygon(cell, points);
    polygons->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
  }
  return polygons;
}

//------------------------------------------------------------------------------
// Cell array of lines or vertices: k ids each.
vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType size, int points)
{
  const auto offsets = MakeLargeArray<vtkTypeInt64Array>(size + 1);
  for (vtkIdType i = 0; i <= size; ++i)
  {
    offsets->SetValue(i, points * i);
  }
  const auto connectivity = MakeLargeArray<vtkTypeInt64Array>(points * size);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
// Only keeps some of the elements, in the order of @a ids.
void Keep(vtkPolyData* elements, vtkCellArray* cells, const std::vector<vtkIdType>& ids,
  void (vtkPolyData::*set)(vtkCellArray*))
{
  vtkNew<vtkIdList> kept;
  kept->SetNumberOfIds(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), kept->begin());
  vtkNew<vtkCellArray> left;
  vtkNew<vtkIdList> points;
  for (const vtkIdType id : ids)
  {
    cells->GetCellAtId(id, points);
    left->InsertNextCell(points);
  }
  vtkNew<vtkCellData> data;
  data->ShallowCopy(elements->GetCellData());
  elements->GetCellData()->Initialize();
  elements->GetCellData()->CopyAllocate(data, kept->GetNumberOfIds());
  elements->GetCellData()->CopyData(data, kept, vtkIdType(0));
  (elements->*set)(left);
}

//------------------------------------------------------------------------------
// Only keeps the marked elements.
void Keep(vtkPolyData* elements, vtkCellArray* cells, const std::vector<unsigned char>& isKept,
  void (vtkPolyData::*set)(vtkCellArray*))
{
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < isKept.size(); ++i)
  {
    if (isKept[i])
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  if (ids.size() < isKept.size())
  {
    Keep(elements, cells, ids, set);
  }
}

//------------------------------------------------------------------------------
// A face belongs to the cell with the smallest global id; kept are those of own cells.
void MarkGhostFaces(const ElementContext& context, const FacetTable& table, unsigned char* ghosts,
  std::vector<vtkIdType>& kept)
{
  std::vector<Index> cells;
  for (Index face = 0; face < table.GetNumberOfFacets(); ++face)
  {
    table.GetCells(face, cells);
    ghosts[face] = context.BelongsToGhost(cells);
  }
  ForEachOwnFacet(
    table, [&](Index cell) { return !context.IsCopy(cell); },
    [&](Index face, Index) { kept.push_back(face); });
}

//------------------------------------------------------------------------------
// The same for faces that are polygons.
void MarkGhostPolygons(
  const ElementContext& context, unsigned char* ghosts, std::vector<vtkIdType>& kept)
{
  vtkIdType face = 0;
  for (const vtkIdType cell : context.GetPolygonCells())
  {
    ghosts[face] = context.GetOptions().Ghosts[cell];
    if (!context.IsCopy(cell))
    {
      kept.push_back(face);
    }
    ++face;
  }
}

//------------------------------------------------------------------------------
// The keys of facets of a table, or without it, of polygons.
void MakeFaceKeys(const ElementContext& context, const FacetTable* table,
  const std::vector<vtkIdType>& faces, std::vector<ElementKey>& keys)
{
  keys.clear();
  for (const vtkIdType face : faces)
  {
    const auto facet = static_cast<Index>(face);
    const vtkIdType cell =
      table ? vtkIdType(table->GetCells(facet).First) : context.GetPolygonCells()[face];
    keys.push_back(
      { context.GetGlobalCell(cell), table ? vtkIdType(table->GetOwnerLocalFacet(facet)) : 0 });
  }
}

//------------------------------------------------------------------------------
// An edge belongs to the cell with the smallest global id.
void MarkGhostEdges(
  const ElementContext& context, unsigned char* ghosts, std::vector<unsigned char>& isKept)
{
  const EdgeFinder& finder = context.GetEdgeFinder();
  const MeshView& mesh = context.GetMesh();
  // Ids of cells, with a ghost flag in the lowest bit.
  Minima<vtkIdType> owners(isKept.size(), VTK_ID_MAX);
  Minima<unsigned char> areCopies(isKept.size(), 1);
  context.ForCells(
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const bool isCopy = context.IsCopy(cell);
        const vtkIdType owner = 2 * context.GetGlobalCell(cell) + isCopy;
        facets.ForEachEdge(cell,
          [&](vtkIdType a, vtkIdType b)
          {
            if (a != b)
            {
              const vtkIdType edge = finder.Find(a, b);
              owners.Add(edge, owner);
              areCopies.Add(edge, isCopy);
            }
          });
      }
    });
  for (std::size_t edge = 0; edge < isKept.size(); ++edge)
  {
    const bool isGhost = owners.Get(static_cast<vtkIdType>(edge)) & 1;
    ghosts[edge] = isGhost ? vtkDataSetAttributes::DUPLICATECELL : 0;
    isKept[edge] = !areCopies.Get(static_cast<vtkIdType>(edge));
  }
}

//------------------------------------------------------------------------------
// The same for vertices; those without a cell have the flag of their point. The duplicates of a
// piece, which are not in its completed mesh, may have points that no other cell has.
void MarkGhostVertices(
  const ElementContext& context, unsigned char* ghosts, std::vector<unsigned char>& isKept)
{
  const PointCells& around = context.GetTopology().GetPointCells();
  vtkUnsignedCharArray* ofPoints = context.GetPiece()->GetPointGhostArray();
  const std::vector<bool> isUsed = MeshView(context.GetPiece()).FindUsedPoints();
  std::vector<Index> cells;
  for (std::size_t point = 0; point < isKept.size(); ++point)
  {
    const auto begin = around.Cells.begin();
    cells.assign(begin + around.Offsets[point], begin + around.Offsets[point + 1]);
    const auto id = static_cast<vtkIdType>(point);
    const bool isOwn = point < isUsed.size();
    const unsigned char flags = ofPoints && isOwn ? ofPoints->GetValue(id) : 0;
    ghosts[point] =
      flags & vtkDataSetAttributes::HIDDENPOINT ? vtkDataSetAttributes::HIDDENCELL : 0;
    if (cells.empty() || !context.GetOptions().Ghosts)
    {
      ghosts[point] |= flags & vtkDataSetAttributes::DUPLICATEPOINT;
      isKept[point] = isOwn && isUsed[point] == !cells.empty();
      continue;
    }
    ghosts[point] |= context.BelongsToGhost(cells);
    isKept[point] =
      !std::all_of(cells.begin(), cells.end(), [&](Index cell) { return context.IsCopy(cell); });
  }
}

//------------------------------------------------------------------------------
// The worst value of the cells around every point, ignoring NaN.
void AddWorst(const ElementContext& context, const Criterion& criterion, vtkDataArray* values,
  vtkPolyData* vertices)
{
  const PointCells& around = context.GetTopology().GetPointCells();
  const IndexLists points(vertices->GetVerts());
  const auto worst = MakeLargeArray<vtkDoubleArray>(vertices->GetNumberOfCells());
  worst->SetName((std::string("VertexWorst") + criterion.Name).c_str());
  worst->CopyInformation(values->GetInformation());
  double* to = worst->GetPointer(0);
  const bool takesLargest = criterion.Better == Better::Smaller;
  ParallelForEach(worst->GetNumberOfValues(), HeavyGrain,
    [&](vtkIdType vertex)
    {
      const vtkIdType point = points[vertex][0];
      double chosen = Null(NullReason::NotApplicable);
      for (vtkIdType use = around.Offsets[point]; use < around.Offsets[point + 1]; ++use)
      {
        const double value = values->GetComponent(around.Cells[use], 0);
        if (std::isnan(chosen) || (takesLargest ? value > chosen : value < chosen))
        {
          chosen = value;
        }
      }
      to[vertex] = chosen;
    });
  vertices->GetCellData()->AddArray(worst);
}
}

//------------------------------------------------------------------------------
bool MakeFaces(const ElementContext& context, const std::vector<std::string>& arrays,
  vtkPolyData* faces, std::vector<ElementKey>* keys)
{
  if (!context.GoesOn())
  {
    return false;
  }
  constexpr double tables = 0.2, shapes = 0.3; // approximate fractions of the time
  const FacetTable& table = context.GetTopology().GetFaces();
  const bool isVolume = context.HasCells(3);
  {
    const ElementContext::Step step(context, tables, shapes);
    const auto polygons = isVolume ? MakePolygons(context, table) : MakePolygonCells(context);
    if (isVolume && context.GoesOn())
    {
      TurnOutward(context, table, polygons);
    }
    if (!context.GoesOn(1))
    {
      return false;
    }
    faces->SetPolys(polygons);
  }
  {
    const ElementContext::Step step(context, shapes, 1);
    if (!AddElementArrays(context, GetFaceArrays(), arrays, faces))
    {
      return false;
    }
  }
  std::vector<vtkIdType> kept;
  if (!context.GetOptions().Ghosts)
  {
    kept.resize(static_cast<std::size_t>(keys ? faces->GetNumberOfCells() : 0));
    std::iota(kept.begin(), kept.end(), 0);
  }
  else
  {
    unsigned char* ghosts = AddGhostArray(faces);
    if (isVolume)
    {
      MarkGhostFaces(context, table, ghosts, kept);
    }
    else
    {
      MarkGhostPolygons(context, ghosts, kept);
    }
    Keep(faces, faces->GetPolys(), kept, &vtkPolyData::SetPolys);
  }
  if (keys)
  {
    MakeFaceKeys(context, isVolume ? &table : nullptr, kept, *keys);
  }
  return context.GoesOn(1);
}

//------------------------------------------------------------------------------
bool MakeEdges(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* edges)
{
  if (!context.GoesOn())
  {
    return false;
  }
  const EdgeList& list = context.GetTopology().GetEdges();
  const auto lines = MakeCells(static_cast<vtkIdType>(list.size()), 2);
  auto* ids = vtkTypeInt64Array::SafeDownCast(lines->GetConnectivityArray())->GetPointer(0);
  for (const auto& edge : list)
  {
    ids = std::copy(edge.begin(), edge.end(), ids);
  }
  edges->SetLines(lines);
  constexpr double table = 0.3; // approximate fraction of the time
  const ElementContext::Step step(context, table, 1);
  if (!AddElementArrays(context, GetEdgeArrays(), arrays, edges))
  {
    return false;
  }
  if (context.GetOptions().Ghosts)
  {
    std::vector<unsigned char> isKept(list.size());
    MarkGhostEdges(context, AddGhostArray(edges), isKept);
    Keep(edges, lines, isKept, &vtkPolyData::SetLines);
  }
  return context.GoesOn(1);
}

//------------------------------------------------------------------------------
bool MakeVertices(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* vertices)
{
  if (!context.GoesOn())
  {
    return false;
  }
  const vtkIdType size = context.GetMesh().GetNumberOfPoints();
  const auto cells = MakeCells(size, 1);
  auto* ids = vtkTypeInt64Array::SafeDownCast(cells->GetConnectivityArray())->GetPointer(0);
  std::iota(ids, ids + size, 0);
  vertices->SetVerts(cells);
  if (!AddElementArrays(context, GetVertexArrays(), arrays, vertices))
  {
    return false;
  }
  if (context.GetOptions().Ghosts || context.GetPiece()->GetPointGhostArray())
  {
    std::vector<unsigned char> isKept(static_cast<std::size_t>(size));
    MarkGhostVertices(context, AddGhostArray(vertices), isKept);
    Keep(vertices, cells, isKept, &vtkPolyData::SetVerts);
  }
  return context.GoesOn(1);
}

//------------------------------------------------------------------------------
bool AddWorstOfCells(const ElementContext& context, vtkPolyData* vertices)
{
  vtkCellData* data = context.GetData()->GetCellData();
  for (const Criterion& criterion : GetCriteria())
  {
    vtkDataArray* values = data->GetArray(criterion.Name);
    if (values && values->GetNumberOfComponents() == 1 && criterion.Better != Better::Neither)
    {
      if (!context.GoesOn())
      {
        return false;
      }
      AddWorst(context, criterion, values, vertices);
    }
  }
  return context.GoesOn(1);
}

namespace
{
//------------------------------------------------------------------------------
// A key and its block as one number; keeps the order.
class KeyPacker
{
public:
  /// Collective.
  KeyPacker(const std::vector<KeyedElements>& pieces, Reducer& reducer)
  {
    std::int64_t limits[] = { 1, 1, 1 }, hasNegative = 0;
    for (const KeyedElements& piece : pieces)
    {
      limits[0] = std::max<std::int64_t>(limits[0], piece.Block + 1);
      for (const ElementKey& key : piece.Keys)
      {
        limits[1] = std::max(limits[1], key[0] + 1);
        limits[2] = std::max(limits[2], key[1] + 1);
        hasNegative |= key[0] < 0 || key[1] < 0;
      }
    }
    reducer.Max(limits, 3);
    reducer.Max(&hasNegative, 1);
    this->Factors = { limits[1], limits[2] };
    this->FitsAll = !hasNegative &&
      static_cast<double>(limits[0]) * static_cast<double>(limits[1]) *
          static_cast<double>(limits[2]) <
        static_cast<double>(std::numeric_limits<std::int64_t>::max());
  }
  bool CanPack() const { return this->FitsAll; }
  std::int64_t Pack(int block, const ElementKey& key) const
  {
    return (block * this->Factors[0] + key[0]) * this->Factors[1] + key[1];
  }

private:
  std::array<std::int64_t, 2> Factors;
  bool FitsAll;
};
}

//------------------------------------------------------------------------------
std::vector<ElementKey> MakeKeys(vtkPolyData* elements)
{
  std::vector<ElementKey> keys;
  vtkDataArray* ids = elements->GetPointData()->GetGlobalIds();
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; ids && i < elements->GetNumberOfCells(); ++i)
  {
    elements->GetCellPoints(i, points);
    ElementKey key = { 0, 0 };
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      key[k] = static_cast<std::int64_t>(ids->GetComponent(points->GetId(k), 0));
    }
    std::sort(key.begin(), key.begin() + points->GetNumberOfIds());
    keys.push_back(key);
  }
  return keys;
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> NumberElements(
  const std::vector<KeyedElements>& pieces, Reducer& reducer)
{
  const KeyPacker packer(pieces, reducer);
  if (!packer.CanPack())
  {
    return {};
  }
  std::vector<KeyCounts> all;
  for (const KeyedElements& piece : pieces)
  {
    for (std::size_t i = 0; i < piece.Keys.size(); ++i)
    {
      const bool isGhost = piece.Ghosts && (piece.Ghosts[i] & vtkDataSetAttributes::DUPLICATECELL);
      all.push_back({ packer.Pack(piece.Block, piece.Keys[i]), { isGhost ? 0 : 1, 0 } });
    }
  }
  const auto isBefore = [](const KeyCounts& a, const KeyCounts& b) { return a.Key < b.Key; };
  std::sort(all.begin(), all.end(), isBefore);
  std::size_t size = 0; // of the distinct keys
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (size > 0 && all[size - 1].Key == all[i].Key)
    {
      all[size - 1].Counts[0] += all[i].Counts[0];
    }
    else
    {
      all[size++] = all[i];
    }
  }
  all.resize(size);
  const std::vector<KeyRank> ranks = RankKeys(all, reducer);
  std::int64_t isRepeated =
    std::any_of(ranks.begin(), ranks.end(), [](const KeyRank& rank) { return rank.Counts[0] > 1; });
  reducer.Max(&isRepeated, 1);
  if (isRepeated)
  {
    return {};
  }
  std::vector<std::vector<vtkIdType>> ids(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    for (const ElementKey& key : pieces[p].Keys)
    {
      const KeyCounts wanted = { packer.Pack(pieces[p].Block, key), {} };
      const auto found = std::lower_bound(all.begin(), all.end(), wanted, isBefore);
      ids[p].push_back(static_cast<vtkIdType>(ranks[found - all.begin()].Before[0]));
    }
  }
  return ids;
}
}
