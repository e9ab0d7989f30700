// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class camaron::FacetTableBuilder
 * @brief Finds the unique facets of a mesh.
 *
 * Facets are listed by their smallest point id and compared within a list by their other points, so that
 * time and memory stay proportional to the mesh; 24 bytes per unique facet are needed meanwhile. Cells
 * are visited in order, so that a mesh whose neighbours are near in memory is read from the cache. Every
 * thread visits all cells, but takes care of its own share of the points only.
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

  /// A facet found so far.
  struct Node
  {
    std::uint32_t Key[3]; ///< what tells it from other facets with its smallest point
    Index Next;           ///< in its list, -1 at the end
    std::uint32_t Item;   ///< its first use; the top bit says that this use runs downwards
    Index Cell;           ///< of that use
  };
  class NodePool;

  void CountFacets();
  void MatchUses();
  void MatchGiven(const std::vector<Index>& given, Index numberOfGiven);
  void NumberFacets();
  void ListCells();
  template <typename ForEachItem>
  void Match(ForEachItem&& forEachItem);
  bool HasPoints(const Node& node, const vtkIdType* points, vtkIdType size,
    CellFacets& facets, std::vector<vtkIdType>& first) const;

  const MeshView& Mesh;
  int Dimension;
  Index NumberOfUses = 0;
  FacetTable Table;
};
}

#endif
