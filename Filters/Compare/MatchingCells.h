// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MatchingCells.h
 * @brief Compares the cells of two meshes, whatever the coordinates of their points.
 */
#ifndef camaron_MatchingCells_h
#define camaron_MatchingCells_h

#include "ElementBlocks.h"

namespace camaron
{
/**
 * Collective. Whether both meshes have, on every process, the same blocks with cells of the same
 * types and points, polyhedra with the same faces, all in the same order. Then a cell of one mesh
 * can be compared with the cell of the same index in the other.
 */
bool HaveSameCells(const ElementBlocks& a, const ElementBlocks& b, Reducer& reducer);
}

#endif
