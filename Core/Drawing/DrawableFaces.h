// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DrawableFaces.h
 * @brief The faces of a mesh as triangles, in the layout of graphics memory.
 *
 * Every face is stored once, with its two cells. It is visible if one of its cells is drawn and
 * the other is not. The boundary of the mesh, the boundary of any subset of its cells, and all
 * interior faces are therefore selections from the same table. The faces visible when all cells
 * are drawn come first.
 */
#ifndef camaron_DrawableFaces_h
#define camaron_DrawableFaces_h

#include "Mesh/FacetTable.h" // for Index

#include "vtkDataSetAttributes.h" // for the kinds of ghosts

#include <array>   // for the rows
#include <cstdint> // for the rows
#include <vector>  // for the tables

namespace camaron
{
class FacetLinks;
class MeshTopology;

/// Shared by all faces from this index on.
constexpr int LastFacetBit = 63;

/// The bit of a face by its index in the cell.
inline std::uint64_t GetFacetBit(int local)
{
  return std::uint64_t(1) << (local < LastFacetBit ? local : LastFacetBit);
}

/**
 * For every 3D cell the bits of its faces without another cell, in this piece or in @a links
 * (nullptr: no other pieces). They are passed on with cells that are sent to another rank or merged
 * with those of another piece, whose faces may lose their neighbors without being at the boundary.
 */
std::vector<std::uint64_t> FindOuterFacets(const MeshTopology& topology, const FacetLinks* links);

class SubdividedFacets;

struct DrawableFaces
{
  static constexpr std::uint32_t NoCell = 0xffffffffu;
  /// There is a cell, but it is not in this piece of the mesh.
  static constexpr std::uint32_t CellElsewhere = 0xfffffffeu;
  /// The same, and the cell in the other piece comes first: it draws an interior face that one of
  /// the two cells draws.
  static constexpr std::uint32_t FirstCellElsewhere = 0xfffffffdu;
  /// Number of bits below the face in the last entry of a triangle: which of its three vertices
  /// begin an edge of the face.
  static constexpr int EdgeBits = 3;

  /// Three points, then the number of the face << EdgeBits | the bits of edges that belong to the
  /// face.
  std::vector<std::array<std::uint32_t, 4>> Triangles;
  /**
   * The cell for which the triangles are oriented outward, and the cell on the other side, NoCell
   * or one elsewhere. The order of two cells only depends on the coordinates of the face, so that
   * two pieces agree on it. A face with three or more cells is stored once for every further cell.
   */
  std::vector<std::array<std::uint32_t, 2>> Faces;
  /// Preceding triangles belong to faces with one drawable cell.
  std::uint32_t NumberOfOuterTriangles = 0;
};

enum class FacesToDraw
{
  Outer, ///< with one cell: all that is visible without cuts
  All
};

/// Additional information on cells, not in their topology.
struct CellsToDraw
{
  /// vtkGhostType or nullptr. Faces between two cells of another piece are omitted; hidden cells
  /// are ignored.
  const unsigned char* Ghosts = nullptr;
  /// See FindOuterFacets; if nullptr, all faces with one cell are at the boundary.
  const std::uint64_t* OuterFacets = nullptr;
  /// Of curved cells; the mesh has their new points, too.
  const SubdividedFacets* Subdivided = nullptr;

  bool IsHidden(vtkIdType cell) const
  {
    return this->Ghosts && (this->Ghosts[cell] & vtkDataSetAttributes::HIDDENCELL);
  }
  bool IsGhost(vtkIdType cell) const
  {
    return this->Ghosts && (this->Ghosts[cell] & vtkDataSetAttributes::DUPLICATECELL);
  }
  /// Whether a face with one cell is at the boundary.
  bool IsOuter(vtkIdType cell, Index local) const
  {
    return !this->OuterFacets || (this->OuterFacets[cell] & GetFacetBit(local));
  }
};

/**
 * The faces of the 3D cells, and the 2D cells as faces with one cell.
 * @throw std::length_error if the faces do not fit into the rows
 */
DrawableFaces MakeDrawableFaces(
  const MeshTopology& topology, const CellsToDraw& cells, FacesToDraw which);
}

#endif
