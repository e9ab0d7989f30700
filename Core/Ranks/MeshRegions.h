// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshRegions.h
 * @brief The regions of a mesh, connected over facets or at points, in all its pieces.
 */
#ifndef camaron_MeshRegions_h
#define camaron_MeshRegions_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <cstdint> // for numbers
#include <vector>  // for the cells

namespace camaron
{
struct MeshRegions
{
  static constexpr std::int64_t None = -1;    ///< no 2D or 3D cell, or one without facets
  static constexpr std::int64_t Unknown = -2; ///< a copy that no cell of its piece leads to
  std::vector<std::int64_t> OfCells;
};

/**
 * Collective. Regions of all pieces whose Options.Links lead to each other. They are numbered from
 * 0 in the order of their first cells: by global ids, or without them block after block and piece
 * after piece.
 */
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/// Of every point of a piece; see CountPointRegions.
struct PointRegions
{
  std::vector<Index> Counts;
};

/// Collective. With the cells that the other pieces of the block have at the points of each piece,
/// whose Data must be set; time and memory beyond those for single pieces are proportional to the
/// cells at borders.
std::vector<PointRegions> FindPointRegions(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
