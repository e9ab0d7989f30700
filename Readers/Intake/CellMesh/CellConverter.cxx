// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/CellConverter.h"

namespace camaron
{
namespace
{
using Kind = ConversionStep::Kind;
}

//------------------------------------------------------------------------------
void CellConverter::PutPolygon(const vtkIdType* points, vtkIdType size)
{
  const unsigned char type = this->Plan.GetPolygonType(size);
  if (type != VTK_EMPTY_CELL)
  {
    this->Put(type, points, size);
  }
  else if (size < 3 || !this->Plan.CutsPolygons())
  {
    this->AddOnce(this->Found.Unsupported[this->Type]);
  }
  else
  {
    if (!this->Cutter.CutPolygon(points, size))
    {
      this->Found.Uncut.Add(this->Cell);
    }
    this->AddOnce(this->Found.Cut[this->Type]);
    for (const CellCutter::Triangle& triangle : this->Cutter.GetTriangles())
    {
      this->Put(VTK_TRIANGLE, triangle, 3);
    }
  }
}

//------------------------------------------------------------------------------
void CellConverter::PutSurface()
{
  this->Found.Surface.Add(this->Cell);
  const FacetTable::Range uses = this->Faces->GetCellFacets(this->Cell);
  const auto isWanted = [&](Index local)
  {
    const Index facet = uses[local].Facet();
    return this->How.Surface == SurfaceFaces::Boundary
      ? this->Faces->IsBoundary(facet)
      : this->Faces->GetCells(facet).First == this->Cell &&
        this->Faces->GetOwnerLocalFacet(facet) == local;
  };
  for (Index local = 0; local < uses.size(); ++local)
  {
    if (isWanted(local))
    {
      this->Polygon.clear();
      this->Facets.GetFacet(this->Cell, local, this->Polygon);
      ++this->Found.NumberOfFaces;
      this->PutPolygon(this->Polygon.data(), static_cast<vtkIdType>(this->Polygon.size()));
    }
  }
}

//------------------------------------------------------------------------------
void CellConverter::PutTetrahedra()
{
  if (this->Facets.GetNumberOfFacets(this->Cell) == 0)
  {
    this->AddOnce(this->Found.Unsupported[this->Type]); // a point set without its hull
    return;
  }
  this->Cutter.CutCell(this->Cell);
  this->AddOnce(this->Found.Cut[this->Type]);
  vtkIdType notPositive = 0;
  for (const CellCutter::Tetrahedron& tetrahedron : this->Cutter.GetTetrahedra())
  {
    this->Put(VTK_TETRA, tetrahedron, 4);
    notPositive += this->Cutter.GetVolume(tetrahedron) > 0 ? 0 : 1;
  }
  if (notPositive > 0)
  {
    this->Found.NotPositive.Add(this->Cell);
    this->Found.NumberOfNotPositive += notPositive;
  }
}

//------------------------------------------------------------------------------
void CellConverter::PutPolyhedron()
{
  vtkIdType nodes[8];
  const unsigned char type = this->Cutter.MatchPolyhedron(this->Cell, nodes);
  if (type != VTK_POLYHEDRON && this->Plan.Holds(type))
  {
    this->Put(type, nodes, GetCellShape(type).NumberOfCorners);
  }
  else if (this->Plan.Holds(VTK_TETRA))
  {
    this->PutTetrahedra();
  }
  else
  {
    this->AddOnce(this->Found.Unsupported[this->Type]);
  }
}

//------------------------------------------------------------------------------
void CellConverter::Convert(vtkIdType cell, CellChunk& chunk)
{
  this->Chunk = &chunk;
  this->Cell = cell;
  this->Type = this->Mesh.GetCellType(cell);
  this->IsCounted = false;
  const ConversionStep& step = this->Plan[this->Type];
  const Tally& leftOut = this->Found.Unsupported[this->Type];
  const vtkIdType leftOutBefore = leftOut.Count;
  this->Put(step);
  if (step.LosesNodes && leftOut.Count == leftOutBefore)
  {
    this->Found.Reduced[this->Type].Add(cell);
  }
}

//------------------------------------------------------------------------------
void CellConverter::Put(const ConversionStep& step)
{
  CellChunk& chunk = *this->Chunk;
  const vtkIdType cell = this->Cell;
  const IndexRange points = this->Mesh.GetCellPoints(cell);
  switch (step.What)
  {
    case Kind::Nodes:
    {
      const vtkIdType size = step.NumberOfNodes ? step.NumberOfNodes : points.Size;
      for (vtkIdType i = 0; i < size; ++i)
      {
        chunk.Points.push_back(points[step.Order ? step.Order[i] : i]);
      }
      this->Put(step.Type);
      return;
    }
    case Kind::Polygon:
      this->Facets.GetPolygon(cell, this->Polygon);
      this->PutPolygon(this->Polygon.data(), static_cast<vtkIdType>(this->Polygon.size()));
      return;
    case Kind::Strip:
      for (vtkIdType i = 0; i + 2 < points.Size; ++i)
      {
        const vtkIdType triangle[3] = { points[i], points[i + 1 + i % 2], points[i + 2 - i % 2] };
        this->PutPolygon(triangle, 3);
      }
      return;
    case Kind::Lines:
      for (vtkIdType i = 0; i + 1 < points.Size; ++i)
      {
        const vtkIdType line[2] = { points[i], points[i + 1] };
        this->Put(step.Type, line, 2);
      }
      return;
    case Kind::Vertices:
      for (vtkIdType i = 0; i < points.Size; ++i)
      {
        const vtkIdType vertex = points[i];
        this->Put(step.Type, &vertex, 1);
      }
      return;
    case Kind::Surface:
      this->PutSurface();
      return;
    case Kind::Polyhedron:
      this->PutPolyhedron();
      return;
    case Kind::Tetrahedra:
      this->PutTetrahedra();
      return;
    default:
      this->Found.Unsupported[this->Type].Add(cell);
  }
}
}
