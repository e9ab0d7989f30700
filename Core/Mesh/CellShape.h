// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShape.h
 * @brief Names, nodes, vertices and faces of VTK's cell types, queried from VTK's own cells.
 *
 * Faces are ordered so that their vector areas point out of a cell whose nodes are in VTK's order.
 * They are queried once from VTK, because VTK changed the order of the wedge between versions and
 * orders quadratic and Lagrange wedges opposite to the linear one.
 */
#ifndef camaron_CellShape_h
#define camaron_CellShape_h

#include "vtkCellType.h" // for the types of polygons
#include "vtkType.h"     // for vtkIdType

#include <string> // for names

namespace camaron
{
struct CellShape
{
  static constexpr int MaxFaces = 8;
  static constexpr int MaxFacePoints = 36; // of all faces of a hexagonal prism

  /// 0 to 3; -1 for types without known vertices (empty cells, VTK's parametric cells).
  int Dimension = -1;
  /// The vertices are the first nodes of the cell; 0 if their number varies from cell to cell.
  int NumberOfCorners = 0;
  /// All nodes of a cell; 0 if their number varies from cell to cell.
  int NumberOfNodes = 0;
  /// A higher-order type, which is evaluated as the linear cell of its vertices.
  bool IsHigherOrder = false;
  /// A 3D type whose cells list their faces: VTK_POLYHEDRON, and VTK_CONVEX_POINT_SET with its
  /// convex hull.
  bool ListsFaces = false;
  /// Faces of the other 3D types: offsets into FacePoints, which contains local node numbers.
  int NumberOfFaces = 0;
  int FaceOffsets[MaxFaces + 1] = {};
  int FacePoints[MaxFacePoints] = {};
};

/// Shape of a VTK cell type. Thread safe.
const CellShape& GetCellShape(unsigned char cellType);

/// Number of vertices of a cell with this number of points.
vtkIdType GetNumberOfCorners(unsigned char cellType, vtkIdType numberOfPoints);

///@{
/**
 * The order of the nodes of wedges in files and in VTK. Files list a prism as an extrusion: the
 * normal of the triangle (0,1,2), by the right-hand rule, points to the triangle (3,4,5). VTK's
 * linear wedge is inverted in some versions, but its quadratic wedge is not; these functions query
 * VTK.
 *
 * IsExtrusion returns whether VTK's order of a wedge type is that of an extrusion.
 * GetExtrusionOrder maps the nodes of VTK_WEDGE (6) or VTK_QUADRATIC_WEDGE (15, its edges in VTK's
 * order) to those of an extrusion: vtk[i] = extrusion[order[i]]. The permutation is its own
 * inverse.
 */
constexpr int MaxWedgeNodes = 15;
bool IsExtrusion(unsigned char wedgeType);
const int* GetExtrusionOrder(unsigned char wedgeType);
///@}

/// The type of a polygon with so many points; lines, vertices and empty cells for fewer than three.
/// Without branches, which would be mispredicted if triangles and quadrilaterals are mixed.
inline unsigned char GetPolygonType(vtkIdType size)
{
  constexpr unsigned char Types[] = { VTK_EMPTY_CELL, VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_QUAD,
    VTK_POLYGON };
  return Types[size < 5 ? size : 5];
}

/// Name of a cell type in messages: in words, singular, such as "quadratic tetrahedron"; the number
/// of a type that VTK does not know.
std::string GetCellTypeName(unsigned char type);
}

#endif
