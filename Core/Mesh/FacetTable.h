// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTable
 * @brief Unique facets of the cells of one dimension, and which cells meet at them.
 *
 * The facets of 3D cells are polygons (faces), those of 2D cells are edges. Two facets are the same
 * when they have the same set of points, in whatever order; a facet may have any number of cells
 * (one on the boundary, two inside, more where the mesh is non-manifold), and the same cell twice.
 *
 * Facets are numbered by their owner, the first cell that has them, and within it by their local
 * number; the numbering is thus the same for any number of threads. A facet runs in the direction
 * of its owner; every other use says whether it runs the same way.
 *
 * What is left of a facet with fewer than three different points (an edge: two), and the edges of a
 * polygon with fewer than three, are collapsed: nothing can lie beyond them. No two cells share
 * them, and they are not on the boundary.
 *
 * The table holds no points: those of a facet are those of its owner's local facet.
 */
#ifndef camaron_FacetTable_h
#define camaron_FacetTable_h

#include "Base/Buffer.h" // for LargeVector

#include "vtkType.h" // for vtkIdType

#include <cstdint> // for the packed indices
#include <vector>  // for the tables

namespace camaron
{
/// Id of a cell or facet of one piece of a mesh; a piece may have up to 2^30 of either.
using Index = std::int32_t;

/// One use of a facet by a cell.
struct CellFacet
{
  Index Packed;
  CellFacet() = default;
  CellFacet(Index facet, bool reversed)
    : Packed(facet * 2 + (reversed ? 1 : 0))
  {
  }
  Index Facet() const { return this->Packed >> 1; }
  /// True when the cell runs around the facet against the direction of the facet's owner.
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
    Index Second; ///< below 0 if there is none
  };

  Index GetNumberOfFacets() const { return static_cast<Index>(this->FacetCells.size()); }
  Index GetNumberOfCells() const { return this->NumberOfCells; }

  /// Facets of a cell in the cell's local order; empty for a cell of another dimension.
  Range GetCellFacets(vtkIdType cell) const
  {
    const CellFacet* data = this->CellFacets.data();
    return { data + this->GetOffset(cell), data + this->GetOffset(cell + 1) };
  }
  /// The first two cells of a facet; the same cell twice where it meets itself.
  CellPair GetCells(Index facet) const { return this->FacetCells[facet]; }
  /// All cells of a facet, the owner first, then ascending; @a cells is overwritten.
  void GetCells(Index facet, std::vector<Index>& cells) const;
  /// 1 on the boundary and of collapsed ones, 2 inside, more where the mesh is non-manifold.
  Index GetNumberOfCells(Index facet) const;
  bool HasMoreThanTwoCells(Index facet) const
  {
    return !this->ExtraCells.empty() && this->GetNumberOfCells(facet) > 2;
  }
  bool IsBoundary(Index facet) const { return this->FacetCells[facet].Second == NoCell; }
  bool IsCollapsed(Index facet) const { return this->FacetCells[facet].Second == Nothing; }
  /// Local number of the facet in its owner, the first cell of GetCells.
  Index GetOwnerLocalFacet(Index facet) const;

  /// Bytes held.
  std::size_t GetMemorySize() const;

private:
  friend class FacetMatcher;
  friend class FacetTableBuilder;
  friend class TetrahedronFaces;

  ///@{
  /// In place of the second cell.
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
  Index Stride = 0;                   ///< facets per cell when all cells have the same, else 0
  LargeVector<vtkIdType> CellOffsets; ///< only if Stride is 0
  LargeVector<CellFacet> CellFacets;
  LargeVector<CellPair> FacetCells;
  std::vector<ExtraCell> ExtraCells; ///< third and further cells, sorted
};
}

#endif
