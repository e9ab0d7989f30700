// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLElements.h
 * @brief Conversion between elements of Mechanical APDL and cells of VTK.
 *
 * Elements are identified by number (185 is SOLID185) and belong to a few classes. Elements of a
 * class express degenerate shapes by repeated nodes: a wedge is a brick with nodes I,J,K,K,M,N,O,O.
 */
#ifndef camaron_MAPDLElements_h
#define camaron_MAPDLElements_h

#include "vtkType.h" // for vtkIdType

#include <array>   // for edges
#include <cstdint> // for ids
#include <limits>  // for the largest id

namespace camaron
{
/// Largest number of a node or element.
constexpr std::int32_t MaxMAPDLId = std::numeric_limits<std::int32_t>::max();
/// MESH200, whose shape depends on KEYOPT(1).
constexpr int MeshOnly = 200;

enum class MAPDLClass : unsigned char
{
  Undefined,   ///< the type is not defined: the number of nodes decides
  Unknown,     ///< an element that is not a cell, unless it has one node
  Point,       ///< one node
  Line,        ///< two nodes; further ones give an orientation
  CurvedLine,  ///< two nodes and a mid-side node
  Surface,     ///< 1 to 9 nodes
  Tetrahedron, ///< 4 or 10 nodes, or a degenerate brick
  Solid        ///< 8 or 20 nodes, also in degenerate form
};

/// Most nodes of an element that are relevant for its cell.
constexpr int MaxMAPDLNodes = 20;

/// Class of an element by its number and, for MESH200, its KEYOPT(1).
MAPDLClass GetMAPDLClass(int element, int shape = 0);
/// Whether an element is attached to the surface of others, for contact or loads.
bool IsMAPDLSurfaceEffect(int element);

/// A cell by node ids in VTK's order; 0 is a missing mid-side node.
struct MAPDLCell
{
  unsigned char Type = 0; ///< VTK_EMPTY_CELL for elements that are not cells
  std::int32_t Size = 0;
  std::int32_t Nodes[MaxMAPDLNodes];
};

/**
 * Creates the cell of an element.
 * @param count number of nodes, at most MaxMAPDLNodes; trailing ones may be missing
 * @param linear whether to create linear cells only
 */
void MakeMAPDLCell(
  MAPDLClass elementClass, const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell);

/// The vertices of the edge whose mid-side node this node of a cell is; -1 for other nodes.
std::array<vtkIdType, 2> GetMAPDLEdge(const MAPDLCell& cell, std::int32_t node);

/// How cells of a type are written.
struct MAPDLForm
{
  int Element = 0;       ///< number of the usual element; 0 if the format cannot store the type
  int MeshOnlyShape = 0; ///< KEYOPT(1) with which MESH200 has this shape
  int NumberOfNodes = 0;
  const unsigned char* Order = nullptr; ///< per node, the index of the point in the cell
};
/// Tetrahedra of the class Solid are degenerate bricks.
MAPDLForm GetMAPDLForm(unsigned char type, MAPDLClass elementClass = MAPDLClass::Undefined);
}

#endif
