// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimpleShapes.h
 * @brief Tells tetrahedra, pyramids, wedges and hexahedra by their topology, and orders their nodes.
 */
#ifndef camaron_SimpleShapes_h
#define camaron_SimpleShapes_h

#include "Criteria/Criterion.h"
#include "Mesh/CellTopology.h"

namespace camaron
{
/// One of Tetrahedra, Pyramids, Wedges and Hexahedra, or 0; whatever the directions of the faces.
unsigned FindSimpleShape(const CellTopology& topology);

constexpr int MaxSimpleNodes = 8;

/**
 * Points of a cell of a simple shape in the order of textbooks: a base whose normal points into the cell,
 * then the apex, or the other ends of the edges from the base. The faces must run outward.
 * @return how many there are
 */
int GetSimpleNodes(const CellTopology& topology, unsigned shape, int nodes[MaxSimpleNodes]);
}

#endif
