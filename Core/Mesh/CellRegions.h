// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellRegions.h
 * @brief What hangs together in a mesh: as a whole, and around every point.
 */
#ifndef camaron_CellRegions_h
#define camaron_CellRegions_h

#include "Mesh/MeshTopology.h"

#include <vector> // for the tables

namespace camaron
{
/**
 * Of every 2D and 3D cell the region that it belongs to: cells that are connected over facets.
 * Regions are numbered from 0 in the order of their first cells. -1 for other cells.
 */
std::vector<Index> FindCellRegions(const MeshTopology& topology);

/**
 * For every point the number of groups of cells around it that are connected over facets with that
 * point; more than 1 where the mesh is pinched. Of 2D or 3D cells, whichever are more: a solid may
 * bring its boundary along. 0 for points that are no corner of either.
 */
std::vector<Index> CountPointRegions(const MeshTopology& topology);
}

#endif
