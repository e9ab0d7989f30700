// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellTetrahedra.h
 * @brief Cuts the cells of a mesh into tetrahedra that fit at shared faces.
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

/**
 * Tetrahedra of the 3D cells, in the order of these. A cell is a fan from its first point
 * (FirstPoint.h) over the triangles of the faces that do not have it: of a convex face a fan from
 * its own first point, of others those of PolygonTriangulator. Two cells therefore cut the face
 * between them in the same way, also on two processes.
 *
 * Of a cell that its first point does not see all of, some tetrahedra are negative: what lies in
 * them is outside of the cell, or in one more of the others. Seen from the first point, a place is
 * in the cell if and only if the first face behind it is that of a tetrahedron that is not
 * negative.
 */
struct CellTetrahedra
{
  /// Cells that lie together in memory, and mostly in space.
  static constexpr vtkIdType CellsPerBlock = 64;

  /// Room for the bits beside a cell.
  static constexpr int WallBits = 4;
  /// Bit of Edges: a negative tetrahedron. These come first in a cell.
  static constexpr std::uint8_t Negative = 64;
  static constexpr std::uint32_t None = 0xffffffff;

  std::vector<std::array<std::uint32_t, 4>> Points;
  /// The cell << WallBits; bit i: the face opposite point i lies in a face of the cell.
  std::vector<std::uint32_t> Cells;
  /// Bits of the lines between points (0, 1), (0, 2), (0, 3), (1, 2), (1, 3) and (2, 3): those that
  /// are edges of the cell.
  std::vector<std::uint8_t> Edges;
  /// Of every cell its first negative tetrahedron and its first row of NegativeBoxes, or None;
  /// empty if there is no such cell.
  std::vector<std::array<std::uint32_t, 2>> FirstNegatives;
  /**
   * A tree of boxes around the faces of the cell that its negative tetrahedra have; and the first
   * point, of those that have a face of the cell at their sides, too. In the order in which they
   * are looked at: Next is where to go on if nothing in a box is wanted, and one more than its own
   * place for a leaf; Last is the end of the negative ones in it; both count from those of the
   * cell.
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
CellTetrahedra MakeCellTetrahedra(const MeshView& mesh);

/// The least and the largest value that the points of each block of cells have; NaN does not count.
std::vector<std::array<float, 2>> FindBlockRanges(
  const MeshView& mesh, const std::vector<float>& pointValues);

/// The boxes around each block of cells, (x, x, y, y, z, z) in the unit of coordinates; 1, -1
/// around no points.
std::vector<std::array<double, 6>> FindBlockBounds(const MeshView& mesh);
}

#endif
