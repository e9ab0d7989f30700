// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTableBuilder
 * @brief Finds the unique facets of a mesh.
 *
 * Facets are put into one bucket per smallest point id and compared there by their other points, so
 * that time and memory stay proportional to the mesh. 16 bytes per facet use are needed meanwhile.
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

  /// One facet to be matched with the others of its bucket.
  struct Entry
  {
    std::uint64_t Key;   ///< of up to four points: the second and third smallest; else a hash
    std::uint32_t Extra; ///< the fourth point, or what tells the cases apart
    std::uint32_t Item;  ///< use of a facet; the top bit says that it runs downwards
  };

  void CountFacets();
  void MatchUses();
  void MatchGiven(const std::vector<Index>& given, Index numberOfGiven);
  void NumberFacets();
  void ListCells();
  template <typename ForEachItem>
  void Match(vtkIdType numberOfCells, ForEachItem&& forEachItem);
  void MatchBucket(Entry* first, Entry* last);
  bool HaveSamePoints(Index use0, Index use1) const;
  void GetSortedPoints(Index use, std::vector<vtkIdType>& points) const;

  const MeshView& Mesh;
  int Dimension;
  Index NumberOfUses = 0;
  FacetTable Table;
};
}

#endif
