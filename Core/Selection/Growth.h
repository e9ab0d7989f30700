// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Growth.h
 * @brief Rings of cells around others, and what hangs together, over all pieces of a mesh.
 *
 * Cells are neighbors over common facets (faces of 3D cells, edges of 2D cells), edges or
 * vertices, in whatever piece they are. Cells that are copies of others (DUPLICATECELL) are never
 * marked. All functions are collective; what they find does not depend on how the mesh is split.
 */
#ifndef camaron_Growth_h
#define camaron_Growth_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <cstdint> // for counts
#include <vector>  // for marks

namespace camaron
{
/// Of each piece and cell, or point, 1 or 0.
using CellMarks = std::vector<std::vector<unsigned char>>;

struct Neighborhood
{
  camaron::Adjacency Adjacency = camaron::Adjacency::Facet;
  /**
   * Over an edge of 2D cells whose normals differ by more than this angle, in degrees, they are no
   * neighbors; of more than two cells, if any two of them differ. For facets only.
   */
  double FeatureAngle = 180;
};

/// Adds to @a marks @a rings times the neighbors of the marked cells among those that are @a
/// allowed.
void Grow(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood, int rings,
  const CellMarks& allowed, Reducer& reducer, CellMarks& marks);

/// Adds to @a marks, of points, @a rings times the @a allowed points on a facet, an edge or
/// (Vertex) a cell with a marked one. What holds for a point of one piece holds for its copies in
/// others, and is marked there.
void GrowPoints(const std::vector<LinkedPiece>& pieces, Adjacency adjacency, int rings,
  CellMarks allowed, Reducer& reducer, CellMarks& marks);

/// Adds to @a marks all @a allowed cells to which neighbors lead from marked ones.
void Flood(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  const CellMarks& allowed, Reducer& reducer, CellMarks& marks);

/**
 * Leaves of the marked cells only the @a rank th largest part that hangs together, 1 for the
 * largest; of equally large ones that with the smallest id comes first.
 * @param ids of each piece and cell, unique in all pieces
 * @return the number of parts
 */
std::int64_t KeepPart(const std::vector<LinkedPiece>& pieces, const Neighborhood& neighborhood,
  std::int64_t rank, const std::vector<std::vector<vtkIdType>>& ids, Reducer& reducer,
  CellMarks& marks);
}

#endif
