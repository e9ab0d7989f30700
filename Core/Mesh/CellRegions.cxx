// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/CellRegions.h"

#include "Base/DisjointSets.h"
#include "Mesh/CellFacets.h"

#include <algorithm>

namespace camaron
{
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
}
