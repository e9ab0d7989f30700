// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetLinks
 * @brief The cells of other pieces at the facets of a piece of a mesh.
 *
 * Created by LinkPieces.
 */
#ifndef camaron_FacetLinks_h
#define camaron_FacetLinks_h

#include "Base/Vector.h"
#include "Mesh/FacetTable.h"

#include <algorithm> // for a search
#include <cstddef>   // for std::size_t
#include <cstdint>   // for ids
#include <vector>    // for the cells

namespace camaron
{
/// The known properties of a cell of another piece.
struct LinkedCell
{
  Vector Centroid;     ///< absolute coordinates
  double Size = 0;     ///< volume or area; NaN if the cell is not closed
  Vector Area;         ///< unit normal of a polygon; zero if it has no area
  std::int64_t Id = 0; ///< global id, or index in its block or piece
  std::int32_t Process = 0, Piece = 0, Cell = 0;
  Index Facet = 0;
};

class FacetLinks
{
public:
  /// Whether a cell of another piece has this facet.
  bool Has(Index facet) const { return !this->Marks.empty() && this->Marks[facet]; }

  /// Calls @a visit(const LinkedCell&, bool isReversed) for the other cells at a facet, in an order
  /// that is the same on all ranks. isReversed is relative to the facet's owner in this piece, as
  /// in CellFacet.
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
  const Entry& Find(Index facet) const
  {
    return *std::lower_bound(this->Entries.begin(), this->Entries.end(), facet,
      [](const Entry& entry, Index f) { return entry.Facet < f; });
  }

  std::int32_t Process = 0, Piece = 0;
  std::vector<bool> Marks;       // for all facets
  std::vector<Entry> Entries;    // sorted
  std::vector<LinkedCell> Cells; // of all pieces, including this one, grouped by facet
  std::vector<bool> Descends;    // whether the cell traverses an edge towards the smaller key
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
