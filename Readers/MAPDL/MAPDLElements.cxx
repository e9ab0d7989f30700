// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MAPDLElements.h"

#include "Mesh/CellShape.h"

#include "vtkCellType.h"
#include "vtkQuadraticHexahedron.h"
#include "vtkQuadraticPyramid.h"
#include "vtkQuadraticTetra.h"
#include "vtkQuadraticWedge.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace camaron
{
namespace
{
// Elements of every class, from the element reference of Mechanical APDL.
constexpr short Points[] = { 7, 21, 71, 175 };
constexpr short Lines[] = { 1, 3, 4, 8, 10, 11, 12, 14, 16, 17, 18, 20, 23, 24, 31, 32, 33, 34, 37,
  38, 39, 40, 44, 54, 59, 60, 61, 66, 68, 116, 126, 129, 161, 171, 177, 178, 179, 180, 184, 188,
  208, 214, 250, 251, 288 };
constexpr short CurvedLines[] = { 151, 153, 156, 169, 172, 176, 189, 209, 280, 289, 290 };
constexpr short Surfaces[] = { 2, 13, 22, 25, 28, 29, 35, 41, 42, 43, 51, 53, 55, 57, 63, 67, 75,
  77, 78, 79, 81, 82, 83, 88, 91, 93, 99, 106, 108, 115, 118, 121, 130, 131, 132, 136, 143, 152,
  154, 155, 157, 163, 170, 173, 174, 181, 182, 183, 212, 213, 218, 219, 222, 223, 230, 233, 238,
  252, 281, 282, 283, 292, 293 };
constexpr short Tetrahedra[] = { 87, 92, 98, 119, 123, 140, 148, 168, 187, 217, 221, 227, 232, 237,
  240, 285, 291 };
constexpr short Solids[] = { 5, 30, 45, 46, 62, 64, 65, 69, 70, 73, 80, 89, 90, 95, 96, 97, 107,
  117, 120, 122, 164, 185, 186, 190, 215, 216, 220, 225, 226, 231, 236, 239, 272, 273, 278, 279 };
constexpr int MaxElement = 300;

//------------------------------------------------------------------------------
std::array<MAPDLClass, MaxElement + 1> MakeClasses()
{
  std::array<MAPDLClass, MaxElement + 1> classes;
  classes.fill(MAPDLClass::Unknown);
  classes[0] = MAPDLClass::Undefined;
  const auto add = [&classes](const auto& elements, MAPDLClass elementClass)
  {
    for (const short element : elements)
    {
      classes[element] = elementClass;
    }
  };
  add(Points, MAPDLClass::Point);
  add(Lines, MAPDLClass::Line);
  add(CurvedLines, MAPDLClass::CurvedLine);
  add(Surfaces, MAPDLClass::Surface);
  add(Tetrahedra, MAPDLClass::Tetrahedron);
  add(Solids, MAPDLClass::Solid);
  return classes;
}

// By KEYOPT(1) of MESH200, 0 to 11.
constexpr MAPDLClass MeshOnlyClasses[] = { MAPDLClass::Line, MAPDLClass::CurvedLine,
  MAPDLClass::Line, MAPDLClass::CurvedLine, MAPDLClass::Surface, MAPDLClass::Surface,
  MAPDLClass::Surface, MAPDLClass::Surface, MAPDLClass::Tetrahedron, MAPDLClass::Tetrahedron,
  MAPDLClass::Solid, MAPDLClass::Solid };

//------------------------------------------------------------------------------
// A shape: the nodes of the element that are points of the cell, vertices first.
struct Shape
{
  unsigned char Linear;
  unsigned char Quadratic;
  unsigned char Corners;
  unsigned char Size; ///< with mid-side nodes
  unsigned char Nodes[MaxMAPDLNodes];
};
constexpr Shape LineShape = { VTK_LINE, VTK_QUADRATIC_EDGE, 2, 3, { 0, 1, 2 } };
constexpr Shape Triangle = { VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE, 3, 6, { 0, 1, 2, 3, 4, 5 } };
// A quadrilateral I,J,K,K.
constexpr Shape Quad3 = { VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE, 3, 6, { 0, 1, 2, 4, 5, 7 } };
constexpr Shape Quad4 = { VTK_QUAD, VTK_QUADRATIC_QUAD, 4, 8, { 0, 1, 2, 3, 4, 5, 6, 7 } };
constexpr Shape Tetra = { VTK_TETRA, VTK_QUADRATIC_TETRA, 4, 10, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } };
// Prisms are listed as extrusions and then reordered for VTK.
constexpr Shape Prism = { VTK_WEDGE, VTK_WEDGE, 6, 6, { 0, 1, 2, 3, 4, 5 } };
// Bricks I,J,K,K,M,M,M,M and I,J,K,L,M,M,M,M and I,J,K,K,M,N,O,O and without repeated nodes.
constexpr Shape Brick4 = { VTK_TETRA, VTK_QUADRATIC_TETRA, 4, 10,
  { 0, 1, 2, 4, 8, 9, 11, 16, 17, 18 } };
constexpr Shape Brick5 = { VTK_PYRAMID, VTK_QUADRATIC_PYRAMID, 5, 13,
  { 0, 1, 2, 3, 4, 8, 9, 10, 11, 16, 17, 18, 19 } };
constexpr Shape Brick6 = { VTK_WEDGE, VTK_QUADRATIC_WEDGE, 6, 15,
  { 0, 1, 2, 4, 5, 6, 8, 9, 11, 12, 13, 15, 16, 17, 18 } };
constexpr Shape Brick8 = { VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON, 8, 20,
  { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19 } };

//------------------------------------------------------------------------------
const Shape& GetBrick(const std::int32_t* n)
{
  if (n[6] != n[7])
  {
    return Brick8;
  }
  if (n[5] != n[6])
  {
    return n[2] == n[3] ? Brick6 : Brick8;
  }
  return n[4] != n[5] ? Brick8 : n[2] != n[3] ? Brick5 : Brick4;
}

//------------------------------------------------------------------------------
// Fills a cell with the nodes of a shape: quadratic if mid-side nodes exist, else linear.
void Fill(const Shape& shape, const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell)
{
  bool hasMidSides = false;
  for (int i = shape.Corners; i < shape.Size && !linear && !hasMidSides; ++i)
  {
    hasMidSides = shape.Nodes[i] < count && nodes[shape.Nodes[i]] != 0;
  }
  cell.Type = hasMidSides ? shape.Quadratic : shape.Linear;
  cell.Size = hasMidSides ? shape.Size : shape.Corners;
  const bool isWedge = cell.Type == VTK_WEDGE || cell.Type == VTK_QUADRATIC_WEDGE;
  const int* const order = isWedge ? GetExtrusionOrder(cell.Type) : nullptr;
  for (int i = 0; i < cell.Size; ++i)
  {
    const unsigned char node = shape.Nodes[order ? order[i] : i];
    cell.Nodes[i] = node < count ? nodes[node] : 0;
  }
}

//------------------------------------------------------------------------------
void FillSurface(const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell)
{
  switch (count)
  {
    case 1:
      cell.Type = VTK_VERTEX;
      cell.Size = 1;
      cell.Nodes[0] = nodes[0];
      return;
    case 2:
      return Fill(LineShape, nodes, count, true, cell);
    case 3:
      return Fill(Triangle, nodes, count, linear, cell);
    case 6: // a quadrilateral I,J,K,K without trailing zeros, not a triangle with six nodes
      return Fill(nodes[2] == nodes[3] ? Quad3 : Triangle, nodes, count, linear, cell);
    case 5: // four nodes and an extra one
      return Fill(nodes[2] == nodes[3] ? Quad3 : Quad4, nodes, 4, true, cell);
    default: // four or eight nodes, possibly without trailing zeros, or eight and an extra
             // one
      return Fill(nodes[2] == nodes[3] ? Quad3 : Quad4, nodes, count, linear, cell);
  }
}

//------------------------------------------------------------------------------
void FillSolid(const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell)
{
  if (count >= 8)
  {
    return Fill(GetBrick(nodes), nodes, count, linear, cell);
  }
  return Fill(count == 6 ? Prism
      : count == 5       ? Brick5
      : count == 4       ? Tetra
                         : Brick8,
    nodes, count, true, cell);
}

//------------------------------------------------------------------------------
MAPDLClass GetClassByNodes(int count)
{
  return count == 1 ? MAPDLClass::Point
    : count == 2    ? MAPDLClass::Line
    : count < 8     ? MAPDLClass::Surface
    : count == 10   ? MAPDLClass::Tetrahedron
                    : MAPDLClass::Solid;
}

//------------------------------------------------------------------------------
// The point of the cell for each node of an element.
constexpr unsigned char InOrder[MaxMAPDLNodes] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
  15, 16, 17, 18, 19 };
