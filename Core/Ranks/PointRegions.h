// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointRegions.h
 * @brief How many groups of cells meet at the points of a mesh, over all its pieces.
 */
#ifndef camaron_PointRegions_h
#define camaron_PointRegions_h

#include "Ranks/LinkedPiece.h"
#include "Ranks/Reducer.h"

#include <vector> // for the points

namespace camaron
{
/// Of every point of a piece; see CountPointRegions.
struct PointRegions
{
  std::vector<Index> Counts;
};

/// Collective. With the cells that the other pieces of the block have at the points of each piece, whose Data must be
/// set; time and memory beyond those for single pieces are proportional to the cells at borders.
std::vector<PointRegions> FindPointRegions(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
