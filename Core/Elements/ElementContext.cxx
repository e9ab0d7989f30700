// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementContext.h"

#include "Elements/CoincidentPoints.h"
#include "Elements/Counters.h"
#include "Mesh/CellFacets.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Sorts and removes repetitions.
void MakeUnique(std::vector<vtkIdType>& items)
{
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

//------------------------------------------------------------------------------
// Counts uses by cells and faces: forItems(points, size, visit(item)) visits the items that a ring
// of points uses.
template <typename ForItems>
class UseCounter
{
public:
  UseCounter(const ElementContext& context, std::size_t size, const ForItems& forItems)
    : Table(context.GetTopology().GetFaces())
    , ForItemsOf(forItems)
    , Cells(size)
    , Polygons(size)
    , Faces(size)
    , BoundaryFaces(size)
  {
    context.ForCells(
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(context.GetMesh());
        Scratch scratch;
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          this->Count(cell, facets, scratch);
        }
      });
  }
  ElementUses Get() const
  {
    return { this->Cells.Get(), this->Polygons.Get(), this->Faces.Get(),
      this->BoundaryFaces.Get() };
  }

private:
  struct Scratch
  {
    std::vector<vtkIdType> Ring, OfFace, OfCell;
  };

  void Count(vtkIdType cell, CellFacets& facets, Scratch& scratch)
  {
    const bool isPolygon = facets.GetDimension(cell) == 2;
    scratch.OfCell.clear();
    if (isPolygon)
    {
      facets.GetPolygon(cell, scratch.Ring);
      this->FindItems(scratch.Ring.data(), static_cast<vtkIdType>(scratch.Ring.size()), scratch);
      AddAll(scratch.OfFace, this->Faces);
    }
    else
    {
      const FacetTable::Range uses = this->Table.GetCellFacets(cell);
      facets.ForEach(cell,
        [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
        {
          this->FindItems(points, size, scratch);
          const auto use = static_cast<Index>(local);
          const bool isUsed = use < uses.size() && !this->Table.IsCollapsed(uses[use].Facet());
          if (isUsed && this->Table.IsOwner(uses[use].Facet(), cell, use))
          {
            AddAll(scratch.OfFace, this->Faces);
            if (this->Table.IsBoundary(uses[use].Facet()))
            {
              AddAll(scratch.OfFace, this->BoundaryFaces);
            }
          }
        });
    }
    MakeUnique(scratch.OfCell);
    AddAll(scratch.OfCell, this->Cells);
    if (isPolygon)
    {
      AddAll(scratch.OfCell, this->Polygons);
    }
  }

  // The distinct items of one face, and adds them to those of the other faces of the cell.
  void FindItems(const vtkIdType* points, vtkIdType size, Scratch& scratch) const
  {
    scratch.OfFace.clear();
    this->ForItemsOf(points, size, [&](vtkIdType item) { scratch.OfFace.push_back(item); });
    MakeUnique(scratch.OfFace);
    scratch.OfCell.insert(scratch.OfCell.end(), scratch.OfFace.begin(), scratch.OfFace.end());
  }

  static void AddAll(const std::vector<vtkIdType>& items, Counters& counters)
  {
    for (const vtkIdType item : items)
    {
      counters.Add(item);
    }
  }

  const FacetTable& Table;
  const ForItems& ForItemsOf;
  Counters Cells, Polygons, Faces, BoundaryFaces;
};

//------------------------------------------------------------------------------
EdgeAngles ComputeEdgeAngles(const ElementContext& context)
{
  const EdgeFinder& finder = context.GetEdgeFinder();
  const std::size_t size = context.GetTopology().GetEdges().size();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Minima<double> smallest(size, infinity), negated(size, infinity);
  AngleSums sums(size);
  context.ForCells(
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      for (vtkIdType id = begin; id < end; ++id)
      {
        cell.Load(context.GetMesh(), id, context.GetOptions());
        cell.Normalize();
        if (!(cell.GetShapes() & Polyhedra))
        {
          continue;
        }
        cell.Compute(NeedsEdges | NeedsFaces | NeedsVolume | NeedsDihedral);
        const std::vector<CellTopology::Edge>& edges = cell.GetTopology().Edges;
        for (std::size_t e = 0; e < edges.size(); ++e)
        {
          const vtkIdType edge =
            finder.Find(cell.GetPointId(edges[e].Points[0]), cell.GetPointId(edges[e].Points[1]));
          const double angle = cell.GetDihedralAngle(static_cast<int>(e));
          sums.Add(edge, angle);
          if (!std::isnan(angle))
          {
            smallest.Add(edge, angle);
            negated.Add(edge, -angle);
          }
        }
      }
    });
  EdgeAngles angles;
  angles.Sum.reserve(size);
  angles.Min.reserve(size);
  angles.Max.reserve(size);
  const auto get = [&](double value, double sum)
  {
    return std::abs(value) < infinity ? value
      : std::isnan(sum)               ? sum
                                      : Null(NullReason::NotApplicable);
  };
  for (vtkIdType edge = 0; edge < static_cast<vtkIdType>(size); ++edge)
  {
    const double sum = sums.Get(edge);
    angles.Sum.push_back(sum);
    angles.Min.push_back(get(smallest.Get(edge), sum));
    const double largest = get(negated.Get(edge), sum);
    angles.Max.push_back(std::isnan(largest) ? largest : -largest);
  }
  return angles;
}

