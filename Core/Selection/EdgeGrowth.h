// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeGrowth.h
 * @brief Rings of cells over edges in a mesh that is in one piece.
 *
 * A mesh has several times as many edges as cells; here only those around the rings are looked at.
 */
#ifndef camaron_EdgeGrowth_h
#define camaron_EdgeGrowth_h

#include "Ranks/LinkedPieces.h"

#include <vector> // for marks

namespace camaron
{
/// As Grow over edges (Growth.h), of a mesh without other pieces.
void GrowOverEdges(const LinkedPiece& piece, int rings, const std::vector<unsigned char>& allowed,
  std::vector<unsigned char>& marks);
}

#endif
