// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTableBuilder
 * @brief Finds the unique facets of a mesh.
 *
 * Uses of facets are sorted into buckets by a hash of their points that is similar for neighbors.
 * Uses with the same hash are compared within a bucket, which fits into the processor cache. Time
 * and memory therefore stay proportional to the mesh, however it is numbered; temporary memory is
 * 4 bytes per use.
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
   * Facets of the cells of @a dimension (3: faces, 2: edges).
   * @param given empty, or for every use of a facet, cell by cell, a number below
   * @a numberOfGiven; equal numbers mean the same facet
   * @throw std::length_error for more than 2^30 uses of facets
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
  /// For every given number.
  LargeVector<std::atomic<Index>> FindFirstUses(
    const LargeVector<Index>& given, Index numberOfGiven);
  void Match(const Buckets& buckets);
  template <typename Wants>
  Buckets FillBuckets(Wants&& wants);
  /// The first use with the same points, before facets are numbered.
  CellFacet GetLeader(Index use) const;

  const MeshView& Mesh;
  int Dimension;
  bool AreTetrahedra = false; ///< the mesh has no other cells
  Index NumberOfUses = 0;
  std::mutex Mutex;             ///< for what threads rarely find
  std::vector<Index> Collapsed; ///< uses of collapsed facets, see FacetTable
  FacetTable Table;
};
}

#endif
