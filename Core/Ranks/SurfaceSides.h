// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSides.h
 * @brief Determines the outer side of the polygons of closed surfaces.
 */
#ifndef camaron_SurfaceSides_h
#define camaron_SurfaceSides_h

#include "Ranks/LinkedPieces.h"
#include "Ranks/Reducer.h"

#include <vector> // for the sides

namespace camaron
{
enum class SurfaceSide : signed char
{
  Inward = -1, ///< the polygon's normal points inside
  None = 0,    ///< the surface is open, non-manifold, or not consistently oriented
  Outward = 1,
  Unknown = 2 ///< the surface may continue in another piece
};

struct SurfaceSides
{
  std::vector<SurfaceSide> OfCells; ///< None for cells that are not polygons
};

/**
 * Collective. A surface is a set of polygons connected over edges, across all pieces by their
 * Options.Links. It is closed if each edge has two polygons that traverse it in opposite
 * directions; inside is the enclosed volume. The decision uses exact arithmetic, so it does not
 * depend on how the surface is split.
 */
std::vector<SurfaceSides> FindSurfaceSides(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
