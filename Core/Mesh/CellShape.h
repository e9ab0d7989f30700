// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellShape.h
 * @brief Corners and faces of VTK's cell types, taken from VTK's own cells.
 *
 * Faces run so that their vector areas point out of a cell whose nodes are in VTK's order. They are
 * asked of VTK once, because VTK changed the order of the wedge between versions and orders
 * quadratic and Lagrange wedges the other way round than the linear one.
 */
#ifndef camaron_CellShape_h
#define camaron_CellShape_h

namespace camaron
{
struct CellShape
{
  static constexpr int MaxFaces = 8;
  static constexpr int MaxFacePoints = 36; // of all faces of a hexagonal prism

  /// 0 to 3; -1 for a type that has no corners we know (empty cells, VTK's parametric cells).
  int Dimension = -1;
  /// Corner nodes, the first ones of the cell; 0 when the cell itself says how many it has.
  int NumberOfCorners = 0;
  /// A higher-order type, which is evaluated by its corners.
  bool IsHigherOrder = false;
  /// A 3D type whose cells list their faces: VTK_POLYHEDRON, and VTK_CONVEX_POINT_SET with its
  /// hull.
  bool ListsFaces = false;
  /// Faces of any other 3D type: offsets into FacePoints, which are local nodes.
  int NumberOfFaces = 0;
  int FaceOffsets[MaxFaces + 1] = {};
  int FacePoints[MaxFacePoints] = {};
};

/// Shape of a VTK cell type. Thread safe.
const CellShape& GetCellShape(unsigned char cellType);
}

#endif