constexpr unsigned char TriangleNodes[] = { 0, 1, 2, 2 };
constexpr unsigned char QuadraticTriangleNodes[] = { 0, 1, 2, 2, 3, 4, 2, 5 };
constexpr unsigned char PixelNodes[] = { 0, 1, 3, 2 };
constexpr unsigned char VoxelNodes[] = { 0, 1, 3, 2, 4, 5, 7, 6 };
constexpr unsigned char BrickTetraNodes[] = { 0, 1, 2, 2, 3, 3, 3, 3 };
constexpr unsigned char QuadraticBrickTetraNodes[] = { 0, 1, 2, 2, 3, 3, 3, 3, 4, 5, 2, 6, 3, 3, 3,
  3, 7, 8, 9, 9 };
constexpr unsigned char PyramidNodes[] = { 0, 1, 2, 3, 4, 4, 4, 4 };
constexpr unsigned char QuadraticPyramidNodes[] = { 0, 1, 2, 3, 4, 4, 4, 4, 5, 6, 7, 8, 4, 4, 4, 4,
  9, 10, 11, 12 };
// For an extrusion.
constexpr unsigned char WedgeNodes[] = { 0, 1, 2, 2, 3, 4, 5, 5 };
constexpr unsigned char QuadraticWedgeNodes[] = { 0, 1, 2, 2, 3, 4, 5, 5, 6, 7, 2, 8, 9, 10, 5, 11,
  12, 13, 14, 14 };

