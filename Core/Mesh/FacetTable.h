// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTable
 * @brief The unique facets of the cells of one dimension, and the cells at each of them.
 *
 * The facets of 3D cells are polygons (faces), those of 2D cells are edges. Facets with the same
 * set of points, in any order, are the same facet. A facet may have any number of cells (one at
 * the boundary, two inside, more where the mesh is non-manifold), and the same cell twice.
 *
 * The owner of a facet is its first cell. Facets are numbered in the order of their owners, then
 * by their local index in the owner, so the numbering does not depend on the number of threads. A
 * facet has the orientation that its owner gives it; every other use stores whether it is reversed.
 *
 * A facet with fewer than three different points (an edge: two), and every edge of a polygon with
 * fewer than three, is collapsed: it has no neighbor, is shared by no two cells, and is not on the
 * boundary.
 *
 * The table does not store the points of facets; get them from the owner's local facet.
 */
#ifndef camaron_FacetTable_h
#define camaron_FacetTable_h

#include "Base/Buffer.h" // for LargeVector

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for the packed indices
#include <vector>  // for the tables

namespace camaron
{
/// Index of a cell or facet of one piece of a mesh; a piece may have up to 2^30 of either.
using Index = std::int32_t;

/// The use of a facet by a cell.
struct CellFacet
{
  Index Packed;
  CellFacet() = default;
  CellFacet(Index facet, bool reversed)
    : Packed(facet * 2 + (reversed ? 1 : 0))
  {
  }
  Index Facet() const { return this->Packed >> 1; }
  /// Whether the cell traverses the facet opposite to the facet's owner.
  bool IsReversed() const { return (this->Packed & 1) != 0; }
};

class FacetTable
{
public:
  struct Range
  {
    const CellFacet* First = nullptr;
    const CellFacet* Last = nullptr;
    const CellFacet* begin() const { return this->First; }
    const CellFacet* end() const { return this->Last; }
    Index size() const { return static_cast<Index>(this->Last - this->First); }
    CellFacet operator[](Index i) const { return this->First[i]; }
  };
  struct CellPair
  {
    Index First;  ///< the owner
    Index Second; ///< negative if there is none
  };

  Index GetNumberOfFacets() const { return static_cast<Index>(this->FacetCells.size()); }
  Index GetNumberOfCells() const { return this->NumberOfCells; }

  /// Facets of a cell in the cell's local order; empty for a cell of another dimension.
  Range GetCellFacets(vtkIdType cell) const
  {
    const CellFacet* data = this->CellFacets.data();
    return { data + this->GetOffset(cell), data + this->GetOffset(cell + 1) };
  }
  /// The first two cells of a facet; the same cell twice if it is its own neighbor.
  CellPair GetCells(Index facet) const { return this->FacetCells[facet]; }
  /// All cells of a facet, the owner first, then ascending; @a cells is overwritten.
  void GetCells(Index facet, std::vector<Index>& cells) const;
  /// 1 on the boundary and for collapsed facets, 2 inside, more where the mesh is non-manifold.
  Index GetNumberOfCells(Index facet) const;
  bool HasMoreThanTwoCells(Index facet) const
  {
    return !this->ExtraCells.empty() && this->GetNumberOfCells(facet) > 2;
  }
  bool IsBoundary(Index facet) const { return this->FacetCells[facet].Second == NoCell; }
  bool IsCollapsed(Index facet) const { return this->FacetCells[facet].Second == Nothing; }
  /// Local index of the facet in its owner, the first cell of GetCells.
  Index GetOwnerLocalFacet(Index facet) const;
  /// Whether cells may have other rings of the points of a facet than its owner: such a cell
  /// traverses them in another order, or repeats a point.
  bool HasOtherRings() const { return this->OtherRings; }
  /// Whether this is the owner of the facet, and @a local its local index.
  bool IsOwner(Index facet, vtkIdType cell, vtkIdType local) const
  {
    return this->GetCells(facet).First == cell && this->GetOwnerLocalFacet(facet) == local;
  }
  /// Calls @a visit(facet, points, numberOfPoints) for the facets that a cell owns; @a facets are
  /// CellFacets of the mesh.
  template <typename Facets, typename Visit>
  void ForEachOwned(vtkIdType cell, Facets& facets, Visit&& visit) const
  {
    const Range uses = this->GetCellFacets(cell);
    if (uses.size() > 0)
    {
      facets.ForEach(cell,
        [&](const vtkIdType* points, vtkIdType size, vtkIdType local)
        {
          const Index facet = uses[static_cast<Index>(local)].Facet();
          if (this->IsOwner(facet, cell, local))
          {
            visit(facet, points, size);
          }
        });
    }
  }

private:
  friend class FacetMatcher;
  friend class FacetTableBuilder;
  friend class TetrahedronFaces;

  ///@{
  /// Stored instead of the second cell: none, or collapsed.
  static constexpr Index NoCell = -1;
  static constexpr Index Nothing = -2;
  ///@}

  vtkIdType GetOffset(vtkIdType cell) const
  {
    return this->Stride ? cell * this->Stride : this->CellOffsets[cell];
  }

  struct ExtraCell
  {
    Index Facet;
    Index Cell;
  };

  Index NumberOfCells = 0;
  bool OtherRings = false;
  Index Stride = 0;                   ///< facets per cell if all cells have the same number, else 0
  LargeVector<vtkIdType> CellOffsets; ///< only if Stride is 0
  LargeVector<CellFacet> CellFacets;
  LargeVector<CellPair> FacetCells;
  std::vector<ExtraCell> ExtraCells; ///< third and further cells, sorted
};

/**
 * Calls @a visit(facet, cell) once for each facet of the cells with @a isOwn(cell), with the first
 * of these cells. Cells of other pieces between them have no influence, so elements have the same
 * numbers in a piece without ghost cells, with them, and in the completed piece.
 */
template <typename IsOwn, typename Visit>
void ForEachOwnFacet(const FacetTable& table, IsOwn&& isOwn, Visit&& visit)
{
  std::vector<bool> isVisited(static_cast<std::size_t>(table.GetNumberOfFacets()), false);
  for (Index cell = 0; cell < table.GetNumberOfCells(); ++cell)
  {
    if (!isOwn(cell))
    {
      continue;
    }
    for (const CellFacet use : table.GetCellFacets(cell))
    {
      if (!isVisited[use.Facet()])
      {
        isVisited[use.Facet()] = true;
        visit(use.Facet(), cell);
      }
    }
  }
}
}

#endif
