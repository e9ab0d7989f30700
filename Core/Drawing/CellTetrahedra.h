// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellTetrahedra.h
 * @brief Cuts the cells of a mesh into tetrahedra that fit at shared faces.
 */
#ifndef camaron_CellTetrahedra_h
#define camaron_CellTetrahedra_h

#include "vtkType.h" // for vtkIdType

#include <array>   // for the rows
#include <cstdint> // for the rows
#include <vector>  // for the tables

class vtkDataArray;

namespace camaron
{
class MeshView;

/**
 * Tetrahedra of the 3D cells, in the order of these. A cell is a fan from its first point (FirstPoint.h) over the
 * triangles of the faces that do not have it: of a convex face a fan from its own first point, of others those of
 * PolygonTriangulator. Two cells therefore cut the face between them in the same way, also on two processes.
 * Right for cells that are convex, or at least seen entirely from their first point.
 */
struct CellTetrahedra
{
  /// Cells that lie together in memory, and mostly in space.
  static constexpr vtkIdType CellsPerBlock = 64;

  /// Room for the bits beside a cell.
  static constexpr int WallBits = 4;

  std::vector<std::array<std::uint32_t, 4>> Points;
  /// The cell << WallBits; bit i: the face opposite point i lies in a face of the cell.
  std::vector<std::uint32_t> Cells;
  /// Bits of the lines between points (0, 1), (0, 2), (0, 3), (1, 2), (1, 3) and (2, 3): those that are
  /// edges of the cell.
  std::vector<std::uint8_t> Edges;
  /// Where the tetrahedra of each block of cells begin, and the end.
  std::vector<std::uint32_t> Blocks;
};

/// @throw std::length_error for 2^32 tetrahedra or 2^28 cells, or more
CellTetrahedra MakeCellTetrahedra(const MeshView& mesh);

/// The least and the largest value that the points of each block of cells have; NaN does not count.
std::vector<std::array<float, 2>> FindBlockRanges(
  const MeshView& mesh, const std::vector<float>& pointValues);

/// The boxes around each block of cells, (x, x, y, y, z, z) in the unit of coordinates; 1, -1 around no points.
std::vector<std::array<double, 6>> FindBlockBounds(const MeshView& mesh);
}

#endif
