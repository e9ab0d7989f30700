// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OwnPoints.h
 * @brief Which points of pieces of a mesh count, so that each counts once.
 */
#ifndef camaron_OwnPoints_h
#define camaron_OwnPoints_h

#include "ElementBlocks.h"

namespace camaron
{
/**
 * Collective. Of every block of points whether they count: a point that several pieces of a block have belongs to the
 * first of them, by process; a point that only copies of cells have, to none. Empty if points are marked already
 * (vtkGhostType of points) or there is just one piece.
 * @param numberOfRequestedPieces in how many pieces the pipeline works
 */
std::vector<std::vector<unsigned char>> FindOwnPoints(
  const ElementBlocks& blocks, int numberOfRequestedPieces, Reducer& reducer);
}

#endif
