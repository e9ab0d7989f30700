// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetMatcher
 * @brief Compares the uses of one bucket of FacetTableBuilder after the other. Holds its memory for the next bucket.
 */
#ifndef camaron_FacetMatcher_h
#define camaron_FacetMatcher_h

#include "Mesh/CellFacets.h"
#include "Mesh/FacetKey.h"
#include "Mesh/FacetTable.h"

#include <vector> // for the entries

namespace camaron
{
class FacetMatcher
{
public:
  /// Of @a table the offsets are there, and cell facets for all uses.
  FacetMatcher(const MeshView& mesh, FacetTable& table)
    : Table(table)
    , Facets(mesh)
  {
  }

  /**
   * Leaves in the cell facets of ascending uses the first of these with the same points: a use itself, or the complement
   * of another one and whether it runs against it.
   */
  void Match(const Index* uses, Index size);

  /// The same where the table has hashes of the uses and few have the same. Only these are compared.
  void MatchHashed(const Index* uses, Index size);

private:
  struct Entry
  {
    FacetKey Key;
    std::uint64_t Hash;
    vtkIdType Begin, Size; // in Points, if the key is hashed
    Index Next;            // with the same hash
  };

  void FindAlike(const Index* uses, Index size);
  void LoadEntries(const Index* uses, Index size);
  void Load(Entry& entry, const vtkIdType* points, vtkIdType size);
  bool IsSame(const Entry& a, const Entry& b) const
  {
    return a.Key == b.Key && (!a.Key.IsHashed() || this->HaveSamePoints(a, b));
  }
  bool HaveSamePoints(const Entry& a, const Entry& b) const;
  vtkIdType FindCell(Index use, vtkIdType from) const;

  FacetTable& Table;
  CellFacets Facets;
  std::vector<Entry> Entries;
  std::vector<Index> Lists; // of entries with the same hash
  std::vector<Index> Alike; // uses with the same hash as another one
  std::vector<unsigned char> IsAlike;
  std::vector<vtkIdType> Points, Sorted;
};
}

#endif