//------------------------------------------------------------------------------
// The value of a table, which is built on first use.
template <typename Table, typename Make>
const Table& GetOnce(std::optional<Table>& table, Make&& make)
{
  if (!table)
  {
    table.emplace(make());
  }
  return *table;
}
}

//------------------------------------------------------------------------------
unsigned FindCellDimensions(const MeshView& mesh)
{
  const CellFacets facets(mesh);
  unsigned dimensions = 0;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    const int dimension = facets.GetDimension(cell);
    dimensions |= dimension >= 2 ? 1u << dimension : 0;
  }
  return dimensions;
}

//------------------------------------------------------------------------------
ElementContext::ElementContext(vtkDataSet* mesh, const MeshTopology& topology,
  EvaluationOptions options, double mergeTolerance, const ElementSource& source)
  : Data(mesh)
  , Topology(topology)
  , Options(options)
  , MergeTolerance(mergeTolerance)
  , Source(source)
{
  this->Source.Piece = source.Piece ? source.Piece : mesh;
  this->Source.Dimensions |= FindCellDimensions(this->GetMesh());
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  this->Options.Ghosts = ghosts ? ghosts->GetPointer(0) : nullptr;
  this->Options.GlobalIds = mesh->GetCellData()->GetGlobalIds();
}

//------------------------------------------------------------------------------
bool ElementContext::GoesOn(double done) const
{
  // Tables shared by several arrays are built in the step of the first one, possibly in several
  // passes.
  this->Done = std::max(this->Done, this->Range[0] + done * (this->Range[1] - this->Range[0]));
  this->IsStopped = this->IsStopped || (this->Progress && !this->Progress(this->Done));
  return !this->IsStopped;
}

//------------------------------------------------------------------------------
vtkIdType ElementContext::GetGlobalCell(vtkIdType cell) const
{
  vtkDataArray* ids = this->Options.GlobalIds;
  return ids ? static_cast<vtkIdType>(ids->GetComponent(cell, 0)) : cell;
}

//------------------------------------------------------------------------------
unsigned char ElementContext::BelongsToGhost(const std::vector<Index>& cells) const
{
  const auto first = std::min_element(cells.begin(), cells.end(),
    [this](Index a, Index b) { return this->GetGlobalCell(a) < this->GetGlobalCell(b); });
  return first != cells.end() && this->IsCopy(*first) ? vtkDataSetAttributes::DUPLICATECELL : 0;
}

//------------------------------------------------------------------------------
const EdgeFinder& ElementContext::GetEdgeFinder() const
{
  return GetOnce(this->Edges,
    [this] { return EdgeFinder(this->Topology.GetEdges(), this->GetMesh().GetNumberOfPoints()); });
}

//------------------------------------------------------------------------------
const ElementUses& ElementContext::GetEdgeUses() const
{
  const EdgeFinder& finder = this->GetEdgeFinder();
  return GetOnce(this->EdgeUses,
    [&]
    {
      return UseCounter(*this, this->Topology.GetEdges().size(),
        [&](const vtkIdType* points, vtkIdType size, auto&& visit)
        {
          for (vtkIdType i = 0; i < size; ++i)
          {
            const vtkIdType a = points[i], b = points[i + 1 < size ? i + 1 : 0];
            if (a != b)
            {
              visit(finder.Find(a, b));
            }
          }
        })
        .Get();
    });
}

//------------------------------------------------------------------------------
const ElementUses& ElementContext::GetVertexUses() const
{
  return GetOnce(this->VertexUses,
    [this]
    {
      return UseCounter(*this, static_cast<std::size_t>(this->GetMesh().GetNumberOfPoints()),
        [](const vtkIdType* points, vtkIdType size, auto&& visit)
        {
          for (vtkIdType i = 0; i < size; ++i)
          {
            visit(points[i]);
          }
        })
        .Get();
    });
}

//------------------------------------------------------------------------------
const EdgeAngles& ElementContext::GetEdgeAngles() const
{
  return GetOnce(this->Angles, [this] { return ComputeEdgeAngles(*this); });
}

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& ElementContext::GetCoincidentPoints() const
{
  return GetOnce(this->CoincidentPoints,
    [this]
    {
      PointNumbers numbers;
      numbers.Array = this->Source.Piece->GetPointData()->GetGlobalIds();
      std::vector<vtkIdType> points = this->Source.CoincidentPoints
        ? *this->Source.CoincidentPoints
        : FindCoincidentPoints(MeshView(this->Source.Piece), this->MergeTolerance, numbers);
      points.resize(static_cast<std::size_t>(this->GetMesh().GetNumberOfPoints()), -1);
      return points;
    });
}

//------------------------------------------------------------------------------
const std::vector<Index>& ElementContext::GetMismatchedFaces() const
{
  return GetOnce(this->MismatchedFaces,
    [this]
    {
      if (this->Source.MismatchedFaces)
      {
        return *this->Source.MismatchedFaces;
      }
      Reducer alone;
      const PieceOfFaces whole = { &this->Topology, 0, [](Index) { return true; } };
      return FindMismatchedFaces({ whole }, this->MergeTolerance, alone)[0];
    });
}

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& ElementContext::GetPolygonCells() const
{
  return GetOnce(this->PolygonCells,
    [this]
    {
      const CellFacets facets(this->GetMesh());
      std::vector<vtkIdType> cells;
      for (vtkIdType cell = 0; cell < this->GetMesh().GetNumberOfCells(); ++cell)
      {
        if (facets.GetDimension(cell) == 2)
        {
          cells.push_back(cell);
        }
      }
      return cells;
    });
}
}
