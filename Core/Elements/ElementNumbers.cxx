// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elements/ElementNumbers.h"

#include "Base/Parallel.h"
#include "Elements/Counters.h"
#include "Mesh/CellFacets.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace camaron
{
//------------------------------------------------------------------------------
ElementNumbers::ElementNumbers(
  vtkDataSet* mesh, const unsigned char* ghosts, const std::vector<vtkIdType>& firstCells)
  : Topology(mesh)
  , Ghosts(ghosts)
{
  this->MakePieces(firstCells);
}

//------------------------------------------------------------------------------
bool ElementNumbers::IsGhost(vtkIdType cell) const
{
  return this->Ghosts && (this->Ghosts[cell] & vtkDataSetAttributes::DUPLICATECELL);
}

//------------------------------------------------------------------------------
void ElementNumbers::MakePieces(const std::vector<vtkIdType>& firstCells)
{
  const MeshView& mesh = this->Topology.GetMesh();
  const CellFacets facets(mesh);
  const std::vector<vtkIdType> firsts =
    firstCells.empty() ? std::vector<vtkIdType>{ 0 } : firstCells;
  for (std::size_t i = 0; i < firsts.size(); ++i)
  {
    const vtkIdType end = i + 1 < firsts.size() ? firsts[i + 1] : mesh.GetNumberOfCells();
    Piece piece{ firsts[i], 0, false };
    vtkIdType firstPoint = mesh.GetNumberOfPoints();
    for (vtkIdType cell = firsts[i]; cell < end; ++cell)
    {
      piece.HasVolume |= facets.GetDimension(cell) == 3;
      if (i > 0)
      {
        for (const vtkIdType point : mesh.GetCellPoints(cell))
        {
          firstPoint = std::min(firstPoint, point);
        }
      }
    }
    piece.FirstPoint = i > 0 ? firstPoint : 0;
    this->Pieces.push_back(piece);
  }
}

//------------------------------------------------------------------------------
// Facets of a piece only have cells of that piece.
void ElementNumbers::NumberFaces() const
{
  const FacetTable& table = this->Topology.GetFaces();
  this->Faces.resize(table.GetNumberOfFacets(), None);
  std::size_t piece = 0;
  Index next = 0;
  ForEachOwnFacet(
    table, [&](Index cell) { return !this->IsGhost(cell); },
    [&](Index face, Index cell)
    {
      for (; piece + 1 < this->Pieces.size() && cell >= this->Pieces[piece + 1].FirstCell; ++piece)
      {
        next = 0;
      }
      this->Faces[face] = next++;
    });
}

//------------------------------------------------------------------------------
void ElementNumbers::NumberPolygons() const
{
  const MeshView& mesh = this->Topology.GetMesh();
  const CellFacets facets(mesh);
  this->Polygons.resize(mesh.GetNumberOfCells(), None);
  std::size_t piece = 0;
  Index next = 0;
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    for (; piece + 1 < this->Pieces.size() && cell >= this->Pieces[piece + 1].FirstCell; ++piece)
    {
      next = 0;
    }
    if (!this->Pieces[piece].HasVolume && facets.GetDimension(cell) == 2 && !this->IsGhost(cell))
    {
      this->Polygons[cell] = next++;
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType ElementNumbers::GetFace(vtkIdType cell, const vtkIdType points[3]) const
{
  const MeshView& mesh = this->Topology.GetMesh();
  CellFacets facets(mesh);
  if (facets.GetDimension(cell) == 2)
  {
    if (this->Polygons.empty())
    {
      this->NumberPolygons();
    }
    return this->Polygons[cell];
  }
  if (this->Faces.empty())
  {
    this->NumberFaces();
  }
  const FacetTable::Range uses = this->Topology.GetFaces().GetCellFacets(cell);
  vtkIdType found = None;
  facets.ForEach(cell,
    [&](const vtkIdType* of, vtkIdType size, vtkIdType local)
    {
      const auto has = [&](vtkIdType point)
      { return std::find(of, of + size, point) != of + size; };
      if (found == None && has(points[0]) && has(points[1]) && has(points[2]))
      {
        found = this->Faces[uses[static_cast<Index>(local)].Facet()];
      }
    });
  return found;
}

//------------------------------------------------------------------------------
// Edges are sorted by their points, so those of a piece are contiguous.
void ElementNumbers::NumberEdges() const
{
  const MeshView& mesh = this->Topology.GetMesh();
  const EdgeList& list = this->Topology.GetEdges();
  this->Finder = std::make_unique<EdgeFinder>(list, mesh.GetNumberOfPoints());
  Minima<unsigned char> areCopies(this->Ghosts ? list.size() : 0, 1);
  if (this->Ghosts)
  {
    ParallelFor(mesh.GetNumberOfCells(), MediumGrain,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellFacets facets(mesh);
        for (vtkIdType cell = begin; cell < end; ++cell)
        {
          const unsigned char isCopy = this->IsGhost(cell) ? 1 : 0;
          facets.ForEachEdge(cell,
            [&](vtkIdType a, vtkIdType b)
            {
              if (a != b)
              {
                areCopies.Add(this->Finder->Find(a, b), isCopy);
              }
            });
        }
      });
  }
  this->Edges.resize(list.size(), None);
  std::size_t piece = 0;
  Index next = 0;
  for (std::size_t edge = 0; edge < list.size(); ++edge)
  {
    for (; piece + 1 < this->Pieces.size() && list[edge][0] >= this->Pieces[piece + 1].FirstPoint;
      ++piece)
    {
      next = 0;
    }
    if (!this->Ghosts || !areCopies.Get(static_cast<vtkIdType>(edge)))
    {
      this->Edges[edge] = next++;
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType ElementNumbers::GetEdge(vtkIdType a, vtkIdType b) const
{
  if (!this->Finder)
  {
    this->NumberEdges();
  }
  const EdgeList& list = this->Topology.GetEdges();
  const vtkIdType edge = this->Finder->Find(a, b);
  const bool isThere = edge < static_cast<vtkIdType>(list.size()) &&
    list[edge][0] == std::min(a, b) && list[edge][1] == std::max(a, b);
  return isThere ? this->Edges[edge] : None;
}
}
