// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/FaceMesh/SharedFaces.h"

#include "Base/Parallel.h"
#include "Base/Progress.h"
#include "Geometry/FacetRing.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>

namespace camaron
{
//------------------------------------------------------------------------------
SharedFaces::RoleTable SharedFaces::GetUsualRoles()
{
  RoleTable roles;
  for (int type = 0; type < static_cast<int>(roles.size()); ++type)
  {
    const CellShape& shape = GetCellShape(static_cast<unsigned char>(type));
    FaceRole& role = roles[type];
    role = FaceRole::None;
    if (shape.Dimension == 3)
    {
      const bool hasFaces = type == VTK_POLYHEDRON || shape.NumberOfFaces > 0;
      role = hasFaces ? FaceRole::Polyhedron : FaceRole::None;
    }
    else if (shape.Dimension == 2)
    {
      role = type == VTK_TRIANGLE_STRIP ? FaceRole::Strip : FaceRole::Polygon;
    }
    else if (shape.Dimension == 0 || shape.Dimension == 1)
    {
      role = FaceRole::Pieces;
    }
    else if (type == VTK_EMPTY_CELL)
    {
      role = FaceRole::Polyhedron;
    }
  }
  return roles;
}

//------------------------------------------------------------------------------
SharedFaces::SharedFaces(vtkDataSet* mesh, const RoleTable& roles)
  : Topology(mesh)
  , Mesh(this->Topology.GetMesh())
  , Faces(this->Topology.GetFaces())
  , Roles(roles)
{
}

//------------------------------------------------------------------------------
// Whether every edge belongs to two faces, so that the reader can orient the cell.
bool SharedFaces::IsClosed(vtkIdType cell) const
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  CellFacets(this->Mesh)
    .ForEach(cell,
      [&edges](const vtkIdType* points, vtkIdType size, vtkIdType)
      {
        for (vtkIdType i = 0; i < size; ++i)
        {
          const vtkIdType a = points[i], b = points[i + 1 < size ? i + 1 : 0];
          if (a != b)
          {
            edges.emplace_back(std::min(a, b), std::max(a, b));
          }
        }
      });
  std::sort(edges.begin(), edges.end());
  bool closed = edges.size() % 2 == 0;
  for (std::size_t i = 0; closed && i < edges.size(); i += 2)
  {
    closed = edges[i] == edges[i + 1] && (i == 0 || edges[i] != edges[i - 1]);
  }
  return closed;
}

//------------------------------------------------------------------------------
bool SharedFaces::AreSameRing(const Use& use, const Use& other) const
{
  if (!this->Faces.HasOtherRings())
  {
    return true;
  }
  CellFacets facets(this->Mesh), otherFacets(this->Mesh);
  bool areSame = false;
  facets.Visit(use.first, use.second,
    [&](const vtkIdType* points, vtkIdType size)
    {
      otherFacets.Visit(other.first, other.second,
        [&](const vtkIdType* otherPoints, vtkIdType otherSize)
        {
          areSame =
            AreSameRings(FacetPoints{ points, size }, FacetPoints{ otherPoints, otherSize });
        });
    });
  return areSame;
}

