// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetMatcher
 * @brief Finds equal facets within a bucket of FacetTableBuilder. Reuses its memory for the next
 * bucket.
 */
#ifndef camaron_FacetMatcher_h
#define camaron_FacetMatcher_h

#include "Mesh/CellFacets.h"
#include "Mesh/FacetTable.h"

#include <vector> // for what is known of uses

namespace camaron
{
class FacetMatcher
{
public:
  /// The offsets of @a table must be set, and its cell facets must contain hashes of the points of
  /// all uses.
  FacetMatcher(const MeshView& mesh, FacetTable& table)
    : Table(table)
    , CellsPerUse(table.Stride > 0 ? 1.0 / table.Stride : 0)
    , Facets(mesh)
    , OtherFacets(mesh)
  {
  }

  /**
   * Replaces the cell facets of the given uses, in ascending order, by the first use with the same
   * points: the use itself, or the complement of another one and whether it has the opposite
   * orientation. Only uses with the same hash are compared.
   */
  void Match(const Index* uses, Index size);

  /// Whether facets were matched that have the same points but may be other rings of them.
  bool MatchesOtherRings = false;

private:
  void FindAlike(const Index* uses, Index size);
  bool AreSame(Index use, Index other, vtkIdType cell, vtkIdType otherCell, bool& isReversed);
  vtkIdType FindCell(Index use, vtkIdType from) const;

  FacetTable& Table;
  double CellsPerUse; ///< if all cells have the same number of facets
  CellFacets Facets, OtherFacets;
  ///@{
  /// For every use of the bucket.
  std::vector<Index> Hashes;
  std::vector<Index> Firsts; // the first use with the same hash
  std::vector<Index> Nexts;  // next use with the same hash but other points
  std::vector<unsigned char> AreAlike;
  std::vector<Index> Cells; // of uses with a duplicate
  ///@}
  std::vector<Index> Slots; // of a hash table of first uses
};
}

#endif
