// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/CurvedFacets.h"

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <map>
#include <utility>

namespace camaron
{
namespace
{
// Cells with a fixed number of nodes, including one at the middle of each edge.
constexpr int CurvedTypes[] = { VTK_QUADRATIC_TRIANGLE, VTK_BIQUADRATIC_TRIANGLE,
  VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
  VTK_TRIQUADRATIC_HEXAHEDRON, VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_PYRAMID,
  VTK_TRIQUADRATIC_PYRAMID, VTK_QUADRATIC_WEDGE, VTK_BIQUADRATIC_QUADRATIC_WEDGE };

using NodesOfEdges = std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType>;

//------------------------------------------------------------------------------
NodesOfEdges AskVTK(int cellType)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(cellType);
  for (vtkIdType node = 0; node < cell->GetNumberOfPoints(); ++node)
  {
    cell->GetPointIds()->SetId(node, node);
  }
  NodesOfEdges nodes;
  for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
  {
    vtkIdList* edge = cell->GetEdge(e)->GetPointIds();
    nodes[std::minmax({ edge->GetId(0), edge->GetId(1) })] = edge->GetId(2);
  }
  return nodes;
}

//------------------------------------------------------------------------------
bool AreAtSamePlace(const MeshView& mesh, vtkIdType a, vtkIdType b)
{
  return a == b || Norm2(mesh.GetPoint(a) - mesh.GetPoint(b)) == 0;
}
}

//------------------------------------------------------------------------------
CurvedFacets::EdgeNodes CurvedFacets::MakeNodes(int cellType)
{
  const NodesOfEdges nodes = AskVTK(cellType);
  const CellShape& shape = GetCellShape(static_cast<unsigned char>(cellType));
  EdgeNodes made;
  made.HasNodes = true;
  const auto add = [&](int place, int corner, int next)
  {
    made.Nodes[place] =
      static_cast<signed char>(nodes.at(std::minmax({ vtkIdType(corner), vtkIdType(next) })));
  };
  for (int i = 0; shape.Dimension == 2 && i < shape.NumberOfCorners; ++i)
  {
    add(i, i, (i + 1) % shape.NumberOfCorners);
  }
  for (int f = 0; f < shape.NumberOfFaces; ++f)
  {
    const int begin = shape.FaceOffsets[f], end = shape.FaceOffsets[f + 1];
    for (int i = begin; i < end; ++i)
    {
      add(i, shape.FacePoints[i], shape.FacePoints[i + 1 < end ? i + 1 : begin]);
    }
  }
  return made;
}

//------------------------------------------------------------------------------
const CurvedFacets::EdgeNodes& CurvedFacets::GetNodes(unsigned char cellType)
{
  static const std::array<EdgeNodes, 256> nodes = []
  {
    std::array<EdgeNodes, 256> made;
    for (const int type : CurvedTypes)
    {
      made[type] = MakeNodes(type);
    }
    return made;
  }();
  return nodes[cellType];
}

//------------------------------------------------------------------------------
PolygonTriangles::Outline CurvedFacets::GetOutline(vtkIdType cell, vtkIdType local)
{
  if (!this->IsSubdivided(cell))
  {
    this->FindOutline(cell, local);
    return { this->Outline.data(), static_cast<vtkIdType>(this->Outline.size()),
      PolygonTriangles::Form::Curved };
  }
  const SubdividedFacets::Triangles triangles = this->Subdivided->Get(cell, local);
  const vtkIdType size = 3 * triangles.Count;
  if (!triangles.AreReversed)
  {
    return { triangles.Points, size, PolygonTriangles::Form::Triangles, triangles.Edges };
  }
  this->Outline.assign(triangles.Points, triangles.Points + size);
  this->Edges.resize(static_cast<std::size_t>(triangles.Count));
  for (vtkIdType i = 0; i < triangles.Count; ++i)
  {
    std::swap(this->Outline[3 * i + 1], this->Outline[3 * i + 2]);
    this->Edges[i] = PolygonTriangles::ReverseEdges(triangles.Edges[i]);
  }
  return { this->Outline.data(), size, PolygonTriangles::Form::Triangles, this->Edges.data() };
}

//------------------------------------------------------------------------------
void CurvedFacets::FindOutline(vtkIdType cell, vtkIdType local)
{
  const unsigned char type = this->Mesh.GetCellType(cell);
  const CellShape& shape = GetCellShape(type);
  const EdgeNodes& nodes = GetNodes(type);
  const IndexRange points = this->Mesh.GetCellPoints(cell);
  const bool isFace = shape.Dimension == 3;
  const int begin = isFace ? shape.FaceOffsets[local] : 0;
  const int end = isFace ? shape.FaceOffsets[local + 1] : shape.NumberOfCorners;
  const auto getVertex = [&](int i) { return points[isFace ? shape.FacePoints[i] : i]; };
  this->Outline.clear();
  for (int i = begin; i < end; ++i)
  {
    const vtkIdType vertex = getVertex(i), node = points[nodes.Nodes[i]];
    if (vertex != getVertex(i + 1 < end ? i + 1 : begin) ||
      !AreAtSamePlace(this->Mesh, vertex, node))
    {
      this->Outline.push_back(vertex);
      this->Outline.push_back(node);
    }
  }
  if (this->Outline.size() < 6) // two vertices
  {
    this->Outline.clear();
  }
}

//------------------------------------------------------------------------------
PolygonTriangles::Outline CurvedFacets::GetSurface(vtkIdType cell)
{
  auto form = PolygonTriangles::Form::Straight;
  if (this->IsCurved(cell))
  {
    return this->GetOutline(cell, 0);
  }
  if (this->Mesh.GetCellType(cell) == VTK_TRIANGLE_STRIP)
  {
    form = PolygonTriangles::Form::Strip;
    const IndexRange points = this->Mesh.GetCellPoints(cell);
    this->Outline.clear();
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      this->Outline.push_back(points[i]);
    }
  }
  else
  {
    this->Facets.GetPolygon(cell, this->Outline);
  }
  return { this->Outline.data(), static_cast<vtkIdType>(this->Outline.size()), form };
}
}
