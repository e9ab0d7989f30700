// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelMesh.h"

#include "InspectionArrays.h"
#include "InspectionMesh.h"

#include "Drawing/CurvedFacets.h"
#include "Drawing/DrawableFaces.h"
#include "Mesh/CellShape.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// Global ids, else ids of the data set from which the elements come; null if there are none: then
// elements are numbered here.
vtkDataArray* FindIds(vtkDataSetAttributes* attributes, const char* name)
{
  vtkDataArray* global = attributes->GetGlobalIds();
  return global ? global : attributes->GetArray(name);
}

//------------------------------------------------------------------------------
vtkIdType GetId(vtkDataArray* ids, vtkIdType element)
{
  return ids ? static_cast<vtkIdType>(ids->GetComponent(element, 0)) : element;
}

//------------------------------------------------------------------------------
// First cells of each process and block.
std::vector<vtkIdType> FindPieces(vtkUnstructuredGrid* grid)
{
  vtkDataArray* origins[] = { grid->GetCellData()->GetArray(ProcessIdsName),
    grid->GetCellData()->GetArray(BlockIdsName) };
  std::vector<vtkIdType> pieces = { 0 };
  for (vtkIdType cell = 1; cell < grid->GetNumberOfCells(); ++cell)
  {
    for (vtkDataArray* origin : origins)
    {
      if (origin && origin->GetComponent(cell, 0) != origin->GetComponent(cell - 1, 0))
      {
        pieces.push_back(cell);
        break;
      }
    }
  }
  return pieces;
}
}

//------------------------------------------------------------------------------
void LabelMesh::Update(InspectionMesh& mesh, const InspectionStyle& style, bool hasPieces)
{
  // Arrays may change even if the mesh stays the same.
  vtkUnstructuredGrid* grid = mesh.GetGrid();
  vtkUnsignedCharArray* ghosts = grid->GetPointGhostArray();
  this->PointGhosts = ghosts ? ghosts->GetPointer(0) : nullptr;
  this->PointIds = FindIds(grid->GetPointData(), PointIdsName);
  this->CellIds = FindIds(grid->GetCellData(), CellIdsName);
  this->Style = style;
  if (this->Version == mesh.GetVersion() && this->Grid == grid && this->HasPieces == hasPieces)
  {
    return;
  }
  this->Release();
  this->Grid = grid;
  this->Version = mesh.GetVersion();
  this->HasPieces = hasPieces;
  this->Middle = mesh.GetMiddle();
  this->View = MeshView(this->Grid);
  this->Subdivided = mesh.GetSubdividedFacets();
  this->Triangles.resize(mesh.Triangles.GetNumberOfRows());
  mesh.Triangles.Download(this->Triangles.data(), this->Triangles.size());
  this->Faces.resize(mesh.Faces.GetNumberOfRows());
  mesh.Faces.Download(this->Faces.data(), this->Faces.size());
  this->Marks.resize(mesh.Marks.GetNumberOfRows());
  mesh.Marks.Download(this->Marks.data(), this->Marks.size());
  this->FindFaceCenters();
}

//------------------------------------------------------------------------------
void LabelMesh::Release()
{
  this->Version = -1;
  this->Numbers = nullptr;
  this->Subdivided = nullptr;
  this->CurvedEdges.clear();
  this->HasCurvedEdges = false;
  this->View = MeshView();
  this->Grid = nullptr;
  this->Triangles = {};
  this->Faces = {};
  this->FaceCenters = {};
  this->Marks = {};
}

