// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Criteria/CellNeighborhood.h"

#include "Parallel.h"

namespace camaron
{
namespace
{
constexpr vtkIdType Grain = 1024;

//------------------------------------------------------------------------------
bool HasDimension(const MeshView& mesh, int dimension)
{
  const CellShape* const shapes = &GetCellShape(0);
  for (vtkIdType cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    if (shapes[mesh.GetCellType(cell)].Dimension == dimension)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
CellCenters::CellCenters(const MeshView& mesh, const EvaluationOptions& options)
  : Centroids(mesh.GetNumberOfCells())
  , Sizes(mesh.GetNumberOfCells())
{
  ParallelFor(mesh.GetNumberOfCells(), Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      CellGeometry cell;
      for (vtkIdType id = begin; id < end; ++id)
      {
        cell.Load(mesh, id, options);
        const bool isPolygon = (cell.GetShapes() & Polygons) != 0;
        if (!(cell.GetShapes() & PolygonsAndPolyhedra) || !cell.IsFinite())
        {
          this->Sizes[id] = Null(NullReason::NotApplicable);
          continue;
        }
        cell.Compute(CellNeighborhood::BaseNeeds);
        this->Centroids[id] = cell.GetOrigin() + cell.GetCentroid();
        this->Sizes[id] = isPolygon ? cell.GetPolygonArea() : cell.GetVolume();
      }
    });
}

//------------------------------------------------------------------------------
CellNeighborhood::CellNeighborhood(
  const MeshTopology& topology, const CellCenters& centers, const EvaluationOptions& options)
  : Centers(centers)
  , Ghosts(options.Ghosts)
  , IsPieceWithoutGhosts(options.IsPieceWithoutGhosts)
{
  if (HasDimension(topology.GetMesh(), 3))
  {
    this->Faces = &topology.GetFaces();
  }
  if (HasDimension(topology.GetMesh(), 2))
  {
    this->Edges = &topology.GetSurfaceEdges();
  }
}

//------------------------------------------------------------------------------
void CellNeighborhood::FindOther(
  vtkIdType cell, CellFacet use, const FacetTable& table, Facet& facet) const
{
  const FacetTable::CellPair cells = table.GetCells(use.Facet());
  if (cells.Second < 0)
  {
    // What lies beyond a ghost is not known.
    const bool isGhost = this->Ghosts && this->Ghosts[cell];
    facet.Other = isGhost || this->IsPieceWithoutGhosts ? Side::Missing : Side::Boundary;
    return;
  }
  if (cells.First == cells.Second || table.GetNumberOfCells(use.Facet()) > 2)
  {
    facet.Other = Side::NonManifold;
    return;
  }
  const vtkIdType other = cells.First == cell ? cells.Second : cells.First;
  facet.Other = Side::Cell;
  facet.OtherCentroid = this->Centers.Centroids[other] - this->Geometry->GetOrigin();
  facet.OtherSize = this->Centers.Sizes[other];
}

//------------------------------------------------------------------------------
bool CellNeighborhood::Load(vtkIdType cell, const CellGeometry& geometry)
{
  this->Geometry = &geometry;
  this->Facets.clear();
  this->IsPolygon = (geometry.GetShapes() & Polygons) != 0;
  this->Size = this->Centers.Sizes[cell];
  const CellTopology& topology = geometry.GetTopology();
  if (this->IsPolygon)
  {
    const FacetTable::Range uses = this->Edges->GetCellFacets(cell);
    const int size = topology.GetNumberOfFaces() > 0 ? topology.GetFaceSize(0) : 0;
    if (size != uses.size())
    {
      return false; // a point follows itself
    }
    const Vector normal = Unit(geometry.GetFaceVector(0));
    const int* ring = topology.GetFace(0);
    for (int i = 0; i < size; ++i)
    {
      const Vector &a = geometry.GetPoint(ring[i]),
                   &b = geometry.GetPoint(ring[i + 1 < size ? i + 1 : 0]);
      Facet facet;
      facet.Area = Cross(b - a, normal);
      facet.Center = 0.5 * (a + b);
      facet.Number = i;
      this->FindOther(cell, uses[i], *this->Edges, facet);
      this->Facets.push_back(facet);
    }
    return true;
  }
  const FacetTable::Range uses = this->Faces->GetCellFacets(cell);
  for (int f = 0; f < topology.GetNumberOfFaces(); ++f)
  {
    Facet facet;
    facet.Area = geometry.GetFaceVector(f);
    facet.Center = geometry.GetFaceCenter(f);
    facet.Number = f;
    this->FindOther(cell, uses[topology.FaceNumbers[f]], *this->Faces, facet);
    this->Facets.push_back(facet);
  }
  return true;
}
}