//------------------------------------------------------------------------------
// The nodes of a wedge as points in VTK's order.
template <std::size_t Size>
std::array<unsigned char, Size> TurnWedge(const unsigned char (&nodes)[Size], unsigned char type)
{
  std::array<unsigned char, Size> points;
  std::transform(std::begin(nodes), std::end(nodes), points.begin(), [type](unsigned char node)
    { return static_cast<unsigned char>(GetExtrusionOrder(type)[node]); });
  return points;
}
}

//------------------------------------------------------------------------------
MAPDLClass GetMAPDLClass(int element, int shape)
{
  static const std::array<MAPDLClass, MaxElement + 1> classes = MakeClasses();
  if (element == MeshOnly)
  {
    return shape >= 0 && shape < static_cast<int>(std::size(MeshOnlyClasses))
      ? MeshOnlyClasses[shape]
      : MAPDLClass::Unknown;
  }
  return element >= 0 && element <= MaxElement ? classes[element] : MAPDLClass::Unknown;
}

//------------------------------------------------------------------------------
bool IsMAPDLSurfaceEffect(int element)
{
  return (element >= 151 && element <= 156) || (element >= 169 && element <= 178);
}

//------------------------------------------------------------------------------
void MakeMAPDLCell(
  MAPDLClass elementClass, const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell)
{
  cell.Type = VTK_EMPTY_CELL;
  cell.Size = 0;
  const bool isVertex = count == 1 && nodes[0] != 0;
  if (count == 0 || (elementClass == MAPDLClass::Unknown && !isVertex))
  {
    return;
  }
  if (elementClass == MAPDLClass::Undefined)
  {
    elementClass = GetClassByNodes(count);
  }
  if (count == 1 || elementClass == MAPDLClass::Point)
  {
    return FillSurface(nodes, 1, linear, cell);
  }
  switch (elementClass)
  {
    case MAPDLClass::Line:
      return Fill(LineShape, nodes, 2, true, cell);
    case MAPDLClass::CurvedLine:
      return Fill(LineShape, nodes, count, linear, cell);
    case MAPDLClass::Surface:
      return FillSurface(nodes, count, linear, cell);
    case MAPDLClass::Tetrahedron:
      // A degenerate brick repeats its third node.
      return count >= 8 && nodes[2] == nodes[3] ? FillSolid(nodes, count, linear, cell)
                                                : Fill(Tetra, nodes, count, linear, cell);
    default:
      return FillSolid(nodes, count, linear, cell);
  }
}

