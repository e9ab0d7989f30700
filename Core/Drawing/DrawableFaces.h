// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DrawableFaces.h
 * @brief The faces of a mesh as triangles, in the form that the graphics memory holds.
 *
 * Every face stands once, with the two cells at it. It is seen where one of its cells is drawn and
 * the other is not, so that the outside of the mesh, the outside of any part of its cells and all
 * the walls between them are choices from the same table. The faces that are seen when all cells
 * are drawn come first.
 */
#ifndef camaron_DrawableFaces_h
#define camaron_DrawableFaces_h

#include <array>   // for the rows
#include <cstdint> // for the rows
#include <vector>  // for the tables

namespace camaron
{
class MeshTopology;

struct DrawableFaces
{
  static constexpr std::uint32_t NoCell = 0xffffffffu;
  /// There is a cell, but not in this piece of the mesh.
  static constexpr std::uint32_t CellElsewhere = 0xfffffffeu;
  /// The same, and it comes first there: of the wall between two cells that one draws, it does.
  static constexpr std::uint32_t FirstCellElsewhere = 0xfffffffdu;
  /// Bits of a triangle's last entry below the face: its three corners begin an edge of the face.
  static constexpr int EdgeBits = 3;

  /// Three points, then the number of the face << EdgeBits | the edges that are the face's own.
  std::vector<std::array<std::uint32_t, 4>> Triangles;
  /**
   * The cell that the triangles run around outward, and the cell on the other side, NoCell or one
   * elsewhere. Which of two cells comes first follows from the coordinates of the face alone, so
   * that two pieces agree on it. A face of three and more cells stands once for every further cell.
   */
  std::vector<std::array<std::uint32_t, 2>> Faces;
  /// Triangles before these belong to faces with one cell to draw.
  std::uint32_t NumberOfOuterTriangles = 0;
};

enum class FacesToDraw
{
  Outer, ///< with one cell: all that is seen while the mesh is whole
  All
};

/// What is known of the cells beyond what their topology tells.
struct CellsToDraw
{
  /// vtkGhostType or null. A face between two cells that are another piece's is left out; so are
  /// hidden cells, as if the mesh did not have them.
  const unsigned char* Ghosts = nullptr;
  /// See OuterFacets.h; null: faces with one cell are on the outside.
  const std::uint64_t* OuterFacets = nullptr;
};

/**
 * The faces of the 3D cells and the 2D cells themselves, each of which is a face with one cell.
 * @throw std::length_error when the faces do not fit into the rows
 */
DrawableFaces MakeDrawableFaces(
  const MeshTopology& topology, const CellsToDraw& cells, FacesToDraw which);
}

#endif
