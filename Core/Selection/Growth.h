// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Growth.h
 * @brief Layers of neighbors, and connected components, across all pieces of a mesh.
 *
 * Cells are neighbors over common facets (faces of 3D cells, edges of 2D cells), edges or
 * vertices, in any piece. Duplicates of cells (DUPLICATECELL) are never marked. All functions are
 * collective, and results do not depend on how the mesh is split.
 */
#ifndef camaron_Growth_h
#define camaron_Growth_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"
#include "Selection/CellElements.h"

#include <cstdint> // for counts
#include <vector>  // for marks

namespace camaron
{
/// For each piece and cell, or point, 1 or 0.
using CellMarks = std::vector<std::vector<unsigned char>>;

struct Neighborhood
{
  camaron::Adjacency Adjacency = camaron::Adjacency::Facet;
  /**
   * In degrees: 2D cells whose normals differ by more than this are not neighbors over their edge;
   * at an edge with more than two cells, if any two of them differ by more. Only for facets.
   */
  double FeatureAngle = 180;
};

/// Adds @a numberOfLayers layers of neighbors of the marked cells to @a marks, restricted to the
/// cells that are @a allowed.
void Grow(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  int numberOfLayers, const CellMarks& allowed, Reducer& reducer, CellMarks& marks);

/// As Grow over edges, for a mesh without other pieces. A mesh has several times more edges than
/// cells, so this only processes those near the layers.
void GrowOverEdges(const LinkedPiece& piece, int numberOfLayers,
  const std::vector<unsigned char>& allowed, std::vector<unsigned char>& marks);

/// Adds @a numberOfLayers layers of @a allowed points to @a marks, which are marks of points: those
/// on a facet, an edge or (Vertex) a cell with a marked point. Points shared by several pieces are
/// marked in all of them.
void GrowPoints(const std::vector<LinkedPiece>& pieces, Adjacency adjacency, int numberOfLayers,
  CellMarks allowed, Reducer& reducer, CellMarks& marks);

/// Adds all @a allowed cells to @a marks that are connected to marked cells.
void Flood(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  const CellMarks& allowed, Reducer& reducer, CellMarks& marks);

/// The largest connected components of a set of cells. Of equally large ones, the one with the
/// smallest id comes first.
struct LargestParts
{
  struct PartCell
  {
    vtkIdType Cell;
    std::size_t Part; ///< position in Sizes
  };
  std::int64_t Total = 0;                   ///< number of all components
  std::vector<std::int64_t> Sizes;          ///< numbers of cells
  std::vector<std::vector<PartCell>> Cells; ///< for each piece its cells in these components
};

/**
 * The largest @a count connected components of the marked cells; 0 means all.
 * @param ids for each piece and cell, unique over all pieces
 */
LargestParts FindLargestParts(const std::vector<LinkedPiece>& pieces,
  const Neighborhood& neighborhood, std::int64_t count,
  const std::vector<std::vector<vtkIdType>>& ids, Reducer& reducer, const CellMarks& marks);

/**
 * Only keeps the @a rank-th largest connected component of the marked cells, where 1 is the
 * largest; of equally large ones, the one with the smallest id comes first.
 * @param ids for each piece and cell, unique over all pieces
 * @return the number of components
 */
std::int64_t KeepComponent(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  std::int64_t rank, const std::vector<std::vector<vtkIdType>>& ids, Reducer& reducer,
  CellMarks& marks);
}

#endif
