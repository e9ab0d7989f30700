// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UsedPoints.h
 * @brief Which points of a mesh have a cell.
 */
#ifndef camaron_UsedPoints_h
#define camaron_UsedPoints_h

#include "Mesh/MeshView.h"

#include <vector> // for the points

namespace camaron
{
/// Of every point whether a cell has it that is not a hidden one (VTK_EMPTY_CELL). Ids that are
/// none of a point are passed over.
std::vector<bool> FindUsedPoints(const MeshView& mesh);
}

#endif
