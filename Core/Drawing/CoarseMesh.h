// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CoarseMesh.h
 * @brief A mesh of fewer cells that looks like another one from outside and from inside.
 *
 * Points in the same box of a grid become one of them, and cells that lose no corner by that stay:
 * tetrahedra of the 3D cells, triangles of the 2D cells, segments and vertices. Points of the
 * outside have finer boxes than those inside. Cells that became the same are one; where they are
 * turned against each other as often as not, none. So what tetrahedra are left enclose what the
 * outside of the mesh became (the boundary of the image of a chain is the image of its boundary),
 * without cracks. Outer faces that no tetrahedron is left behind stay as triangles: parts thinner
 * than the boxes become sheets. Source: J. Rossignac, P. Borrel, Multi-resolution 3D approximations
 * for rendering complex scenes (1993), for surfaces.
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

  /// Those of the mesh that stand for the others.
  std::vector<vtkIdType> Points;
  /// Places in Points, NoPoint after the last; tetrahedra, then cells of one, two and three
  /// corners.
  std::vector<std::array<std::uint32_t, 4>> Cells;
  /// The cell of the mesh that each is of.
  std::vector<vtkIdType> Origins;
  /// See OuterFacets.h; of each cell.
  std::vector<std::uint64_t> OuterFacets;
};

/// Boxes along each axis.
struct CoarseBoxes
{
  std::array<double, 6> Bounds = { { 1, -1, 1, -1, 1, -1 } }; ///< of them all
  int OfOutside = 85;
  int OfInside = 30;
};

/**
 * Ghosts and hidden cells are left out.
 * @throw std::length_error when the mesh has too many cells for MakeCellTetrahedra
 */
CoarseMesh MakeCoarseMesh(
  const MeshTopology& topology, const CellsToDraw& cells, const CoarseBoxes& boxes);
}

#endif
