// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellTetrahedra.h
 * @brief Divides the cells of a mesh into tetrahedra that match at shared faces.
 */
#ifndef camaron_CellTetrahedra_h
#define camaron_CellTetrahedra_h

#include "Geometry/Bounds.h"

#include "vtkType.h" // for vtkIdType

#include <array>   // for the rows
#include <cstdint> // for the rows
#include <vector>  // for the tables

class vtkDataArray;

namespace camaron
{
class MeshView;
class SubdividedFacets;

/**
 * Tetrahedra of the 3D cells, in the order of the cells. A cell is a fan from its first point
 * (MeshView::FindFirstPoint) over the triangles of
 * the faces without this point; a convex face is a fan from its own first point, other faces are
 * triangulated by PolygonTriangulator. Two cells therefore divide their common face identically,
 * even on two ranks.
 *
 * If a cell is not completely visible from its first point, some tetrahedra are negative: their
 * interior is outside of the cell, or in additional other tetrahedra. Seen from the first point, a
 * position is inside the cell if and only if the first face behind it belongs to a tetrahedron
 * that is not negative.
 */
struct CellTetrahedra
{
  /// Cells that are adjacent in memory, and usually in space.
  static constexpr vtkIdType CellsPerBlock = 64;

  /// Number of bits stored next to a cell.
  static constexpr int OuterFaceBits = 4;
  /// Bit of Edges: a negative tetrahedron. Negative tetrahedra come first in a cell.
  static constexpr std::uint8_t Negative = 64;
  static constexpr std::uint32_t None = 0xffffffff;

  std::vector<std::array<std::uint32_t, 4>> Points;
  /// The cell << OuterFaceBits; bit i is set if the face opposite point i is part of a face of the
  /// cell.
  std::vector<std::uint32_t> Cells;
  /// Bits for the lines between points (0, 1), (0, 2), (0, 3), (1, 2), (1, 3) and (2, 3) that are
  /// edges of the cell.
  std::vector<std::uint8_t> Edges;
  /// For every cell its first negative tetrahedron and its first row of NegativeBoxes, or None;
  /// empty if no cell has negative tetrahedra.
  std::vector<std::array<std::uint32_t, 2>> FirstNegatives;
  /**
   * A tree of boxes around those faces of the cell that belong to its negative tetrahedra; the
   * boxes also contain the first point for tetrahedra that have a face of the cell at their sides.
   * In the order of traversal: Next is where to continue if nothing in a box is needed, and the
   * index of a leaf plus one; Last is the end of the negative tetrahedra in it. Both are relative
   * to those of the cell.
   */
  struct NegativeBox
  {
    Bounds Box;
    std::uint32_t Next, Last;
  };
  std::vector<NegativeBox> NegativeBoxes;
  /// Where the tetrahedra of each block of cells begin, and the end.
  std::vector<std::uint32_t> Blocks;
};

/// @throw std::length_error for 2^32 tetrahedra or 2^28 cells, or more
CellTetrahedra MakeCellTetrahedra(
  const MeshView& mesh, const SubdividedFacets* subdivided = nullptr);

/// Minimum and maximum value of the points of each block of cells, ignoring NaN.
std::vector<std::array<float, 2>> FindBlockRanges(const MeshView& mesh,
  const std::vector<float>& pointValues, const SubdividedFacets* subdivided = nullptr);

/// The bounding box of each block of cells, (x, x, y, y, z, z) in the unit of coordinates; 1, -1
/// without points.
std::vector<std::array<double, 6>> FindBlockBounds(
  const MeshView& mesh, const SubdividedFacets* subdivided = nullptr);
}

#endif