//------------------------------------------------------------------------------
// Means of the points, like ParaView's cell centers. The triangles of a face are consecutive.
void LabelMesh::FindFaceCenters()
{
  this->FaceCenters.resize(this->Faces.size());
  std::vector<std::uint32_t> points;
  for (std::size_t first = 0, next = 0; first < this->Triangles.size(); first = next)
  {
    const std::uint32_t face = this->Triangles[first][3] >> DrawableFaces::EdgeBits;
    points.clear();
    for (;
      next < this->Triangles.size() && this->Triangles[next][3] >> DrawableFaces::EdgeBits == face;
      ++next)
    {
      points.insert(points.end(), this->Triangles[next].begin(), this->Triangles[next].begin() + 3);
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    double sum[3] = { 0, 0, 0 };
    for (const std::uint32_t point : points)
    {
      double x[3];
      this->View.GetPoint(point, x);
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += x[k] - this->Middle[k];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      this->FaceCenters[face][k] = static_cast<float>(sum[k] / static_cast<double>(points.size()));
    }
  }
}

//------------------------------------------------------------------------------
std::uint32_t LabelMesh::GetFace(std::uint32_t entry) const
{
  return this->Triangles[entry >> 1][3] >> DrawableFaces::EdgeBits;
}

//------------------------------------------------------------------------------
bool LabelMesh::IsGhostPoint(vtkIdType point) const
{
  return this->PointGhosts && (this->PointGhosts[point] & vtkDataSetAttributes::DUPLICATEPOINT);
}

//------------------------------------------------------------------------------
// As in CutExactly.glsl.
bool LabelMesh::IsCutAway(const Place& place) const
{
  return this->Style.CutsExactly() &&
    this->Style.ExactShape.Contains(this->AddMiddle(place).data()) != this->Style.KeepInside;
}

//------------------------------------------------------------------------------
Place LabelMesh::GetMeanPoint(vtkIdType cell) const
{
  const IndexRange points = this->View.GetCellPoints(cell);
  Place mean = { { 0, 0, 0 } };
  for (vtkIdType i = 0; i < points.Size; ++i)
  {
    double x[3];
    this->View.GetPoint(points[i], x);
    for (int k = 0; k < 3; ++k)
    {
      mean[k] += (x[k] - this->Middle[k]) / static_cast<double>(points.Size);
    }
  }
  return mean;
}

//------------------------------------------------------------------------------
// As in Place.glsl.
Place LabelMesh::Move(const Place& place, vtkIdType cell) const
{
  if (!this->MovesCells())
  {
    return place;
  }
  const Place center = this->GetMeanPoint(cell);
  const Place from = this->Style.GetExplodeCenter(this->Middle);
  Place moved;
  for (int k = 0; k < 3; ++k)
  {
    moved[k] = center[k] + this->Style.ShrinkFactor * (place[k] - center[k]) +
      this->Style.ExplodeFactor * (center[k] - from[k]);
  }
  return moved;
}

//------------------------------------------------------------------------------
Place LabelMesh::GetPoint(vtkIdType point, vtkIdType cell) const
{
  Place x;
  this->View.GetPoint(point, x.data());
  for (int k = 0; k < 3; ++k)
  {
    x[k] -= this->Middle[k];
  }
  return this->Move(x, cell);
}

//------------------------------------------------------------------------------
Place LabelMesh::GetFaceCenter(std::uint32_t face, vtkIdType cell) const
{
  const std::array<float, 3>& center = this->FaceCenters[face];
  return this->Move({ { center[0], center[1], center[2] } }, cell);
}

//------------------------------------------------------------------------------
Place LabelMesh::GetCellCenter(vtkIdType cell) const
{
  return this->Move(this->GetMeanPoint(cell), cell);
}

//------------------------------------------------------------------------------
Place LabelMesh::AddMiddle(const Place& place) const
{
  return { { place[0] + this->Middle[0], place[1] + this->Middle[1], place[2] + this->Middle[2] } };
}

//------------------------------------------------------------------------------
vtkIdType LabelMesh::GetPointId(vtkIdType point) const
{
  return GetId(this->PointIds, point);
}

//------------------------------------------------------------------------------
vtkIdType LabelMesh::GetCellId(vtkIdType cell) const
{
  return GetId(this->CellIds, cell);
}

//------------------------------------------------------------------------------
const ElementNumbers* LabelMesh::GetNumbers() const
{
  if (!this->Numbers && this->HasPieces)
  {
    vtkUnsignedCharArray* ghosts = this->Grid->GetCellGhostArray();
    this->Numbers = std::make_unique<ElementNumbers>(
      this->Grid, ghosts ? ghosts->GetPointer(0) : nullptr, FindPieces(this->Grid));
  }
  return this->Numbers.get();
}

//------------------------------------------------------------------------------
void LabelMesh::FindCurvedEdges() const
{
  this->HasCurvedEdges = true;
  if (this->Subdivided)
  {
    for (const std::array<vtkIdType, 4>& part : this->Subdivided->GetMiddleParts())
    {
      this->CurvedEdges[std::minmax(part[0], part[1])] = { part[2], part[3] };
    }
  }
  CurvedFacets facets(this->View, this->Subdivided);
  for (vtkIdType cell = 0; cell < this->View.GetNumberOfCells(); ++cell)
  {
    if (!facets.IsCurved(cell) || (this->Subdivided && this->Subdivided->Has(cell)))
    {
      continue;
    }
    // Each vertex is followed by the node on the edge to the next one.
    const CellShape& shape = GetCellShape(this->View.GetCellType(cell));
    for (int facet = 0; facet < (shape.Dimension == 3 ? shape.NumberOfFaces : 1); ++facet)
    {
      const PolygonTriangles::Outline outline = facets.GetOutline(cell, facet);
      for (vtkIdType i = 0; i < outline.Size; i += 2)
      {
        const Ends ends =
          std::minmax(outline.Points[i], outline.Points[i + 2 < outline.Size ? i + 2 : 0]);
        this->CurvedEdges[std::minmax(ends.first, outline.Points[i + 1])] = ends;
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType LabelMesh::GetEdgeId(vtkIdType a, vtkIdType b) const
{
  const ElementNumbers* numbers = this->GetNumbers();
  const vtkIdType number = numbers ? numbers->GetEdge(a, b) : ElementNumbers::None;
  if (!numbers || number != ElementNumbers::None)
  {
    return number;
  }
  if (!this->HasCurvedEdges)
  {
    this->FindCurvedEdges();
  }
  const auto found = this->CurvedEdges.find(std::minmax(a, b));
  return found == this->CurvedEdges.end()
    ? ElementNumbers::None
    : numbers->GetEdge(found->second.first, found->second.second);
}

//------------------------------------------------------------------------------
vtkIdType LabelMesh::GetFaceId(std::uint32_t entry) const
{
  const ElementNumbers* numbers = this->GetNumbers();
  const vtkIdType cell = this->GetCell(entry);
  const CellShape& shape = GetCellShape(this->View.GetCellType(cell));
  if (!numbers || !shape.IsHigherOrder)
  {
    const std::array<std::uint32_t, 4>& triangle = this->Triangles[entry >> 1];
    const vtkIdType points[3] = { triangle[0], triangle[1], triangle[2] };
    return numbers ? numbers->GetFace(cell, points) : ElementNumbers::None;
  }
  // Three vertices of the face, whose triangles are consecutive.
  const IndexRange nodes = this->View.GetCellPoints(cell);
  const std::uint32_t face = this->GetFace(entry);
  std::uint32_t first = entry >> 1;
  while (first > 0 && this->GetFace((first - 1) << 1) == face)
  {
    --first;
  }
  std::vector<vtkIdType> vertices;
  for (; first < this->Triangles.size() && this->GetFace(first << 1) == face; ++first)
  {
    for (int i = 0; i < 3 && vertices.size() < 3; ++i)
    {
      const vtkIdType point = this->Triangles[first][i];
      bool isVertex = false;
      for (int corner = 0; corner < shape.NumberOfCorners; ++corner)
      {
        isVertex = isVertex || nodes[corner] == point;
      }
      if (isVertex && std::find(vertices.begin(), vertices.end(), point) == vertices.end())
      {
        vertices.push_back(point);
      }
    }
  }
  return vertices.size() == 3 ? numbers->GetFace(cell, vertices.data()) : ElementNumbers::None;
}
}
