// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MAPDLElements.h
 * @brief What the elements of Mechanical APDL are to VTK, and the other way round.
 *
 * Elements are known by number (185 is SOLID185) and fall into a few classes. Those of a class
 * write degenerate shapes by naming a node several times: a wedge is a brick with nodes
 * I,J,K,K,M,N,O,O.
 */
#ifndef camaron_MAPDLElements_h
#define camaron_MAPDLElements_h

#include <cstdint> // for ids

namespace camaron
{
enum class MAPDLClass : unsigned char
{
  Undefined,   ///< nothing is known of the type: the number of nodes decides
  Unknown,     ///< an element that is no cell, unless it has one node
  Point,       ///< one node
  Line,        ///< two nodes; further ones give a direction
  CurvedLine,  ///< two nodes and one between them
  Surface,     ///< 1 to 9 nodes
  Tetrahedron, ///< 4 or 10 nodes, or a degenerate brick
  Solid        ///< 8 or 20 nodes, also in degenerate form
};

/// Nodes of an element that matter for its cell.
constexpr int MaxMAPDLNodes = 20;

/// Class of an element by its number and, for MESH200, its KEYOPT(1).
MAPDLClass GetMAPDLClass(int element, int shape = 0);
/// Whether an element is on the surface of others for contact or loads.
bool IsMAPDLSurfaceEffect(int element);
/// Nodes that every element of a number has, 0 if they have several or it is not known how many.
int GetMAPDLNodes(int element, int shape = 0);
/// Most nodes an element of a class has, 0 if that is not known.
int GetMaxMAPDLNodes(MAPDLClass elementClass);

/// A cell by ids of nodes in VTK's order; 0 stands for a missing mid-side node.
struct MAPDLCell
{
  unsigned char Type = 0; ///< VTK_EMPTY_CELL for elements that are no cells
  std::int32_t Size = 0;
  std::int32_t Nodes[MaxMAPDLNodes];
};

/**
 * Makes a cell of an element.
 * @param count of its nodes, at most MaxMAPDLNodes; trailing ones may be missing
 * @param linear whether all cells shall be linear
 */
void MakeMAPDLCell(
  MAPDLClass elementClass, const std::int32_t* nodes, int count, bool linear, MAPDLCell& cell);

/// Corners of a quadratic cell of VTK on both sides of its first mid-side nodes, and how many there
/// are.
struct QuadraticEdges
{
  int NumberOfCorners = 0;
  int NumberOfEdges = 0;
  const unsigned char (*Edges)[2] = nullptr;
};
/// No edges if the type is not a quadratic one that MakeMAPDLCell makes.
QuadraticEdges GetQuadraticEdges(unsigned char type);

/// How cells of a type are written.
struct MAPDLForm
{
  int Element = 0;       ///< number of the usual element; 0 if the format cannot hold the type
  int MeshOnlyShape = 0; ///< KEYOPT(1) with which MESH200 has this shape
  int NumberOfNodes = 0;
  const unsigned char* Order = nullptr; ///< per node, which point of the cell it is
};
/// Tetrahedra among solids are degenerate bricks.
MAPDLForm GetMAPDLForm(unsigned char type, MAPDLClass elementClass = MAPDLClass::Undefined);
}

#endif
