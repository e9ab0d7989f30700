// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
// The map of a cell in CellGeometry.
#include "Cell/CellGeometry.h"

#include <algorithm>
#include <utility>

namespace camaron
{
//------------------------------------------------------------------------------
int CellGeometry::GetSimpleCorners(Vector corners[MaxSimpleNodes]) const
{
  int nodes[MaxSimpleNodes] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  int size = this->NumberOfPoints;
  if (this->Shapes & SimplePolygons)
  {
    std::copy_n(this->Topology->GetFace(0), size, nodes);
  }
  else if (!this->HasNodesInOrder())
  {
    size = GetSimpleNodes(*this->Topology, this->Shapes & SimplePolyhedra, nodes);
  }
  else if (this->CellType == VTK_VOXEL)
  {
    std::swap(nodes[2], nodes[3]);
    std::swap(nodes[6], nodes[7]);
  }
  else if (this->Shapes & Wedges)
  {
    std::copy_n(GetExtrusionOrder(this->CellType), size, nodes);
  }
  for (int i = 0; i < size; ++i)
  {
    corners[i] = this->Points[nodes[i]];
  }
  return size;
}

//------------------------------------------------------------------------------
bool CellGeometry::LoadMap() const
{
  if (this->CellShapes[this->CellType].IsHigherOrder &&
    this->Map.Load(*this->Mesh, this->CellId, this->LengthExponent) && this->Map.IsCurved())
  {
    return true;
  }
  struct Simple
  {
    unsigned Shape;
    unsigned char Type;
  };
  constexpr Simple Types[] = { { Triangles, VTK_TRIANGLE }, { Quadrilaterals, VTK_QUAD },
    { Tetrahedra, VTK_TETRA }, { Pyramids, VTK_PYRAMID }, { Wedges, VTK_WEDGE },
    { Hexahedra, VTK_HEXAHEDRON } };
  const auto* const found = std::find_if(std::begin(Types), std::end(Types),
    [this](const Simple& simple) { return (this->Shapes & simple.Shape) != 0; });
  if (found == std::end(Types))
  {
    return false;
  }
  Vector corners[MaxSimpleNodes], nodes[MaxSimpleNodes];
  const int size = this->GetSimpleCorners(corners);
  const bool isWedge = found->Type == VTK_WEDGE;
  for (int i = 0; i < size; ++i)
  {
    nodes[i] = corners[isWedge ? GetExtrusionOrder(VTK_WEDGE)[i] : i];
  }
  return this->Map.Load(found->Type, nodes, size);
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
