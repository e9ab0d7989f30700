// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/DrawableFaces.h"

#include "Base/Parallel.h"
#include "Drawing/CurvedFacets.h"
#include "Drawing/PolygonTriangles.h"
#include "Geometry/FacetRing.h"
#include "Mesh/CellFacets.h"
#include "Mesh/FacetLinks.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace camaron
{
namespace
{
constexpr int Outer = 0;
constexpr int Inner = 1;

struct Vertices
{
  const vtkIdType* Points = nullptr;
  vtkIdType Size = 0;
};

struct Counts
{
  vtkIdType Faces[2] = { 0, 0 };
  vtkIdType Triangles[2] = { 0, 0 };
};

//------------------------------------------------------------------------------
// Visits the faces that a cell contributes: those it owns, those where it is a third cell, and
// itself if 2D.
class FacesOfCells
{
public:
  FacesOfCells(const MeshTopology& topology, const CellsToDraw& cells)
    : Mesh(topology.GetMesh())
    , Table(topology.GetFaces())
    , Cells(cells)
    , Facets(this->Mesh)
    , Curved(this->Mesh, cells.Subdivided)
  {
  }

  // Calls visit(kind, outline, cells, vertices) for the boundary faces or all faces; vertices are
  // those of interior faces.
  template <typename Visitor>
  void ForEach(vtkIdType cell, FacesToDraw which, Visitor&& visit)
  {
    if (this->Cells.IsHidden(cell))
    {
      return;
    }
    const auto self = static_cast<std::uint32_t>(cell);
    const int dimension = this->Facets.GetDimension(cell);
    if (dimension == 2 && !this->Cells.IsGhost(cell))
    {
      visit(Outer, this->Curved.GetSurface(cell),
        std::array<std::uint32_t, 2>{ { self, DrawableFaces::NoCell } }, Vertices());
    }
    if (dimension != 3)
    {
      return;
    }
    // Most cells have no boundary face, so points are fetched last.
    const FacetTable::Range uses = this->Table.GetCellFacets(cell);
    for (Index local = 0; local < uses.size(); ++local)
    {
      const vtkIdType other = this->GetOther(uses[local].Facet(), cell, local);
      if (other == NotOurs ||
        (this->Cells.IsGhost(cell) && (other == None || this->Cells.IsGhost(other))))
      {
        continue;
      }
      const auto neighbor = other != None  ? static_cast<std::uint32_t>(other)
        : this->Cells.IsOuter(cell, local) ? DrawableFaces::NoCell
                                           : DrawableFaces::CellElsewhere;
      const int kind = neighbor == DrawableFaces::NoCell ? Outer : Inner;
      if (kind == Outer || which == FacesToDraw::All)
      {
        this->Facets.Visit(cell, local,
          [&](const vtkIdType* points, vtkIdType size)
          {
            visit(kind, this->GetOutline(cell, local, points, size),
              std::array<std::uint32_t, 2>{ { self, neighbor } }, Vertices{ points, size });
          });
      }
    }
  }

private:
  static constexpr vtkIdType None = -1;
  static constexpr vtkIdType NotOurs = -2;

  PolygonTriangles::Outline GetOutline(
    vtkIdType cell, vtkIdType local, const vtkIdType* points, vtkIdType size)
  {
    if (!this->Curved.IsCurved(cell))
    {
      return { points, size, PolygonTriangles::Form::Straight };
    }
    return this->Curved.GetOutline(cell, local);
  }

  // The cell on the other side of a face of `cell`, None, or NotOurs if another cell visits the
  // face.
  vtkIdType GetOther(Index face, vtkIdType cell, Index local)
  {
    const FacetTable::CellPair pair = this->Table.GetCells(face);
    // Coincident points may have been merged earlier, but this does not make the cells neighbors.
    if (this->Cells.OuterFacets && local < LastFacetBit && pair.First != pair.Second &&
      this->Cells.IsOuter(cell, local))
    {
      return None;
    }
    const bool firstHidden = this->Cells.IsHidden(pair.First);
    if (pair.First == cell)
    {
      if (pair.Second == cell)
      {
        return this->Table.GetOwnerLocalFacet(face) == local ? None : NotOurs;
      }
      const bool alone = pair.Second < 0 || this->Cells.IsHidden(pair.Second);
      return alone ? None : pair.Second;
    }
    if (pair.Second == cell)
    {
      return firstHidden ? None : NotOurs;
    }
    return firstHidden ? None : pair.First; // a third cell
  }

  const MeshView& Mesh;
  const FacetTable& Table;
  const CellsToDraw& Cells;
  CellFacets Facets;
  CurvedFacets Curved;
};

//------------------------------------------------------------------------------
// Selects one of the two directions of a polygon, regardless of its first point.
bool RunsDownInSpace(const MeshView& mesh, const Vertices& vertices)
{
  return RingRunsDown(vertices.Size,
    [&](vtkIdType corner)
    {
      std::array<double, 3> place;
      mesh.GetPoint(vertices.Points[corner], place.data());
      return place;
    });
}

//------------------------------------------------------------------------------
// The same triangle, with reversed orientation.
PolygonTriangles::Triangle TurnOver(const PolygonTriangles::Triangle& triangle)
{
  PolygonTriangles::Triangle turned = triangle;
  std::swap(turned.Corners[1], turned.Corners[2]);
  turned.Edges = PolygonTriangles::ReverseEdges(triangle.Edges);
  return turned;
}

//------------------------------------------------------------------------------
// Where each chunk of cells writes: boundary faces first, then interior ones.
void PlaceChunks(std::vector<Counts>& chunks)
{
  Counts next;
  for (const Counts& chunk : chunks)
  {
    next.Faces[Inner] += chunk.Faces[Outer];
    next.Triangles[Inner] += chunk.Triangles[Outer];
  }
  for (Counts& chunk : chunks)
  {
    const Counts size = chunk;
    chunk = next;
    for (const int kind : { Outer, Inner })
    {
      next.Faces[kind] += size.Faces[kind];
      next.Triangles[kind] += size.Triangles[kind];
    }
  }
  chunks.push_back(next);
  constexpr vtkIdType maxFaces = vtkIdType(1) << (32 - DrawableFaces::EdgeBits);
  if (next.Faces[Inner] > maxFaces || next.Triangles[Inner] > vtkIdType(DrawableFaces::NoCell))
  {
    throw std::length_error("Mesh Inspection can only draw pieces of up to 2^29 faces.");
  }
}
}

//------------------------------------------------------------------------------
DrawableFaces MakeDrawableFaces(
  const MeshTopology& topology, const CellsToDraw& cells, FacesToDraw which)
{
  const vtkIdType numberOfCells = topology.GetMesh().GetNumberOfCells();
  std::vector<Counts> chunks((numberOfCells + MediumGrain - 1) / MediumGrain);
  topology.GetFaces();
  const auto forEachFace = [&](auto&& perChunk)
  {
    ParallelFor(static_cast<vtkIdType>(chunks.size()), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        FacesOfCells faces(topology, cells);
        PolygonTriangles triangles(topology.GetMesh());
        for (vtkIdType chunk = begin; chunk < end; ++chunk)
        {
          for (vtkIdType cell = chunk * MediumGrain;
            cell < std::min(numberOfCells, (chunk + 1) * MediumGrain); ++cell)
          {
            perChunk(faces, triangles, cell, chunks[chunk]);
          }
        }
      });
  };
  forEachFace(
    [which](FacesOfCells& faces, PolygonTriangles&, vtkIdType cell, Counts& counts)
    {
      faces.ForEach(cell, which,
        [&](int kind, const PolygonTriangles::Outline& outline, const auto&, const Vertices&)
        {
          ++counts.Faces[kind];
          counts.Triangles[kind] += outline.GetNumberOfTriangles();
        });
    });
  PlaceChunks(chunks);
  const Counts total = chunks.back();
  const Counts outer = chunks.front(); // interior faces start where boundary faces end
  chunks.pop_back();

  DrawableFaces drawable;
  drawable.NumberOfOuterTriangles = static_cast<std::uint32_t>(outer.Triangles[Inner]);
  drawable.Faces.resize(total.Faces[Inner]);
  drawable.Triangles.resize(total.Triangles[Inner]);
  forEachFace(
    [&](FacesOfCells& faces, PolygonTriangles& triangles, vtkIdType cell, Counts& next)
    {
      faces.ForEach(cell, which,
        [&](int kind, const PolygonTriangles::Outline& outline, const auto& cellsOfFace,
          const Vertices& vertices)
        {
          const auto face = static_cast<std::uint32_t>(next.Faces[kind]++);
          const bool isFirst = kind == Outer || !RunsDownInSpace(topology.GetMesh(), vertices);
          const bool isTurned = !isFirst && cellsOfFace[1] != DrawableFaces::CellElsewhere;
          drawable.Faces[face] = cellsOfFace;
          if (isTurned)
          {
            std::swap(drawable.Faces[face][0], drawable.Faces[face][1]);
          }
          else if (!isFirst)
          {
            drawable.Faces[face][1] = DrawableFaces::FirstCellElsewhere;
          }
          triangles.ForEach(outline,
            [&](const PolygonTriangles::Triangle& ofFace)
            {
              const PolygonTriangles::Triangle triangle = isTurned ? TurnOver(ofFace) : ofFace;
              auto& row = drawable.Triangles[next.Triangles[kind]++];
              for (int i = 0; i < 3; ++i)
              {
                row[i] = static_cast<std::uint32_t>(outline.Points[triangle.Corners[i]]);
              }
              row[3] = face << DrawableFaces::EdgeBits | triangle.Edges;
            });
        });
    });
  return drawable;
}

std::vector<std::uint64_t> FindOuterFacets(const MeshTopology& topology, const FacetLinks* links)
{
  constexpr vtkIdType grain = 1 << 14;
  const FacetTable& faces = topology.GetFaces();
  std::vector<std::uint64_t> bits(topology.GetMesh().GetNumberOfCells(), 0);
  ParallelFor(static_cast<vtkIdType>(bits.size()), grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        int local = 0;
        for (const CellFacet use : faces.GetCellFacets(cell))
        {
          const bool isOuter = faces.IsBoundary(use.Facet()) && !(links && links->Has(use.Facet()));
          bits[cell] |= isOuter ? GetFacetBit(local) : 0;
          ++local;
        }
      }
    });
  return bits;
}
}
