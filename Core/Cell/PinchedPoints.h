// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PinchedPoints.h
 * @brief Whether the surface of a cell, open or not, comes to a point more than once.
 */
#ifndef camaron_PinchedPoints_h
#define camaron_PinchedPoints_h

namespace camaron
{
class CellTopology;

/// Whether the faces at some point are more than one group that hangs together over edges at that point. After FindEdges.
bool HasPinchedPoints(const CellTopology& topology);
}

#endif
