// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Intake/CellMesh/ConversionPlan.h"

#include "Mesh/CellShape.h"

#include "vtkCellType.h"

namespace camaron
{
namespace
{
//------------------------------------------------------------------------------
// The quadratic type whose nodes are the first ones of a type with more nodes.
struct Reduction
{
  int From, To, NumberOfNodes;
};
constexpr Reduction Reductions[] = {
  { VTK_BIQUADRATIC_TRIANGLE, VTK_QUADRATIC_TRIANGLE, 6 },
  { VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_QUAD, 8 },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON, 20 },
  { VTK_TRIQUADRATIC_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON, 20 },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_QUADRATIC_WEDGE, 15 },
  { VTK_TRIQUADRATIC_PYRAMID, VTK_QUADRATIC_PYRAMID, 13 },
};

//------------------------------------------------------------------------------
// The linear type with the vertices of a type.
int GetLinearType(const CellShape& shape, unsigned char type)
{
  switch (shape.NumberOfCorners)
  {
    case 4:
      return VTK_TETRA;
    case 5:
      return VTK_PYRAMID;
    case 6:
      return VTK_WEDGE;
    case 8:
      return VTK_HEXAHEDRON;
    default:
      return type;
  }
}

//------------------------------------------------------------------------------
ConversionStep MakeStep(ConversionStep::Kind what, int type = VTK_EMPTY_CELL)
{
  ConversionStep step;
  step.What = what;
  step.Type = static_cast<unsigned char>(type);
  return step;
}

//------------------------------------------------------------------------------
ConversionStep MakeNodes(int type, int numberOfNodes, const int* order = nullptr)
{
  ConversionStep step = MakeStep(ConversionStep::Kind::Nodes, type);
  step.NumberOfNodes = numberOfNodes;
  step.Order = order;
  return step;
}
}

//------------------------------------------------------------------------------
ConversionPlan::ConversionPlan(const CellConversion& how)
  : How(how)
  , Cuts(how.Others == UnsupportedCells::Convert)
{
  for (int type = 0; type < 256; ++type)
  {
    this->Steps[type] = this->Choose(static_cast<unsigned char>(type));
  }
}

//------------------------------------------------------------------------------
unsigned char ConversionPlan::GetPolygonType(vtkIdType size) const
{
  const unsigned char type = camaron::GetPolygonType(size);
  if (size >= 3 && this->Holds(type))
  {
    return type;
  }
  return size >= 3 && this->Holds(VTK_POLYGON) ? VTK_POLYGON : VTK_EMPTY_CELL;
}

//------------------------------------------------------------------------------
ConversionStep ConversionPlan::Choose(unsigned char type) const
{
  using Kind = ConversionStep::Kind;
  const CellShape& shape = GetCellShape(type);
  if (shape.Dimension == 3 && this->How.Surface != SurfaceFaces::None)
  {
    ConversionStep surface = MakeStep(Kind::Surface);
    surface.LosesNodes = shape.IsHigherOrder;
    return surface;
  }
  if (this->Holds(type))
  {
    ConversionStep same = MakeNodes(type, 0);
    same.IsSame = true;
    return same;
  }
  for (const Reduction& reduction : Reductions)
  {
    if (reduction.From == type && this->Holds(reduction.To))
    {
      ConversionStep step = MakeNodes(reduction.To, reduction.NumberOfNodes);
      step.LosesNodes = true;
      return step;
    }
  }
  ConversionStep step;
  switch (shape.Dimension)
  {
    case 3:
      step = this->ChooseFor3D(type);
      break;
    case 2:
      step = MakeStep(type == VTK_TRIANGLE_STRIP ? Kind::Strip : Kind::Polygon);
      break;
    case 1:
      if (this->Holds(VTK_LINE))
      {
        step = type == VTK_POLY_LINE ? MakeStep(Kind::Lines, VTK_LINE) : MakeNodes(VTK_LINE, 2);
      }
      else if (this->Holds(VTK_POLY_LINE))
      {
        step = MakeNodes(VTK_POLY_LINE, 2);
      }
      break;
    case 0:
      if (this->Holds(VTK_VERTEX))
      {
        step = MakeStep(Kind::Vertices, VTK_VERTEX);
      }
      else if (this->Holds(VTK_POLY_VERTEX))
      {
        step = MakeNodes(VTK_POLY_VERTEX, 0);
      }
      break;
    default:
      break;
  }
  step.LosesNodes = shape.IsHigherOrder && step.What != Kind::None;
  return step;
}

//------------------------------------------------------------------------------
ConversionStep ConversionPlan::ChooseFor3D(unsigned char type) const
{
  using Kind = ConversionStep::Kind;
  const CellShape& shape = GetCellShape(type);
  const int linear = GetLinearType(shape, type);
  if (linear != type && this->Holds(linear))
  {
    static const int voxel[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
    const bool turns = linear == VTK_WEDGE && IsExtrusion(type) != IsExtrusion(VTK_WEDGE);
    // Both orders of the linear wedge differ by swapping two nodes of each triangle.
    static const int turned[] = { 0, 2, 1, 3, 5, 4 };
    return MakeNodes(linear, shape.NumberOfCorners,
      type == VTK_VOXEL ? voxel
        : turns         ? turned
                        : nullptr);
  }
  if (this->Holds(VTK_POLYHEDRON))
  {
    return MakeNodes(VTK_POLYHEDRON, shape.NumberOfCorners);
  }
  if (!this->Cuts || !this->Holds(VTK_TETRA))
  {
    return ConversionStep();
  }
  return MakeStep(shape.ListsFaces ? Kind::Polyhedron : Kind::Tetrahedra);
}
}