//------------------------------------------------------------------------------
std::array<vtkIdType, 2> GetMAPDLEdge(const MAPDLCell& cell, std::int32_t node)
{
  const CellShape& shape = GetCellShape(cell.Type);
  const std::int32_t edge = node - shape.NumberOfCorners;
  if (!shape.IsHigherOrder || edge < 0)
  {
    return { -1, -1 };
  }
  if (shape.Dimension < 3)
  {
    return { edge, (edge + 1) % shape.NumberOfCorners };
  }
  const auto getEdge = cell.Type == VTK_QUADRATIC_TETRA ? vtkQuadraticTetra::GetEdgeArray
    : cell.Type == VTK_QUADRATIC_PYRAMID                ? vtkQuadraticPyramid::GetEdgeArray
    : cell.Type == VTK_QUADRATIC_WEDGE                  ? vtkQuadraticWedge::GetEdgeArray
                                                        : vtkQuadraticHexahedron::GetEdgeArray;
  for (vtkIdType i = 0; i < cell.Size - shape.NumberOfCorners; ++i)
  {
    const vtkIdType* const ends = getEdge(i); // in another order than the nodes
    if (ends[2] == node)
    {
      return { ends[0], ends[1] };
    }
  }
  return { -1, -1 };
}

//------------------------------------------------------------------------------
MAPDLForm GetMAPDLForm(unsigned char type, MAPDLClass elementClass)
{
  static const auto wedge = TurnWedge(WedgeNodes, VTK_WEDGE);
  static const auto quadraticWedge = TurnWedge(QuadraticWedgeNodes, VTK_QUADRATIC_WEDGE);
  const bool isBrick = elementClass == MAPDLClass::Solid;
  switch (type)
  {
    case VTK_VERTEX:
      return { 21, -1, 1, InOrder };
    case VTK_LINE:
      return { 188, 2, 2, InOrder };
    case VTK_QUADRATIC_EDGE:
      return { 189, 3, 3, InOrder };
    case VTK_TRIANGLE:
      return { 181, 4, 4, TriangleNodes };
    case VTK_QUADRATIC_TRIANGLE:
      return { 281, 5, 8, QuadraticTriangleNodes };
    case VTK_QUAD:
      return { 181, 6, 4, InOrder };
    case VTK_PIXEL:
      return { 181, 6, 4, PixelNodes };
    case VTK_QUADRATIC_QUAD:
      return { 281, 7, 8, InOrder };
    case VTK_TETRA:
      return isBrick ? MAPDLForm{ 185, 10, 8, BrickTetraNodes } : MAPDLForm{ 285, 8, 4, InOrder };
    case VTK_QUADRATIC_TETRA:
      return isBrick ? MAPDLForm{ 186, 11, 20, QuadraticBrickTetraNodes }
                     : MAPDLForm{ 187, 9, 10, InOrder };
    case VTK_PYRAMID:
      return { 185, 10, 8, PyramidNodes };
    case VTK_QUADRATIC_PYRAMID:
      return { 186, 11, 20, QuadraticPyramidNodes };
    case VTK_WEDGE:
      return { 185, 10, 8, wedge.data() };
    case VTK_QUADRATIC_WEDGE:
      return { 186, 11, 20, quadraticWedge.data() };
    case VTK_HEXAHEDRON:
      return { 185, 10, 8, InOrder };
    case VTK_VOXEL:
      return { 185, 10, 8, VoxelNodes };
    case VTK_QUADRATIC_HEXAHEDRON:
      return { 186, 11, 20, InOrder };
    default:
      return {};
  }
}
}
