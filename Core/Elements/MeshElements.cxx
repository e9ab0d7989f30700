// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/MeshElements.h"

#include "Elements/Counters.h"
#include "Mesh/CellFacets.h"
#include "Parallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> MakePolygons(const MeshView& mesh, const FacetTable& table)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(table.GetNumberOfFacets() + 1);
  vtkTypeInt64* starts = offsets->GetPointer(0);
  starts[0] = 0;
  const auto forCells = [&](auto&& visit)
  {
    ParallelFor(mesh.GetNumberOfCells(), Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          const FacetTable::Range uses = table.GetCellFacets(cell);
          if (uses.size() > 0)
          {
            facets.ForEach(cell,
              [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
              {
                const Index facet = uses[static_cast<Index>(local)].Facet();
                if (table.GetCells(facet).First == cell &&
                  table.GetOwnerLocalFacet(facet) == static_cast<Index>(local))
                {
                  visit(facet, points, size);
                }
              });
          }
        }
      });
  };
  forCells([&](Index facet, const vtkIdType*, vtkIdType size) { starts[facet + 1] = size; });
  std::partial_sum(starts, starts + table.GetNumberOfFacets() + 1, starts);
  connectivity->SetNumberOfValues(starts[table.GetNumberOfFacets()]);
  vtkTypeInt64* ids = connectivity->GetPointer(0);
  forCells([&](Index facet, const vtkIdType* points, vtkIdType size)
    { std::copy_n(points, size, ids + starts[facet]); });
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(offsets, connectivity);
  return polygons;
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
// Cells that lines or vertices are made of: k ids each.
vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType size, int points)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(size + 1);
  for (vtkIdType i = 0; i <= size; ++i)
  {
    offsets->SetValue(i, points * i);
  }
  connectivity->SetNumberOfValues(points * size);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

//------------------------------------------------------------------------------
// Edges belong to the cell of the smallest global id of all that have them.
void MarkGhostEdges(const ElementContext& context, unsigned char* ghosts)
{
  const EdgeFinder& finder = context.GetEdgeFinder();
  const MeshView& mesh = context.GetMesh();
  // Ids of cells, ghosts in the lowest bit.
  Minima<vtkIdType> owners(context.GetTopology().GetEdges().size(), VTK_ID_MAX);
  ParallelFor(mesh.GetNumberOfCells(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellFacets facets(mesh);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const vtkIdType owner = 2 * context.GetGlobalCell(cell) + context.IsGhost(cell);
        facets.ForEachEdge(cell,
          [&](vtkIdType a, vtkIdType b)
          {
            if (a != b)
            {
              owners.Add(finder.Find(a, b), owner);
            }
          });
      }
    });
  for (std::size_t edge = 0; edge < context.GetTopology().GetEdges().size(); ++edge)
  {
    const bool isGhost = owners.Get(static_cast<vtkIdType>(edge)) & 1;
    ghosts[edge] = isGhost ? vtkDataSetAttributes::DUPLICATECELL : 0;
  }
}

//------------------------------------------------------------------------------
// The worst value of the cells around every point; what is null counts for nothing.
void AddWorst(const ElementContext& context, const Criterion& criterion, vtkDataArray* values,
  vtkPolyData* vertices)
{
  const PointCells& around = context.GetTopology().GetPointCells();
  vtkNew<vtkDoubleArray> worst;
  worst->SetName((std::string("VertexWorst") + criterion.Name).c_str());
  worst->SetNumberOfValues(vertices->GetNumberOfCells());
  worst->CopyInformation(values->GetInformation());
  double* to = worst->GetPointer(0);
  const bool takesLargest = criterion.Better == Better::Smaller;
  ParallelFor(worst->GetNumberOfValues(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        double chosen = Null(NullReason::NotApplicable);
        for (vtkIdType use = around.Offsets[point]; use < around.Offsets[point + 1]; ++use)
        {
          const double value = values->GetComponent(around.Cells[use], 0);
          if (std::isnan(chosen) || (takesLargest ? value > chosen : value < chosen))
          {
            chosen = value;
          }
        }
        to[point] = chosen;
      }
    });
  vertices->GetCellData()->AddArray(worst);
}
}

//------------------------------------------------------------------------------
void MakeFaces(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* faces)
{
  const FacetTable& table = context.GetTopology().GetFaces();
  const bool isVolume = context.HasCells(3);
  faces->SetPolys(
    isVolume ? MakePolygons(context.GetMesh(), table) : MakePolygonCells(context));
  AddElementArrays(context, GetFaceArrays(), arrays, faces);
  if (!context.GetOptions().Ghosts)
  {
    return;
  }
  unsigned char* ghosts = AddGhostArray(faces);
  std::vector<Index> cells;
  for (vtkIdType face = 0; face < faces->GetNumberOfCells(); ++face)
  {
    if (isVolume)
    {
      table.GetCells(static_cast<Index>(face), cells);
      ghosts[face] = context.BelongsToGhost(cells);
    }
    else
    {
      ghosts[face] = context.GetOptions().Ghosts[context.GetPolygonCells()[face]];
    }
  }
}

//------------------------------------------------------------------------------
void MakeEdges(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* edges)
{
  const EdgeList& list = context.GetTopology().GetEdges();
  const auto lines = MakeCells(static_cast<vtkIdType>(list.size()), 2);
  auto* ids = vtkTypeInt64Array::SafeDownCast(lines->GetConnectivityArray())->GetPointer(0);
  for (const auto& edge : list)
  {
    ids = std::copy(edge.begin(), edge.end(), ids);
  }
  edges->SetLines(lines);
  AddElementArrays(context, GetEdgeArrays(), arrays, edges);
  if (context.GetOptions().Ghosts)
  {
    MarkGhostEdges(context, AddGhostArray(edges));
  }
}

//------------------------------------------------------------------------------
void MakeVertices(
  const ElementContext& context, const std::vector<std::string>& arrays, vtkPolyData* vertices)
{
  const vtkIdType size = context.GetMesh().GetNumberOfPoints();
  const auto cells = MakeCells(size, 1);
  auto* ids = vtkTypeInt64Array::SafeDownCast(cells->GetConnectivityArray())->GetPointer(0);
  std::iota(ids, ids + size, 0);
  vertices->SetVerts(cells);
  AddElementArrays(context, GetVertexArrays(), arrays, vertices);
  if (vtkUnsignedCharArray* ghosts = context.GetData()->GetPointGhostArray())
  {
    std::copy_n(ghosts->GetPointer(0), size, AddGhostArray(vertices));
  }
}

//------------------------------------------------------------------------------
void AddWorstOfCells(const ElementContext& context, vtkPolyData* vertices)
{
  vtkCellData* data = context.GetData()->GetCellData();
  for (const Criterion& criterion : GetCriteria())
  {
    vtkDataArray* values = data->GetArray(criterion.Name);
    if (values && values->GetNumberOfComponents() == 1 && criterion.Better != Better::Neither)
    {
      AddWorst(context, criterion, values, vertices);
    }
  }
}
}
