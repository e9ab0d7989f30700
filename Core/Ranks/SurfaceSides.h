// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSides.h
 * @brief Which side of a polygon of a closed surface is the outer one.
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
  Inward = -1, ///< the polygon's normal points to the inside
  None = 0,    ///< the surface is open, not a manifold, or its polygons do not run consistently
  Outward = 1,
  Unknown = 2 ///< there may be more of the surface in another piece
};

struct SurfaceSides
{
  std::vector<SurfaceSide> OfCells; ///< None for cells that are no polygons
};

/**
 * Collective. A surface is what hangs together by edges, over all pieces whose Options.Links lead
 * to each other. It is closed when each edge has two polygons that run along it in opposite
 * directions; inside is what it encloses. The decision is exact: the same however the surface is
 * split.
 */
std::vector<SurfaceSides> FindSurfaceSides(
  const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
