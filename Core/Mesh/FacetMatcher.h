// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetMatcher
 * @brief Compares the uses of one bucket of FacetTableBuilder after the other. Holds its memory for
 * the next bucket.
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
  /// Of @a table the offsets are there, and in place of its cell facets hashes of the points of all
  /// uses.
  FacetMatcher(const MeshView& mesh, FacetTable& table)
    : Table(table)
    , CellsPerUse(table.Stride > 0 ? 1.0 / table.Stride : 0)
    , Facets(mesh)
    , OtherFacets(mesh)
  {
  }

  /**
   * Leaves in the cell facets of ascending uses the first of these with the same points: a use
   * itself, or the complement of another one and whether it runs against it. Only those with the
   * same hash are compared.
   */
  void Match(const Index* uses, Index size);

private:
  void FindAlike(const Index* uses, Index size);
  bool AreSame(Index use, Index other, vtkIdType cell, vtkIdType otherCell, bool& isReversed);
  vtkIdType FindCell(Index use, vtkIdType from) const;

  FacetTable& Table;
  double CellsPerUse; ///< if all have as many
  CellFacets Facets, OtherFacets;
  ///@{
  /// Of every use of the bucket.
  std::vector<Index> Hashes;
  std::vector<Index> Firsts; // the first one with the same hash
  std::vector<Index> Nexts;  // of those that are different, but have the same hash
  std::vector<unsigned char> AreAlike;
  std::vector<Index> Cells; // of those that are alike
  ///@}
  std::vector<Index> Slots; // of a hash table of the first ones
};
}

#endif
