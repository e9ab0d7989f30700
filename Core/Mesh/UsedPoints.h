// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UsedPoints.h
 * @brief Finds the points that are used by cells.
 */
#ifndef camaron_UsedPoints_h
#define camaron_UsedPoints_h

#include "Mesh/MeshView.h"

#include <vector> // for the points

namespace camaron
{
/// For every point, whether a cell uses it, except for hidden cells (VTK_EMPTY_CELL). Point ids out
/// of range are ignored.
std::vector<bool> FindUsedPoints(const MeshView& mesh);
}

#endif
