// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTableBuilder
 * @brief Finds the unique facets of a mesh.
 *
 * Uses of facets are put into buckets by a hash of their points that is close for neighbors. Those
 * with the same hash are compared within a bucket, which fits into the cache of a processor. So
 * time and memory stay proportional to the mesh however it is numbered; 4 bytes per use are needed
 * meanwhile.
 */
#ifndef camaron_FacetTableBuilder_h
#define camaron_FacetTableBuilder_h

#include "Mesh/CellFacets.h"
#include "Mesh/FacetTable.h"

#include <atomic> // for first uses
#include <mutex>  // for collapsed facets
#include <vector> // for scratch

namespace camaron
{
class FacetTableBuilder
{
public:
  /**
   * Facets of the cells of @a dimension (3: faces, 2: edges). @a given is empty or holds for every
   * use of a facet, cell by cell, a number below @a numberOfGiven; equal numbers are the same
   * facet.
   * @throw std::length_error if there are more than 2^30 uses of facets
   */
  static FacetTable Build(const MeshView& mesh, int dimension, const LargeVector<Index>& given = {},
    Index numberOfGiven = 0);

private:
  FacetTableBuilder(const MeshView& mesh, int dimension);

  struct Buckets;

  void CountFacets();
  void ClearUses();
  void MatchUses();
  void MatchGiven(const LargeVector<Index>& given, Index numberOfGiven);
  void NumberFacets();
  void ListCells();
  void ListExtraCells();
  template <typename PutFacet>
  void ForEachValidFacet(CellFacets& facets, vtkIdType cell, PutFacet&& put);
  void KeepCollapsed();
  /// Of every given number.
  LargeVector<std::atomic<Index>> FindFirstUses(
    const LargeVector<Index>& given, Index numberOfGiven);
  void Match(const Buckets& buckets);
  template <typename PutItems>
  Buckets FillBuckets(Index maxKey, PutItems&& putItems);
  /// The first use with the same points, as long as facets have no numbers.
  CellFacet GetLeader(Index use) const;

  const MeshView& Mesh;
  int Dimension;
  bool AreTetrahedra = false; ///< and nothing else
  Index NumberOfUses = 0;
  std::mutex CollapsedMutex;
  std::vector<Index> Collapsed; ///< uses of facets that are, see FacetTable
  FacetTable Table;
};
}

#endif
