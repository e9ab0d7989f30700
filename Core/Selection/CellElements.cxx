// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Selection/CellElements.h"

#include "Base/Parallel.h"
#include "Cell/CellNeighborhood.h"
#include "Mesh/MeshTopology.h"

namespace camaron
{
//------------------------------------------------------------------------------
CellElements::CellElements(const MeshTopology& topology, Adjacency adjacency)
  : Mesh(topology.GetMesh())
  , Kind(adjacency)
{
  if (adjacency == Adjacency::Vertex)
  {
    this->Size = this->Mesh.GetNumberOfPoints();
  }
  else if (adjacency == Adjacency::Edge)
  {
    this->FindEdges(topology);
  }
  else
  {
    if (HasCellsOfDimension(this->Mesh, 3))
    {
      this->Faces = &topology.GetFaces();
      this->NumberOfFaces = this->Faces->GetNumberOfFacets();
    }
    if (HasCellsOfDimension(this->Mesh, 2))
    {
      this->SurfaceEdges = &topology.GetSurfaceEdges();
    }
    this->Size =
      this->NumberOfFaces + (this->SurfaceEdges ? this->SurfaceEdges->GetNumberOfFacets() : 0);
  }
}

//------------------------------------------------------------------------------
void CellElements::FindEdges(const MeshTopology& topology)
{
  const EdgeList& edges = topology.GetEdges();
  const EdgeFinder finder(edges, this->Mesh.GetNumberOfPoints());
  const vtkIdType numberOfCells = this->Mesh.GetNumberOfCells();
  this->Size = static_cast<vtkIdType>(edges.size());
  this->EdgeOffsets.resize(numberOfCells + 1);
  const auto forEachEdge = [&](vtkIdType begin, vtkIdType end, auto&& visit)
  {
    CellFacets facets(this->Mesh);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      facets.ForEachEdge(cell,
        [&](vtkIdType a, vtkIdType b)
        {
          if (a != b) // skips edges of collapsed cells
          {
            visit(cell, a, b);
          }
        });
    }
  };
  constexpr vtkIdType chunk = 1 << 14;
  ParallelScan(
    numberOfCells, chunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType count = 0;
      forEachEdge(begin, end, [&](vtkIdType, vtkIdType, vtkIdType) { ++count; });
      return count;
    },
    [&](vtkIdType begin, vtkIdType end, vtkIdType before)
    {
      std::fill(this->EdgeOffsets.begin() + begin + 1, this->EdgeOffsets.begin() + end + 1, before);
      forEachEdge(begin, end,
        [&](vtkIdType cell, vtkIdType, vtkIdType) { this->EdgeOffsets[cell + 1] = ++before; });
    });
  for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
  {
    // Cells without edges end where the one before does.
    this->EdgeOffsets[cell + 1] = std::max(this->EdgeOffsets[cell + 1], this->EdgeOffsets[cell]);
  }
  this->Edges.resize(this->EdgeOffsets.back());
  ParallelFor(numberOfCells, chunk,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdType next = this->EdgeOffsets[begin];
      forEachEdge(begin, end, [&](vtkIdType, vtkIdType a, vtkIdType b)
        { this->Edges[next++] = static_cast<Index>(finder.Find(a, b)); });
    });
}
}
