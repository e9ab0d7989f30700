// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cell/CellNeighborhood.h"

#include "Mesh/FacetLinks.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
bool HasCenter(const CellGeometry& geometry)
{
  return (geometry.GetShapes() & PolygonsAndPolyhedra) && geometry.IsFinite();
}

//------------------------------------------------------------------------------
void ReadCenter(const CellGeometry& geometry, Vector& centroid, double& size)
{
  if (!HasCenter(geometry))
  {
    // Not a position that could be the centroid of a neighbor.
    const double none = Null(NullReason::NotApplicable);
    centroid = { none, none, none };
    size = none;
    return;
  }
  centroid = geometry.ToMesh(geometry.GetCentroid());
  size = (geometry.GetShapes() & Polygons) ? geometry.ToMesh(geometry.GetPolygonArea(), 2)
                                           : geometry.ToMesh(geometry.GetVolume(), 3);
}
}

//------------------------------------------------------------------------------
bool HasCellsOfDimension(const MeshView& mesh, int dimension)
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

//------------------------------------------------------------------------------
void GetCellCenter(const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options,
  CellGeometry& scratch, Vector& centroid, double& size)
{
  scratch.Load(mesh, cell, options);
  scratch.Normalize();
  if (HasCenter(scratch))
  {
    scratch.Compute(CellNeighborhood::BaseNeeds);
  }
  ReadCenter(scratch, centroid, size);
}

//------------------------------------------------------------------------------
Vector GetCellVector(
  const MeshView& mesh, vtkIdType cell, const EvaluationOptions& options, CellGeometry& scratch)
{
  scratch.Load(mesh, cell, options);
  scratch.Normalize();
  if ((scratch.GetShapes() & Polygons) && scratch.GetTopology().GetNumberOfFaces() > 0)
  {
    scratch.Compute(NeedsFaces);
    if (scratch.IsFinite() && !scratch.IsZeroArea(scratch.GetFaceArea(0)))
    {
      return Unit(scratch.GetFaceVector(0));
    }
  }
  return Vector();
}

//------------------------------------------------------------------------------
CellCenters::CellCenters(vtkIdType numberOfCells)
  : Centroids(numberOfCells)
  , Sizes(numberOfCells)
{
}

//------------------------------------------------------------------------------
void CellCenters::Set(vtkIdType cell, const CellGeometry& geometry)
{
  ReadCenter(geometry, this->Centroids[cell], this->Sizes[cell]);
}

//------------------------------------------------------------------------------
CellNeighborhood::CellNeighborhood(
  const MeshTopology& topology, const CellCenters& centers, const EvaluationOptions& options)
  : Centers(centers)
  , Options(options)
  , Links(options.Links)
{
  if (HasCellsOfDimension(topology.GetMesh(), 3))
  {
    this->Faces = &topology.GetFaces();
  }
  if (HasCellsOfDimension(topology.GetMesh(), 2))
  {
    this->Edges = &topology.GetSurfaceEdges();
  }
}

//------------------------------------------------------------------------------
Index CountCellsOfAllPieces(Index facet, const FacetTable& table, const FacetLinks& links,
  const EvaluationOptions& options, std::vector<Index>& scratch)
{
  table.GetCells(facet, scratch);
  auto count = std::count_if(
    scratch.begin(), scratch.end(), [&](Index cell) { return !options.IsCopy(cell); });
  links.ForEach(facet, [&](const LinkedCell&, bool) { ++count; });
  return static_cast<Index>(count);
}

//------------------------------------------------------------------------------
// For facets shared with other pieces: the values of the owning ranks count, not those of
// duplicates.
bool CellNeighborhood::FindLinked(
  vtkIdType cell, CellFacet use, const FacetTable& table, const FacetLinks& links, Facet& facet)
{
  if (!links.Has(use.Facet()) || this->Options.IsCopy(cell))
  {
    return false;
  }
  links.ForEach(use.Facet(),
    [&](const LinkedCell& linked, bool)
    {
      facet.OtherCentroid = this->Geometry->ToCell(linked.Centroid);
      facet.OtherSize = linked.Size;
    });
  const Index count =
    CountCellsOfAllPieces(use.Facet(), table, links, this->Options, this->FacetCells);
  facet.Other = count == 2 ? Side::Cell : Side::NonManifold;
  return true;
}

