// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MatchingCells.h
 * @brief Whether two meshes have the same cells, wherever their points are.
 */
#ifndef camaron_MatchingCells_h
#define camaron_MatchingCells_h

#include "ElementBlocks.h"

namespace camaron
{
/**
 * Collective. Whether on every process both meshes have the same blocks, with cells of the same
 * types and points, and polyhedra with the same faces, in the same order.
 */
bool HaveSameCells(const ElementBlocks& a, const ElementBlocks& b, Reducer& reducer);
}

#endif