//------------------------------------------------------------------------------
// A polygon with two polyhedra can face outward for both only if these traverse it in opposite
// directions. Readers reverse the faces of closed cells; other cells need their own polygons.
void SharedFaces::ShareFacet(Index facet)
{
  std::vector<Index> cells;
  this->Faces.GetCells(facet, cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  const Use none(-1, -1);
  Use first = none;
  Use waiting = none; // has a polygon that another use may share
  bool waitingIsReversed = false;
  for (const Index cell : cells)
  {
    const FacetTable::Range facets = this->Faces.GetCellFacets(cell);
    for (Index local = 0; local < facets.size(); ++local)
    {
      if (facets[local].Facet() != facet)
      {
        continue;
      }
      const Use use(cell, local);
      const bool isReversed = facets[local].IsReversed();
      if (waiting != none && this->AreSameRing(use, waiting) &&
        (isReversed != waitingIsReversed ||
          (this->IsClosed(cell) && this->IsClosed(waiting.first))))
      {
        if (waiting != first)
        {
          this->ExtraUses[use] = { waiting, -1 };
        }
        waiting = none;
        continue;
      }
      if (first == none)
      {
        first = use;
      }
      else
      {
        this->ExtraUses[use] = { use, -1 };
      }
      waiting = use;
      waitingIsReversed = isReversed;
    }
  }
}

//------------------------------------------------------------------------------
void SharedFaces::FindExtraUses()
{
  std::vector<Index> facets;
  std::mutex mutex;
  Progress().For(this->Mesh.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Index> found;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        const FacetTable::Range uses = this->Faces.GetCellFacets(cell);
        for (Index local = 0; local < uses.size(); ++local)
        {
          const Index facet = uses[local].Facet();
          const FacetTable::CellPair cells = this->Faces.GetCells(facet);
          const bool isSameWay = !uses[local].IsReversed() &&
            (cells.First != cell || cells.Second == cell ||
              this->Faces.GetNumberOfCells(facet) > 2);
          if (cells.Second >= 0 &&
            (isSameWay ||
              !this->AreSameRing(
                { cell, local }, { cells.First, this->Faces.GetOwnerLocalFacet(facet) })))
          {
            found.push_back(facet);
          }
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      facets.insert(facets.end(), found.begin(), found.end());
    });
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  for (const Index facet : facets)
  {
    this->ShareFacet(facet);
  }
}

//------------------------------------------------------------------------------
// Calls visit(points, size, local) for the polygons whose first cell this is; local is the index of
// a face of a 3D cell.
template <typename Visit>
void SharedFaces::ForEachPolygon(Scratch& scratch, vtkIdType cell, Visit&& visit) const
{
  switch (this->GetRole(cell))
  {
    case FaceRole::Polyhedron:
    {
      if (this->Mesh.GetCellType(cell) == VTK_EMPTY_CELL)
      {
        return;
      }
      const FacetTable::Range cellFacets = this->Faces.GetCellFacets(cell);
      scratch.Facets.ForEach(cell,
        [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
        {
          const Index facet = cellFacets[static_cast<Index>(local)].Facet();
          bool first = this->Faces.GetCells(facet).First == cell;
          for (Index earlier = 0; first && earlier < local; ++earlier)
          {
            first = cellFacets[earlier].Facet() != facet;
          }
          if (!first && !this->ExtraUses.empty())
          {
            const Use use(cell, static_cast<Index>(local));
            const auto extra = this->ExtraUses.find(use);
            first = extra != this->ExtraUses.end() && extra->second.Start == use;
          }
          if (first)
          {
            visit(points, size, local);
          }
        });
      return;
    }
    case FaceRole::Strip:
    {
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      for (vtkIdType i = 0; i + 2 < points.Size; ++i)
      {
        const vtkIdType triangle[3] = { points[i], points[i + 1 + i % 2], points[i + 2 - i % 2] };
        visit(triangle, vtkIdType(3), vtkIdType(-1));
      }
      return;
    }
    case FaceRole::Pieces:
    {
      const IndexRange points = this->Mesh.GetCellPoints(cell);
      const CellShape& shape = GetCellShape(this->Mesh.GetCellType(cell));
      const vtkIdType pieces = points.Size - shape.Dimension;
      const vtkIdType last = shape.IsHigherOrder ? std::min<vtkIdType>(pieces, 1) : pieces;
      for (vtkIdType i = 0; i < last; ++i)
      {
        const vtkIdType piece[2] = { points[i], points[i + shape.Dimension] };
        visit(piece, vtkIdType(shape.Dimension + 1), vtkIdType(-1));
      }
      return;
    }
    case FaceRole::Polygon:
      scratch.Facets.GetPolygon(cell, scratch.Polygon);
      visit(scratch.Polygon.data(), static_cast<vtkIdType>(scratch.Polygon.size()), vtkIdType(-1));
      return;
    default:
      return;
  }
}

//------------------------------------------------------------------------------
std::int32_t SharedFaces::GetPolygon(vtkIdType cell, Index local, Index facet) const
{
  if (!this->ExtraUses.empty())
  {
    const auto extra = this->ExtraUses.find(Use(cell, local));
    if (extra != this->ExtraUses.end())
    {
      return extra->second.Polygon;
    }
  }
  return this->PolygonOfFacet[facet];
}

//------------------------------------------------------------------------------
void SharedFaces::Build()
{
  this->FindExtraUses();
  const vtkIdType numberOfCells = this->Mesh.GetNumberOfCells();
  const vtkIdType numberOfChunks = (numberOfCells + MediumGrain - 1) / MediumGrain;
  struct Sizes
  {
    vtkIdType Polygons = 0, PolygonWords = 0, Polyhedra = 0, PolyhedronWords = 0;
  };
  std::vector<Sizes> sizes(static_cast<std::size_t>(numberOfChunks) + 1);
  const auto forChunks = [&](auto&& visit)
  {
    Progress().For(numberOfChunks,
      [&](vtkIdType first, vtkIdType last)
      {
        Scratch scratch{ CellFacets(this->Mesh), {} };
        for (vtkIdType chunk = first; chunk < last; ++chunk)
        {
          visit(scratch, chunk, chunk * MediumGrain,
            std::min((chunk + 1) * MediumGrain, numberOfCells));
        }
      });
  };
  forChunks(
    [&](Scratch& scratch, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      Sizes sum;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->ForEachPolygon(scratch, cell,
          [&sum](const vtkIdType*, vtkIdType size, vtkIdType)
          {
            ++sum.Polygons;
            sum.PolygonWords += 1 + size;
          });
        if (this->GetRole(cell) == FaceRole::Polyhedron)
        {
          ++sum.Polyhedra;
          sum.PolyhedronWords += 1 + this->Faces.GetCellFacets(cell).size();
        }
      }
      sizes[chunk + 1] = sum;
    });
  for (vtkIdType chunk = 1; chunk <= numberOfChunks; ++chunk)
  {
    sizes[chunk].Polygons += sizes[chunk - 1].Polygons;
    sizes[chunk].PolygonWords += sizes[chunk - 1].PolygonWords;
    sizes[chunk].Polyhedra += sizes[chunk - 1].Polyhedra;
    sizes[chunk].PolyhedronWords += sizes[chunk - 1].PolyhedronWords;
  }
  const Sizes& total = sizes.back();
  if (std::max(total.Polygons, this->Mesh.GetNumberOfPoints()) > INT32_MAX)
  {
    throw std::length_error("a piece has more polygons or vertices than 32-bit ids can number");
  }
  this->Polygons.Count = total.Polygons;
  this->Polygons.Words = Buffer<std::int32_t>(total.PolygonWords);
  this->Polyhedra.Count = total.Polyhedra;
  this->Polyhedra.Words = Buffer<std::int32_t>(total.PolyhedronWords);
  for (const Sizes& size : sizes)
  {
    this->Polygons.Starts.push_back(size.PolygonWords);
    this->Polyhedra.Starts.push_back(size.PolyhedronWords);
  }

  this->PolygonOfFacet.resize(static_cast<std::size_t>(this->Faces.GetNumberOfFacets()));
  this->CellOfPolygon = Buffer<std::int32_t>(total.Polygons);
  forChunks(
    [&](Scratch& scratch, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      auto polygon = static_cast<std::int32_t>(sizes[chunk].Polygons);
      std::int32_t* word = this->Polygons.Words.data() + sizes[chunk].PolygonWords;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->ForEachPolygon(scratch, cell,
          [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
          {
            this->CellOfPolygon[polygon] = static_cast<std::int32_t>(cell);
            *word++ = static_cast<std::int32_t>(size);
            for (vtkIdType i = 0; i < size; ++i)
            {
              *word++ = static_cast<std::int32_t>(points[i]);
            }
            if (local >= 0)
            {
              const auto extra = this->ExtraUses.find(Use(cell, static_cast<Index>(local)));
              if (extra != this->ExtraUses.end())
              {
                extra->second.Polygon = polygon; // every entry is written once
              }
              else
              {
                const Index facet =
                  this->Faces.GetCellFacets(cell)[static_cast<Index>(local)].Facet();
                this->PolygonOfFacet[facet] = polygon;
              }
            }
            ++polygon;
          });
      }
    });
  for (auto& entry : this->ExtraUses)
  {
    entry.second.Polygon = this->ExtraUses[entry.second.Start].Polygon;
  }

  forChunks(
    [&](Scratch&, vtkIdType chunk, vtkIdType begin, vtkIdType end)
    {
      std::int32_t* word = this->Polyhedra.Words.data() + sizes[chunk].PolyhedronWords;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        if (this->GetRole(cell) == FaceRole::Polyhedron)
        {
          const FacetTable::Range facets = this->Faces.GetCellFacets(cell);
          *word++ = facets.size();
          for (Index local = 0; local < facets.size(); ++local)
          {
            *word++ = this->GetPolygon(cell, local, facets[local].Facet());
          }
        }
      }
    });
}
}