//------------------------------------------------------------------------------
void CellNeighborhood::FindOther(
  vtkIdType cell, CellFacet use, const FacetTable& table, const FacetLinks* links, Facet& facet)
{
  if (links && this->FindLinked(cell, use, table, *links, facet))
  {
    return;
  }
  const FacetTable::CellPair cells = table.GetCells(use.Facet());
  if (cells.Second < 0)
  {
    facet.Other = this->Options.MayHaveMore(cell) ? Side::Missing : Side::Boundary;
    return;
  }
  if (cells.First == cells.Second || table.HasMoreThanTwoCells(use.Facet()))
  {
    facet.Other = Side::NonManifold;
    return;
  }
  const vtkIdType other = cells.First == cell ? cells.Second : cells.First;
  facet.Other = Side::Cell;
  facet.OtherCentroid = this->Geometry->ToCell(this->Centers.Centroids[other]);
  facet.OtherSize = this->Centers.Sizes[other];
}

//------------------------------------------------------------------------------
// Intermediate values of a facet that several criteria need.
void CellNeighborhood::Finish(Facet& facet) const
{
  facet.IsZero = this->IsPolygon ? this->Geometry->IsZeroLength(facet.Size)
                                 : this->Geometry->IsZeroArea(facet.Size);
  facet.Way = facet.Center - this->GetCentroid();
  facet.WayLength = Norm(facet.Way);
  facet.AreaByWay = Dot(facet.Area, facet.Way);
  facet.Line = facet.Other == Side::Cell ? facet.OtherCentroid - this->GetCentroid() : Vector();
  facet.LineLength = Norm(facet.Line);
  facet.AreaByLine = Dot(facet.Area, facet.Line);
}

//------------------------------------------------------------------------------
// If a point is repeated in a row, the ring has its first occurrence, and the edge begins at the
// last.
void CellNeighborhood::FindUsesOfRing()
{
  const std::vector<vtkIdType>& ids = this->Geometry->GetCornerIds();
  const int size = static_cast<int>(ids.size());
  const auto after = [size](int corner) { return corner + 1 < size ? corner + 1 : 0; };
  this->UsesOfRing.clear();
  for (int corner = 0; corner < size; ++corner)
  {
    if (ids[corner] != ids[corner > 0 ? corner - 1 : size - 1])
    {
      int last = corner;
      while (ids[last] == ids[after(last)])
      {
        last = after(last);
      }
      this->UsesOfRing.push_back(last);
    }
  }
}

//------------------------------------------------------------------------------
bool CellNeighborhood::Load(vtkIdType cell, const CellGeometry& geometry)
{
  this->Geometry = &geometry;
  this->IsPolygon = (geometry.GetShapes() & Polygons) != 0;
  this->Size = this->Centers.Sizes[cell];
  const CellTopology& topology = geometry.GetTopology();
  const FacetTable& table = this->IsPolygon ? *this->Edges : *this->Faces;
  const FacetTable::Range uses = table.GetCellFacets(cell);
  const FacetLinks* links =
    this->Links ? &this->Links->GetFacets(this->IsPolygon ? 2 : 3) : nullptr;
  const auto finish = [&](Facet& facet, int number, int use)
  {
    facet.Number = number;
    facet.Use = use;
    this->FindOther(cell, uses[use], table, links, facet);
    this->Finish(facet);
  };
  if (this->IsPolygon)
  {
    const int size = topology.GetNumberOfFaces() > 0 ? topology.GetFaceSize(0) : 0;
    this->FindUsesOfRing();
    if (size == 0 || size != static_cast<int>(this->UsesOfRing.size()))
    {
      this->Facets.clear();
      return false;
    }
    // A polygon without area has no plane; its edges are treated as collapsed.
    const Vector normal =
      geometry.IsZeroArea(geometry.GetFaceArea(0)) ? Vector() : Unit(geometry.GetFaceVector(0));
    const FaceRing ring(geometry, 0);
    this->Facets.resize(size);
    for (int i = 0; i < size; ++i)
    {
      const Vector &a = ring.GetBegin(i), &b = ring.GetEnd(i);
      Facet& facet = this->Facets[i];
      facet.Area = Cross(b - a, normal);
      facet.Size = Norm(facet.Area);
      facet.Center = 0.5 * (a + b);
      finish(facet, i, this->UsesOfRing[i]);
    }
    return true;
  }
  const int numberOfFaces = topology.GetNumberOfFaces();
  this->Facets.resize(numberOfFaces);
  for (int f = 0; f < numberOfFaces; ++f)
  {
    Facet& facet = this->Facets[f];
    facet.Area = geometry.GetFaceVector(f);
    facet.Size = geometry.GetFaceArea(f);
    facet.Center = geometry.GetFaceCenter(f);
    finish(facet, f, topology.FaceNumbers[f]);
  }
  return true;
}
}
