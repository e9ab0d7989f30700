// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoarseMesh.h
 * @brief A mesh with fewer cells that looks similar from outside and from inside.
 *
 * Points in the same box of a grid are merged, and cells that keep all their vertices remain:
 * tetrahedra of the 3D cells, triangles of the 2D cells, segments and vertices. Boxes are finer
 * for points of the boundary than inside. Cells that became identical are merged; if they cancel
 * in orientation, they are removed. The remaining tetrahedra therefore fill exactly what the
 * simplified boundary encloses (the boundary of the image of a chain is the image of its
 * boundary), without cracks. Boundary faces without a remaining tetrahedron behind them stay as
 * triangles, so parts thinner than the boxes become sheets. Source: J. Rossignac, P. Borrel,
 * Multi-resolution 3D approximations for rendering complex scenes (1993), for surfaces.
 */
#ifndef camaron_CoarseMesh_h
#define camaron_CoarseMesh_h

#include "Drawing/DrawableFaces.h" // for CellsToDraw

#include "vtkType.h" // for vtkIdType

#include <array>   // for the rows
#include <cstdint> // for the rows
#include <vector>  // for the tables

namespace camaron
{
class MeshTopology;

struct CoarseMesh
{
  static constexpr std::uint32_t NoPoint = 0xffffffffu;

  /// The points of the mesh that represent the others.
  std::vector<vtkIdType> Points;
  /// Indices into Points, NoPoint after the last; tetrahedra, then cells with one, two and three
  /// vertices.
  std::vector<std::array<std::uint32_t, 4>> Cells;
  /// The original cell of each cell.
  std::vector<vtkIdType> Origins;
  /// For each cell; see FindOuterFacets.
  std::vector<std::uint64_t> OuterFacets;
};

/// Number of boxes along each axis.
struct CoarseBoxes
{
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1, -1 } }; ///< of all boxes
  int OfOutside = 85;
  int OfInside = 30;
};

/**
 * Ignores ghosts and hidden cells.
 * @throw std::length_error if the mesh has too many cells for MakeCellTetrahedra
 */
CoarseMesh MakeCoarseMesh(
  const MeshTopology& topology, const CellsToDraw& cells, const CoarseBoxes& boxes);
}

#endif
