// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The map of a cell in CellGeometry.
#include "Cell/CellGeometry.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace camaron
{
namespace
{
struct SimpleType
{
  unsigned Shape;
  unsigned char Type; // with linear edges
  ParametricShape::Domain Domain;
};
constexpr SimpleType SimpleTypes[] = {
  { Triangles, VTK_TRIANGLE, ParametricShape::Domain::Triangle },
  { Quadrilaterals, VTK_QUAD, ParametricShape::Domain::Quadrilateral },
  { Tetrahedra, VTK_TETRA, ParametricShape::Domain::Tetrahedron },
  { Pyramids, VTK_PYRAMID, ParametricShape::Domain::Pyramid },
  { Wedges, VTK_WEDGE, ParametricShape::Domain::Wedge },
  { Hexahedra, VTK_HEXAHEDRON, ParametricShape::Domain::Hexahedron },
};

//------------------------------------------------------------------------------
const SimpleType* FindSimpleType(unsigned shapes)
{
  const auto* const found = std::find_if(std::begin(SimpleTypes), std::end(SimpleTypes),
    [shapes](const SimpleType& simple) { return (shapes & simple.Shape) != 0; });
  return found == std::end(SimpleTypes) ? nullptr : found;
}
}

//------------------------------------------------------------------------------
int CellGeometry::GetSimplePoints(int points[MaxSimpleNodes]) const
{
  std::iota(points, points + MaxSimpleNodes, 0);
  int size = this->NumberOfPoints;
  if (this->Shapes & SimplePolygons)
  {
    std::copy_n(this->Topology->GetFace(0), size, points);
  }
  else if (!this->HasNodesInOrder())
  {
    size = GetSimpleNodes(*this->Topology, this->Shapes & SimplePolyhedra, points);
  }
  else if (this->CellType == VTK_VOXEL)
  {
    std::swap(points[2], points[3]);
    std::swap(points[6], points[7]);
  }
  else if (this->Shapes & Wedges)
  {
    std::copy_n(GetExtrusionOrder(this->CellType), size, points);
  }
  return size;
}

//------------------------------------------------------------------------------
int CellGeometry::GetSimpleCorners(Vector corners[MaxSimpleNodes]) const
{
  int points[MaxSimpleNodes];
  const int size = this->GetSimplePoints(points);
  for (int i = 0; i < size; ++i)
  {
    corners[i] = this->Points[points[i]];
  }
  return size;
}

//------------------------------------------------------------------------------
// Loads the map of what remains of a cell of higher order that lists corners more than once; false
// if its nodes are elsewhere.
bool CellGeometry::LoadDegenerateMap() const
{
  const SimpleType* const simple = FindSimpleType(this->Shapes);
  if (!simple || !this->Map.Load(*this->Mesh, this->CellId, this->LengthExponent))
  {
    return false;
  }
  const IndexRange nodes = this->Mesh->GetCellPoints(this->CellId);
  int points[MaxSimpleNodes];
  const int size = this->GetSimplePoints(points);
  CollapsedShape::Corners corners = {};
  for (int node = 0; node < this->CellShapes[this->CellType].NumberOfCorners; ++node)
  {
    const int* const found = std::find_if(
      points, points + size, [&](int point) { return this->GetPointId(point) == nodes[node]; });
    if (found == points + size)
    {
      return false; // the corners are listed in another order than around a polygon
    }
    corners[node] = static_cast<signed char>(found - points);
  }
  return this->Map.Collapse(simple->Domain, corners);
}

//------------------------------------------------------------------------------
bool CellGeometry::LoadMap() const
{
  const bool isLoaded = this->DegenerateForm ? this->LoadDegenerateMap()
                                             : this->CellShapes[this->CellType].IsHigherOrder &&
      this->Map.Load(*this->Mesh, this->CellId, this->LengthExponent);
  if (isLoaded && this->Map.IsCurved())
  {
    return true;
  }
  const SimpleType* const simple = FindSimpleType(this->Shapes);
  if (!simple)
  {
    return false;
  }
  Vector corners[MaxSimpleNodes], nodes[MaxSimpleNodes];
  const int size = this->GetSimpleCorners(corners);
  const bool isWedge = simple->Type == VTK_WEDGE;
  for (int i = 0; i < size; ++i)
  {
    nodes[i] = corners[isWedge ? GetExtrusionOrder(VTK_WEDGE)[i] : i];
  }
  return this->Map.Load(simple->Type, nodes, size);
}

//------------------------------------------------------------------------------
const CellMap* CellGeometry::GetMap() const
{
  this->HasMap = this->HasMap ? *this->HasMap : this->LoadMap();
  return *this->HasMap ? &this->Map : nullptr;
}

//------------------------------------------------------------------------------
Vector CellGeometry::GetNormal() const
{
  if (!(this->Shapes & Polygons) || this->Topology->GetNumberOfFaces() == 0)
  {
    return {};
  }
  const bool isFlat = this->IsZeroArea(this->FaceAreas[0]);
  return Unit(isFlat && this->GetCurvedMap() ? this->Map.GetVectorArea() : this->FaceVectors[0]);
}
}
