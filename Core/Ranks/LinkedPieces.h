// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LinkedPieces.h
 * @brief Finds the cells of other pieces at the facets of each piece of a mesh.
 *
 * Facets of two pieces are the same when they have the same points, see PieceBorders. Each process computes
 * what others need to know of its own cells, so it is the same, to the last bit, as in an undivided mesh.
 * Copies of cells (DUPLICATECELL) take no part.
 *
 * Facets whose points lie within the box of another piece are compared by a hash of 128 bits; every process
 * compares its share of the hashes. Memory, messages and time are proportional to these facets.
 */
#ifndef camaron_LinkedPieces_h
#define camaron_LinkedPieces_h

#include "Ranks/LinkedPiece.h"
#include "Mesh/FacetLinks.h"
#include "Ranks/Reducer.h"

#include <vector> // for the pieces

namespace camaron
{
/// Collective. Of every piece the cells of others at its facets.
std::vector<PieceLinks> LinkPieces(const std::vector<LinkedPiece>& pieces, Reducer& reducer);
}

#endif
