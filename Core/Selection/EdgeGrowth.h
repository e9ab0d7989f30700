// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EdgeGrowth.h
 * @brief Layers of cells connected over edges, in a mesh without other pieces.
 *
 * A mesh has several times more edges than cells, so this only processes those near the layers.
 */
#ifndef camaron_EdgeGrowth_h
#define camaron_EdgeGrowth_h

#include "Ranks/LinkedPieces.h"

#include <vector> // for marks

namespace camaron
{
/// As Grow over edges (Growth.h), for a mesh without other pieces.
void GrowOverEdges(const LinkedPiece& piece, int rings, const std::vector<unsigned char>& allowed,
  std::vector<unsigned char>& marks);
}

#endif
