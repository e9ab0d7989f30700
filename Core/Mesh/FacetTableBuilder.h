// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTableBuilder
 * @brief Finds the unique facets of a mesh.
 *
 * Uses of facets are put into buckets by their smallest point id and compared within a bucket, whose keys fit
 * into the cache of a processor. So time and memory stay proportional to the mesh however it is numbered; 4 bytes per
 * use are needed meanwhile.
 */
#ifndef camaron_FacetTableBuilder_h
#define camaron_FacetTableBuilder_h

#include "Mesh/CellFacets.h"
#include "Mesh/FacetTable.h"

#include <vector> // for scratch

namespace camaron
{
class FacetTableBuilder
{
public:
  /**
   * Facets of the cells of @a dimension (3: faces, 2: edges). @a given is empty or holds for every use
   * of a facet, cell by cell, a number below @a numberOfGiven; equal numbers are the same facet.
   * @throw std::length_error if there are more than 2^30 uses of facets
   */
  static FacetTable Build(const MeshView& mesh, int dimension, const std::vector<Index>& given = {},
    Index numberOfGiven = 0);

private:
  FacetTableBuilder(const MeshView& mesh, int dimension);

  struct Buckets;
  class BucketMatcher;

  void CountFacets();
  void MatchUses();
  void MatchGiven(const std::vector<Index>& given, Index numberOfGiven);
  void NumberFacets();
  void ListCells();
  template <typename ForEachItem>
  void Match(ForEachItem&& forEachItem);
  template <typename ForEachItem>
  Buckets FillBuckets(ForEachItem&& forEachItem);
  /// The first use with the same points, as long as facets have no numbers.
  CellFacet GetLeader(Index use) const;

  const MeshView& Mesh;
  int Dimension;
  Index NumberOfUses = 0;
  FacetTable Table;
};
}

#endif
