// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetLinks
 * @brief The cells of other pieces at the facets of a piece of a mesh.
 *
 * Made by LinkPieces.
 */
#ifndef camaron_FacetLinks_h
#define camaron_FacetLinks_h

#include "Base/Vector.h"
#include "Mesh/FacetTable.h"

#include <cstddef> // for std::size_t
#include <cstdint> // for ids
#include <vector>  // for the cells

namespace camaron
{
/// What is known of a cell of another piece.
struct LinkedCell
{
  Vector Centroid;     ///< not relative to anything
  double Size = 0;     ///< volume or area, null where the cell is not closed
  Vector Area;         ///< unit normal of a polygon; zero if it has no area
  std::int64_t Id = 0; ///< global id, or the number in its block or piece
  std::int32_t Process = 0, Piece = 0, Cell = 0;
  Index Facet = 0;
};

class FacetLinks
{
public:
  /// Whether a cell of another piece has this facet.
  bool Has(Index facet) const { return !this->Marks.empty() && this->Marks[facet]; }

  /// Calls @a visit(const LinkedCell&, bool isReversed) for the other cells of a facet, in an order
  /// that is the same everywhere; isReversed as in CellFacet, with respect to the facet's owner in
  /// this piece.
  template <typename Visit>
  void ForEach(Index facet, Visit&& visit) const
  {
    if (!this->Has(facet))
    {
      return;
    }
    const Entry& entry = this->Find(facet);
    for (std::size_t i = entry.First; i < entry.Last; ++i)
    {
      const LinkedCell& cell = this->Cells[i];
      if (cell.Process != this->Process || cell.Piece != this->Piece || cell.Facet != facet)
      {
        visit(cell, this->Descends[i] != entry.OwnerDescends);
      }
    }
  }

private:
  friend class PieceLinker;
  struct Entry
  {
    Index Facet;
    bool OwnerDescends;
    std::size_t First, Last;
  };
  const Entry& Find(Index facet) const;

  std::int32_t Process = 0, Piece = 0;
  std::vector<bool> Marks;       // of all facets
  std::vector<Entry> Entries;    // sorted
  std::vector<LinkedCell> Cells; // of all pieces, this one included, facet by facet
  std::vector<bool> Descends;    // whether they run along an edge towards the smaller key
};

struct PieceLinks
{
  FacetLinks Faces; ///< of 3D cells
  FacetLinks Edges; ///< of 2D cells

  const FacetLinks& GetFacets(int dimension) const
  {
    return dimension == 3 ? this->Faces : this->Edges;
  }
};
}

#endif
