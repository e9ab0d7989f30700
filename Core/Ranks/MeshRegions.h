// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeshRegions.h
 * @brief Connected components of a mesh, over facets or around points, across all its pieces.
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
  static constexpr std::int64_t None = -1;    ///< not a 2D or 3D cell, or one without facets
  static constexpr std::int64_t Unknown = -2; ///< a duplicate not connected to any own cell of its
                                              ///< piece
  std::vector<std::int64_t> OfCells;
};

/**
 * Collective. Regions of all pieces, connected over their Options.Links, numbered from 0 in the
 * order of their first cells: by global ids, otherwise block by block and piece by piece.
 */
std::vector<MeshRegions> FindMeshRegions(const std::vector<LinkedPiece>& pieces, Reducer& reducer);

/// For every point of a piece; see CountPointRegions.
struct PointRegions
{
  std::vector<Index> Counts;
};

/// Collective. Includes the cells of other pieces of the block at the points of each piece, whose
/// Data must be set. Additional time and memory are proportional to the number of cells at borders.
std::vector<PointRegions> FindPointRegions(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
